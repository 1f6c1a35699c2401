#include "seen_line.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"

#include <limits>
#include <utility>

namespace oversketch
{

std::vector<WorldLine> linesOf(vtkPolyData* lines)
{
  std::vector<WorldLine> result;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; lines && i < lines->GetNumberOfLines(); ++i)
  {
    lines->GetLines()->GetCellAtId(i, ids);
    WorldLine line;
    vtkIdType count = ids->GetNumberOfIds();
    line.closed = count > 2 && ids->GetId(0) == ids->GetId(count - 1);
    count -= line.closed;
    for (vtkIdType k = 0; k < count; ++k)
    {
      line.points.emplace_back(lines->GetPoint(ids->GetId(k)));
    }
    result.push_back(std::move(line));
  }
  return result;
}

std::vector<Polyline> seenIn(const View& view, const std::vector<Vector3>& line, bool closed)
{
  std::vector<Polyline> pieces(1);
  const std::size_t count = line.size() + (closed && !line.empty() ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3& point = line[i % line.size()];
    if (view.inFront(point))
    {
      pieces.back().emplace_back(view.toDisplay(point).head<2>());
    }
    else if (!pieces.back().empty())
    {
      pieces.emplace_back();
    }
  }
  return pieces;
}

std::vector<Polyline> seenIn(const View& view, const std::vector<WorldLine>& lines)
{
  std::vector<Polyline> seen;
  for (const WorldLine& line : lines)
  {
    const std::vector<Polyline> pieces = seenIn(view, line.points, line.closed);
    seen.insert(seen.end(), pieces.begin(), pieces.end());
  }
  return seen;
}

double distanceTo(const View& view, const std::vector<Vector3>& line, bool closed, const Vector2& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline& piece : seenIn(view, line, closed))
  {
    if (!piece.empty())
    {
      least = std::min(least, NearestPlace(piece)(place).distance);
    }
  }
  return least;
}

Line2D::Line2D(vtkProperty2D* property)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->data);
  this->actor->SetMapper(mapper);
  this->actor->SetProperty(property);
  this->actor->PickableOff();
  this->set({});
}

void Line2D::setAll(const std::vector<Polyline>& lines)
{
  vtkNew<vtkPoints> none;
  none->SetDataTypeToDouble();
  vtkNew<vtkCellArray> segments;
  this->data->SetPoints(none);
  this->data->SetLines(segments);
  for (const Polyline& line : lines)
  {
    bool first = true;
    for (const Vector2& point : line)
    {
      this->add(point, !std::exchange(first, false));
    }
  }
}

void Line2D::add(const Vector2& point, bool joined)
{
  const vtkIdType last = this->data->GetPoints()->InsertNextPoint(point[0], point[1], 0.0);
  if (joined && last > 0)
  {
    const vtkIdType ids[2] = { last - 1, last };
    this->data->GetLines()->InsertNextCell(2, ids);
  }
  this->data->GetPoints()->Modified();
  this->data->GetLines()->Modified();
  this->data->Modified();
}

} // namespace oversketch
