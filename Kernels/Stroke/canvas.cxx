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

bool closesOnCanvas(const Polyline& points, const Canvas& canvas)
{
  if (points.size() < 3)
  {
    return false;
  }
  const double gap = std::min(closingGap * canvas.longest(), closingShare * arcLengths(points).back());
  return (points.front() - points.back()).norm() <= gap &&
         std::any_of(
           points.begin(), points.end(), [&](const Vector2& p) { return (p - points.front()).norm() > gap; });
}

} // namespace oversketch
