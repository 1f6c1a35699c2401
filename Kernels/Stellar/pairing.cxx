#include "Stellar/pairing.h"

#include "Mesh/context.h"
#include "Stellar/defects.h"
#include "Stellar/leaves.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr int longestExchange = 8;  // pairs, A7
constexpr int longestWidening = 32; // the same for narrow ones, which are few
constexpr double angleShare = 0.6;  // of the mesh's smallest angle: what refinement may leave
constexpr int splitDepth = 4;       // of splits after which no other shapes come

// The narrowest of what splits make of a triangle whose refinement edge is opposite its first corner.
double narrowestPiece(const Vector3& p, const Vector3& a, const Vector3& c, int depth)
{
  const double own = narrowness(p, a, c);
  if (depth == 0)
  {
    return own;
  }
  const Vector3 m = 0.5 * (a + c);
  return std::min({ own, narrowestPiece(m, p, a, depth - 1), narrowestPiece(m, c, p, depth - 1) });
}

// The corners of a triangle from the one opposite its edge with another one on.
Triangle apexFirst(const Triangle& t, const Triangle& other)
{
  for (int i = 0; i < 3; ++i)
  {
    if (std::find(other.begin(), other.end(), t[i]) == other.end())
    {
      return { t[i], t[(i + 1) % 3], t[(i + 2) % 3] };
    }
  }
  return t;
}

// Who is whose partner, and along which edges one may be sought.
class Pairing
{
public:
  Pairing(const Mesh& mesh, const Adjacency& adjacency)
    : Shape(mesh)
    , Adj(adjacency)
    , Mate(mesh.triangles.size(), -1)
    , Seen(mesh.triangles.size(), -1)
    , Rank(adjacency.edges.size())
  {
    // A power of two brings squares of tiny and huge lengths within range and changes no order.
    const Eigen::AlignedBox3d box = boxRound(mesh.points);
    const double size = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    const double scale = size > 0.0 ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
    std::vector<std::pair<double, int>> order;
    order.reserve(adjacency.edges.size());
    for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
    {
      const MeshEdge& edge = adjacency.edges[e];
      order.emplace_back(-(scale * (mesh.points[edge.v0] - mesh.points[edge.v1])).squaredNorm(), e);
    }
    std::sort(order.begin(), order.end());
    this->Order.reserve(order.size());
    for (const auto& [length, e] : order)
    {
      this->Rank[e] = static_cast<int>(this->Order.size());
      this->Order.push_back(e);
    }
  }

  void pairGreedily()
  {
    for (int e : this->Order)
    {
      if (this->Adj.edges[e].triangleCount == 2)
      {
        const int* t = this->Adj.trianglesBegin(e);
        if (this->Mate[t[0]] < 0 && this->Mate[t[1]] < 0)
        {
          this->pair(t[0], t[1]);
        }
      }
    }
  }

  // Looks for a partner of a free triangle along alternating paths, shortest first.
  void exchange(int root)
  {
    const auto any = [](int) { return true; };
    this->exchange(root, longestExchange, any, any);
  }

  // Exchanges pairs whose pieces would be much narrower than any triangle of the mesh for such that are not.
  void widen(const Context& context)
  {
    const int count = static_cast<int>(this->Shape.triangles.size());
    std::vector<double> own(count);
    double least = 1.0;
    for (int t = 0; t < count; ++t)
    {
      const Triangle& v = this->Shape.triangles[t];
      own[t] = narrowness(this->Shape.points[v[0]], this->Shape.points[v[1]], this->Shape.points[v[2]]);
      least = std::min(least, own[t]);
    }
    const double angle = std::asin(std::sqrt(least)), bound = std::pow(std::sin(angleShare * angle), 2.0);
    // Halved over its longest edge a triangle this wide does not come near the bound.
    const double wide = std::pow(std::sin(std::min(3.0 * angleShare * angle, 0.5)), 2.0);
    for (int t = 0; t < count; ++t)
    {
      if (t % 65536 == 0)
      {
        context.checkpoint(0.8);
      }
      const int mate = this->Mate[t];
      if (mate < t || this->isSafe(t, own[t], wide) || !(this->narrowestOf(t, mate) < bound))
      {
        continue;
      }
      this->Mate[t] = this->Mate[mate] = -1;
      const auto isWide = [&](int e) { return this->narrowestOf(e) >= bound; };
      if (!this->exchange(t, longestWidening, isWide, [mate](int other) { return other == mate; }))
      {
        this->pair(t, mate);
      }
    }
  }

  int mate(int t) const { return this->Mate[t]; }

private:
  // Through so many pairs at most. `mayPair(edge)`, and whether the path may end at a free triangle. False:
  // there is none.
  template <class MayPair, class MayEnd>
  bool exchange(int root, int longest, const MayPair& mayPair, const MayEnd& mayEnd)
  {
    // A triangle that the path may leave by an edge that is not its pair's.
    struct Step
    {
      int triangle, from, before, pairs; // from: its present mate; before: the step that reached that
    };
    std::vector<Step> steps{ { root, -1, -1, 0 } };
    ++this->Search;
    this->Seen[root] = this->Search;
    for (int i = 0; i < static_cast<int>(steps.size()); ++i)
    {
      const Step step = steps[i];
      std::array<int, 3> edges = this->Adj.triangleEdges[step.triangle];
      std::sort(edges.begin(), edges.end(), [&](int a, int b) { return this->Rank[a] < this->Rank[b]; });
      for (int e : edges)
      {
        if (this->Adj.edges[e].triangleCount != 2)
        {
          continue;
        }
        const int* t = this->Adj.trianglesBegin(e);
        const int other = t[0] == step.triangle ? t[1] : t[0], mate = this->Mate[other];
        if (this->Seen[other] == this->Search || (mate < 0 && !mayEnd(other)) || !mayPair(e))
        {
          continue;
        }
        if (mate < 0)
        {
          this->pair(other, step.triangle);
          for (int k = i; steps[k].before >= 0; k = steps[k].before)
          {
            this->pair(steps[k].from, steps[steps[k].before].triangle);
          }
          return true;
        }
        if (step.pairs < longest)
        {
          this->Seen[other] = this->Seen[mate] = this->Search;
          steps.push_back({ mate, other, i, step.pairs + 1 });
        }
      }
    }
    return false;
  }

