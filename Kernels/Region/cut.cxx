#include "Region/cut.h"

#include "Region/border.h"
#include "Region/flow.h"
#include "Region/grow.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace oversketch
{

namespace
{

enum Role : char
{
  Outside,
  Inside,
  Band
};

// A triangle as the cut sees it.
struct Facet
{
  char selected; // corners in the region
  Role role;
  int node; // in the network; -1 outside the band
};

double medianDiameter(const std::vector<double>& diameter, const std::vector<int>& vertices)
{
  std::vector<double> values = valuesAt(diameter, vertices);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Plane
{
  Vector3 centre, normal;
  Plane(const Mesh& mesh, const std::vector<Vector3>& normals, int triangle)
  {
    const auto [a, b, c] = mesh.triangles[triangle];
    this->centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    this->normal = (normals[a] + normals[b] + normals[c]).stableNormalized();
  }
};

// Larger bands are cut coarsely first: the flow's time grows faster than its nodes.
constexpr int manyNodes = 20000;
constexpr int coarseNodes = 8000;

template <typename Visit>
void eachNeighbour(const Adjacency& adjacency, int triangle, const Visit& visit)
{
  for (const int edge : adjacency.triangleEdges[triangle])
  {
    if (edge >= 0)
    {
      for (const int t : adjacency.trianglesAt(edge))
      {
        if (t != triangle)
        {
          visit(t);
        }
      }
    }
  }
}

// One node for each connected clump of `size` band triangles, or less where they run out. Returns the number
// of nodes.
int clump(const Adjacency& adjacency, const std::vector<int>& band, std::vector<Facet>& facets, int size)
{
  int nodes = 0;
  for (const int t : band)
  {
    facets[t].node = -1;
  }
  std::vector<int> members;
  for (const int start : band)
  {
    if (facets[start].role != Band || facets[start].node >= 0)
    {
      continue;
    }
    members.assign(1, start);
    facets[start].node = nodes;
    for (std::size_t i = 0; i < members.size() && int(members.size()) < size; ++i)
    {
      eachNeighbour(adjacency,
        members[i],
        [&](int t)
        {
          if (facets[t].role == Band && facets[t].node < 0 && int(members.size()) < size)
          {
            facets[t].node = nodes;
            members.push_back(t);
          }
        });
    }
    ++nodes;
  }
  return nodes;
}

// The minimum cut of the band's nodes: per triangle, whether it is inside.
std::vector<char> minimumCut(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const std::vector<int>& band,
  const std::vector<Facet>& facets,
  int nodes,
  double width,
  double faithful)
{
  const double scale = 1e9 / boundingDiagonal(mesh); // whole numbers below 2^53 keep the flow exact
  FlowNetwork network{ std::vector<double>(nodes, 0.0), std::vector<double>(nodes, 0.0), {} };
  for (const int t : band)
  {
    const Facet& facet = facets[t];
    if (facet.node < 0)
    {
      continue;
    }
    if (facet.selected == 0 || facet.selected == 3)
    {
      (facet.selected == 3 ? network.source : network.sink)[facet.node] +=
        std::round(scale * faithful * facetArea(mesh, t) / width);
    }
    for (const int e : adjacency.triangleEdges[t])
    {
      // An edge is its first node's.
      if (e < 0 || t != *std::find_if(adjacency.trianglesBegin(e),
                          adjacency.trianglesEnd(e),
                          [&](int other) { return facets[other].node >= 0; }))
      {
        continue;
      }
      const MeshEdge& edge = adjacency.edges[e];
      const int* triangles = adjacency.trianglesBegin(e);
      for (int i = 0; i < edge.triangleCount; ++i)
      {
        for (int j = i + 1; j < edge.triangleCount; ++j)
        {
          const Facet& a = facets[triangles[i]];
          const Facet& b = facets[triangles[j]];
          if (a.node == b.node) // one clump, or both outside the band
          {
            continue;
          }
          const Plane from(mesh, normals, triangles[i]), to(mesh, normals, triangles[j]);
          const Vector3 step = to.centre - from.centre;
          const double squared = step.squaredNorm();
          const double curvature =
            squared > 0.0 ? (to.normal - from.normal).dot(step) / squared : 0.0; // < 0: concave
          const double cost = std::round(scale * (mesh.points[edge.v0] - mesh.points[edge.v1]).norm() /
                                         (1.0 + width * std::max(0.0, -curvature)));
          if (a.node >= 0 && b.node >= 0)
          {
            network.links.push_back({ a.node, b.node, cost });
          }
          else
          {
            const Facet& fixed = a.node >= 0 ? b : a;
            (fixed.role == Inside ? network.source : network.sink)[std::max(a.node, b.node)] += cost;
          }
        }
      }
    }
  }
  const std::vector<char> side = leastCut(network);
  std::vector<char> inside(facets.size());
  for (std::size_t t = 0; t < facets.size(); ++t)
  {
    inside[t] = facets[t].node >= 0 ? side[facets[t].node] : facets[t].role == Inside;
  }
  return inside;
}

// Leaves only the triangles within `rings` of the cut in the band; the others keep their side.
void narrowBand(const Adjacency& adjacency,
  const std::vector<int>& band,
  const std::vector<char>& inside,
  int rings,
  std::vector<Facet>& facets)
{
  std::vector<char> near(facets.size(), 0);
  std::vector<int> front;
  for (const int t : band)
  {
    eachNeighbour(adjacency,
      t,
      [&](int other)
      {
        for (const int side : { t, other })
        {
          if (inside[other] != inside[t] && !near[side])
          {
            near[side] = 1;
            front.push_back(side);
          }
        }
      });
  }
  for (int ring = 1; ring < rings; ++ring)
  {
    std::vector<int> next;
    for (int t : front)
    {
      eachNeighbour(adjacency,
        t,
        [&](int other)
        {
          if (!near[other])
          {
            near[other] = 1;
            next.push_back(other);
          }
        });
    }
    front.swap(next);
  }
  for (const int t : band)
  {
    if (!near[t])
    {
      facets[t].role = inside[t] ? Inside : Outside;
    }
  }
}

double regionArea(const std::vector<double>& areas, const std::vector<char>& region)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    sum += region[v] ? areas[v] : 0.0;
  }
  return sum;
}

} // namespace

