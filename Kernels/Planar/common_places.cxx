#include "Planar/common_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace oversketch
{
namespace
{

constexpr int mostRounds = 32;   // a crossing's place is rounded, which may make another one: seldom twice
constexpr double farAlong = 3.0; // reaches along a stroke: what its own end may go on to

struct Segment
{
  int from, to, path, number;
  std::int64_t least; // x
};

class Noding
{
public:
  Noding(const Frame& frame, const std::vector<DrawnStroke>& strokes, double reach, const Context& context)
    : Raster(frame)
    , Strokes(strokes)
    , Reach(reach * placesPerPixel)
    , Progress(context)
  {
  }

  CommonPlaces run()
  {
    this->read();
    this->node();
    this->Progress.checkpoint(0.4);
    this->joinEnds();
    this->node();
    return {
      std::move(this->Places), std::move(this->World), std::move(this->Paths), std::move(this->PathOf)
    };
  }

private:
  int placeNumber(const GridPlace& place, const Vector2& world)
  {
    const auto [at, isNew] = this->Numbers.emplace(place, static_cast<int>(this->Places.size()));
    if (isNew)
    {
      this->Places.push_back(place);
      this->World.push_back(world);
    }
    else
    {
      Vector2& known = this->World[at->second];
      known = std::make_pair(world[0], world[1]) < std::make_pair(known[0], known[1]) ? world : known;
    }
    return at->second;
  }

  void read()
  {
    this->PathOf.assign(this->Strokes.size(), -1);
    for (std::size_t i = 0; i < this->Strokes.size(); ++i)
    {
      const DrawnStroke& stroke = this->Strokes[i];
      const Polyline pixels = onRaster(this->Raster, stroke.points);
      PlacePath path{ {}, stroke.closed };
      for (std::size_t k = 0; k < pixels.size(); ++k)
      {
        path.at.push_back(this->placeNumber(onGrid(pixels[k]), stroke.points[k]));
      }
      withoutRepeats(path);
      if (std::set<int>(path.at.begin(), path.at.end()).size() >= (stroke.closed ? 3u : 2u))
      {
        this->PathOf[i] = static_cast<int>(this->Paths.size());
        this->Paths.push_back(std::move(path));
      }
    }
  }

  static void withoutRepeats(PlacePath& path)
  {
    path.at.erase(std::unique(path.at.begin(), path.at.end()), path.at.end());
    while (path.closed && path.at.size() > 1 && path.at.front() == path.at.back())
    {
      path.at.pop_back();
    }
  }

  void node()
  {
    for (int round = 0; round < mostRounds; ++round)
    {
      if (!this->insertMeetings())
      {
        return;
      }
    }
    throw Error(
      Failure::BadStroke, "the strokes run over each other again and again; draw fewer over one place");
  }

  std::vector<Segment> segments() const
  {
    std::vector<Segment> found;
    for (std::size_t p = 0; p < this->Paths.size(); ++p)
    {
      const PlacePath& path = this->Paths[p];
      for (int i = 0; i < path.segments(); ++i)
      {
        const int from = path.from(i), to = path.to(i);
        found.push_back(
          { from, to, static_cast<int>(p), i, std::min(this->Places[from].x, this->Places[to].x) });
      }
    }
    std::stable_sort(
      found.begin(), found.end(), [](const Segment& s, const Segment& t) { return s.least < t.least; });
    return found;
  }

  // Puts the places where segments meet into both. Whether there were any.
  bool insertMeetings()
  {
    const std::vector<Segment> all = this->segments();
    std::map<std::pair<int, int>, std::vector<int>> more; // by path and segment
    const auto insert = [&](const Segment& s, int place)
    {
      if (place != s.from && place != s.to)
      {
        more[{ s.path, s.number }].push_back(place);
      }
    };
    const auto ends = mapped(all,
      [this](const Segment& s) {
        return SegmentEnds{ this->Places[s.from].vector(), this->Places[s.to].vector() };
      });
    this->Progress.checkpoint(0.1);
    forEachNear(
      ends, [&](int i, int j) { this->meet(all[i], all[j], insert); }, this->Progress);
    for (auto& [which, places] : more)
    {
      const PlacePath& path = this->Paths[which.first];
      const GridPlace from = this->Places[path.from(which.second)];
      std::sort(places.begin(),
        places.end(),
        [&](int a, int b)
        {
          return std::make_pair(apart(from, this->Places[a]), a) <
                 std::make_pair(apart(from, this->Places[b]), b);
        });
    }
    for (std::size_t p = 0; p < this->Paths.size(); ++p)
    {
      PlacePath& path = this->Paths[p];
      PlacePath longer{ {}, path.closed };
      for (int i = 0; i < static_cast<int>(path.at.size()); ++i)
      {
        longer.at.push_back(path.at[i]);
        const auto places = more.find({ static_cast<int>(p), i });
        if (places != more.end())
        {
          longer.at.insert(longer.at.end(), places->second.begin(), places->second.end());
        }
      }
      withoutRepeats(longer);
      path = std::move(longer);
    }
    return !more.empty();
  }

  template <typename Insert>
  void meet(const Segment& s, const Segment& t, const Insert& insert)
  {
    const GridPlace a = this->Places[s.from], b = this->Places[s.to];
    const GridPlace c = this->Places[t.from], d = this->Places[t.to];
    const int toC = turnOf(a, b, c), toD = turnOf(a, b, d), toA = turnOf(c, d, a), toB = turnOf(c, d, b);
    if (toC * toD < 0 && toA * toB < 0)
    {
      const int place = this->crossing(s, t);
      insert(s, place);
      insert(t, place);
      return;
    }
    const auto onto = [&](const Segment& on, int place, int turn)
    {
      if (turn == 0 && isWithin(this->Places[on.from], this->Places[on.to], this->Places[place]))
      {
        insert(on, place);
      }
    };
    onto(s, t.from, toC);
    onto(s, t.to, toD);
    onto(t, s.from, toA);
    onto(t, s.to, toB);
  }

  // Finds the same whichever comes first and wherever they come from.
  int crossing(const Segment& s, const Segment& t)
  {
    const auto ascending = [&](const Segment& which)
    { return std::minmax(this->Places[which.from], this->Places[which.to]); };
    std::pair<GridPlace, GridPlace> one = ascending(s), two = ascending(t);
    if (two < one)
    {
      std::swap(one, two);
    }
    const auto [a, b] = one;
    const auto [c, d] = two;
    const auto product = [](std::int64_t ux, std::int64_t uy, std::int64_t vx, std::int64_t vy)
    { return static_cast<double>(static_cast<Wide>(ux) * vy - static_cast<Wide>(uy) * vx); };
    const double along = product(c.x - a.x, c.y - a.y, d.x - c.x, d.y - c.y) /
                         product(b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y);
    const GridPlace place{ a.x + std::llround(along * static_cast<double>(b.x - a.x)),
      a.y + std::llround(along * static_cast<double>(b.y - a.y)) };
    return this->placeNumber(place, this->Raster.toWorld(place.vector() / placesPerPixel));
  }

  struct Join
  {
    double distance;
    int path, end, target;
    bool last;
  };

  // Whether an end is so far from all that its stroke meets that it has not been drawn up to something.
  bool isFree(const LineGraph& graph, const PlacePath& path, bool last) const
  {
    const int count = static_cast<int>(path.at.size());
    double length = 0.0;
    for (int i = 0; i < count && length < this->Reach; ++i)
    {
      const int at = path.at[last ? count - 1 - i : i];
      if (i == 0 ? graph.degree(at) != 1 : graph.degree(at) > 2)
      {
        return false;
      }
      const int next = last ? count - 2 - i : i + 1;
      length += next >= 0 && next < count ? apart(this->Places[at], this->Places[path.at[next]]) : 0.0;
    }
    return true;
  }

  Join joinOf(int number, bool last) const
  {
    const PlacePath& path = this->Paths[number];
    const int end = last ? path.at.back() : path.at.front();
    const GridPlace& from = this->Places[end];
    Join best{ std::min(this->Reach, arrangeShare * path.length(this->Places)), number, end, -1, last };
    const auto offer = [&](int place)
    {
      const double distance = apart(from, this->Places[place]);
      const bool nearer = best.target < 0 ? distance <= best.distance
                                          : std::make_pair(distance, this->Places[place]) <
                                              std::make_pair(best.distance, this->Places[best.target]);
      if (place != end && nearer)
      {
        best.distance = distance;
        best.target = place;
      }
    };
    for (std::size_t p = 0; p < this->Paths.size(); ++p)
    {
      if (static_cast<int>(p) != number)
      {
        std::for_each(this->Paths[p].at.begin(), this->Paths[p].at.end(), offer);
      }
    }
    const int count = static_cast<int>(path.at.size());
    double along = 0.0;
    for (int i = 1; i < count; ++i)
    {
      const int at = path.at[last ? count - 1 - i : i];
      along += apart(this->Places[at], this->Places[path.at[last ? count - i : i - 1]]);
      if (along > farAlong * this->Reach)
      {
        offer(at);
      }
    }
    return best;
  }

  void joinEnds()
  {
    const LineGraph graph(this->Places, this->Paths);
    std::vector<Join> joins;
    for (std::size_t p = 0; p < this->Paths.size(); ++p)
    {
      for (const bool last : { false, true })
      {
        if (!this->Paths[p].closed && this->isFree(graph, this->Paths[p], last))
        {
          const Join join = this->joinOf(static_cast<int>(p), last);
          if (join.target >= 0)
          {
            joins.push_back(join);
          }
        }
      }
    }
    std::sort(joins.begin(),
      joins.end(),
      [&](const Join& a, const Join& b)
      {
        return std::make_tuple(a.distance, this->Places[a.end], this->Places[a.target]) <
               std::make_tuple(b.distance, this->Places[b.end], this->Places[b.target]);
      });
    std::set<int> joined;
    for (const Join& join : joins)
    {
      if (joined.count(join.end) == 0)
      {
        std::vector<int>& at = this->Paths[join.path].at;
        at.insert(join.last ? at.end() : at.begin(), join.target);
        joined.insert({ join.end, join.target });
      }
    }
  }

  const Frame& Raster;
  const std::vector<DrawnStroke>& Strokes;
  double Reach; // on the grid
  const Context& Progress;

  std::map<GridPlace, int> Numbers;
  std::vector<GridPlace> Places;
  Polyline World; // of each place
  std::vector<PlacePath> Paths;
  std::vector<int> PathOf; // of each stroke
};

} // namespace

CommonPlaces commonPlaces(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double reach,
  const Context& context)
{
  return Noding(frame, strokes, reach, context).run();
}

} // namespace oversketch
