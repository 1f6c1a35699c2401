#include "two_sides.h"

#include "vtkOversketchMirror.h"

#include "mirror_image.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <Eigen/Core>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace oversketch_session
{

namespace
{

constexpr double endShare = 0.1; // of a section's length, at either end, rests on the body

Point placeOf(vtkPolyData* mesh, vtkIdType i)
{
  Point place;
  mesh->GetPoint(i, place.data());
  return place;
}

bool isBelow(const Section& section, const MirrorPlane& plane)
{
  return section.middle[static_cast<std::size_t>(plane.axis)] < plane.offset;
}

using Move = std::array<float, 9>;

// Adds how a side's points follow, by where they are.
void gather(const Side& side, std::map<Point, Move>& moves)
{
  const Following& following = *side.details->following;
  for (std::size_t i = 0; i < following.points.size(); ++i)
  {
    moves[placeOf(side.mesh, following.points[i])] = following.moves[i];
  }
}

void append(vtkPolyData* part, vtkPoints* points, vtkCellArray* polygons)
{
  const vtkIdType first = points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(part->GetPoint(i));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < part->GetNumberOfPolys(); ++t)
  {
    part->GetPolys()->GetCellAtId(t, ids);
    polygons->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
    for (const vtkIdType id : *ids)
    {
      polygons->InsertCellPoint(first + id);
    }
  }
}

using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Matrix matrixOf(vtkDataArray* array, vtkIdType cell)
{
  Matrix matrix;
  array->GetTuple(cell, matrix.data());
  return matrix;
}

vtkDataArray* arrayOf(vtkPolyData* strokes, const char* name, int components)
{
  vtkDataArray* array = strokes->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
                    array->GetNumberOfTuples() == strokes->GetNumberOfCells();
  return fits ? array : nullptr;
}

} // namespace

vtkSmartPointer<vtkPolyData> withReflections(vtkPolyData* strokes, const MirrorPlane& plane)
{
  auto mirrored = vtkSmartPointer<vtkPolyData>::New();
  mirrored->DeepCopy(strokes);
  vtkDataArray* view = arrayOf(mirrored, "ViewTransform", 16);
  vtkDataArray* projection = arrayOf(mirrored, "ProjectionTransform", 16);
  vtkDataArray* size = arrayOf(mirrored, "ViewportSize", 2);
  if (!view || !projection || !size || mirrored->GetNumberOfLines() != mirrored->GetNumberOfCells())
  {
    return strokes;
  }
  Matrix across = Matrix::Identity();
  across(plane.axis, plane.axis) = -1.0;
  across(plane.axis, 3) = 2.0 * plane.offset;
  Matrix flipped = Matrix::Identity(); // left and right
  flipped(0, 0) = -1.0;
  std::vector<bool> done(static_cast<std::size_t>(mirrored->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mirrored->GetNumberOfCells(); ++cell)
  {
    view->SetTuple(cell, Matrix(flipped * matrixOf(view, cell) * across).data());
    projection->SetTuple(cell, Matrix(flipped * matrixOf(projection, cell) * flipped).data());
    const double width = size->GetComponent(cell, 0);
    mirrored->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
    {
      double place[3];
      mirrored->GetPoint(id, place);
      place[0] = width - place[0];
      if (!done[static_cast<std::size_t>(id)]) // a closed stroke may name its first point twice
      {
        mirrored->GetPoints()->SetPoint(id, place);
        done[static_cast<std::size_t>(id)] = true;
      }
    }
  }
  vtkNew<vtkAppendPolyData> both;
  both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  both->AddInputData(strokes);
  both->AddInputData(mirrored);
  both->Update();
  return both->GetOutput();
}

bool crossesMirrorPlane(vtkPolyData* hold, const MirrorPlane& plane, double tolerance)
{
  vtkNew<vtkIdList> ids;
  if (hold->GetNumberOfLines() > 0)
  {
    hold->GetLines()->GetCellAtId(0, ids);
  }
  std::vector<double> along, heights;
  Point last{};
  for (const vtkIdType id : *ids)
  {
    const Point p = placeOf(hold, id);
    const double step = along.empty() ? 0.0 : std::hypot(p[0] - last[0], p[1] - last[1], p[2] - last[2]);
    along.push_back(along.empty() ? 0.0 : along.back() + step);
    heights.push_back(p[static_cast<std::size_t>(plane.axis)] - plane.offset);
    last = p;
  }
  bool above = false, below = false;
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    const bool rests = along[i] < endShare * along.back() || along[i] > (1.0 - endShare) * along.back();
    above = above || (!rests && heights[i] > tolerance);
    below = below || (!rests && heights[i] < -tolerance);
  }
  return !along.empty() && above == below;
}

