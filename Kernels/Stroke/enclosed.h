// Places of the picture that a lasso encloses.
#ifndef oversketch_kernels_stroke_enclosed_h
#define oversketch_kernels_stroke_enclosed_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// 1 for each place [px] within the lasso, which its last and first sample close by a straight line; on it is
// within. Of one that crosses itself a place is within where a line outwards meets it an odd number of times.
// Lasso and places are rounded to floats. Throws Error(Failure::Cancelled).
std::vector<char> enclosedBy(const std::vector<Vector2>& lasso,
  const std::vector<Vector2>& places,
  const Context& context = Context());

} // namespace oversketch
#endif
