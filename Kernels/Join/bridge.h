// A bar between two bodies that do not meet.
#ifndef oversketch_kernels_join_bridge_h
#define oversketch_kernels_join_bridge_h

#include "Join/body.h"
#include "Mesh/context.h"

namespace oversketch
{

// A round bar of a thickness [model length] about the shortest way from the one to the other, which ends as
// far inside either as it is thick. Its triangles lie where the way ends, those nearer to the second body on
// that; its part is bridgePart.
Body barBetween(const Body& first, const Body& second, double thickness, const Context& context);

} // namespace oversketch
#endif
