#include "vtkOversketchPrintCheck.h"

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

namespace
{

const PrintCheck nothingFound;

} // namespace

vtkStandardNewMacro(vtkOversketchPrintCheck);

vtkOversketchPrintCheck::vtkOversketchPrintCheck()
  : Last(&nothingFound)
{
}

int vtkOversketchPrintCheck::RequestData(vtkInformation* request,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->Last = &nothingFound;
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
  this->Last = &found;
}

void vtkOversketchPrintCheck::GetLargestHole(double place[3]) const
{
  Vector3::Map(place) = this->Found().holePlace;
}

double vtkOversketchPrintCheck::GetBodyVolume(int body) const
{
  return body >= 0 && body < this->GetNumberOfBodies() ? this->Found().bodies[body].volume : 0.0;
}

void vtkOversketchPrintCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wall: " << this->Wall << "\n";
}
