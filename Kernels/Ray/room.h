// How far a place of a surface can move before it meets another part.
#ifndef oversketch_kernels_ray_room_h
#define oversketch_kernels_ray_room_h

#include "Ray/surface_rays.h"

namespace oversketch
{

// Lengths from a place of the surface along its normal; infinite where nothing is met.
struct Room
{
  double inward;  // to where the line leaves the solid: how thick that is
  double outward; // to where it enters a solid: how wide the gap is
};

// Facets that the line meets from their other side do not count: folds of the surface round the place.
Room roomAt(const SurfaceRays& surface, const Vector3& place, const Vector3& normal);

// Along a line of sight, from a place within the solid to the farther of both places where the line leaves
// it; 0 outside. An outline that is drawn through the place has to carry that much away to either side of it.
double depthAt(const SurfaceRays& surface, const Vector3& place, const Vector3& sight);

} // namespace oversketch
#endif
