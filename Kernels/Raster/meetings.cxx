#include "Raster/meetings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace oversketch
{
namespace
{

constexpr double grid = 1048576.0; // places per px
constexpr int cellShift = 23;      // a cell of the search is 8 px

__extension__ using Wide = __int128;

struct Node
{
  std::int64_t x, y;
  bool operator==(const Node& other) const { return this->x == other.x && this->y == other.y; }
};

struct Segment
{
  Node a, b;
  int curve, number; // the number is its first point's
  int place;         // among the curve's segments that have a length
  int count;         // of these; negative where the curve is open
  bool nodeA, nodeB; // that its ends are nodes
};

// Sign of twice the area of a triangle.
int side(const Node& a, const Node& b, const Node& c)
{
  const Wide area = static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
  return (area > 0) - (area < 0);
}

bool within(const Node& a, const Node& b, const Node& p)
{
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(const Segment& s, const Segment& t)
{
  const int a = side(s.a, s.b, t.a), b = side(s.a, s.b, t.b);
  const int c = side(t.a, t.b, s.a), d = side(t.a, t.b, s.b);
  if (a * b < 0 && c * d < 0)
  {
    return true;
  }
  return (a == 0 && within(s.a, s.b, t.a)) || (b == 0 && within(s.a, s.b, t.b)) ||
         (c == 0 && within(t.a, t.b, s.a)) || (d == 0 && within(t.a, t.b, s.b));
}

// Two segments with a node of both curves in common meet only if they run over each other from there.
bool meetBesideNodes(const Segment& s, const Segment& t)
{
  for (const bool first : { true, false })
  {
    for (const bool second : { true, false })
    {
      const Node &p = first ? s.a : s.b, &q = second ? t.a : t.b;
      if (p == q && (first ? s.nodeA : s.nodeB) && (second ? t.nodeA : t.nodeB))
      {
        const Node &u = first ? s.b : s.a, &v = second ? t.b : t.a;
        const Wide along =
          static_cast<Wide>(u.x - p.x) * (v.x - p.x) + static_cast<Wide>(u.y - p.y) * (v.y - p.y);
        return side(p, u, v) == 0 && along > 0;
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
  return side(s.a, s.b, t.b) == 0 && along < 0;
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
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Polyline& points = curves[c].points;
    const int count = static_cast<int>(points.size());
    const auto node = [&](int i) {
      return Node{ std::llround(points[i % count][0] * grid), std::llround(points[i % count][1] * grid) };
    };
    const std::vector<int>& nodes = curves[c].nodes;
    const auto isNode = [&](int i) { return std::binary_search(nodes.begin(), nodes.end(), i); };
    const std::size_t first = segments.size();
    for (int i = 0; i < (curves[c].closed ? count : count - 1); ++i)
    {
      const Segment segment{ node(i),
        node(i + 1),
        static_cast<int>(c),
        i,
        static_cast<int>(segments.size() - first),
        0,
        isNode(i),
        isNode((i + 1) % count) };
      if (!(segment.a == segment.b))
      {
        segments.push_back(segment);
      }
    }
    const int kept = static_cast<int>(segments.size() - first);
    for (std::size_t i = first; i < segments.size(); ++i)
    {
      segments[i].count = curves[c].closed ? kept : -kept;
    }
  }
  context.checkpoint(0.0);

  // Segments by the cells that their boxes touch; two are compared in the first cell that both touch.
  struct Entry
  {
    std::int64_t cell;
    int segment;
    bool operator<(const Entry& other) const
    {
      return this->cell != other.cell ? this->cell < other.cell : this->segment < other.segment;
    }
  };
  const auto cells = [](const Segment& s)
  {
    return std::array<std::int64_t, 4>{ std::min(s.a.x, s.b.x) >> cellShift,
      std::min(s.a.y, s.b.y) >> cellShift,
      std::max(s.a.x, s.b.x) >> cellShift,
      std::max(s.a.y, s.b.y) >> cellShift };
  };
  constexpr std::int64_t stride = std::int64_t(1) << 24;
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const auto [x0, y0, x1, y1] = cells(segments[i]);
    for (std::int64_t y = y0; y <= y1; ++y)
    {
      for (std::int64_t x = x0; x <= x1; ++x)
      {
        entries.push_back({ y * stride + x, static_cast<int>(i) });
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end)
  {
    for (end = begin; end < entries.size() && entries[end].cell == entries[begin].cell; ++end)
    {
    }
    if (end - begin > 1000) // a cell full of scribble takes time
    {
      context.checkpoint(static_cast<double>(begin) / static_cast<double>(entries.size()));
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      const Segment& s = segments[entries[i].segment];
      const auto sc = cells(s);
      for (std::size_t j = i + 1; j < end; ++j)
      {
        const Segment& t = segments[entries[j].segment];
        const auto tc = cells(t);
        if (std::max(sc[1], tc[1]) * stride + std::max(sc[0], tc[0]) == entries[begin].cell &&
            (s.curve == t.curve ? meetOnOne(s, t) : meetBesideNodes(s, t)))
        {
          note(s, t);
          note(t, s);
        }
      }
    }
  }
}

} // namespace

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
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }
  return found;
}

} // namespace oversketch
