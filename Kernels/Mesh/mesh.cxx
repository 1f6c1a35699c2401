#include "Mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace oversketch
{

namespace
{

// Lists of `count` buckets from (bucket, value) pairs given in order; order within a bucket is kept.
template <typename Visit>
Lists gather(int count, const Visit& visit)
{
  Lists lists;
  lists.offsets.assign(count + 1, 0);
  visit([&](int bucket, int) { ++lists.offsets[bucket + 1]; });
  for (int i = 0; i < count; ++i)
  {
    lists.offsets[i + 1] += lists.offsets[i];
  }
  lists.values.resize(lists.offsets[count]);
  std::vector<int> next(lists.offsets.begin(), lists.offsets.end() - 1);
  visit([&](int bucket, int value) { lists.values[next[bucket]++] = value; });
  return lists;
}

} // namespace

int Adjacency::findEdge(int a, int b) const
{
  const auto key = std::minmax(a, b);
  const auto less = [](const MeshEdge& e, const std::pair<int, int>& k)
  { return e.v0 < k.first || (e.v0 == k.first && e.v1 < k.second); };
  const auto it = std::lower_bound(
    this->edges.begin(), this->edges.end(), std::pair<int, int>(key.first, key.second), less);
  return it != this->edges.end() && it->v0 == key.first && it->v1 == key.second
           ? static_cast<int>(it - this->edges.begin())
           : -1;
}

Adjacency buildAdjacency(const Mesh& mesh)
{
  const int vertices = mesh.vertexCount();
  const int triangles = mesh.triangleCount();
  Adjacency adjacency;
  adjacency.vertexTriangles = gather(vertices,
    [&](auto&& add)
    {
      for (int t = 0; t < triangles; ++t)
      {
        const Triangle& v = mesh.triangles[t];
        add(v[0], t);
        if (v[1] != v[0])
          add(v[1], t);
        if (v[2] != v[0] && v[2] != v[1])
          add(v[2], t);
      }
    });
  // Half-edges bucketed by their lower vertex, then sorted per bucket: edges come out ascending.
  struct Half
  {
    int v1, triangle, corner;
  };
  std::vector<int> offsets(vertices + 1, 0);
  const auto eachHalf = [&](auto&& visit)
  {
    for (int t = 0; t < triangles; ++t)
    {
      const Triangle& v = mesh.triangles[t];
      // A collapsed triangle has no edges: the two that remain of it are one, and the triangles on either
      // side of it are true neighbours.
      for (int k = 0; k < 3 && v[0] != v[1] && v[1] != v[2] && v[2] != v[0]; ++k)
      {
        visit(std::min(v[k], v[(k + 1) % 3]), Half{ std::max(v[k], v[(k + 1) % 3]), t, k });
      }
    }
  };
  eachHalf([&](int v0, const Half&) { ++offsets[v0 + 1]; });
  for (int i = 0; i < vertices; ++i)
  {
    offsets[i + 1] += offsets[i];
  }
  std::vector<Half> halves(offsets[vertices]);
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  eachHalf([&](int v0, const Half& half) { halves[next[v0]++] = half; });
  adjacency.triangleEdges.assign(triangles, { -1, -1, -1 });
  adjacency.borderVertex.assign(vertices, 0);
  adjacency.edges.reserve(halves.size() / 2 + 1);
  for (int v0 = 0; v0 < vertices; ++v0)
  {
    const auto begin = halves.begin() + offsets[v0];
    const auto end = halves.begin() + offsets[v0 + 1];
    std::sort(begin,
      end,
      [](const Half& a, const Half& b) { return a.v1 != b.v1 ? a.v1 < b.v1 : a.triangle < b.triangle; });
    for (auto it = begin; it != end;)
    {
      MeshEdge edge{ v0, it->v1, static_cast<int>(adjacency.edgeTriangles.size()), 0 };
      const int id = static_cast<int>(adjacency.edges.size());
      for (; it != end && it->v1 == edge.v1; ++it)
      {
        adjacency.triangleEdges[it->triangle][it->corner] = id;
        adjacency.edgeTriangles.push_back(it->triangle);
        ++edge.triangleCount;
      }
      if (edge.triangleCount == 1)
      {
        adjacency.borderVertex[edge.v0] = adjacency.borderVertex[edge.v1] = 1;
      }
      adjacency.edges.push_back(edge);
    }
  }
  adjacency.vertexVertices = gather(vertices,
    [&](auto&& add)
    {
      // Lower neighbours first, then higher ones: both ascend because the edges do.
      for (const MeshEdge& e : adjacency.edges)
      {
        add(e.v1, e.v0);
      }
      for (const MeshEdge& e : adjacency.edges)
      {
        add(e.v0, e.v1);
      }
    });
  return adjacency;
}

Vector3 facetNormal(const Mesh& mesh, int triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  const Vector3 n = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
  const double length = n.norm();
  return length > 0.0 ? Vector3(n / length) : Vector3(Vector3::Zero());
}

std::vector<Vector3> vertexNormals(const Mesh& mesh)
{
  std::vector<Vector3> normals(mesh.points.size(), Vector3::Zero());
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Vector3 n = facetNormal(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3& p = mesh.points[mesh.triangles[t][k]];
      const Vector3 a = mesh.points[mesh.triangles[t][(k + 1) % 3]] - p;
      const Vector3 b = mesh.points[mesh.triangles[t][(k + 2) % 3]] - p;
      normals[mesh.triangles[t][k]] += std::atan2(a.cross(b).norm(), a.dot(b)) * n;
    }
  }
  for (Vector3& n : normals)
  {
    const double length = n.norm();
    n = length > 0.0 ? Vector3(n / length) : Vector3(Vector3::Zero());
  }
  return normals;
}

double boundingDiagonal(const Mesh& mesh)
{
  if (mesh.points.empty())
  {
    return 0.0;
  }
  Vector3 low = mesh.points[0];
  Vector3 high = mesh.points[0];
  for (const Vector3& p : mesh.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

std::vector<double> edgeDistances(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& sources,
  double limit)
{
  std::vector<double> distance(mesh.points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int source : sources)
  {
    distance[source] = 0.0;
    queue.push({ 0.0, source });
  }
  while (!queue.empty())
  {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v])
    {
      continue;
    }
    for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
    {
      const double through = d + (mesh.points[*n] - mesh.points[v]).norm();
      if (through <= limit && through < distance[*n])
      {
        distance[*n] = through;
        queue.push({ through, *n });
      }
    }
  }
  return distance;
}

} // namespace oversketch
