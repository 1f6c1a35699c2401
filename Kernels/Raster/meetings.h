// Where strokes cross, touch or run over each other or themselves.
#ifndef oversketch_kernels_raster_meetings_h
#define oversketch_kernels_raster_meetings_h

#include "Mesh/context.h"
#include "Stroke/polyline.h"

namespace oversketch
{

struct PlaneCurve
{
  Polyline points;
  bool closed = false; // the first point is not repeated
  // Of its points, ascending: where another curve has one, too, they do not meet by that alone.
  std::vector<int> nodes = {};
};

// Of each curve, the first segment of its own (from that point to the next) at which it meets another one or
// itself, and which curve it meets there, of several the least; -1 for one that meets nothing. Points that
// two neighbouring segments of a curve share are no meeting; running straight back is.
struct Meeting
{
  int segment = -1;
  int other = -1; // the curve's own number where it meets itself
};

// Curves in px, each coordinate under 1e6 in size: they are rounded to 2^-20 px, and what is said of the
// rounded ones is exact. The same in any order and direction of the curves, up to numbering.
std::vector<Meeting> meetings(const std::vector<PlaneCurve>& curves, const Context& context);

// Of each curve, all of its segments that meet another one or itself, ascending.
std::vector<std::vector<int>> meetingSegments(const std::vector<PlaneCurve>& curves, const Context& context);

} // namespace oversketch
#endif
