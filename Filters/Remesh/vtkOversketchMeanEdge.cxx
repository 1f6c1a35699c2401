#include "vtkOversketchMeanEdge.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchMeanEdge);

namespace
{

const char* const meanName = "MeanEdge";

double meanEdgeOf(const MeshData& data)
{
  const std::vector<Vector3>& points = data.Surface().points;
  const std::vector<MeshEdge>& edges = data.Neighbours().edges;
  double sum = 0.0;
  for (const MeshEdge& edge : edges)
  {
    sum += (points[edge.v1] - points[edge.v0]).norm();
  }
  const double mean = sum / static_cast<double>(edges.size());
  if (!(mean > 0.0))
  {
    throw Error(Failure::BadMesh, "No edge of the mesh has a length; give a mesh with triangles.");
  }
  return mean;
}

} // namespace

void vtkOversketchMeanEdge::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  if (input->GetFieldData()->GetAbstractArray(meanName))
  {
    FieldValue(input, meanName, "mesh", "remove it, and it is made anew");
    return;
  }
  output->GetFieldData()->AddArray(OneValue<vtkDoubleArray>(meanName, meanEdgeOf(*SharedMesh(input))));
}
