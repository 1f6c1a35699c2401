#include "Join/unite.h"

#include "Join/crossings.h"
#include "Join/polygon.h"
#include "Join/slivers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace oversketch
{

namespace
{

[[noreturn]] void refuseCrossed(int part, const Vector3& p)
{
  throw Error(Failure::BadMesh,
    "Part %1 goes through itself near {(%2, %3, %4)}, where the other one meets it; mend it there, or move a "
    "part.",
    part,
    p[0],
    p[1],
    p[2]);
}

// A surface that the other one cuts: what of it is kept, and how.
class CutSurface
{
public:
  CutSurface(const Body& body, int number, const Context& context)
    : Own(body)
    , Places(body.mesh)
    , Edges(buildAdjacency(body.mesh, context))
    , Number(number)
  {
    std::vector<char> isTorn(this->Edges.edges.size());
    context.each(static_cast<int>(isTorn.size()), [&](int e) { isTorn[e] = this->isPaired(e) ? 0 : 1; });
    const auto torn = std::find(isTorn.begin(), isTorn.end(), 1);
    if (torn != isTorn.end())
    {
      const MeshEdge& edge = this->Edges.edges[torn - isTorn.begin()];
      const Vector3& p = body.mesh.points[edge.v0];
      throw Error(Failure::BadMesh,
        edge.triangleCount == 1
          ? "Part %1 is not closed: near {(%2, %3, %4)} an edge has one triangle; close the hole first."
          : "Part %1 is no closed surface: near {(%2, %3, %4)} an edge has %5 triangles, or two that are "
            "turned against each other; mend it first.",
        number,
        p[0],
        p[1],
        p[2],
        edge.triangleCount);
    }
  }

  // Moves some vertices further out by a way, for the question what is inside what.
  void move(const std::vector<int>& vertices, double way)
  {
    for (const int v : vertices)
    {
      this->Places.points[v] += way * vertexNormal(this->Own.mesh, this->Edges.vertexTriangles, v);
    }
  }

  const Mesh& places() const { return this->Places; }
  const Adjacency& edges() const { return this->Edges; }

  // Takes the crossings of both surfaces: which lie on its edges, and what pieces of curve its faces have, in
  // the direction with the other body to the left.
  void take(const Crossings& all, bool isSecond, const Mesh& other)
  {
    this->All = &all;
    this->IsSecond = isSecond;
    const auto& points = all.points;
    this->OnEdge = Lists::gathered(this->Edges.edges.size(),
      [&](const auto& visit)
      {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          if (points[i].ofSecond == isSecond)
          {
            visit(points[i].edge, static_cast<int>(i));
          }
        }
      });
    this->InFace = Lists::gathered(this->Own.mesh.triangles.size(),
      [&](const auto& visit)
      {
        for (std::size_t i = 0; i < all.pieces.size(); ++i)
        {
          visit(isSecond ? all.pieces[i].second : all.pieces[i].first, static_cast<int>(i));
        }
      });
    this->Inside.assign(this->Own.mesh.points.size(), -1);
    for (int e = 0; e < static_cast<int>(this->Edges.edges.size()); ++e)
    {
      if (this->OnEdge.size(e) > 0)
      {
        this->Crossed.push_back(e);
      }
    }
    this->sortCrossings();
    this->spread(other);
    this->orderCrossings();
  }

  bool isCut(int face) const { return this->InFace.size(face) > 0; }
  bool isKept(int vertex, bool inside) const { return (this->Inside[vertex] == 1) == inside; }

  // Adds what is kept to a body, where its vertices begin with the number `own`, crossings with `crossed`.
  void keep(bool inside, bool reversed, int own, int crossed, Body& into, Body& cuts) const
  {
    for (int f = 0; f < this->Own.mesh.triangleCount(); ++f)
    {
      const Triangle& t = this->triangle(f);
      if (this->isCut(f))
      {
        this->keepCut(f, inside, reversed, own, crossed, cuts);
      }
      else if (this->isKept(t[0], inside))
      {
        const Triangle moved{ own + t[0], own + t[1], own + t[2] };
        if (reversed || !this->Own.isWhole(f))
        {
          this->add(into, moved, f, this->Own.weightsOf(f), reversed);
        }
        else
        {
          into.add(moved, this->Own.source[f], this->Own.part[f]);
        }
      }
    }
  }

private:
  const Triangle& triangle(int f) const { return this->Own.mesh.triangles[f]; }

  // Tells whether an edge has two triangles that are turned alike.
  bool isPaired(int e) const
  {
    const MeshEdge& edge = this->Edges.edges[e];
    const int* at = this->Edges.trianglesBegin(e);
    return edge.triangleCount == 2 && runsAlong(this->triangle(at[0]), edge.v0, edge.v1) !=
                                        runsAlong(this->triangle(at[1]), edge.v0, edge.v1);
  }

  // Adds a triangle that lies on a face.
  void add(Body& to, Triangle t, int face, CornerWeights weights, bool reversed) const
  {
    if (reversed)
    {
      std::swap(t[1], t[2]);
      std::swap(weights[1], weights[2]);
    }
    to.add(t, this->Own.source[face], this->Own.part[face], weights);
  }

  int* crossingsBegin(int e) { return this->OnEdge.values.data() + this->OnEdge.offsets[e]; }
  int* crossingsEnd(int e) { return this->OnEdge.values.data() + this->OnEdge.offsets[e + 1]; }

  // Sorts crossings along their edges, and tells what side ends are on where rounding cannot have changed
  // their order.
  void sortCrossings()
  {
    const auto& points = this->All->points;
    for (const int e : this->Crossed)
    {
      int *begin = this->crossingsBegin(e), *end = this->crossingsEnd(e);
      std::stable_sort(begin, end, [&](int a, int b) { return points[a].share < points[b].share; });
      const auto entering = std::count_if(begin, end, [&](int c) { return points[c].entering; });
      const auto count = end - begin;
      const bool isSure = count < 2 || points[begin[1]].share - points[begin[0]].share > 1e-9;
      if (2 * entering != count || isSure)
      {
        const bool inside = 2 * entering != count ? 2 * entering < count : !points[*begin].entering;
        this->mark(this->Edges.edges[e].v0, inside);
        this->mark(this->Edges.edges[e].v1, inside != (count % 2 == 1));
      }
    }
  }

  // Along each edge the body is entered and left in turn: where rounding made two crossings change places,
  // they change back.
  void orderCrossings()
  {
    const auto& points = this->All->points;
    for (const int e : this->Crossed)
    {
      int* end = this->crossingsEnd(e);
      bool inside = this->Inside[this->Edges.edges[e].v0] == 1;
      for (int* at = this->crossingsBegin(e); at != end; ++at, inside = !inside)
      {
        int* fitting = std::find_if(at, end, [&](int c) { return points[c].entering != inside; });
        if (fitting == end || points[*fitting].share - points[*at].share > 1e-6)
        {
          this->refuse(points[*at].point);
        }
        std::rotate(at, fitting, fitting + 1);
      }
      this->mark(this->Edges.edges[e].v1, inside);
    }
  }

  // Says that the other one goes through itself.
  [[noreturn]] void refuse(const Vector3& place) const { refuseCrossed(this->Number == 1 ? 2 : 1, place); }

  void mark(int vertex, bool inside)
  {
    if (this->Inside[vertex] == (inside ? 0 : 1))
    {
      this->refuse(this->Own.mesh.points[vertex]);
    }
    this->Inside[vertex] = inside ? 1 : 0;
  }

  // The ends of an edge without crossings are on the same side; of pieces that nothing cuts a ray tells.
  void spread(const Mesh& other)
  {
    std::vector<char> isCut(this->Inside.size(), 0); // ends of edges with crossings
    for (const int e : this->Crossed)
    {
      isCut[this->Edges.edges[e].v0] = isCut[this->Edges.edges[e].v1] = 1;
    }
    std::vector<int> queue;
    for (int v = 0; v < this->Own.mesh.vertexCount(); ++v)
    {
      if (this->Inside[v] >= 0)
      {
        queue.push_back(v);
      }
    }
    const auto flood = [&]
    {
      while (!queue.empty())
      {
        const int v = queue.back();
        queue.pop_back();
        for (const int n : this->Edges.vertexVertices[v])
        {
          if (!isCut[v] || !isCut[n] || this->OnEdge.size(this->Edges.findEdge(v, n)) == 0)
          {
            if (this->Inside[n] < 0)
            {
              queue.push_back(n);
            }
            this->mark(n, this->Inside[v] == 1);
          }
        }
      }
    };
    flood();
    for (int v = 0; v < this->Own.mesh.vertexCount(); ++v)
    {
      if (this->Inside[v] < 0)
      {
        this->mark(v, isInside(this->Places.points[v], this->IsSecond, other));
        queue.push_back(v);
        flood();
      }
    }
  }

  // A corner of what is kept of a face: a vertex, or a crossing.
  struct Place
  {
    int crossing = -1, corner = -1;
  };

  // The weights of a crossing in one of the faces that it is seen in.
  Vector3 weightsOf(int crossing, int face) const
  {
    const EdgeCrossing& c = this->All->points[crossing];
    const Triangle& t = this->triangle(face);
    Vector3 weights = Vector3::Zero();
    if (c.ofSecond == this->IsSecond)
    {
      const MeshEdge& edge = this->Edges.edges[c.edge];
      weights[cornerOf(t, edge.v0)] = 1.0 - c.share;
      weights[cornerOf(t, edge.v1)] = c.share;
      return weights;
    }
    const auto& p = this->Places.points;
    const Vector3 u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], w = c.point - p[t[0]], n = u.cross(v);
    const double area = n.squaredNorm();
    weights[1] = w.cross(v).dot(n) / area;
    weights[2] = u.cross(w).dot(n) / area;
    weights[0] = 1.0 - weights[1] - weights[2];
    return weights;
  }

  void keepCut(int f, bool inside, bool reversed, int own, int crossed, Body& into) const
  {
    const auto& points = this->All->points;
    // The next crossing along the curve, with what is kept to its left; -1 where it is none of this face's.
    const bool along = inside != this->IsSecond;
    std::vector<std::pair<int, int>> ways;
    for (const int piece : this->InFace[f])
    {
      const CrossingPiece& p = this->All->pieces[piece];
      ways.emplace_back(along ? p.from : p.to, along ? p.to : p.from);
    }
    std::sort(ways.begin(), ways.end());
    std::vector<char> used(ways.size(), 0);
    const auto wayFrom = [&](int crossing)
    {
      const auto at = std::lower_bound(ways.begin(), ways.end(), std::make_pair(crossing, -1));
      return at != ways.end() && at->first == crossing ? static_cast<int>(at - ways.begin()) : -1;
    };

    // Round the face: corners, and the crossings on its edges.
    std::vector<Place> round;
    for (int k = 0; k < 3; ++k)
    {
      round.push_back({ -1, k });
      const int e = this->Edges.triangleEdges[f][k];
      const Lists::Range at = this->OnEdge[e];
      std::vector<int> on(at.begin(), at.end());
      if (this->Edges.edges[e].v0 != this->triangle(f)[k])
      {
        std::reverse(on.begin(), on.end());
      }
      for (const int c : on)
      {
        round.push_back({ c, -1 });
      }
    }
    const int n = static_cast<int>(round.size());
    const auto leaves = [&](int i) { return wayFrom(round[i].crossing) >= 0; };

    std::vector<std::vector<Place>> outer, loose;
    std::vector<char> begun(round.size(), 0);
    for (int i = 0; i < n; ++i)
    {
      if (round[i].crossing < 0 || begun[i] || leaves(i))
      {
        continue;
      }
      // From where the border of the face comes back to what is kept, and on.
      std::vector<Place> loop;
      int at = i;
      do
      {
        begun[at] = 1;
        loop.push_back(round[at]);
        at = (at + 1) % n;
        while (round[at].crossing < 0)
        {
          loop.push_back(round[at]);
          at = (at + 1) % n;
        }
        int crossing = round[at].crossing, way = wayFrom(crossing);
        if (way < 0)
        {
          this->refuse(points[crossing].point);
        }
        loop.push_back(round[at]);
        for (; way >= 0 && !used[way]; way = wayFrom(crossing))
        {
          used[way] = 1;
          crossing = ways[way].second;
          if (points[crossing].ofSecond == this->IsSecond)
          {
            break;
          }
          loop.push_back({ crossing, -1 });
        }
        at = static_cast<int>(
          std::find_if(round.begin(), round.end(), [&](const Place& p) { return p.crossing == crossing; }) -
          round.begin());
        if (at == n)
        {
          this->refuse(points[crossing].point);
        }
      } while (at != i && !begun[at]);
      outer.push_back(std::move(loop));
    }
    if (outer.empty() && this->isKept(this->triangle(f)[0], inside))
    {
      outer.push_back({ { -1, 0 }, { -1, 1 }, { -1, 2 } });
    }
    for (std::size_t w = 0; w < ways.size(); ++w)
    {
      std::vector<Place> loop;
      for (int way = static_cast<int>(w); way >= 0 && !used[way]; way = wayFrom(ways[way].second))
      {
        used[way] = 1;
        loop.push_back({ ways[way].first, -1 });
      }
      if (!loop.empty())
      {
        loose.push_back(std::move(loop));
      }
    }
    this->fill(f, outer, loose, reversed, own, crossed, into);
  }

  void fill(int f,
    const std::vector<std::vector<Place>>& outer,
    const std::vector<std::vector<Place>>& loose,
    bool reversed,
    int own,
    int crossed,
    Body& into) const
  {
    const Triangle& t = this->triangle(f);
    const auto& corner = this->Places.points;
    const Vector3 normal = (corner[t[1]] - corner[t[0]]).cross(corner[t[2]] - corner[t[0]]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    std::vector<Place> places;
    std::vector<Vector2> flat;
    const auto loopOf = [&](const std::vector<Place>& of)
    {
      std::vector<int> loop;
      for (const Place& p : of)
      {
        const Vector3& at = p.corner >= 0 ? corner[t[p.corner]] : this->All->points[p.crossing].point;
        loop.push_back(static_cast<int>(places.size()));
        places.push_back(p);
        flat.push_back(normal[axis] > 0.0 ? Vector2(at[x], at[y]) : Vector2(at[y], at[x]));
      }
      return loop;
    };
    std::vector<std::vector<std::vector<int>>> regions;
    for (const auto& loop : outer)
    {
      regions.push_back({ loopOf(loop) });
    }
    std::vector<std::vector<int>> holes;
    for (const auto& loop : loose)
    {
      std::vector<int> ids = loopOf(loop);
      turnedArea(flat, ids) > 0.0 ? regions.push_back({ std::move(ids) }) : holes.push_back(std::move(ids));
    }
    for (std::vector<int>& hole : holes)
    {
      const auto holds = [&](const auto& region)
      { return isInLoop(flat, region.front(), flat[hole.front()]); };
      auto region =
        regions.size() == 1 ? regions.begin() : std::find_if(regions.begin(), regions.end(), holds);
      if (region != regions.end())
      {
        region->push_back(std::move(hole));
      }
      else // by rounding a loop without area
      {
        regions.push_back({ std::move(hole) });
      }
    }
    for (auto& region : regions)
    {
      for (const Triangle& made : triangulatePolygon(flat, region))
      {
        Triangle ids;
        CornerWeights weights;
        for (int k = 0; k < 3; ++k)
        {
          const Place& p = places[made[k]];
          ids[k] = p.corner >= 0 ? own + t[p.corner] : crossed + p.crossing;
          const Vector3 in =
            p.corner >= 0 ? Vector3(Vector3::Unit(p.corner)) : this->weightsOf(p.crossing, f);
          weights[k] = this->Own.weightsAt(f, in);
        }
        this->add(into, ids, f, weights, reversed);
      }
    }
  }

  const Body& Own;
  Mesh Places; // its own, but for vertices that are moved
  const Adjacency Edges;
  const int Number;
  const Crossings* All = nullptr;
  bool IsSecond = false;
  Lists OnEdge, InFace;     // crossings, pieces
  std::vector<int> Crossed; // edges
  std::vector<char> Inside; // of vertices: 1, 0, -1 not known
};

} // namespace

