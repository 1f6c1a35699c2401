#include "part_drag.h"

#include "parts.h"

#include <cmath>
#include <optional>

namespace oversketch_studio
{

using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;
using oversketch_session::PartPlace;

namespace
{

constexpr double leastPartSide = 0.02; // that a drag leaves of a side
constexpr double foreshortened = 0.2;  // of the z axis, that is too little to be dragged along
constexpr double grazing = 1e-3;       // sine of a ray's angle to the plane

Vector3 middleOf(const PartPlace& place)
{
  return { 0.5 * (place.box[0] + place.box[2]), 0.5 * (place.box[1] + place.box[3]), place.depth };
}

// The direction in which nearer is seen, and whether it is that of the z axis.
struct Nearer
{
  Vector2 direction;
  bool isAxis;
};

Nearer nearerAt(const View& view, const Vector3& place)
{
  const double step = pixelSize(view, place);
  const Vector3 ahead = place + step * Vector3::UnitZ();
  const Vector2 seen = view.toDisplay(ahead).head<2>() - view.toDisplay(place).head<2>();
  if (view.inFront(ahead) && seen.norm() > foreshortened)
  {
    return { seen.normalized(), true };
  }
  return { Vector2(-std::sqrt(0.5), -std::sqrt(0.5)), false };
}

std::optional<Vector2> onPlane(const View& view, const Vector2& display, const Vector3& place)
{
  const oversketch::Sight sight = sightAt(view, display, place);
  if (std::abs(sight.direction().z()) < grazing)
  {
    return std::nullopt;
  }
  const Vector3 met =
    sight.origin() + (place.z() - sight.origin().z()) / sight.direction().z() * sight.direction();
  return view.inFront(met) ? std::optional<Vector2>(met.head<2>()) : std::nullopt;
}

// A box one of whose corners is moved, the opposite one stays.
std::array<double, 4> stretched(const std::array<double, 4>& box, int corner, const Vector2& by, bool free)
{
  const std::size_t x = corner == 0 || corner == 3 ? 0 : 2, y = corner < 2 ? 1 : 3;
  const Vector2 fixed(box[2 - x], box[4 - y]), side = Vector2(box[x], box[y]) - fixed;
  Vector2 scale = (side + by).cwiseQuotient(side);
  if (!free)
  {
    scale.setConstant((side + by).dot(side) / side.squaredNorm());
  }
  scale = scale.cwiseMax(leastPartSide);
  std::array<double, 4> result = box;
  result[x] = fixed[0] + scale[0] * side[0];
  result[y] = fixed[1] + scale[1] * side[1];
  return result;
}

} // namespace

bool seeHandles(const View& view, const PartPlace& place, double distance, std::array<Vector2, 6>& seen)
{
  const Vector3 middle = middleOf(place);
  const Vector3 corners[5] = { { place.box[0], place.box[1], place.depth },
    { place.box[2], place.box[1], place.depth },
    { place.box[2], place.box[3], place.depth },
    { place.box[0], place.box[3], place.depth },
    middle };
  for (std::size_t i = 0; i < 5; ++i)
  {
    if (!view.inFront(corners[i]))
    {
      return false;
    }
    seen[i] = view.toDisplay(corners[i]).head<2>();
  }
  seen[5] = seen[4] + distance * nearerAt(view, middle).direction;
  return true;
}

PartPlace dragged(const View& view,
  const PartPlace& from,
  PartHandle handle,
  const Vector2& start,
  const Vector2& now,
  bool free)
{
  PartPlace to = from;
  const Vector3 middle = middleOf(from);
  if (handle == PartHandle::Depth)
  {
    const Nearer nearer = nearerAt(view, middle);
    to.depth += nearer.isAxis ? alongAxis(view, now, middle, Vector3::UnitZ()) -
                                  alongAxis(view, start, middle, Vector3::UnitZ())
                              : (now - start).dot(nearer.direction) * pixelSize(view, middle);
  }
  else
  {
    const auto before = onPlane(view, start, middle), after = onPlane(view, now, middle);
    const Vector2 by = before && after ? Vector2(*after - *before) : Vector2(0.0, 0.0);
    if (handle == PartHandle::Middle)
    {
      to.box = { from.box[0] + by[0], from.box[1] + by[1], from.box[2] + by[0], from.box[3] + by[1] };
    }
    else
    {
      to.box = stretched(from.box, static_cast<int>(handle), by, free);
    }
  }
  return faultOf(to).empty() ? to : from;
}

} // namespace oversketch_studio
