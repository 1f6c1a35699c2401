// Vertices of a mesh that no part of it hides.
#ifndef oversketch_kernels_ray_seen_h
#define oversketch_kernels_ray_seen_h

#include "Mesh/view.h"
#include "Ray/surface_rays.h"

#include <vector>

namespace oversketch
{

// 1 for each of the vertices that the eye, or in a parallel view a place before the mesh, sees from either
// side of the surface: none of it lies before them by over 1e-6 of the mesh's diagonal. One that is not in
// front of the eye is not seen. Throws Error(Failure::Cancelled).
std::vector<char> seenVertices(const SurfaceRays& surface,
  const View& view,
  const std::vector<int>& vertices,
  const Context& context = Context());

} // namespace oversketch
#endif
