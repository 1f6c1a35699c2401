// Closed parts of a mesh as one closed body.
#ifndef oversketch_kernels_join_join_h
#define oversketch_kernels_join_join_h

#include "Join/seam.h"

namespace oversketch
{

struct JoinOptions
{
  JoinKind kind = JoinKind::Join;
  double width = 0.0;  // of the seam [model length]; 0 is a crease
  bool bridge = false; // parts that do not meet are joined by a bar as thick as the seam is wide
};

// Joins, cuts or intersects parts of a mesh, in the order of their numbers; of what is cut away from, the
// first one. Parts that touch within 2.5e-7 of the diagonal of the box round all of them meet.
//
// No faces go through each other afterwards that did not before: what rounding leaves is taken out at 1e-6 of
// that diagonal, and where that does not do at other sizes. Throws Error(BadMesh) as unite does and where
// parts do not meet, are one, or nothing is left; Error(Torn) where faces still go through each other;
// Error(BadRegion) as roundSeam does.
Joined join(const JoinInput& input, const JoinOptions& options, const Context& context = Context());

} // namespace oversketch
#endif
