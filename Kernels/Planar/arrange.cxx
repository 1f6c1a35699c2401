#include "Planar/arrange.h"

#include "Planar/common_places.h"

#include <algorithm>
#include <set>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double faceShare = 0.25; // of reach squared: smaller faces are joined

class Arrangement
{
public:
  Arrangement(const Frame& frame,
    const std::vector<DrawnStroke>& strokes,
    double reach,
    const Context& context)
    : Raster(frame)
    , Strokes(strokes)
    , Reach(reach * placesPerPixel)
    , Progress(context)
  {
  }

  std::vector<ArrangedCurve> run()
  {
    CommonPlaces common =
      commonPlaces(this->Raster, this->Strokes, this->Reach / placesPerPixel, this->Progress);
    this->Places = std::move(common.places);
    this->World = std::move(common.world);
    this->Paths = std::move(common.paths);
    this->PathOf = std::move(common.pathOf);
    this->Progress.checkpoint(0.7);
    LineGraph graph(this->Places, this->Paths);
    this->joinFaces(graph);
    this->Progress.checkpoint(0.9);
    this->findRings(graph);
    return this->curves(graph);
  }

private:
  // Takes ends away that run past what they meet.
  void cutEnds(LineGraph& graph) const
  {
    std::vector<double> strokeLength(graph.edgeCount(), 0.0); // of an edge's longest stroke
    for (const PlacePath& path : this->Paths)
    {
      const double length = path.length(this->Places);
      for (int i = 0; i < path.segments(); ++i)
      {
        const int edge = graph.edgeBetween(path.from(i), path.to(i));
        if (edge >= 0)
        {
          strokeLength[edge] = std::max(strokeLength[edge], length);
        }
      }
    }
    for (bool cut = true; cut;)
    {
      std::vector<int> ends;
      for (int edge = 0; edge < graph.edgeCount(); ++edge)
      {
        for (const int place : graph.ends(edge))
        {
          if (!graph.has(edge) || graph.degree(place) != 1)
          {
            continue;
          }
          const std::vector<int> chain = graph.chain(edge, place);
          const double length = graph.length(chain);
          int at = place;
          for (const int one : chain)
          {
            at = graph.other(one, at);
          }
          if (graph.degree(at) > 2 && length < this->Reach && length < arrangeShare * strokeLength[edge])
          {
            ends.insert(ends.end(), chain.begin(), chain.end());
          }
        }
      }
      std::for_each(ends.begin(), ends.end(), [&](int edge) { graph.remove(edge); });
      cut = !ends.empty();
    }
  }

  // The longest curve round a face that has another face beyond; none of a closed curve alone.
  std::vector<int> longestCurve(const LineGraph& graph,
    const LineGraph::Walk& walk,
    const std::vector<std::array<int, 2>>& ofEdge) const
  {
    std::vector<int> best;
    double most = 0.0;
    int nodes = 0;
    for (std::size_t i = 0; i < walk.places.size(); ++i)
    {
      const int place = walk.places[i], edge = walk.edges[i];
      if (graph.degree(place) < 3)
      {
        continue;
      }
      ++nodes;
      const std::vector<int> chain = graph.chain(edge, place);
      const double length = graph.length(chain);
      const bool isLess = !best.empty() && length == most && chain.front() < best.front();
      if (ofEdge[edge][0] != ofEdge[edge][1] && (length > most || isLess))
      {
        most = length;
        best = chain;
      }
    }
    return nodes > 1 ? best : std::vector<int>();
  }

  void joinFaces(LineGraph& graph) const
  {
    for (bool joined = true; joined;)
    {
      this->cutEnds(graph);
      std::vector<std::array<int, 2>> ofEdge;
      const std::vector<LineGraph::Walk> walks = graph.walks({}, ofEdge);
      std::vector<int> small;
      for (std::size_t w = 0; w < walks.size(); ++w)
      {
        if (walks[w].area > 0.0 && 0.5 * walks[w].area < faceShare * this->Reach * this->Reach)
        {
          small.push_back(static_cast<int>(w));
        }
      }
      const auto least = [&](int w)
      {
        GridPlace place = this->Places[walks[w].places[0]];
        for (const int one : walks[w].places)
        {
          place = std::min(place, this->Places[one]);
        }
        return std::make_pair(walks[w].area, place);
      };
      std::sort(small.begin(), small.end(), [&](int a, int b) { return least(a) < least(b); });
      std::vector<char> changed(walks.size(), 0);
      joined = false;
      std::vector<int> gone;
      for (const int face : small)
      {
        const std::vector<int> curve = this->longestCurve(graph, walks[face], ofEdge);
        if (curve.empty() || changed[ofEdge[curve[0]][0]] || changed[ofEdge[curve[0]][1]])
        {
          continue;
        }
        changed[ofEdge[curve[0]][0]] = changed[ofEdge[curve[0]][1]] = 1;
        gone.insert(gone.end(), curve.begin(), curve.end());
        joined = true;
      }
      std::for_each(gone.begin(), gone.end(), [&](int edge) { graph.remove(edge); });
    }
  }