United unite(const Body& a, const Body& b, JoinKind kind, double least, const Context& context)
{
  const double reach = least / 4.0, way = kind == JoinKind::Common ? -2.0 * reach : 2.0 * reach;
  const std::vector<FacePair> near = nearFaces(a.mesh, b.mesh, 4.0 * reach, context);
  // Points that touch do so once: the second body's points first, then those of the first one that still do.
  CutSurface first(a, 1, context), second(b, 2, context);
  second.move(touching(b.mesh, a.mesh, near, 1, reach), way);
  first.move(touching(a.mesh, second.places(), near, 0, reach), kind == JoinKind::Join ? way : -2.0 * reach);
  context.checkpoint(0.4);
  const Crossings crossings =
    findCrossings(first.places(), first.edges(), second.places(), second.edges(), near, context);
  first.take(crossings, false, second.places());
  second.take(crossings, true, first.places());
  context.checkpoint(0.7);

  United united;
  united.meet = !crossings.points.empty();
  Body& body = united.body;
  Body cuts;
  const int own = a.mesh.vertexCount(), crossed = own + b.mesh.vertexCount();
  body.mesh.points = a.mesh.points;
  body.mesh.points.insert(body.mesh.points.end(), b.mesh.points.begin(), b.mesh.points.end());
  for (const EdgeCrossing& crossing : crossings.points)
  {
    body.mesh.points.push_back(crossing.point);
  }
  body.reserve(a.source.size() + b.source.size());
  first.keep(kind == JoinKind::Common, false, 0, crossed, body, cuts);
  second.keep(kind != JoinKind::Join, kind == JoinKind::Cut, own, crossed, body, cuts);
  united.changed.assign(body.mesh.triangles.size(), 0);
  united.changed.resize(body.mesh.triangles.size() + cuts.mesh.triangles.size(), 1);
  for (int t = 0; t < cuts.mesh.triangleCount(); ++t)
  {
    body.add(cuts.mesh.triangles[t], cuts.source[t], cuts.part[t], cuts.weights[t]);
  }
  united.isNew.assign(body.mesh.points.size(), 0);
  std::fill(united.isNew.begin() + crossed, united.isNew.end(), 1);
  removeSlivers(united, least);
  return united;
}

} // namespace oversketch
