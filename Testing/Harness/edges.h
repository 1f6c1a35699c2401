// A mesh's triangles and edges, counted and walked along. Header-only.
#ifndef oversketch_testing_harness_edges_h
#define oversketch_testing_harness_edges_h

#include "Harness/shapes.h"

#include <set>
#include <utility>
#include <vector>

namespace oversketch_test
{

// The vertices of a sphere from pole to pole: the first pole, rings of `sectors` vertices each, the other.
struct Rings
{
  int count, sectors; // from pole to pole, `count` steps

  int id(int ring, int sector) const
  {
    return ring == 0 ? 0
                     : 1 + (ring - 1) * this->sectors + (ring == this->count ? 0 : sector % this->sectors);
  }
  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> all;
    for (int s = 0; s < this->sectors; ++s)
    {
      all.push_back({ 0, this->id(1, s), this->id(1, s + 1) });
      for (int r = 1; r + 1 < this->count; ++r)
      {
        all.push_back({ this->id(r, s), this->id(r + 1, s), this->id(r + 1, s + 1) });
        all.push_back({ this->id(r, s), this->id(r + 1, s + 1), this->id(r, s + 1) });
      }
      const int last = this->count - 1;
      all.push_back({ this->id(last, s), this->id(this->count, s), this->id(last, s + 1) });
    }
    return all;
  }
  // Over the first pole, from `arm` rings away to as far on the other side, where sector 0 is.
  std::vector<int> overPole(int arm) const
  {
    std::vector<int> way;
    for (int k = -arm; k <= arm; ++k)
    {
      way.push_back(this->id(std::abs(k), k < 0 ? this->sectors / 2 : 0));
    }
    return way;
  }
};

// V - E + F of all vertices that triangles have.
inline int eulerNumber(const std::vector<Triangle>& triangles)
{
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      vertices.insert(a);
      edges.emplace(std::min(a, b), std::max(a, b));
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(triangles.size());
}

// The shortest way over edges.
inline std::vector<int> edgeWay(const Mesh& mesh, int from, int to)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<double> far = edgeDistances(mesh, adjacency, { to });
  std::vector<int> way{ from };
  while (way.back() != to)
  {
    const int v = way.back();
    way.push_back(*std::min_element(adjacency.vertexVertices.begin(v),
      adjacency.vertexVertices.end(v),
      [&](int a, int b)
      {
        return far[a] + (mesh.points[a] - mesh.points[v]).norm() <
               far[b] + (mesh.points[b] - mesh.points[v]).norm();
      }));
  }
  return way;
}

inline int nearestVertex(const Mesh& mesh, const Vector3& place)
{
  int nearest = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    nearest = (mesh.points[v] - place).norm() < (mesh.points[nearest] - place).norm() ? v : nearest;
  }
  return nearest;
}

} // namespace oversketch_test
#endif