  // ---- Curves

  [[noreturn]] void refuse(int place) const
  {
    std::vector<std::size_t> names;
    for (std::size_t i = 0; i < this->Strokes.size(); ++i)
    {
      const int p = this->PathOf[i];
      if (p >= 0 && std::count(this->Paths[p].at.begin(), this->Paths[p].at.end(), place) > 0)
      {
        names.push_back(i);
      }
    }
    throw Error(Failure::BadStroke,
      names.size() > 1
        ? "{stroke %1} meets {stroke %2} near {(%3, %4)} so that two parts hang together by one "
          "point; let them overlap more, or keep them apart"
        : "{stroke %1} meets itself near {(%3, %4)} so that two parts hang together by one "
          "point; let them overlap more, or keep them apart",
      names.front(),
      names.back(),
      this->World[place][0],
      this->World[place][1]);
  }

  void findRings(const LineGraph& graph)
  {
    std::vector<std::array<int, 2>> ofEdge, inside;
    graph.walks({}, ofEdge);
    std::vector<char> single(ofEdge.size(), 0); // the same face on both sides
    for (std::size_t e = 0; e < ofEdge.size(); ++e)
    {
      single[e] = ofEdge[e][0] == ofEdge[e][1];
    }
    this->RingOf.assign(ofEdge.size(), -1);
    std::vector<int> rings(this->Places.size(), 0); // through each place
    const auto add = [&](const std::vector<int>& places, const std::vector<int>& edges)
    {
      for (const int edge : edges)
      {
        this->RingOf[edge] = static_cast<int>(this->Rings.size());
      }
      this->Rings.push_back(places);
    };
    for (const LineGraph::Walk& walk : graph.walks(single, inside))
    {
      if (walk.area < 0.0)
      {
        for (const int place : walk.places)
        {
          if (++rings[place] > 1)
          {
            this->refuse(place);
          }
        }
        add(walk.places, walk.edges);
      }
    }
    // Closed strokes inside; those that meet each other all go, so that no order is preferred.
    std::vector<std::pair<const PlacePath*, std::vector<int>>> candidates;
    for (const PlacePath& path : this->Paths)
    {
      std::vector<int> edges;
      bool whole = path.closed && std::set<int>(path.at.begin(), path.at.end()).size() == path.at.size();
      for (int i = 0; whole && i < path.segments(); ++i)
      {
        edges.push_back(graph.edgeBetween(path.from(i), path.to(i)));
        whole = edges.back() >= 0 && !single[edges.back()] && this->RingOf[edges.back()] < 0;
      }
      if (whole)
      {
        std::for_each(path.at.begin(), path.at.end(), [&](int place) { ++rings[place]; });
        candidates.emplace_back(&path, std::move(edges));
      }
    }
    for (const auto& [path, edges] : candidates)
    {
      if (std::all_of(path->at.begin(), path->at.end(), [&](int place) { return rings[place] == 1; }))
      {
        add(path->at, edges);
      }
    }
  }

  DrawnStroke ringFrom(const LineGraph& graph, const std::vector<int>& ring, int from, int to) const
  {
    const int count = static_cast<int>(ring.size());
    const int first = static_cast<int>(std::find(ring.begin(), ring.end(), from) - ring.begin());
    const int step = ring[(first + 1) % count] == to ? 1 : count - 1;
    DrawnStroke made;
    made.closed = true;
    for (int i = 0, at = first; i < count; ++i, at = (at + step) % count)
    {
      if (graph.degree(ring[at]) > 2)
      {
        made.nodes.push_back(i);
      }
      made.points.push_back(this->World[ring[at]]);
    }
    return made;
  }

