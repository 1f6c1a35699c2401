// How far from their origin rays may start without missing a facet to leave through.
#ifndef oversketch_ray_starts_h
#define oversketch_ray_starts_h

#include "Ray/ray_caster.h"

namespace oversketch
{

// Near a vertex of a smooth surface no facet can be left through by the cone of rays round -normal: all face
// the other way. Per vertex of `vertices`, which follow the curve of the scene, a distance [unit of the
// scene] within which no facet lies that any ray of its cone can leave through; 0 where nothing is known.
// Rays that start there skip the crowded part of the tree. `opening` is the angle between the cone's axis and
// its outermost ray [radians].
std::vector<float> rayStarts(const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<int>& vertices,
  double opening,
  const Context& context);

} // namespace oversketch
#endif
