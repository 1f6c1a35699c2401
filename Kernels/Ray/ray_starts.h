// Which facets the cones of rays may leave through, by bounds: how far from its origin a ray may start, and
// which rays a change of the mesh can alter.
#ifndef oversketch_kernels_ray_ray_starts_h
#define oversketch_kernels_ray_ray_starts_h

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

// Per vertex of `vertices`, which follow the curve of the scene, 1 where a ray of its cone may leave through
// one of the facets of `others` that is nearer than `reaches`, with a margin; 0 where surely none does.
// `others` is a scene of the same frame.
std::vector<char> conesThatMeet(const RayScene& others,
  const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<int>& vertices,
  const std::vector<float>& reaches,
  double opening,
  const Context& context);

} // namespace oversketch
#endif