  // Places of an open curve through a segment of a path, in its direction.
  static std::vector<int> openThrough(const LineGraph& graph, int edge, int from, int to)
  {
    std::vector<int> before{ to }, places;
    for (const int one : graph.chain(edge, to))
    {
      before.push_back(graph.other(one, before.back()));
    }
    places.assign(before.rbegin(), before.rend());
    int at = from;
    for (const int one : graph.chain(edge, from))
    {
      at = graph.other(one, at);
      if (one != edge)
      {
        places.push_back(at);
      }
    }
    return places;
  }

  void addOpen(const LineGraph& graph,
    std::vector<int> places,
    int stroke,
    std::vector<ArrangedCurve>& to) const
  {
    std::vector<std::vector<int>> parts;
    if (places.front() == places.back())
    {
      // Round and back to one node: two curves, so that each has two ends.
      const GridPlace& node = this->Places[places.front()];
      const auto half = std::max_element(places.begin(),
        places.end(),
        [&](int a, int b)
        {
          return std::make_pair(apart(node, this->Places[a]), this->Places[a]) <
                 std::make_pair(apart(node, this->Places[b]), this->Places[b]);
        });
      parts = { { places.begin(), half + 1 }, { half, places.end() } };
    }
    else
    {
      parts = { std::move(places) };
    }
    for (const std::vector<int>& part : parts)
    {
      ArrangedCurve made;
      made.stroke = stroke;
      made.curve.points = valuesAt(this->World, part);
      const bool isNode[2] = { parts.size() > 1 || graph.degree(part.front()) > 2,
        parts.size() > 1 || graph.degree(part.back()) > 2 };
      if (part.size() == 2 && isNode[0] && isNode[1])
      {
        // What it divides needs a point on it that is on no rim.
        Polyline& points = made.curve.points;
        points.insert(points.begin() + 1, 0.5 * (points[0] + points[1]));
      }
      if (isNode[0])
      {
        made.curve.nodes.push_back(0);
      }
      if (isNode[1])
      {
        made.curve.nodes.push_back(static_cast<int>(made.curve.points.size()) - 1);
      }
      to.push_back(std::move(made));
    }
  }

  std::vector<ArrangedCurve> curves(const LineGraph& graph) const
  {
    std::vector<ArrangedCurve> made;
    std::vector<char> done(graph.edgeCount(), 0);
    for (std::size_t i = 0; i < this->Strokes.size(); ++i)
    {
      const int stroke = static_cast<int>(i);
      if (this->PathOf[i] < 0)
      {
        made.push_back({ this->Strokes[i], stroke });
        continue;
      }
      const PlacePath& path = this->Paths[this->PathOf[i]];
      for (int k = 0; k < path.segments(); ++k)
      {
        const int from = path.from(k), to = path.to(k), edge = graph.edgeBetween(from, to);
        if (edge < 0 || done[edge])
        {
          continue;
        }
        if (this->RingOf[edge] >= 0)
        {
          const std::vector<int>& ring = this->Rings[this->RingOf[edge]];
          made.push_back({ this->ringFrom(graph, ring, from, to), stroke });
          for (std::size_t r = 0; r < ring.size(); ++r)
          {
            done[graph.edgeBetween(ring[r], ring[(r + 1) % ring.size()])] = 1;
          }
          continue;
        }
        const std::vector<int> places = openThrough(graph, edge, from, to);
        for (std::size_t p = 1; p < places.size(); ++p)
        {
          done[graph.edgeBetween(places[p - 1], places[p])] = 1;
        }
        this->addOpen(graph, places, stroke, made);
      }
    }
    return made;
  }

  const Frame& Raster;
  const std::vector<DrawnStroke>& Strokes;
  double Reach; // on the grid
  const Context& Progress;

  std::vector<GridPlace> Places;
  Polyline World; // of each place
  std::vector<PlacePath> Paths;
  std::vector<int> PathOf; // of each stroke; -1 of one that stays as it is

  std::vector<std::vector<int>> Rings; // places round each
  std::vector<int> RingOf;             // of each edge; -1 of none
};

} // namespace

std::vector<ArrangedCurve> arrange(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double reach,
  const Context& context)
{
  return Arrangement(frame, strokes, reach, context).run();
}

} // namespace oversketch
