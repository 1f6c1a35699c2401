// Meshes whose edges lie on a reference curve and a boundary round it, and what must hold of such meshes.
// Header-only.
#ifndef oversketch_testing_harness_enclosures_h
#define oversketch_testing_harness_enclosures_h

#include "Harness/edges.h"

#include <array>

namespace oversketch_test
{

// Curves are chains of vertices; a closed one repeats its first.
struct Enclosure
{
  Mesh mesh;
  std::vector<int> reference, boundary;
};

// The unit sphere in `rings` (a multiple of 3) and `sectors` (even) round the z axis. The boundary is the
// ring at z = 0.5, the reference curve lies in y = 0 over the pole, 45 degrees to either side at most.
inline Enclosure ringedSphere(int rings, int sectors)
{
  Enclosure scene;
  Mesh& mesh = scene.mesh;
  mesh.points.emplace_back(0.0, 0.0, 1.0);
  for (int r = 1; r < rings; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      const double down = pi * r / rings, round = 2.0 * pi * s / sectors;
      mesh.points.emplace_back(std::sin(down) * std::cos(round),
        std::sin(down) * std::sin(round),
        3 * r == rings ? 0.5 : std::cos(down));
    }
  }
  mesh.points.emplace_back(0.0, 0.0, -1.0);
  const Rings net{ rings, sectors };
  mesh.triangles = net.triangles();
  for (int s = 0; s <= sectors; ++s)
  {
    scene.boundary.push_back(net.id(rings / 3, s));
  }
  scene.reference = net.overPole(rings / 4);
  return scene;
}

// Even triangles of side 1 in the plane z = 0, in a hexagon of `reach` + 4 triangles' side: the boundary is
// the hexagon of `reach`, the reference curve lies on the x axis through half of it.
inline Enclosure sheet(int reach)
{
  Enclosure scene;
  const int all = reach + 4, width = 2 * all + 1;
  std::vector<int> ids(static_cast<std::size_t>(width) * width, -1);
  const auto id = [&](int q, int r) -> int&
  { return ids[static_cast<std::size_t>(r + all) * width + q + all]; };
  const auto inside = [&](int q, int r) {
    return std::max({ std::abs(q), std::abs(r), std::abs(q + r) }) <= all;
  };
  for (int r = -all; r <= all; ++r)
  {
    for (int q = -all; q <= all; ++q)
    {
      if (inside(q, r))
      {
        id(q, r) = scene.mesh.vertexCount();
        scene.mesh.points.emplace_back(q + 0.5 * r, std::sqrt(0.75) * r, 0.0);
      }
    }
  }
  for (int r = -all; r <= all; ++r)
  {
    for (int q = -all; q <= all; ++q)
    {
      if (inside(q, r) && inside(q + 1, r) && inside(q, r + 1))
      {
        scene.mesh.triangles.push_back({ id(q, r), id(q + 1, r), id(q, r + 1) });
      }
      if (inside(q, r) && inside(q, r + 1) && inside(q - 1, r + 1))
      {
        scene.mesh.triangles.push_back({ id(q, r), id(q, r + 1), id(q - 1, r + 1) });
      }
    }
  }
  const std::array<std::array<int, 2>, 6> ways = {
    { { -1, 1 }, { -1, 0 }, { 0, -1 }, { 1, -1 }, { 1, 0 }, { 0, 1 } }
  };
  int q = reach, r = 0;
  for (const std::array<int, 2>& way : ways)
  {
    for (int step = 0; step < reach; ++step)
    {
      scene.boundary.push_back(id(q, r));
      q += way[0];
      r += way[1];
    }
  }
  scene.boundary.push_back(scene.boundary.front());
  for (int k = -reach / 2; k <= reach / 2; ++k)
  {
    scene.reference.push_back(id(k, 0));
  }
  return scene;
}

// The least distance of a place to a chain.
inline double distanceTo(const Mesh& mesh, const std::vector<int>& chain, const Vector3& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    const Vector3 &from = mesh.points[chain[i - 1]], step = mesh.points[chain[i]] - from;
    const double share = std::clamp((place - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - from - share * step).norm());
  }
  return least;
}

// By vertex, 0 on the reference curve and 1 on the boundary; 1 where the region says outside.
inline std::vector<double> sharesOf(const Enclosure& scene, const std::vector<char>& region)
{
  std::vector<double> shares(scene.mesh.points.size(), 1.0);
  for (std::size_t v = 0; v < shares.size(); ++v)
  {
    if (region[v] == 2)
    {
      const double near = distanceTo(scene.mesh, scene.reference, scene.mesh.points[v]);
      shares[v] = near / (near + distanceTo(scene.mesh, scene.boundary, scene.mesh.points[v]));
    }
  }
  return shares;
}

// No edge twice in one direction, every vertex in a triangle.
inline bool isManifold(const Mesh& mesh)
{
  std::set<std::pair<int, int>> sides;
  std::set<int> vertices;
  bool sound = true;
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      sound = sides.insert({ t[k], t[(k + 1) % 3] }).second && sound;
      vertices.insert(t[k]);
    }
  }
  return sound && static_cast<int>(vertices.size()) == mesh.vertexCount();
}

inline bool isChainOfEdges(const Mesh& mesh, const std::vector<int>& chain)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  bool joined = chain.size() > 1;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    joined = joined && adjacency.findEdge(chain[i - 1], chain[i]) >= 0;
  }
  return joined;
}

} // namespace oversketch_test
#endif
