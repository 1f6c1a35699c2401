#include "Silhouette/extract.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

struct Extraction
{
  const Mesh& mesh;
  const Adjacency& adjacency;
  const std::vector<Vector3>& normals;
  std::vector<double> g;
  double zero = 0.0;         // |g| up to this counts as on the silhouette
  std::vector<char> visited; // triangles

  bool crossed(int edge) const
  {
    const MeshEdge& e = this->adjacency.edges[edge];
    return (this->g[e.v0] >= 0.0) != (this->g[e.v1] >= 0.0);
  }

  // The other crossed edge of a triangle that has one.
  int across(int triangle, int edge) const
  {
    for (int other : this->adjacency.triangleEdges[triangle])
    {
      if (other != edge && this->crossed(other))
      {
        return other;
      }
    }
    return edge;
  }

  CurvePoint pointOn(int edge) const
  {
    const MeshEdge& e = this->adjacency.edges[edge];
    const double g0 = this->g[e.v0], g1 = this->g[e.v1];
    // Of two ends on the silhouette the one that counts as + is taken, so that a run round it is one run.
    const int plus = g0 >= 0.0 ? e.v0 : e.v1, minus = g0 >= 0.0 ? e.v1 : e.v0;
    CurvePoint p;
    if (std::abs(this->g[plus]) <= this->zero)
      p.binding = Binding::vertex(plus);
    else if (std::abs(this->g[minus]) <= this->zero)
      p.binding = Binding::vertex(minus);
    else
      p.binding = Binding::edge(e.v0, e.v1, g1 / (g1 - g0));
    p.position = p.binding.of(this->mesh.points);
    p.normal = p.binding.of(this->normals).normalized();
    return p;
  }

  // Follows the crossed edges from an edge through one of its triangles and appends them, until the curve
  // ends or is back at the edge it started from; true for the latter.
  bool walk(int start, int triangle, std::vector<int>& chain)
  {
    for (int edge = start; !this->visited[triangle];)
    {
      this->visited[triangle] = 1;
      edge = this->across(triangle, edge);
      if (edge == start)
      {
        return true;
      }
      chain.push_back(edge);
      if (this->adjacency.edges[edge].triangleCount != 2)
      {
        break;
      }
      const int* sides = this->adjacency.trianglesBegin(edge);
      triangle = sides[0] == triangle ? sides[1] : sides[0];
    }
    return false;
  }

  void emit(const std::vector<int>& chain, bool closed, std::vector<Curve>& curves) const
  {
    const auto sameVertex = [](const CurvePoint& a, const CurvePoint& b) {
      return a.binding.onVertex() && b.binding.onVertex() && a.binding.vertices[0] == b.binding.vertices[0];
    };
    Curve curve;
    for (int edge : chain)
    {
      const CurvePoint p = this->pointOn(edge);
      if (curve.points.empty() || !sameVertex(curve.points.back(), p))
      {
        curve.points.push_back(p);
      }
    }
    if (closed && curve.points.size() > 1 && sameVertex(curve.points.front(), curve.points.back()))
    {
      curve.points.pop_back();
    }
    curve.closed = closed && curve.points.size() > 2; // two points go to and fro on one edge
    if (curve.points.size() > 1)
    {
      curves.push_back(std::move(curve));
    }
  }
};

} // namespace

std::vector<Curve> extractSilhouette(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view)
{
  Extraction extraction{ mesh,
    adjacency,
    normals,
    std::vector<double>(mesh.points.size()),
    0.0,
    std::vector<char>(mesh.triangles.size(), 0) };
  double largest = 0.0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    extraction.g[v] = normals[v].dot(view.towardsViewer(mesh.points[v]));
    largest = std::max(largest, std::abs(extraction.g[v]));
  }
  extraction.zero = 1e-9 * largest;

  std::vector<Curve> curves;
  std::vector<int> chain;
  for (int seed = 0; seed < static_cast<int>(adjacency.edges.size()); ++seed)
  {
    if (!extraction.crossed(seed))
    {
      continue;
    }
    const int* sides = adjacency.trianglesBegin(seed);
    const bool through = adjacency.edges[seed].triangleCount == 2;
    // One curve runs through a usual edge; at any other, every triangle starts a curve of its own.
    for (int side = 0; side < (through ? 1 : adjacency.edges[seed].triangleCount); ++side)
    {
      if (extraction.visited[sides[side]])
      {
        continue;
      }
      chain.assign(1, seed);
      const bool closed = extraction.walk(seed, sides[side], chain);
      if (through && !closed)
      {
        std::reverse(chain.begin(), chain.end());
        extraction.walk(seed, sides[1], chain);
      }
      extraction.emit(chain, closed, curves);
    }
  }
  return curves;
}

} // namespace oversketch
