#include "drawn_curve.h"

#include "Ray/projection.h"
#include "Stroke/correct.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace oversketch
{

std::shared_ptr<const SurfaceRays> raysOf(vtkPolyData* mesh)
{
  return mesh && mesh->GetNumberOfPolys() > 0 ? sharedRays(SharedMesh(mesh)->KeptSurface(), ThreadsOnly())
                                              : nullptr;
}

std::vector<Vector3> laidOn(const SurfaceRays* model, const View& view, const Polyline& samples, double depth)
{
  std::vector<Vector3> places(samples.size(), Vector3::Zero());
  std::vector<double> depths(samples.size(), depth);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; model && i < samples.size(); ++i)
  {
    const SurfaceHit hit = model->nearest(lineOfSight(view, samples[i], *model));
    if (hit.found())
    {
      places[i] = hit.position;
      depths[i] = view.depth(hit.position);
      found.push_back(i);
    }
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto after = std::lower_bound(found.begin(), found.end(), i);
    if (after != found.end() && *after == i)
    {
      continue;
    }
    if (!found.empty())
    {
      const bool isNearer = after != found.end() && (after == found.begin() || *after - i < i - *(after - 1));
      depths[i] = depths[isNearer ? *after : *(after - 1)];
    }
    places[i] = view.toWorld(samples[i], depths[i]);
  }
  return places;
}

std::vector<Vector3> redrawn(const std::vector<Vector3>& curve,
  bool closed,
  const View& view,
  const Polyline& samples,
  const std::vector<Vector3>& laid)
{
  Polyline seen;
  for (const Vector3& point : curve)
  {
    if (!view.inFront(point))
    {
      return curve;
    }
    seen.emplace_back(view.toDisplay(point).head<2>());
  }
  const Resketched merged = closed ? resketchClosed(seen, samples) : resketch(seen, samples);
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < merged.points.size(); ++i)
  {
    const Origin& origin = merged.origins[i];
    const Vector3 between = origin.of(curve, laid);
    // Where a blend's curve leaves the chord, at the depth of what it is blended of.
    result.push_back(view.inFront(between) ? view.toWorld(merged.points[i], view.depth(between)) : between);
  }
  return result;
}

std::vector<Polyline> segmentsIn(const View& view, const std::vector<std::array<Vector3, 2>>& segments)
{
  std::vector<Polyline> seen;
  for (const auto& [from, to] : segments)
  {
    if (view.inFront(from) && view.inFront(to))
    {
      seen.push_back({ view.toDisplay(from).head<2>(), view.toDisplay(to).head<2>() });
    }
  }
  return seen;
}

std::vector<double> sharesOf(const std::vector<Vector3>& line)
{
  std::vector<double> shares{ 0.0 };
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    shares.push_back(shares.back() + (line[i] - line[i - 1]).norm());
  }
  const double length = shares.back();
  for (double& share : shares)
  {
    share = length > 0.0 ? share / length : 0.0;
  }
  return shares;
}

Vector3 placeAt(const std::vector<Vector3>& line, const std::vector<double>& shares, double share)
{
  const auto after = std::upper_bound(shares.begin() + 1, shares.end() - 1, share);
  const auto i = static_cast<std::size_t>(after - shares.begin());
  const double step = shares[i] - shares[i - 1];
  const double u = step > 0.0 ? std::clamp((share - shares[i - 1]) / step, 0.0, 1.0) : 0.0;
  return (1.0 - u) * line[i - 1] + u * line[i];
}

std::optional<double> nearestShare(const View& view,
  const std::vector<Vector3>& line,
  const std::vector<double>& shares,
  const Vector2& place)
{
  Polyline seen;
  std::vector<double> at;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (view.inFront(line[i]))
    {
      seen.emplace_back(view.toDisplay(line[i]).head<2>());
      at.push_back(shares[i]);
    }
  }
  const NearestPlace::Answer nearest = NearestPlace(seen)(place);
  if (nearest.segment < 0)
  {
    return std::nullopt;
  }
  const auto i = static_cast<std::size_t>(nearest.segment);
  return (1.0 - nearest.t) * at[i] + nearest.t * at[std::min(i + 1, at.size() - 1)];
}

std::vector<Vector3> firstLineOf(vtkPolyData* lines)
{
  const std::vector<WorldLine> all = linesOf(lines);
  return all.empty() ? std::vector<Vector3>() : all[0].points;
}

Polyline flat(const std::vector<Vector3>& line)
{
  Polyline points;
  for (const Vector3& p : line)
  {
    points.emplace_back(p.head<2>());
  }
  return points;
}

void putLine(vtkPolyData* into, const std::vector<Vector3>& line, bool closed)
{
  into->Initialize();
  if (line.empty())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(line.size()) + closed);
  for (const Vector3& p : line)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  if (closed)
  {
    lines->InsertCellPoint(0);
  }
  into->SetPoints(points);
  into->SetLines(lines);
}

std::vector<vtkSmartPointer<vtkPolyData>> strokesOf(vtkPolyData* all)
{
  std::vector<vtkSmartPointer<vtkPolyData>> strokes;
  for (vtkIdType i = 0; all && i < all->GetNumberOfLines(); ++i)
  {
    strokes.push_back(StrokeAlone(all, i));
    strokes.back()->GetFieldData()->Initialize();
  }
  return strokes;
}

} // namespace oversketch