std::vector<char> cutAtJunction(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const MeshParts& parts,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  const CutOptions& options,
  const Context& context)
{
  const std::vector<int> border = borderOf(adjacency, region, true);
  const std::vector<int> seeds = marked(isSeed);
  if (border.empty())
  {
    return region;
  }
  const double unit = medianDiameter(diameter, border);
  const double band = options.band * unit;
  if (!(band > 0.0))
  {
    return region;
  }
  const std::vector<double> fromBorder = edgeDistances(mesh, adjacency, border, band);
  const std::vector<double> fromSeeds = edgeDistances(mesh, adjacency, seeds, options.keep * unit);

  std::vector<Facet> facets(mesh.triangles.size());
  std::vector<int> triangles; // of the band, ascending
  bool anyOutside = false;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const auto [a, b, c] = mesh.triangles[t];
    Facet& facet = facets[t];
    facet.node = -1;
    facet.selected = static_cast<char>(region[a] + region[b] + region[c]);
    const auto reached = [](double distance) { return std::isfinite(distance); };
    const bool seed = isSeed[a] || isSeed[b] || isSeed[c];
    const bool kept =
      facet.selected == 3 && reached(fromSeeds[a]) && reached(fromSeeds[b]) && reached(fromSeeds[c]);
    const bool near = reached(fromBorder[a]) || reached(fromBorder[b]) || reached(fromBorder[c]);
    facet.role = seed || kept ? Inside : near ? Band : facet.selected == 3 ? Inside : Outside;
    anyOutside = anyOutside || facet.role == Outside;
    if (facet.role == Band)
    {
      triangles.push_back(t);
    }
  }
  int nodes = clump(adjacency, triangles, facets, 1);
  if (!anyOutside || nodes == 0)
  {
    return region; // nothing would hold the other side of the cut
  }

  context.checkpoint(0.0);
  if (nodes > manyNodes)
  {
    const int size = nodes / coarseNodes;
    nodes = clump(adjacency, triangles, facets, size);
    const std::vector<char> coarse =
      minimumCut(mesh, adjacency, normals, triangles, facets, nodes, band, options.faithful);
    context.checkpoint(0.6);
    narrowBand(adjacency, triangles, coarse, 3 * int(std::ceil(std::sqrt(size))), facets);
    nodes = clump(adjacency, triangles, facets, 1);
  }
  const std::vector<char> inside =
    minimumCut(mesh, adjacency, normals, triangles, facets, nodes, band, options.faithful);

  std::vector<char> moved = isSeed;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (inside[t])
    {
      for (int v : mesh.triangles[t])
      {
        moved[v] = 1;
      }
    }
  }
  return regionArea(parts.areas, moved) < 0.5 * regionArea(parts.areas, region) ? region : moved;
}

