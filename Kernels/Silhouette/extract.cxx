#include "Silhouette/extract.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

std::vector<Curve> extractSilhouette(
  const Mesh& mesh, const Adjacency& adjacency, const std::vector<Vector3>& normals, const View& view)
{
  const int vertices = mesh.vertexCount();
  std::vector<double> g(vertices);
  double largest = 0.0;
  for (int v = 0; v < vertices; ++v)
  {
    g[v] = normals[v].dot(view.towardsViewer(mesh.points[v]));
    largest = std::max(largest, std::abs(g[v]));
  }
  const auto crossed = [&](int edge)
  { return (g[adjacency.edges[edge].v0] >= 0.0) != (g[adjacency.edges[edge].v1] >= 0.0); };
  // The other crossed edge of a triangle.
  const auto across = [&](int triangle, int edge)
  {
    for (int other : adjacency.triangleEdges[triangle])
    {
      if (other >= 0 && other != edge && crossed(other))
      {
        return other;
      }
    }
    return -1;
  };
  const double zero = 1e-9 * largest;
  const auto pointOn = [&](int edge)
  {
    const MeshEdge& e = adjacency.edges[edge];
    CurvePoint p;
    if (std::abs(g[e.v0]) <= zero)
      p.binding = Binding::vertex(e.v0);
    else if (std::abs(g[e.v1]) <= zero)
      p.binding = Binding::vertex(e.v1);
    else
      p.binding = Binding::edge(e.v0, e.v1, g[e.v1] / (g[e.v1] - g[e.v0]));
    p.position = p.binding.of(mesh.points);
    p.normal = p.binding.of(normals).normalized();
    return p;
  };

  std::vector<char> visited(adjacency.edges.size(), 0);
  // From an edge through one of its triangles until the curve ends or closes.
  const auto walk = [&](int edge, int triangle, std::vector<int>& chain)
  {
    while (true)
    {
      const int next = across(triangle, edge);
      if (next < 0 || visited[next])
      {
        return;
      }
      visited[next] = 1;
      chain.push_back(next);
      const int* begin = adjacency.trianglesBegin(next);
      if (adjacency.edges[next].triangleCount != 2)
      {
        return;
      }
      triangle = begin[0] == triangle ? begin[1] : begin[0];
      edge = next;
    }
  };

  std::vector<Curve> curves;
  for (int seed = 0; seed < static_cast<int>(adjacency.edges.size()); ++seed)
  {
    if (visited[seed] || !crossed(seed) || adjacency.edges[seed].triangleCount > 2)
    {
      continue;
    }
    visited[seed] = 1;
    std::vector<int> chain{ seed };
    const int* triangles = adjacency.trianglesBegin(seed);
    walk(seed, triangles[0], chain);
    bool closed = false;
    if (adjacency.edges[seed].triangleCount == 2)
    {
      closed = chain.size() > 2 && across(triangles[1], seed) == chain.back();
      if (!closed)
      {
        std::reverse(chain.begin(), chain.end());
        walk(seed, triangles[1], chain);
      }
    }
    Curve curve;
    curve.closed = closed;
    for (int edge : chain)
    {
      CurvePoint p = pointOn(edge);
      if (curve.points.empty() || !p.binding.onVertex() || !curve.points.back().binding.onVertex() ||
        curve.points.back().binding.vertices[0] != p.binding.vertices[0])
      {
        curve.points.push_back(p);
      }
    }
    if (curve.closed && curve.points.size() > 1 && curve.points.front().binding.onVertex() &&
      curve.points.back().binding.onVertex() &&
      curve.points.front().binding.vertices[0] == curve.points.back().binding.vertices[0])
    {
      curve.points.pop_back();
    }
    if (curve.points.size() > 1)
    {
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

} // namespace oversketch
