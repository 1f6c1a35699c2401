#include "vtkOversketchEditLimb.h"

#include "Mesh/nearest.h"
#include "Remesh/limb_runs.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

std::pair<double, double> SpanOf(vtkPolyData* ring, vtkIdType run)
{
  vtkDataArray* along = ring->GetPointData()->GetArray("CurveT");
  vtkNew<vtkIdList> ids;
  ring->GetLines()->GetCellAtId(run, ids);
  const vtkIdType count = ids->GetNumberOfIds();
  // One that closes repeats its first point.
  const vtkIdType last = count > 2 && ids->GetId(0) == ids->GetId(count - 1) ? count - 2 : count - 1;
  return { along->GetComponent(ids->GetId(0), 0), along->GetComponent(ids->GetId(last), 0) };
}

std::vector<RunOnMesh> RunsOf(vtkPolyData* curves)
{
  vtkDataArray* triangles = curves->GetPointData()->GetArray("MeshCell");
  std::vector<RunOnMesh> runs;
  vtkNew<vtkIdList> ids;
  for (vtkIdType run = 0; run < curves->GetNumberOfLines(); ++run)
  {
    curves->GetLines()->GetCellAtId(run, ids);
    runs.emplace_back();
    for (const vtkIdType id : *ids)
    {
      runs.back().points.emplace_back(curves->GetPoint(id));
      runs.back().triangles.push_back(static_cast<int>(triangles->GetComponent(id, 0)));
    }
  }
  return runs;
}

std::vector<Vector2> PolygonOf(vtkPolyData* spline)
{
  std::vector<Vector2> polygon;
  for (vtkIdType i = 0; i < spline->GetNumberOfPoints(); ++i)
  {
    double place[3];
    spline->GetPoint(i, place);
    polygon.emplace_back(place[0], place[1]);
  }
  return polygon;
}

bool IsWithin(const std::pair<double, double>& span, double t)
{
  const double turns = std::ceil(span.first - t); // the curve's start may be within
  return t + turns <= span.second;
}

} // namespace

RunSpans SpansOnLimb(vtkPolyData* ring, vtkPolyData* spline, vtkPolyData* mesh, vtkPolyData* line)
{
  RunSpans spans;
  if (ring->GetNumberOfLines() < 2)
  {
    return spans;
  }
  std::vector<int> seeds;
  for (const RunOnMesh& run : RunsOf(line))
  {
    seeds.insert(seeds.end(), run.triangles.begin(), run.triangles.end());
  }
  const auto data = SharedMesh(mesh);
  const std::vector<char> told = runsOnLimb(data->Surface(),
    data->Normals(),
    data->Neighbours().vertexVertices,
    ViewOfStroke(ring, 0),
    PolygonOf(spline),
    seeds,
    RunsOf(ring));
  if (std::find(told.begin(), told.end(), 0) != told.end())
  {
    for (std::size_t run = 0; run < told.size(); ++run)
    {
      if (told[run])
      {
        spans.push_back(SpanOf(ring, static_cast<vtkIdType>(run)));
      }
    }
  }
  return spans;
}

void KeepSpans(vtkPolyData* ring, const RunSpans& spans, vtkPolyData* kept)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  kept->Initialize();
  kept->SetPoints(ring->GetPoints());
  kept->GetPointData()->PassData(ring->GetPointData());
  kept->GetCellData()->CopyAllocate(ring->GetCellData());
  for (vtkIdType run = 0; run < ring->GetNumberOfLines(); ++run)
  {
    const std::pair<double, double> own = SpanOf(ring, run);
    const double middle = 0.5 * (own.first + own.second);
    if (std::any_of(spans.begin(), spans.end(), [&](const auto& span) { return IsWithin(span, middle); }))
    {
      ring->GetLines()->GetCellAtId(run, ids);
      kept->GetCellData()->CopyData(ring->GetCellData(), run, lines->InsertNextCell(ids));
    }
  }
  kept->SetLines(lines);
  kept->GetFieldData()->PassData(ring->GetFieldData());
}

double ShareOutside(vtkPolyData* mesh, vtkPolyData* ring, vtkPolyData* spline)
{
  std::vector<char> inside = ReadEditRegion(mesh);
  for (char& label : inside)
  {
    label = label == EditLabel::Inside;
  }
  return shareOutside(SharedMesh(mesh)->Surface(), inside, ViewOfStroke(ring, 0), PolygonOf(spline));
}

double ShareSeen(vtkPolyData* ring, vtkPolyData* seen, double reach)
{
  const std::vector<RunOnMesh> runs = RunsOf(seen);
  const auto isNear = [&](const Vector3& p)
  {
    return std::any_of(runs.begin(),
      runs.end(),
      [&](const RunOnMesh& run)
      {
        for (std::size_t i = 1; i < run.points.size(); ++i)
        {
          if (distanceToSegment(p, run.points[i - 1], run.points[i]) <= reach)
          {
            return true;
          }
        }
        return false;
      });
  };
  vtkNew<vtkIdList> ids;
  ring->GetLines()->GetCellAtId(0, ids);
  double length = 0.0, known = 0.0;
  for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
  {
    const Vector3 from(ring->GetPoint(ids->GetId(i - 1))), to(ring->GetPoint(ids->GetId(i)));
    length += (to - from).norm();
    known += isNear(0.5 * (from + to)) ? (to - from).norm() : 0.0;
  }
  return length > 0.0 ? known / length : 1.0;
}

} // namespace oversketch
