#include "vtkOversketchStellarParts.h"

#include "vtkOversketchStellarTools.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

namespace oversketch
{

std::vector<int> PartsOf(vtkPolyData* mesh, const Forest& forest)
{
  vtkCellData* cells = mesh->GetCellData();
  if (!cells->GetArray("Chart"))
  {
    return {};
  }
  const std::vector<int> charts = WholeNumbers(
    RequireArray(cells, "Chart", 1, mesh->GetNumberOfCells(), "mesh", "one chart number per triangle"));
  const std::vector<int> roots = WholeNumbers(
    RequireArray(cells, "StellarRoot", 1, mesh->GetNumberOfCells(), "mesh", "the steps carry it"));
  std::vector<int> parts(static_cast<std::size_t>(forest.rootCount), 0);
  for (std::size_t f = charts.size(); f-- > 0;)
  {
    parts[roots[f]] = charts[f];
  }
  return parts;
}

MeshKey PartsKey(vtkPolyData* mesh)
{
  return MeshKey(mesh, { mesh->GetCellData()->GetArray("Chart") });
}

} // namespace oversketch
