#include "Ray/room.h"

#include <algorithm>

namespace oversketch
{

Room roomAt(const SurfaceRays& surface, const Vector3& place, const Vector3& normal)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Room room{ none, none };
  if (!place.allFinite() || !(normal.norm() > 0.0))
  {
    return room;
  }
  const Vector3 n = normal.normalized();
  for (const SurfaceHit& hit : surface.all({ place, n }))
  {
    const double slope = facetNormal(surface.mesh(), hit.at.triangle).dot(n);
    if (hit.distance < 0.0 && slope < 0.0)
    {
      room.inward = std::min(room.inward, -hit.distance);
    }
    if (hit.distance > 0.0 && slope < 0.0)
    {
      room.outward = std::min(room.outward, hit.distance);
    }
  }
  return room;
}

double depthAt(const SurfaceRays& surface, const Vector3& place, const Vector3& sight)
{
  SurfaceHit before, after;
  for (const SurfaceHit& hit : surface.all({ place, sight }))
  {
    if (hit.distance < 0.0)
    {
      before = hit; // the last one
    }
    else if (!after.found())
    {
      after = hit;
    }
  }
  if (!before.found() || !after.found() ||
      facetNormal(surface.mesh(), before.at.triangle).dot(sight) >= 0.0 ||
      facetNormal(surface.mesh(), after.at.triangle).dot(sight) <= 0.0)
  {
    return 0.0;
  }
  return std::max(-before.distance, after.distance);
}

} // namespace oversketch
