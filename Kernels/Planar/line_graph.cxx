#include "Planar/line_graph.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

// Whether a direction from `from` is in the lower half of the turn that begins along x.
bool lower(const GridPlace& from, const GridPlace& to)
{
  return to.y != from.y ? to.y < from.y : to.x < from.x;
}

} // namespace

double apart(const GridPlace& a, const GridPlace& b)
{
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

double PlacePath::length(const std::vector<GridPlace>& places) const
{
  double length = 0.0;
  for (int i = 0; i < this->segments(); ++i)
  {
    length += apart(places[this->from(i)], places[this->to(i)]);
  }
  return length;
}

LineGraph::LineGraph(const std::vector<GridPlace>& places, const std::vector<PlacePath>& paths)
  : Places(places)
  , Around(places.size())
{
  for (const PlacePath& path : paths)
  {
    for (int i = 0; i < path.segments(); ++i)
    {
      const int from = path.from(i), to = path.to(i);
      this->Edges.push_back({ std::min(from, to), std::max(from, to) });
    }
  }
  sortUnique(this->Edges);
  this->Gone.assign(this->Edges.size(), 0);
  for (int e = 0; e < this->edgeCount(); ++e)
  {
    for (const int place : this->Edges[e])
    {
      this->Around[place].push_back(e);
    }
  }
}

int LineGraph::edgeBetween(int a, int b) const
{
  for (const int e : this->Around[a])
  {
    if (this->other(e, a) == b)
    {
      return e;
    }
  }
  return -1;
}

double LineGraph::length(const std::vector<int>& edges) const
{
  double length = 0.0;
  for (const int edge : edges)
  {
    length += apart(this->Places[this->Edges[edge][0]], this->Places[this->Edges[edge][1]]);
  }
  return length;
}

void LineGraph::remove(int edge)
{
  this->Gone[edge] = 1;
  for (const int place : this->Edges[edge])
  {
    std::vector<int>& around = this->Around[place];
    around.erase(std::find(around.begin(), around.end(), edge));
  }
}

std::vector<int> LineGraph::chain(int edge, int place) const
{
  std::vector<int> edges{ edge };
  for (int at = this->other(edge, place); at != place && this->degree(at) == 2;)
  {
    const std::vector<int>& around = this->Around[at];
    edges.push_back(around[0] == edges.back() ? around[1] : around[0]);
    at = this->other(edges.back(), at);
  }
  return edges;
}

std::vector<LineGraph::Walk> LineGraph::walks(const std::vector<char>& left,
  std::vector<std::array<int, 2>>& ofEdge) const
{
  const auto stays = [&](int edge) { return !this->Gone[edge] && !(edge < int(left.size()) && left[edge]); };
  // Edges round each place, counter-clockwise.
  std::vector<std::vector<int>> turns(this->Around.size());
  for (std::size_t p = 0; p < turns.size(); ++p)
  {
    std::copy_if(this->Around[p].begin(), this->Around[p].end(), std::back_inserter(turns[p]), stays);
    const GridPlace& from = this->Places[p];
    std::sort(turns[p].begin(),
      turns[p].end(),
      [&](int e, int f)
      {
        const GridPlace& a = this->Places[this->other(e, static_cast<int>(p))];
        const GridPlace& b = this->Places[this->other(f, static_cast<int>(p))];
        const bool lowA = lower(from, a), lowB = lower(from, b);
        return lowA != lowB ? lowB : turnOf(from, a, b) > 0;
      });
  }
  ofEdge.assign(this->Edges.size(), { -1, -1 });
  std::vector<Walk> found;
  for (int first = 0; first < this->edgeCount(); ++first)
  {
    for (const int way : { 0, 1 })
    {
      if (!stays(first) || ofEdge[first][way] >= 0)
      {
        continue;
      }
      const int number = static_cast<int>(found.size());
      Walk walk;
      Wide area = 0;
      int edge = first, from = this->Edges[first][way];
      const GridPlace& origin = this->Places[from];
      do
      {
        ofEdge[edge][from == this->Edges[edge][0] ? 0 : 1] = number;
        const int to = this->other(edge, from);
        walk.places.push_back(from);
        walk.edges.push_back(edge);
        area += twiceArea(origin, this->Places[from], this->Places[to]);
        const std::vector<int>& around = turns[to];
        const auto back = std::find(around.begin(), around.end(), edge);
        edge = back == around.begin() ? around.back() : *(back - 1);
        from = to;
      } while (edge != first || from != this->Edges[first][way]);
      walk.area = static_cast<double>(area);
      found.push_back(std::move(walk));
    }
  }
  return found;
}

} // namespace oversketch
