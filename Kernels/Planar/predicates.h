// Signs of areas and circles in the plane, exact for any finite coordinates.
#ifndef oversketch_kernels_planar_predicates_h
#define oversketch_kernels_planar_predicates_h

#include "Mesh/mesh.h"

namespace oversketch
{

// 1 when a, b, c turn left, -1 when right, 0 when they lie on a line.
int orientation(const Vector2& a, const Vector2& b, const Vector2& c);

// 1 when d lies inside the circle through a, b, c, which turn left, -1 outside, 0 on it.
int inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d);

// Whether c, on the line through a and b, lies between them, neither of them.
bool between(const Vector2& a, const Vector2& b, const Vector2& c);

// Whether two segments cross, touch or run over each other. A point that is an end of both does not count,
// running over each other from there does.
bool segmentsMeet(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d);

} // namespace oversketch
#endif
