// Distances from a curve over a real surface beside the exact ones on its triangles, from places of the
// curve's edges an eighth of an edge apart, as CGAL finds them.
#include "edit_jobs.h"

#ifdef OVERSKETCH_CGAL
#include "Mesh/context.h"
#include "Shading/fields.h"
#include "vtkOversketchFilterTools.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#endif

namespace oversketch_bench
{

#ifdef OVERSKETCH_CGAL
namespace
{

using ExactSurface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using ExactTraits = CGAL::Surface_mesh_shortest_path_traits<CGAL::Simple_cartesian<double>, ExactSurface>;
using ExactPaths = CGAL::Surface_mesh_shortest_path<ExactTraits>;

constexpr double reach = 0.12, halfCurve = 0.06; // of the model's diagonal
constexpr int parts = 8;                         // of an edge
constexpr double nearest = 2.0;                  // mean edges: nearer ones are not asked

// A part of the bunny, and a chain of its edges through the middle.
struct BunnyPart
{
  Mesh patch;
  Adjacency adjacency;
  std::vector<int> chain;
  double meanEdge = 0.0;

  explicit BunnyPart(const Mesh& whole)
  {
    const Adjacency links = buildAdjacency(whole);
    const int middle = static_cast<int>(std::max_element(whole.points.begin(),
                                          whole.points.end(),
                                          [](const Vector3& a, const Vector3& b) { return a[2] < b[2]; }) -
                                        whole.points.begin());
    const std::vector<double> away = edgeDistances(whole, links, { middle });
    std::vector<int> number(whole.points.size(), -1);
    for (const Triangle& t : whole.triangles)
    {
      if (away[t[0]] < reach && away[t[1]] < reach && away[t[2]] < reach)
      {
        Triangle mine{};
        for (int k = 0; k < 3; ++k)
        {
          if (number[t[k]] < 0)
          {
            number[t[k]] = this->patch.vertexCount();
            this->patch.points.push_back(whole.points[t[k]]);
          }
          mine[k] = number[t[k]];
        }
        this->patch.triangles.push_back(mine);
      }
    }
    this->adjacency = buildAdjacency(this->patch);
    for (const MeshEdge& edge : this->adjacency.edges)
    {
      this->meanEdge += (this->patch.points[edge.v0] - this->patch.points[edge.v1]).norm();
    }
    this->meanEdge /= static_cast<double>(this->adjacency.edges.size());
    const auto farthest = [&](int from)
    {
      const std::vector<double> far = edgeDistances(this->patch, this->adjacency, { from });
      const std::vector<double> centred = edgeDistances(this->patch, this->adjacency, { number[middle] });
      int best = from;
      for (int v = 0; v < this->patch.vertexCount(); ++v)
      {
        best = centred[v] < halfCurve && far[v] > far[best] ? v : best;
      }
      return best;
    };
    const int begin = farthest(number[middle]), end = farthest(begin);
    const std::vector<double> left = edgeDistances(this->patch, this->adjacency, { end });
    for (int v = begin;; v = *std::min_element(this->adjacency.vertexVertices.begin(v),
                           this->adjacency.vertexVertices.end(v),
                           [&](int a, int b) { return left[a] < left[b]; }))
    {
      this->chain.push_back(v);
      if (v == end)
      {
        break;
      }
    }
  }
};

const BunnyPart& bunnyPart(const std::string& size)
{
  static std::map<std::string, std::unique_ptr<BunnyPart>> made;
  std::unique_ptr<BunnyPart>& part = made[size];
  part = part ? std::move(part) : std::make_unique<BunnyPart>(model(size).mesh);
  return *part;
}

std::vector<double> ownDistances(const BunnyPart& part)
{
  return chainDistances(part.patch, part.adjacency, part.chain, false, false, ThreadsOnly()).distance;
}

std::vector<double> exactDistances(const BunnyPart& part)
{
  ExactSurface surface;
  for (const Vector3& p : part.patch.points)
  {
    surface.add_vertex({ p[0], p[1], p[2] });
  }
  const auto vertex = [](int v) { return ExactSurface::Vertex_index(static_cast<unsigned>(v)); };
  for (const Triangle& t : part.patch.triangles)
  {
    if (surface.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) == ExactSurface::null_face())
    {
      std::abort();
    }
  }
  ExactPaths paths(surface);
  for (std::size_t i = 1; i < part.chain.size(); ++i)
  {
    const auto h = surface.halfedge(vertex(part.chain[i - 1]), vertex(part.chain[i]));
    const auto inside = surface.is_border(h) ? surface.opposite(h) : h;
    for (int k = 0; k <= parts; ++k)
    {
      paths.add_source_point(paths.face_location(inside, static_cast<double>(k) / parts));
    }
  }
  paths.build_sequence_tree();
  std::vector<double> distances;
  for (const auto v : surface.vertices())
  {
    distances.push_back(paths.shortest_distance_to_source_points(v).first);
  }
  return distances;
}

std::map<std::string, double> comparison(const BunnyPart& part)
{
  const std::vector<double> own = ownDistances(part), exact = exactDistances(part);
  std::vector<double> off;
  for (std::size_t v = 0; v < exact.size(); ++v)
  {
    if (exact[v] >= nearest * part.meanEdge)
    {
      off.push_back(100.0 * std::abs(own[v] - exact[v]) / exact[v]);
    }
  }
  std::sort(off.begin(), off.end());
  const auto percentile = [&](std::size_t share) { return off[(off.size() - 1) * share / 100]; };
  return { { "vertices", static_cast<double>(off.size()) },
    { "median_off_percent", percentile(50) },
    { "p95_off_percent", percentile(95) },
    { "most_off_percent", off.back() } };
}

} // namespace
#endif

void addDistances()
{
#ifdef OVERSKETCH_CGAL
  for (const std::string& size : sizes({ "5k", "30k", "180k" }))
  {
    const auto prepare = [size] { bunnyPart(size); };
    Job ours{
      "distance on the bunny", size, "ours", 1, prepare, [size] { ownDistances(bunnyPart(size)); }, {}
    };
    ours.figures = [size] { return comparison(bunnyPart(size)); };
    add(ours);
  }
#endif
}

} // namespace oversketch_bench
