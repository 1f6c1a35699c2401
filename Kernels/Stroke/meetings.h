// Where lines in the plane meet: segments that are near each other, places whose predicates are exact, what
// crosses.
#ifndef oversketch_kernels_stroke_meetings_h
#define oversketch_kernels_stroke_meetings_h

#include "Mesh/context.h"
#include "Stroke/polyline.h"

#include <array>
#include <cstdint>
#include <optional>

namespace oversketch
{

// Calls visit(i, j) for each two segments i < j whose boxes touch, ascending. Ends are finite. Throws
// Error(Failure::Cancelled) when cancelled.
using SegmentEnds = std::array<Vector2, 2>;
void forEachNear(const std::vector<SegmentEnds>& segments,
  const std::function<void(int, int)>& visit,
  const Context& context = {});

// ---- Exactly

// A place on a grid so fine that rounding to it moves nothing that is seen; fields under 2^40 in size, so
// that areas of triangles are exact in 128 bits.
struct GridPlace
{
  std::int64_t x = 0, y = 0;

  bool operator==(const GridPlace& other) const { return this->x == other.x && this->y == other.y; }
  bool operator<(const GridPlace& other) const
  {
    return this->x != other.x ? this->x < other.x : this->y < other.y;
  }
  Vector2 vector() const { return { static_cast<double>(this->x), static_cast<double>(this->y) }; }
};

constexpr double placesPerPixel = 1048576.0;
GridPlace onGrid(const Vector2& pixels);

__extension__ using Wide = __int128;

// Twice the area of a triangle, negative where it turns right, and its sign.
Wide twiceArea(const GridPlace& a, const GridPlace& b, const GridPlace& c);
int turnOf(const GridPlace& a, const GridPlace& b, const GridPlace& c);

// Whether p lies in the box of a and b.
bool isWithin(const GridPlace& a, const GridPlace& b, const GridPlace& p);

struct PlaneCurve
{
  Polyline points;
  bool closed = false; // the first point is not repeated
  // Numbers of its points, ascending: where another curve has one, too, they do not meet by that alone.
  std::vector<int> nodes = {};
};

// First segment of each curve (from that point to the next) at which it meets another one or itself, and
// which curve it meets there, of several the least; -1 for one that meets nothing. Points that two
// neighbouring segments of a curve share are no meeting; running straight back is.
struct Meeting
{
  int segment = -1;
  int other = -1; // the curve's own number where it meets itself
};

// Curves in px, each coordinate under 1e6 in size: they are rounded to 2^-20 px, and what is said of the
// rounded ones is exact. The same in any order and direction of the curves, up to numbering.
std::vector<Meeting> meetings(const std::vector<PlaneCurve>& curves, const Context& context);

// All segments of each curve that meet another one or itself, ascending.
std::vector<std::vector<int>> meetingSegments(const std::vector<PlaneCurve>& curves, const Context& context);

// ---- Crossings alone: a segment whose end lies exactly on another crosses it if it does so after an
// infinitesimal shift, so a polyline that crosses another in a point of its own does it once.

// A polyline's segment on the image plane, from point `first` to point `second` of a curve.
struct ImageSegment
{
  int curve, first, second;
  Vector2 from, to;
};

// Where a segment is crossed: at from + place * (to - from), place in [0, 1].
struct Crossing
{
  int segment;
  double place;
};

// All crossings of segments that share no point, two entries for each, ascending by segment and place.
std::vector<Crossing> findCrossings(const std::vector<ImageSegment>& segments, const Context& context = {});

// The first place at which an open line crosses itself with a loop between of at least this length, since a
// hand that trembles draws smaller ones. Going straight back is no crossing.
std::optional<Vector2> selfCrossing(const Polyline& line, double leastLoop);

} // namespace oversketch
#endif
