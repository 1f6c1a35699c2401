#include "Stellar/pairing.h"

#include "Mesh/context.h"
#include "Stellar/defects.h"
#include "Stellar/leaves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int longestExchange = 8; // pairs

// Who is whose partner, and along which edges one may be sought.
class Pairing
{
public:
  Pairing(const Mesh& mesh, const Adjacency& adjacency)
    : Adj(adjacency)
    , Mate(mesh.triangles.size(), -1)
    , Seen(mesh.triangles.size(), -1)
    , Rank(adjacency.edges.size())
  {
    // A power of two brings squares of tiny and huge lengths within range and changes no order.
    Eigen::AlignedBox3d box;
    for (const Vector3& p : mesh.points)
    {
      box.extend(p);
    }
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
    // A triangle that the path may leave by an edge that is not its pair's.
    struct Step
    {
      int triangle, from, before, pairs; // from: its present mate; before: the step that reached that
    };
    std::vector<Step> steps{ { root, -1, -1, 0 } };
    this->Seen[root] = root;
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
        if (this->Seen[other] == root)
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
          return;
        }
        if (step.pairs < longestExchange)
        {
          this->Seen[other] = this->Seen[mate] = root;
          steps.push_back({ mate, other, i, step.pairs + 1 });
        }
      }
    }
  }

  int mate(int t) const { return this->Mate[t]; }

private:
  void pair(int a, int b)
  {
    this->Mate[a] = b;
    this->Mate[b] = a;
  }

  const Adjacency& Adj;
  std::vector<int> Mate, Seen, Rank, Order;
};

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
        "Triangles " + std::to_string(f & ~1) + " and " + std::to_string(f | 1) +
          " do not share the edge opposite their first corners.");
    }
  }
  return forest;
}

} // namespace oversketch
