#include "vtkOversketchQuadMerge.h"

#include "Planar/coarse_faces.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchPlanarTools.h"

#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchQuadMerge);

vtkOversketchQuadMerge::vtkOversketchQuadMerge()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkOversketchQuadMerge::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* triangles = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* edges = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  this->Kept<KeptOutput>().Provide(StepKey({ PlanarKey(triangles), PlanarKey(edges) }, {}),
    output,
    [&](vtkPolyData* result)
    {
      ++this->MergeCount;
      WritePlanarMesh(mergeQuads(PlanarMeshOf(triangles, edges)), result);
    });
  output->GetFieldData()->PassData(triangles->GetFieldData());
  vtkPolyData::GetData(outputs, 1)->ShallowCopy(edges);
}

void vtkOversketchQuadMerge::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeCount: " << this->MergeCount << "\n";
}
