#include "gizmo_drag.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

using oversketch::Pose;
using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;

namespace
{

constexpr int ringCorners = 64;
constexpr double leastRun = 0.17; // sine of the angle to the line of sight
constexpr double facesEye = 0.5;  // cosine of it, from which on an angle is measured about the axis
constexpr double leastFactor = 0.02, mostFactor = 50.0; // of one drag
constexpr double perPixel = M_PI / 180.0;

double distanceToSegment(const Vector2& place, const Vector2& a, const Vector2& b)
{
  const Vector2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((place - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (place - a - t * along).norm();
}

// The angle that the hand turns by about an axis through a place. One that lies across the view, whose circle
// is seen from its rim, turns as the near side of a wheel does.
double angleBetween(const View& view,
  const Vector3& place,
  const Vector3& axis,
  const Vector2& start,
  const Vector2& now)
{
  const Vector3 toEye = view.towardsViewer(place).normalized();
  if (std::abs(toEye.dot(axis)) > facesEye)
  {
    const Eigen::Hyperplane<double, 3> plane(axis, place);
    const Vector3 a = sightAt(view, start, place).intersectionPoint(plane) - place;
    const Vector3 b = sightAt(view, now, place).intersectionPoint(plane) - place;
    return std::atan2(a.cross(b).dot(axis), a.dot(b));
  }
  const Vector3 rim = pixelSize(view, place) * axis.cross(toEye).normalized();
  const Vector2 sideways = (view.toDisplay(place + rim) - view.toDisplay(place)).head<2>();
  return perPixel * (now - start).dot(sideways.normalized());
}

} // namespace

Sight sightAt(const View& view, const Vector2& display, const Vector3& place)
{
  const Vector3 at = view.toWorld(display, view.depth(place));
  return { at, -view.towardsViewer(at).normalized() };
}

double alongAxis(const View& view, const Vector2& display, const Vector3& place, const Vector3& axis)
{
  const Sight sight = sightAt(view, display, place);
  const Vector3 from = place - sight.origin();
  const double slope = sight.direction().dot(axis);
  return (slope * sight.direction().dot(from) - from.dot(axis)) / (1.0 - slope * slope);
}

std::optional<GizmoShape> seeGizmo(const View& view,
  const Vector3& middle,
  const Eigen::Matrix3d& axes,
  double ratio)
{
  if (!view.inFront(middle))
  {
    return std::nullopt;
  }
  GizmoShape shape;
  shape.ratio = ratio;
  shape.middle = view.toDisplay(middle).head<2>();
  const double radius = GizmoSize().ring * ratio * pixelSize(view, middle);
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 across = axes.col((k + 1) % 3), upright = axes.col((k + 2) % 3);
    GizmoShape::Axis& axis = shape.axes[k];
    for (int i = 0; i <= ringCorners; ++i)
    {
      const double angle = 2.0 * M_PI * i / ringCorners;
      const Vector3 at = middle + radius * (std::cos(angle) * across + std::sin(angle) * upright);
      if (!view.inFront(at))
      {
        return std::nullopt;
      }
      axis.ring.emplace_back(view.toDisplay(at).head<2>());
    }
    // A short way, which perspective does not bend.
    const Vector3 ahead = middle + pixelSize(view, middle) * axes.col(k);
    const Vector2 run = view.toDisplay(ahead).head<2>() - shape.middle;
    if (run.norm() > leastRun)
    {
      axis.run = run.normalized();
    }
  }
  return shape;
}

std::optional<GizmoGrip> gripAt(const GizmoShape& shape, const Vector2& place)
{
  const GizmoSize size;
  const Vector2 from = (place - shape.middle) / shape.ratio;
  if (from.cwiseAbs().maxCoeff() <= size.square + 2.0)
  {
    return GizmoGrip{ GizmoGrip::Square, 0 };
  }
  std::optional<GizmoGrip> nearest;
  double least = size.grab;
  const auto look = [&](double distance, GizmoGrip::Part part, int axis)
  {
    if (distance < least)
    {
      least = distance;
      nearest = GizmoGrip{ part, axis };
    }
  };
  for (int k = 0; k < 3; ++k)
  {
    if (const auto& run = shape.axes[k].run)
    {
      look((from - size.box * *run).norm() - size.boxSide, GizmoGrip::Box, k);
      look(distanceToSegment(from, size.arrowFrom * *run, size.arrowTo * *run), GizmoGrip::Arrow, k);
    }
  }
  const bool isBeside = !nearest; // a ring that is seen from its rim lies under arrows
  for (int k = 0; isBeside && k < 3; ++k)
  {
    const std::vector<Vector2>& ring = shape.axes[k].ring;
    for (std::size_t i = 1; i < ring.size(); ++i)
    {
      look(distanceToSegment(place, ring[i - 1], ring[i]) / shape.ratio, GizmoGrip::Ring, k);
    }
  }
  return nearest;
}

Pose posed(const View& view,
  const Vector3& middle,
  const Pose& from,
  const GizmoGrip& grip,
  const Vector2& start,
  const Vector2& now,
  bool uniform)
{
  Pose to = from;
  const Vector3 at = middle + from.move;
  const Eigen::Matrix3d axes = oversketch::turnedBy(from.turn);
  const Vector3 axis = axes.col(grip.axis);
  switch (grip.part)
  {
    case GizmoGrip::Square:
      to.move += view.toWorld(now, view.depth(at)) - view.toWorld(start, view.depth(at));
      break;
    case GizmoGrip::Arrow:
      to.move += (alongAxis(view, now, at, axis) - alongAxis(view, start, at, axis)) * axis;
      break;
    case GizmoGrip::Box:
    {
      const double ratio = alongAxis(view, now, at, axis) / alongAxis(view, start, at, axis);
      const double factor = std::isfinite(ratio) ? std::clamp(ratio, leastFactor, mostFactor) : 1.0;
      for (int k = 0; k < 3; ++k)
      {
        to.scale[k] *= uniform || k == grip.axis ? factor : 1.0;
      }
      break;
    }
    case GizmoGrip::Ring:
      to.turn = oversketch::degreesOf(
        Eigen::AngleAxisd(angleBetween(view, at, axis, start, now), axis).toRotationMatrix() * axes);
      break;
  }
  return to;
}

} // namespace oversketch_studio
