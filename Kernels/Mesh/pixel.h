// How large a pixel is in the world.
#ifndef oversketch_kernels_mesh_pixel_h
#define oversketch_kernels_mesh_pixel_h

#include "Mesh/view.h"

namespace oversketch
{

// The size of a pixel where a point of the world is [model length].
inline double pixelSize(const View& view, const Vector3& world)
{
  const Vector3 display = view.toDisplay(world);
  return (view.toWorld({ display[0] + 1.0, display[1] }, display[2]) - world).norm();
}

} // namespace oversketch
#endif
