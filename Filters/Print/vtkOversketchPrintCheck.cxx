#include "vtkOversketchPrintCheck.h"

#include "Print/print_check.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

using namespace oversketch;

struct vtkOversketchPrintCheck::Last
{
  const PrintCheck* Found = nullptr; // of what is kept
};

vtkStandardNewMacro(vtkOversketchPrintCheck);

int vtkOversketchPrintCheck::RequestData(vtkInformation* request,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->Kept<Last>().Found = nullptr;
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkOversketchPrintCheck::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  RequirePolygonsOnly(input); // the key does not see other cells
  const PrintCheck& found = this->Kept<KeptValue<PrintCheck>>().Provide(StepKey({ MeshKey(input) }, {}),
    [&] { return checkPrint(SharedMesh(input)->Surface(), ContextOf(this)); });
  output->ShallowCopy(input);
  output->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("Wall", found.walls));
  output->GetCellData()->AddArray(ArrayOf<vtkUnsignedCharArray>("Faulty", found.faults));
  this->Kept<Last>().Found = &found;
}

const PrintCheck& vtkOversketchPrintCheck::Found()
{
  static const PrintCheck none;
  const PrintCheck* found = this->Kept<Last>().Found;
  return found ? *found : none;
}

bool vtkOversketchPrintCheck::IsReady()
{
  return this->Found().isReady(this->Wall);
}

int vtkOversketchPrintCheck::GetOpenEdges()
{
  return this->Found().openEdges;
}

int vtkOversketchPrintCheck::GetTurnedEdges()
{
  return this->Found().turnedEdges;
}

int vtkOversketchPrintCheck::GetCrowdedEdges()
{
  return this->Found().crowdedEdges;
}

int vtkOversketchPrintCheck::GetHoles()
{
  return this->Found().holes;
}

double vtkOversketchPrintCheck::GetLargestHoleLength()
{
  return this->Found().holeLength;
}

void vtkOversketchPrintCheck::GetLargestHole(double place[3])
{
  Vector3::Map(place) = this->Found().holePlace;
}

int vtkOversketchPrintCheck::GetNumberOfBodies()
{
  return static_cast<int>(this->Found().bodies.size());
}

double vtkOversketchPrintCheck::GetBodyVolume(int body)
{
  return body >= 0 && body < this->GetNumberOfBodies() ? this->Found().bodies[body].volume : 0.0;
}

int vtkOversketchPrintCheck::GetHollows()
{
  return this->Found().hollows();
}

int vtkOversketchPrintCheck::GetInsideOut()
{
  return this->Found().insideOut();
}

int vtkOversketchPrintCheck::GetCrossingPairs()
{
  return this->Found().crossings;
}

double vtkOversketchPrintCheck::GetLeastWall()
{
  return this->Found().leastWall;
}

double vtkOversketchPrintCheck::GetThinArea()
{
  return this->Found().thinArea(this->Wall);
}

void vtkOversketchPrintCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wall: " << this->Wall << "\n";
}
