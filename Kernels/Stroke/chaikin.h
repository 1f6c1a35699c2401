// Corners cut off a polyline.
#ifndef oversketch_kernels_stroke_chaikin_h
#define oversketch_kernels_stroke_chaikin_h

#include "Stroke/polyline.h"

namespace oversketch
{

// One pass of Chaikin's scheme over `count` points: where the points of the result lie on those given, a
// quarter and three quarters along each segment. An open polyline keeps its ends and gets 2 (count - 1)
// points, a closed one (its first point not repeated) 2 count. Fewer than two points stay as they are.
std::vector<Blend> chaikinPass(int count, bool closed);

// Whether a stroke comes back to its start: three samples or more, the ends nearer than `gap` [px]; and, so
// that a hook of a few pixels is not taken for a ring, nearer than half the length of the stroke.
bool comesBack(const Polyline& samples, double gap);

} // namespace oversketch
#endif
