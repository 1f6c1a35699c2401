// The motion of a coarse surface, given to the points of a fine one near it.
#ifndef oversketch_kernels_ray_detail_transfer_h
#define oversketch_kernels_ray_detail_transfer_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <memory>
#include <vector>

namespace oversketch
{

// New places of points, from the surface at rest and where its points are now. A point hangs at its closest
// place on the surface at rest: it goes with that place, and the way from there to the point turns as the
// surface does, by the rotations of the triangle's corners, weighted. Beside a triangle that has not moved by
// a bit the point keeps its bits. Of equally close places that of the lowest triangle counts.
//
// Takes points by blocks, with progress and cancel after each. The same for any number of threads.
std::vector<Vector3> transferDetail(const std::shared_ptr<const Mesh>& rest,
  const std::vector<Vector3>& now,
  const std::vector<Vector3>& points,
  const Context& context = Context());

} // namespace oversketch
#endif
