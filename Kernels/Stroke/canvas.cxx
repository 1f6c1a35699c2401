#include "Stroke/canvas.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double grazing = 1e-6;     // rad
constexpr double closingGap = 0.02;  // of the longest side
constexpr double closingShare = 0.2; // of the stroke's length
constexpr double overshoot = 0.1;    // of the stroke's length

} // namespace

Canvas pictureCanvas(const Vector2& origin, const Vector2& spacing, int columns, int rows)
{
  if (columns < 1 || rows < 1 || !origin.allFinite() || !spacing.allFinite() || spacing.minCoeff() <= 0.0)
  {
    throw Error(Failure::BadStroke,
      "the picture is empty or its spacing is not positive; give one of at least one sample");
  }
  return { origin - 0.5 * spacing, spacing.cwiseProduct(Vector2(columns, rows)) };
}

std::optional<Vector2> ontoCanvas(const View& view, const Vector2& display)
{
  // Two depths on the visible side of the eye. Their scale is that of the eye's distance from the plane, for
  // a ray taken over a short way loses digits.
  double near = 0.0, far = -1.0;
  if (view.perspective())
  {
    const double reach = std::max(std::abs(view.eye()[2]), 1e-300);
    near = -0.5 * reach;
    far = -1.5 * reach;
  }
  const Vector3 a = view.toWorld(display, near), b = view.toWorld(display, far);
  const Vector3 way = b - a;
  if (!way.allFinite() || std::abs(way[2]) <= grazing * way.norm())
  {
    return std::nullopt;
  }
  const double t = -a[2] / way[2];
  const Vector3 place = a + t * way;
  if (!place.allFinite() || !view.inFront(Vector3(place[0], place[1], 0.0)))
  {
    return std::nullopt;
  }
  return Vector2(place[0], place[1]);
}

Polyline ontoCanvas(const View& view, const Polyline& display)
{
  Polyline points;
  points.reserve(display.size());
  for (const Vector2& sample : display)
  {
    if (const std::optional<Vector2> place = ontoCanvas(view, sample))
    {
      points.push_back(*place);
    }
  }
  return points;
}

std::size_t samplesRound(const Polyline& points, const Canvas& canvas)
{
  const std::size_t count = points.size();
  if (count < 3)
  {
    return 0;
  }
  const Vector2 start = points.front();
  const std::vector<double> lengths = arcLengths(points);
  const double gap = std::min(closingGap * canvas.longest(), closingShare * lengths.back());
  const auto off = [&](std::size_t i) { return (points[i] - start).norm(); };
  std::size_t away = 0;
  while (away < count && off(away) <= gap)
  {
    ++away;
  }
  // The end that runs beside the beginning, and where it is nearest to the first sample.
  Polyline beginning;
  for (std::size_t i = 0; i < count && lengths[i] <= overshoot * lengths.back(); ++i)
  {
    beginning.push_back(points[i]);
  }
  const NearestPlace beside(beginning);
  std::size_t nearest = count - 1;
  for (std::size_t i = count; i-- > away && beginning.size() > 1 &&
                              lengths.back() - lengths[i] <= overshoot * lengths.back() &&
                              (off(i) <= gap || beside(points[i]).distance <= 0.5 * gap);)
  {
    nearest = off(i) < off(nearest) ? i : nearest;
  }
  if (away == count || off(nearest) > gap)
  {
    return 0;
  }
  if (nearest + 1 == count)
  {
    return count;
  }
  const Vector2 way = beginning[1] - start;
  std::size_t kept = nearest + 1;
  while (kept > away + 1 && ((points[kept - 1] - start).dot(way) > 0.0 || off(kept - 1) < 2.0 * off(nearest)))
  {
    --kept;
  }
  return kept;
}

} // namespace oversketch
