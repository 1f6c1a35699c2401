// Curves of mesh edges as polydata, and back. Header-only.
#ifndef oversketch_testing_harness_chains_h
#define oversketch_testing_harness_chains_h

#include "Harness/polydata.h"

#include "vtkIdList.h"
#include "vtkIdTypeArray.h"

namespace oversketch_test
{

// One polyline with VertexId and CurveT; a closed chain repeats its first point's id. A vertex that the mesh
// does not have lies at the origin.
inline vtkSmartPointer<vtkPolyData> toChain(const Mesh& mesh, const std::vector<int>& chain)
{
  const bool closed = chain.size() > 2 && chain.front() == chain.back();
  const std::size_t count = chain.size() - (closed ? 1 : 0);
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("VertexId");
  vtkNew<vtkDoubleArray> shares;
  shares->SetName("CurveT");
  lines->InsertNextCell(static_cast<int>(chain.size()));
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool there = chain[i] >= 0 && chain[i] < mesh.vertexCount();
    const Vector3 place = there ? mesh.points[chain[i]] : Vector3(Vector3::Zero());
    lines->InsertCellPoint(points->InsertNextPoint(place.data()));
    vertices->InsertNextValue(chain[i]);
    shares->InsertNextValue(static_cast<double>(i) / std::max(1.0, static_cast<double>(chain.size()) - 1.0));
  }
  if (closed)
  {
    lines->InsertCellPoint(0);
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
  curve->GetPointData()->AddArray(vertices);
  curve->GetPointData()->AddArray(shares);
  return curve;
}

inline std::vector<int> chainOf(vtkPolyData* curve)
{
  vtkNew<vtkIdList> ids;
  curve->GetLines()->GetCellAtId(0, ids);
  vtkDataArray* vertices = curve->GetPointData()->GetArray("VertexId");
  std::vector<int> chain;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    chain.push_back(static_cast<int>(vertices->GetComponent(ids->GetId(i), 0)));
  }
  return chain;
}

} // namespace oversketch_test
#endif
