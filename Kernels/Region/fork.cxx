#include "Region/fork.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace oversketch
{

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
    for (const int* t = adjacency.trianglesBegin(edge); t != adjacency.trianglesEnd(edge); ++t)
    {
      for (const int other : adjacency.triangleEdges[*t])
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