std::vector<char> cutBridges(const Mesh& mesh,
  const Adjacency& adjacency,
  const MeshParts& parts,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  double share)
{
  std::vector<int> outside;
  for (const int v : borderOf(adjacency, region, true))
  {
    const Lists::Range around = adjacency.vertexVertices[v];
    std::copy_if(
      around.begin(), around.end(), std::back_inserter(outside), [&](int n) { return !region[n]; });
  }
  const std::vector<int> seeds = marked(isSeed);
  if (seeds.empty() || outside.empty())
  {
    return region;
  }
  const double unit = medianDiameter(diameter, seeds);
  const std::vector<double> fromOutside = edgeDistances(mesh, adjacency, outside, share * unit);
  std::vector<char> inner(region);
  for (std::size_t v = 0; v < inner.size(); ++v)
  {
    inner[v] = region[v] && !std::isfinite(fromOutside[v]);
  }
  std::vector<char> held(inner);
  dropSeedless(adjacency, isSeed, held);
  std::vector<int> seeded, seedless;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (inner[v])
    {
      (held[v] ? seeded : seedless).push_back(v);
    }
  }
  if (seeded.empty() || seedless.empty())
  {
    return region;
  }
  const double everywhere = std::numeric_limits<double>::infinity();
  const std::vector<double> toSeeded = edgeDistances(mesh, adjacency, seeded, everywhere);
  const std::vector<double> toSeedless = edgeDistances(mesh, adjacency, seedless, everywhere);
  std::vector<char> kept(region);
  double lost = 0.0;
  for (std::size_t v = 0; v < kept.size(); ++v)
  {
    kept[v] = isSeed[v] || (region[v] && toSeeded[v] <= toSeedless[v]);
    lost += region[v] && !kept[v] ? parts.areas[v] : 0.0;
  }
  constexpr double pi = 3.14159265358979323846;
  return lost < pi * unit * unit ? region : kept; // less than a tube as long as thick is a patch, no limb
}

namespace
{

constexpr double longestLoop = 1.5; // of the region's longest border
constexpr int radii = 48;           // that are tried

struct Borders
{
  int count = 0;
  double longest = 0.0;
  bool closed = true; // all of them
};

// The lines that run through the triangles with vertices on both sides, from edge to edge.
Borders bordersOf(const Mesh& mesh, const Adjacency& adjacency, const std::vector<char>& region)
{
  Borders borders;
  std::vector<int> crossed;
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    if (region[edge.v0] != region[edge.v1])
    {
      crossed.push_back(e);
      borders.closed = borders.closed && edge.triangleCount == 2;
    }
  }
  const auto numberOf = [&](int edge)
  { return static_cast<int>(std::lower_bound(crossed.begin(), crossed.end(), edge) - crossed.begin()); };
  const auto middle = [&](int e) -> Vector3
  { return 0.5 * (mesh.points[adjacency.edges[e].v0] + mesh.points[adjacency.edges[e].v1]); };
  std::vector<int> leader(crossed.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto leads = [&](int i)
  {
    while (leader[i] != i)
    {
      i = leader[i] = leader[leader[i]];
    }
    return i;
  };
  std::vector<double> lengths(crossed.size(), 0.0);
  for (const int edge : crossed)
  {
    for (const int t : adjacency.trianglesAt(edge))
    {
      for (const int other : adjacency.triangleEdges[t])
      {
        const MeshEdge& ends = adjacency.edges[other];
        if (other <= edge || region[ends.v0] == region[ends.v1])
        {
          continue; // a triangle has two of them, the lower one joins the other
        }
        const int first = leads(numberOf(edge)), second = leads(numberOf(other));
        lengths[first] += (middle(edge) - middle(other)).norm() + (first != second ? lengths[second] : 0.0);
        leader[second] = first;
      }
    }
  }
  for (std::size_t i = 0; i < leader.size(); ++i)
  {
    if (leader[i] == static_cast<int>(i))
    {
      ++borders.count;
      borders.longest = std::max(borders.longest, lengths[i]);
    }
  }
  return borders;
}

} // namespace

std::vector<char> cutAtFork(const Mesh& mesh,
  const Adjacency& adjacency,
  const MeshParts& parts,
  const std::vector<int>& seeds,
  const std::vector<char>& region)
{
  const Borders whole = bordersOf(mesh, adjacency, region);
  if (whole.count < 2 || !whole.closed)
  {
    return region;
  }
  const std::vector<double> distance = edgeDistances(mesh, adjacency, seeds);
  double farthest = 0.0;
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    farthest = region[v] && std::isfinite(distance[v]) ? std::max(farthest, distance[v]) : farthest;
  }
  for (int step = radii - 1; step > 0; --step)
  {
    const double radius = farthest * step / radii;
    std::vector<char> near(region);
    for (std::size_t v = 0; v < near.size(); ++v)
    {
      near[v] = region[v] && distance[v] <= radius;
    }
    fillIslands(parts, adjacency, near);
    const Borders borders = bordersOf(mesh, adjacency, near);
    if (borders.count == 1 && borders.longest <= longestLoop * whole.longest)
    {
      return near;
    }
  }
  return region;
}

} // namespace oversketch