  // Paired over its longest edge, and wide.
  bool isSafe(int t, double own, double wide) const
  {
    const std::array<int, 3>& edges = this->Adj.triangleEdges[t];
    const int longest = *std::min_element(
      edges.begin(), edges.end(), [&](int a, int b) { return this->Rank[a] < this->Rank[b]; });
    const int* both = this->Adj.trianglesBegin(longest);
    return own >= wide && this->Adj.edges[longest].triangleCount == 2 &&
           (both[0] == this->Mate[t] || both[1] == this->Mate[t]);
  }

  double narrowestOf(int e) const
  {
    const int* both = this->Adj.trianglesBegin(e);
    return this->narrowestOf(both[0], both[1]);
  }
  double narrowestOf(int t, int other) const
  {
    const Triangle a = apexFirst(this->Shape.triangles[t], this->Shape.triangles[other]),
                   b = apexFirst(this->Shape.triangles[other], this->Shape.triangles[t]);
    const auto at = [this](int v) -> const Vector3& { return this->Shape.points[v]; };
    return std::min(narrowestPiece(at(a[0]), at(a[1]), at(a[2]), splitDepth),
      narrowestPiece(at(b[0]), at(b[1]), at(b[2]), splitDepth));
  }

  void pair(int a, int b)
  {
    this->Mate[a] = b;
    this->Mate[b] = a;
  }

  const Mesh& Shape;
  const Adjacency& Adj;
  std::vector<int> Mate, Seen, Rank, Order;
  int Search = 0; // that Seen tells of
};

void addRoot(Forest& forest, const Triangle& t, int gen)
{
  Forest::Face face;
  std::copy(t.begin(), t.end(), face.v);
  face.root = forest.rootCount++;
  face.gen = static_cast<std::uint8_t>(gen);
  forest.faces.push_back(face);
}

void addPoints(Forest& forest, const Mesh& mesh)
{
  forest.vertices.resize(mesh.points.size());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    forest.vertices[v].position = mesh.points[v];
  }
}

} // namespace

BaseMesh pairTriangles(const Mesh& mesh, const PairingOptions& options, const Context& context)
{
  checkPointIds(mesh);
  const Adjacency adjacency = buildAdjacency(mesh, context);
  context.checkpoint(0.3);
  checkManifold(mesh, adjacency);
  context.checkpoint(0.4);
  Pairing pairing(mesh, adjacency);
  pairing.pairGreedily();
  context.checkpoint(0.7);
  const int count = mesh.triangleCount();
  for (int t = 0; options.improvePairs && t < count; ++t)
  {
    if (pairing.mate(t) < 0)
    {
      pairing.exchange(t);
    }
    if (t % 65536 == 0)
    {
      context.checkpoint(0.7);
    }
  }
  if (options.improvePairs)
  {
    pairing.widen(context);
  }
  BaseMesh base;
  Forest& forest = base.forest;
  addPoints(forest, mesh);
  for (int t = 0; t < count; ++t)
  {
    const Triangle& corners = mesh.triangles[t];
    const int mate = pairing.mate(t);
    if (mate > t)
    {
      addRoot(forest, apexFirst(corners, mesh.triangles[mate]), 0);
      addRoot(forest, apexFirst(mesh.triangles[mate], corners), 0);
      base.rootTriangle.insert(base.rootTriangle.end(), { t, mate });
      ++base.pairs;
    }
    else if (mate < 0)
    {
      const int m = static_cast<int>(forest.vertices.size());
      forest.vertices.emplace_back();
      forest.vertices[m].position =
        mesh.points[corners[0]] / 3.0 + mesh.points[corners[1]] / 3.0 + mesh.points[corners[2]] / 3.0;
      forest.vertices[m].level = 1;
      for (int i = 0; i < 3; ++i)
      {
        addRoot(forest, { m, corners[i], corners[(i + 1) % 3] }, 1);
        base.rootTriangle.push_back(t);
      }
      ++base.unpaired;
    }
  }
  base.rootCorners.reserve(forest.faces.size());
  for (const Forest::Face& root : forest.faces)
  {
    base.rootCorners.push_back({ root.v[0], root.v[1], root.v[2] });
  }
  forest.connect(context);
  context.checkpoint(0.9);
  if (options.eagerPairs)
  {
    for (int f = 0; f < forest.rootCount; ++f)
    {
      if (forest.faces[f].gen == 0)
      {
        forest.split(f, {});
      }
    }
    forest = canonical(forest, context).forest;
  }
  context.checkpoint(1.0);
  return base;
}

Forest forestOfPairs(const Mesh& mesh)
{
  checkManifold(mesh);
  Forest forest;
  addPoints(forest, mesh);
  for (const Triangle& t : mesh.triangles)
  {
    addRoot(forest, t, 0);
  }
  forest.connect(Context());
  for (int f = 0; f < forest.rootCount; ++f)
  {
    if (forest.faces[f].n[0] != (f ^ 1))
    {
      throw Error(Failure::BadMesh,
        "Triangles %1 and %2 do not share the edge opposite their first corners.",
        f & ~1,
        f | 1);
    }
  }
  return forest;
}

} // namespace oversketch
