// Where a line in the plane crosses itself.
#ifndef oversketch_kernels_stroke_self_crossing_h
#define oversketch_kernels_stroke_self_crossing_h

#include "Stroke/polyline.h"

#include <optional>

namespace oversketch
{

// The first place at which an open line crosses itself with a loop between of at least this length, since a
// hand that trembles draws smaller ones. Going straight back is no crossing. Takes time by the square of the
// number of points.
std::optional<Vector2> selfCrossing(const Polyline& line, double leastLoop);

} // namespace oversketch
#endif
