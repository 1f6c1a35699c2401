#include "Region/cut.h"

#include "Region/grow.h"

#include <opencv2/core.hpp>
// The library's own maximum flow (behind its GrabCut); the alternative would be Boost's, an order slower to
// build.
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include <algorithm>
#include <cmath>

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

// What the cut knows of each triangle.
struct Facet
{
  Vector3 centre, normal;
  double area;
  int selected; // corners in the region
  Role role;
  int node; // in the graph; -1 outside the band
};

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
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  const CutOptions& options)
{
  std::vector<int> border, seeds;
  std::vector<double> thickness;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (isSeed[v])
    {
      seeds.push_back(v);
    }
    if (region[v] && std::any_of(adjacency.vertexVertices.begin(v),
                       adjacency.vertexVertices.end(v),
                       [&](int n) { return !region[n]; }))
    {
      border.push_back(v);
      thickness.push_back(diameter[v]);
    }
  }
  if (border.empty())
  {
    return region;
  }
  std::nth_element(thickness.begin(), thickness.begin() + thickness.size() / 2, thickness.end());
  const double unit = thickness[thickness.size() / 2];
  const double band = options.band * unit;
  if (!(band > 0.0))
  {
    return region;
  }
  const std::vector<double> fromBorder = edgeDistances(mesh, adjacency, border, band);
  const std::vector<double> fromSeeds = edgeDistances(mesh, adjacency, seeds, options.keep * unit);

  std::vector<Facet> facets(mesh.triangles.size());
  int nodes = 0;
  bool anyOutside = false;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const auto [a, b, c] = mesh.triangles[t];
    Facet& facet = facets[t];
    facet.centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    facet.normal = (normals[a] + normals[b] + normals[c]).stableNormalized();
    facet.area = 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
    facet.selected = region[a] + region[b] + region[c];
    const auto reached = [](double distance) { return std::isfinite(distance); };
    const bool seed = isSeed[a] || isSeed[b] || isSeed[c];
    const bool kept =
      facet.selected == 3 && reached(fromSeeds[a]) && reached(fromSeeds[b]) && reached(fromSeeds[c]);
    const bool near = reached(fromBorder[a]) || reached(fromBorder[b]) || reached(fromBorder[c]);
    facet.role = seed || kept ? Inside : near ? Band : facet.selected == 3 ? Inside : Outside;
    facet.node = facet.role == Band ? nodes++ : -1;
    anyOutside = anyOutside || facet.role == Outside;
  }
  if (!anyOutside || nodes == 0)
  {
    return region; // nothing would hold the other side of the cut
  }

  // Whole numbers below 2^53 keep the flow exact.
  const double scale = 1e9 / boundingDiagonal(mesh);
  std::vector<double> source(nodes, 0.0), sink(nodes, 0.0);
  for (const Facet& facet : facets)
  {
    if (facet.node >= 0 && (facet.selected == 0 || facet.selected == 3))
    {
      (facet.selected == 3 ? source : sink)[facet.node] =
        std::round(scale * options.faithful * facet.area / band);
    }
  }
  cv::detail::GCGraph<double> graph(static_cast<unsigned>(nodes), static_cast<unsigned>(3 * nodes));
  for (int i = 0; i < nodes; ++i)
  {
    graph.addVtx();
  }
  for (const MeshEdge& edge : adjacency.edges)
  {
    const int* triangles = adjacency.edgeTriangles.data() + edge.firstTriangle;
    for (int i = 0; i < edge.triangleCount; ++i)
    {
      for (int j = i + 1; j < edge.triangleCount; ++j)
      {
        const Facet& a = facets[triangles[i]];
        const Facet& b = facets[triangles[j]];
        if (a.node < 0 && b.node < 0)
        {
          continue;
        }
        const Vector3 step = b.centre - a.centre;
        const double squared = step.squaredNorm();
        const double curvature =
          squared > 0.0 ? (b.normal - a.normal).dot(step) / squared : 0.0; // < 0: concave
        const double cost = std::round(scale * (mesh.points[edge.v0] - mesh.points[edge.v1]).norm() /
                                       (1.0 + band * std::max(0.0, -curvature)));
        if (a.node >= 0 && b.node >= 0)
        {
          graph.addEdges(a.node, b.node, cost, cost);
        }
        else
        {
          const Facet& fixed = a.node >= 0 ? b : a;
          (fixed.role == Inside ? source : sink)[std::max(a.node, b.node)] += cost;
        }
      }
    }
  }
  for (int i = 0; i < nodes; ++i)
  {
    graph.addTermWeights(i, source[i], sink[i]);
  }
  graph.maxFlow();

  std::vector<char> moved = isSeed;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (facets[t].role == Inside || (facets[t].role == Band && graph.inSourceSegment(facets[t].node)))
    {
      for (int v : mesh.triangles[t])
      {
        moved[v] = 1;
      }
    }
  }
  const std::vector<double> areas = vertexAreas(mesh);
  return regionArea(areas, moved) < 0.5 * regionArea(areas, region) ? region : moved;
}

} // namespace oversketch
