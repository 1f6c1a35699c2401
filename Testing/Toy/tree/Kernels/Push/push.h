// What lies between two lines of a picture, pushed along its normals by the brightness of another picture.
#ifndef oversketch_kernels_push_push_h
#define oversketch_kernels_push_push_h

#include "Mesh/context.h"
#include "Mesh/view.h"

#include <vector>

namespace oversketch
{

// Rows from the bottom up, as large as the view or not.
struct Brightness
{
  int width = 0, height = 0;
  std::vector<double> values; // 0 to 1

  // At a place of a picture of the given size.
  double at(const Vector2& place, int ofWidth, int ofHeight) const;
};

// The mesh's points; those that the view shows inside the polygon of one line and the other one backwards go
// along their normals, by length [model length] where it is brightest. Throws Error(Failure::BadStroke) where
// the polygon holds none.
std::vector<Vector3> pushBetween(const Mesh& mesh,
  const View& view,
  const std::vector<Vector2>& first,
  const std::vector<Vector2>& second,
  const Brightness& brightness,
  double length,
  const Context& context);

} // namespace oversketch
#endif
