#include "Stroke/meetings.h"

#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr int mostCells = 256; // along a side of the grid

// A uniform grid of the segments. What lies far outside the middle of the picture, as perspective can throw
// it, falls into the cells of the rim.
struct NearGrid
{
  Vector2 origin = Vector2::Zero(), perUnit = Vector2::Zero();
  int side;

  explicit NearGrid(const std::vector<SegmentEnds>& segments)
    : side(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(segments.size()))), 1, mostCells))
  {
    for (int k = 0; k < 2; ++k)
    {
      auto values = mapped(segments, [k](const SegmentEnds& s) { return s[0][k]; });
      // The middle 98 % decide.
      const auto rank = [&](double share)
      {
        const auto at =
          values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), at, values.end());
        return *at;
      };
      const double low = rank(0.01), high = rank(0.99);
      this->origin[k] = low;
      this->perUnit[k] = high > low ? this->side / (high - low) : 0.0;
    }
  }

  int along(double value, int k) const
  {
    const double place = (value - this->origin[k]) * this->perUnit[k];
    return place <= 0.0 ? 0 : place >= this->side - 1 ? this->side - 1 : static_cast<int>(place);
  }
  int cell(const Vector2& place) const
  {
    return this->along(place[1], 1) * this->side + this->along(place[0], 0);
  }

  template <typename Visit>
  void forEachCell(const Eigen::AlignedBox2d& box, const Visit& visit) const
  {
    const int x0 = this->along(box.min()[0], 0), x1 = this->along(box.max()[0], 0);
    const int y0 = this->along(box.min()[1], 1), y1 = this->along(box.max()[1], 1);
    for (int y = y0; y <= y1; ++y)
    {
      for (int x = x0; x <= x1; ++x)
      {
        visit(y * this->side + x);
      }
    }
  }
};

struct Segment
{
  GridPlace a, b;
  int curve, number; // the number is its first point's
  int place;         // among the curve's segments that have a length
  int count;         // of these; negative where the curve is open
  bool nodeA, nodeB; // that its ends are nodes
};

bool meet(const Segment& s, const Segment& t)
{
  const int a = turnOf(s.a, s.b, t.a), b = turnOf(s.a, s.b, t.b);
  const int c = turnOf(t.a, t.b, s.a), d = turnOf(t.a, t.b, s.b);
  if (a * b < 0 && c * d < 0)
  {
    return true;
  }
  return (a == 0 && isWithin(s.a, s.b, t.a)) || (b == 0 && isWithin(s.a, s.b, t.b)) ||
         (c == 0 && isWithin(t.a, t.b, s.a)) || (d == 0 && isWithin(t.a, t.b, s.b));
}

// Two segments with a node of both curves in common meet only if they run over each other from there.
bool meetBesideNodes(const Segment& s, const Segment& t)
{
  for (const bool first : { true, false })
  {
    for (const bool second : { true, false })
    {
      const GridPlace &p = first ? s.a : s.b, &q = second ? t.a : t.b;
      if (p == q && (first ? s.nodeA : s.nodeB) && (second ? t.nodeA : t.nodeB))
      {
        const GridPlace &u = first ? s.b : s.a, &v = second ? t.b : t.a;
        const Wide along =
          static_cast<Wide>(u.x - p.x) * (v.x - p.x) + static_cast<Wide>(u.y - p.y) * (v.y - p.y);
        return turnOf(p, u, v) == 0 && along > 0;
      }
    }
  }
  return meet(s, t);
}

// t follows s on the same curve, s.b == t.a: whether it runs back.
bool back(const Segment& s, const Segment& t)
{
  const Wide along =
    static_cast<Wide>(s.b.x - s.a.x) * (t.b.x - t.a.x) + static_cast<Wide>(s.b.y - s.a.y) * (t.b.y - t.a.y);
  return turnOf(s.a, s.b, t.b) == 0 && along < 0;
}

bool meetOnOne(const Segment& s, const Segment& t)
{
  const bool closed = s.count > 0;
  const bool next = t.place == s.place + 1 || (closed && s.place == s.count - 1 && t.place == 0);
  const bool before = s.place == t.place + 1 || (closed && t.place == s.count - 1 && s.place == 0);
  if (next || before)
  {
    return (next && back(s, t)) || (before && back(t, s));
  }
  return meet(s, t);
}

// Calls note(s, t) for every two segments that meet, each way round.
template <typename Note>
void forEachMeeting(const std::vector<PlaneCurve>& curves, const Context& context, const Note& note)
{
  std::vector<Segment> segments;
  std::vector<SegmentEnds> ends;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Polyline& points = curves[c].points;
    const int count = static_cast<int>(points.size());
    const std::vector<int>& nodes = curves[c].nodes;
    const auto isNode = [&](int i) { return std::binary_search(nodes.begin(), nodes.end(), i); };
    const std::size_t first = segments.size();
    for (int i = 0; i < (curves[c].closed ? count : count - 1); ++i)
    {
      const int next = (i + 1) % count;
      const Segment segment{ onGrid(points[i]),
        onGrid(points[next]),
        static_cast<int>(c),
        i,
        static_cast<int>(segments.size() - first),
        0,
        isNode(i),
        isNode(next) };
      if (!(segment.a == segment.b))
      {
        segments.push_back(segment);
        ends.push_back({ segment.a.vector(), segment.b.vector() });
      }
    }
    const int kept = static_cast<int>(segments.size() - first);
    for (std::size_t i = first; i < segments.size(); ++i)
    {
      segments[i].count = curves[c].closed ? kept : -kept;
    }
  }
  context.checkpoint(0.0);
  forEachNear(
    ends,
    [&](int i, int j)
    {
      const Segment &s = segments[i], &t = segments[j];
      if (s.curve == t.curve ? meetOnOne(s, t) : meetBesideNodes(s, t))
      {
        note(s, t);
        note(t, s);
      }
    },
    context);
}

