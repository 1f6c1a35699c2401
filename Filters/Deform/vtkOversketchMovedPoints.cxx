#include "vtkOversketchMovedPoints.h"

#include "Matrix/moving_patch.h"
#include "Mesh/context.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch
{

vtkSmartPointer<vtkPoints> WithPlaces(vtkPoints* points, const std::vector<std::pair<int, Vector3>>& moved)
{
  auto copy = vtkSmartPointer<vtkPoints>::New();
  copy->SetDataType(points->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  copy->DeepCopy(points);
  for (const auto& [index, place] : moved)
  {
    copy->SetPoint(index, place.data());
  }
  return copy;
}

bool UsableNormals(vtkDataArray* normals, vtkIdType count)
{
  return normals && normals->GetNumberOfComponents() == 3 && normals->GetNumberOfTuples() == count;
}

vtkSmartPointer<vtkDataArray> WithNormals(vtkDataArray* normals,
  const std::vector<std::pair<int, Vector3>>& changed)
{
  auto copy = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
  copy->DeepCopy(normals);
  for (const auto& [index, normal] : changed)
  {
    if (normal.squaredNorm() > 0.0)
    {
      copy->SetTuple(index, normal.data());
    }
  }
  return copy;
}

MoveReport WriteMoved(vtkPolyData* input,
  MovingPatch& patch,
  const std::vector<Vector3>& places,
  vtkPolyData* output,
  const Context& context)
{
  output->ShallowCopy(input);
  std::vector<std::pair<int, Vector3>> moved;
  moved.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != patch.rest()[i])
    {
      moved.emplace_back(patch.moving()[i], places[i]);
    }
  }
  MoveReport report;
  report.Moved = static_cast<int>(moved.size());
  if (moved.empty())
  {
    return report;
  }
  output->SetPoints(WithPlaces(input->GetPoints(), moved));
  vtkDataArray* pointNormals = input->GetPointData()->GetNormals();
  vtkDataArray* cellNormals = input->GetCellData()->GetNormals();
  const bool turnsPoints = UsableNormals(pointNormals, input->GetNumberOfPoints());
  const bool turnsCells = UsableNormals(cellNormals, input->GetNumberOfCells());
  using Normals = MovingPatch::Normals;
  const Normals wanted = turnsPoints && turnsCells ? Normals::OfBoth
                         : turnsPoints             ? Normals::OfVertices
                         : turnsCells              ? Normals::OfFaces
                                                   : Normals::None;
  const MovingPatch::Shape shape = patch.shapeAt(places, wanted, context);
  report.Folds = shape.foldedEdges;
  if (turnsPoints)
  {
    output->GetPointData()->SetNormals(WithNormals(pointNormals, shape.vertexNormals));
  }
  if (turnsCells)
  {
    output->GetCellData()->SetNormals(WithNormals(cellNormals, shape.faceNormals));
  }
  return report;
}

} // namespace oversketch
