#include "quads.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

#include <array>

namespace oversketch_files
{

namespace
{

// Cosine between the triangles (0, 1, 2) and (0, 2, 3) of four corners.
double alike(vtkPolyData* mesh, const std::array<vtkIdType, 4>& ids)
{
  double p[4][3], first[3], second[3];
  for (std::size_t k = 0; k < 4; ++k)
  {
    mesh->GetPoint(ids[k], p[k]);
  }
  vtkTriangle::ComputeNormal(p[0], p[1], p[2], first);
  vtkTriangle::ComputeNormal(p[0], p[2], p[3], second);
  return vtkMath::Dot(first, second);
}

} // namespace

vtkIdType trianglesIn(vtkPolyData* mesh)
{
  return mesh->GetPolys()->GetNumberOfConnectivityIds() - 2 * mesh->GetNumberOfPolys();
}

vtkSmartPointer<vtkPolyData> withoutQuads(vtkPolyData* mesh)
{
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polygons;
  vtkCellData* arrays = cut->GetCellData();
  arrays->CopyAllocate(mesh->GetCellData(), 2 * mesh->GetNumberOfPolys());
  const auto add = [&](vtkIdType from, vtkIdType size, const vtkIdType* ids)
  { arrays->CopyData(mesh->GetCellData(), from, polygons->InsertNextCell(size, ids)); };
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    if (size != 4)
    {
      add(it->GetCurrentCellId(), size, ids);
      continue;
    }
    std::array<vtkIdType, 4> corners{ ids[0], ids[1], ids[2], ids[3] };
    const std::array<vtkIdType, 4> turned{ ids[1], ids[2], ids[3], ids[0] };
    if (alike(mesh, turned) > alike(mesh, corners))
    {
      corners = turned;
    }
    const vtkIdType halves[2][3] = { { corners[0], corners[1], corners[2] },
      { corners[0], corners[2], corners[3] } };
    add(it->GetCurrentCellId(), 3, halves[0]);
    add(it->GetCurrentCellId(), 3, halves[1]);
  }
  cut->SetPoints(mesh->GetPoints());
  cut->SetPolys(polygons);
  cut->GetPointData()->ShallowCopy(mesh->GetPointData());
  cut->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return cut;
}

} // namespace oversketch_files