// A point on the line counts as left of it, so that a crossing at a point of a polyline is found, too.
bool isRight(const Vector2& a, const Vector2& b, const Vector2& p)
{
  return cross(b - a, p - a) < 0.0;
}

bool passesThrough(const SegmentEnds& s, const SegmentEnds& t)
{
  return isRight(s[0], s[1], t[0]) != isRight(s[0], s[1], t[1]) &&
         isRight(t[0], t[1], s[0]) != isRight(t[0], t[1], s[1]);
}

} // namespace

void forEachNear(const std::vector<SegmentEnds>& segments,
  const std::function<void(int, int)>& visit,
  const Context& context)
{
  if (segments.empty())
  {
    return;
  }
  const NearGrid grid(segments);
  const int count = static_cast<int>(segments.size());
  std::vector<Eigen::AlignedBox2d> boxes;
  std::vector<std::vector<int>> cells(grid.side * grid.side); // ascending segments
  for (int i = 0; i < count; ++i)
  {
    boxes.emplace_back(segments[i][0].cwiseMin(segments[i][1]), segments[i][0].cwiseMax(segments[i][1]));
    grid.forEachCell(boxes[i], [&](int cell) { cells[cell].push_back(i); });
  }
  std::vector<int> near;
  for (int i = 0; i < count; ++i)
  {
    if (i % 256 == 0 && context.cancelled())
    {
      throw Error(Failure::Cancelled, "cancelled");
    }
    near.clear();
    grid.forEachCell(boxes[i],
      [&](int cell)
      {
        const std::vector<int>& here = cells[cell];
        for (auto j = std::upper_bound(here.begin(), here.end(), i); j != here.end(); ++j)
        {
          // A pair belongs to the cell of the low corner of what their boxes share.
          if (boxes[i].intersects(boxes[*j]) && grid.cell(boxes[i].min().cwiseMax(boxes[*j].min())) == cell)
          {
            near.push_back(*j);
          }
        }
      });
    std::sort(near.begin(), near.end());
    std::for_each(near.begin(), near.end(), [&](int j) { visit(i, j); });
  }
}

GridPlace onGrid(const Vector2& pixels)
{
  return { std::llround(pixels[0] * placesPerPixel), std::llround(pixels[1] * placesPerPixel) };
}

Wide twiceArea(const GridPlace& a, const GridPlace& b, const GridPlace& c)
{
  return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
}

int turnOf(const GridPlace& a, const GridPlace& b, const GridPlace& c)
{
  const Wide area = twiceArea(a, b, c);
  return (area > 0) - (area < 0);
}

bool isWithin(const GridPlace& a, const GridPlace& b, const GridPlace& p)
{
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

std::vector<Meeting> meetings(const std::vector<PlaneCurve>& curves, const Context& context)
{
  std::vector<Meeting> found(curves.size());
  forEachMeeting(curves,
    context,
    [&](const Segment& s, const Segment& t)
    {
      Meeting& meeting = found[s.curve];
      if (meeting.segment < 0 || s.number < meeting.segment ||
          (s.number == meeting.segment && t.curve < meeting.other))
      {
        meeting = { s.number, t.curve };
      }
    });
  return found;
}

std::vector<std::vector<int>> meetingSegments(const std::vector<PlaneCurve>& curves, const Context& context)
{
  std::vector<std::vector<int>> found(curves.size());
  forEachMeeting(
    curves, context, [&](const Segment& s, const Segment&) { found[s.curve].push_back(s.number); });
  for (std::vector<int>& numbers : found)
  {
    sortUnique(numbers);
  }
  return found;
}

std::vector<Crossing> findCrossings(const std::vector<ImageSegment>& segments, const Context& context)
{
  const auto ends = mapped(segments, [](const ImageSegment& s) { return SegmentEnds{ s.from, s.to }; });
  std::vector<Crossing> crossings;
  forEachNear(
    ends,
    [&](int i, int j)
    {
      const ImageSegment &p = segments[i], &q = segments[j];
      const bool isBeside = p.curve == q.curve && (p.first == q.first || p.first == q.second ||
                                                    p.second == q.first || p.second == q.second);
      if (!isBeside && passesThrough(ends[i], ends[j]))
      {
        const Vector2 alongP = p.to - p.from, alongQ = q.to - q.from;
        const double q0 = cross(alongP, q.from - p.from), q1 = cross(alongP, q.to - p.from);
        const double p0 = cross(alongQ, p.from - q.from), p1 = cross(alongQ, p.to - q.from);
        crossings.push_back({ i, p0 / (p0 - p1) });
        crossings.push_back({ j, q0 / (q0 - q1) });
      }
    },
    context);
  std::sort(crossings.begin(),
    crossings.end(),
    [](const Crossing& a, const Crossing& b)
    { return a.segment != b.segment ? a.segment < b.segment : a.place < b.place; });
  return crossings;
}

std::optional<Vector2> selfCrossing(const Polyline& line, double leastLoop)
{
  const std::vector<double> lengths = arcLengths(line);
  std::vector<SegmentEnds> segments;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    segments.push_back({ line[i], line[i + 1] });
  }
  std::optional<Vector2> found;
  forEachNear(segments,
    [&](int i, int j)
    {
      if (!found && j > i + 1 && lengths[j] - lengths[i + 1] >= leastLoop &&
          passesThrough(segments[i], segments[j]))
      {
        const auto& [a, b] = segments[i];
        const Vector2 &c = segments[j][0], along = segments[j][1] - c;
        found = a + cross(c - a, along) / cross(b - a, along) * (b - a);
      }
    });
  return found;
}

} // namespace oversketch
