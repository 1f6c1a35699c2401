#include "point_normals.h"

#include "Mesh/weld.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

#include <vector>

namespace oversketch_files
{

vtkSmartPointer<vtkPolyData> withPointNormals(vtkPolyData* mesh)
{
  auto shown = vtkSmartPointer<vtkPolyData>::New();
  shown->ShallowCopy(mesh);
  if (mesh->GetPointData()->GetNormals())
  {
    return shown;
  }
  vtkNew<vtkCellArray> own; // a filter leaves in polygons how far it is
  own->ShallowCopy(mesh->GetPolys());
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(own);
  if (own->IsHomogeneous() != 3)
  {
    vtkNew<vtkTriangleFilter> triangles; // points stay
    triangles->SetInputData(bare);
    triangles->Update();
    bare->SetPolys(triangles->GetOutput()->GetPolys());
  }
  oversketch::Mesh surface = oversketch::MeshOf(bare);
  std::vector<int> places; // only where a seam can be
  if (mesh->GetPointData()->GetTCoords())
  {
    places = oversketch::weldPoints(surface.points);
    surface = places.empty() ? std::move(surface) : oversketch::weldedMesh(surface, places);
  }
  const std::vector<oversketch::Vector3> normals =
    oversketch::vertexNormals(surface, oversketch::trianglesAround(surface), oversketch::ThreadsOnly());
  vtkNew<vtkFloatArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    array->SetTuple(i, normals[places.empty() ? at : static_cast<std::size_t>(places[at])].data());
  }
  shown->GetPointData()->SetNormals(array);
  return shown;
}

} // namespace oversketch_files