bool crossesMirrorPlane(vtkPolyData* hold, const MirrorPlane& plane, vtkPolyData* mesh)
{
  return crossesMirrorPlane(hold, plane, vtkNew<vtkOversketchMirror>()->GetTolerance() * mesh->GetLength());
}

bool isSamePlace(const std::optional<Section>& drawn,
  const std::optional<Section>& inMirror,
  const MirrorPlane& plane)
{
  return drawn && inMirror && isBelow(*drawn, plane) != isBelow(*inMirror, plane);
}

std::string mirroredTo(const std::optional<Section>& drawn, const MirrorPlane& plane)
{
  std::ostringstream text;
  text << "mirrored " << (drawn ? "to " : "at ") << "xyz"[plane.axis]
       << (!drawn                    ? " = "
            : isBelow(*drawn, plane) ? " > "
                                     : " < ")
       << plane.offset;
  return text.str();
}

vtkSmartPointer<vtkPolyData> joined(vtkPolyData* mesh, vtkPolyData* first, vtkPolyData* second)
{
  if (!sameCells(mesh, first) || !sameCells(mesh, second))
  {
    return nullptr;
  }
  auto result = shallowCopyOf(first);
  vtkNew<vtkPoints> points;
  points->SetDataType(first->GetPoints()->GetDataType());
  points->DeepCopy(first->GetPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point before = placeOf(mesh, i), moved = placeOf(second, i);
    if (moved != before && placeOf(first, i) != before)
    {
      return nullptr;
    }
    if (moved != before)
    {
      points->SetPoint(i, moved.data());
    }
  }
  result->SetPoints(points);
  vtkDataArray *old = mesh->GetPointData()->GetNormals(), *turned = second->GetPointData()->GetNormals();
  if (old && turned && first->GetPointData()->GetNormals())
  {
    auto normals = vtkSmartPointer<vtkDataArray>::Take(first->GetPointData()->GetNormals()->NewInstance());
    normals->DeepCopy(first->GetPointData()->GetNormals());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      Point before, after;
      old->GetTuple(i, before.data());
      turned->GetTuple(i, after.data());
      if (after != before)
      {
        normals->SetTuple(i, after.data());
      }
    }
    result->GetPointData()->SetNormals(normals);
  }
  return result;
}

std::shared_ptr<const Details> joined(vtkPolyData* made, const Side& first, const Side& second)
{
  auto details = std::make_shared<Details>();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  append(first.details->region, points, polygons);
  append(second.details->region, points, polygons);
  details->region = vtkSmartPointer<vtkPolyData>::New();
  details->region->SetPoints(points);
  details->region->SetPolys(polygons);
  if (!first.details->following || !second.details->following)
  {
    return details;
  }
  std::map<Point, Move> moves;
  gather(first, moves);
  gather(second, moves);
  auto following = std::make_shared<Following>();
  following->count = made->GetNumberOfPoints();
  for (vtkIdType i = 0; i < following->count; ++i)
  {
    const auto move = moves.find(placeOf(made, i));
    if (move != moves.end())
    {
      following->points.push_back(i);
      following->moves.push_back(move->second);
    }
  }
  details->following = following;
  return details;
}

} // namespace oversketch_session
