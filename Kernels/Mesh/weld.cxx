#include "Mesh/weld.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <queue>

namespace oversketch
{

namespace
{

// Finds the first point in each position: open addressing, at most half full. A place that is not a number
// is met by none.
class PositionTable
{
public:
  explicit PositionTable(const std::vector<Vector3>& points)
    : Points(points)
  {
    std::size_t size = 16;
    while (size < 2 * points.size())
    {
      size *= 2;
    }
    this->Slots.assign(size, -1);
  }

  int firstAt(int point)
  {
    const std::size_t mask = this->Slots.size() - 1;
    for (std::size_t slot = hash(this->Points[point]) & mask;; slot = (slot + 1) & mask)
    {
      int& known = this->Slots[slot];
      if (known < 0)
      {
        known = point;
        return point;
      }
      if (this->Points[known] == this->Points[point])
      {
        return known;
      }
    }
  }

private:
  static std::size_t hash(const Vector3& p)
  {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double x = p[k] + 0.0; // -0 is 0
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof bits);
      h = (h ^ bits) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }

  const std::vector<Vector3>& Points;
  std::vector<int> Slots;
};

} // namespace

std::vector<int> weldPoints(const std::vector<Vector3>& points)
{
  const int count = static_cast<int>(points.size());
  PositionTable table(points);
  std::vector<int> vertices(points.size());
  int next = 0;
  for (int i = 0; i < count; ++i)
  {
    const int first = table.firstAt(i);
    vertices[i] = first == i ? next++ : vertices[first];
  }
  if (next == count)
  {
    vertices.clear();
  }
  return vertices;
}

Mesh weldedMesh(const Mesh& mesh, const std::vector<int>& vertices)
{
  Mesh welded;
  welded.triangles = mesh.triangles;
  for (int i = 0; i < mesh.vertexCount(); ++i)
  {
    if (vertices[i] == welded.vertexCount())
    {
      welded.points.push_back(mesh.points[i]);
    }
  }
  for (Triangle& t : welded.triangles)
  {
    for (int& v : t)
    {
      v = vertices[v];
    }
  }
  return welded;
}

std::vector<int> attributeClasses(const std::vector<int>& vertices, const PointValues& values)
{
  const int count = static_cast<int>(vertices.size());
  Lists points = Lists::gathered( // by vertex, ascending
    count > 0 ? *std::max_element(vertices.begin(), vertices.end()) + 1 : 0,
    [&](auto&& visit)
    {
      for (int i = 0; i < count; ++i)
      {
        visit(vertices[i], i);
      }
    });

  // Ordered by values, what is not a number last; then by number.
  const auto before = [&](int a, int b)
  {
    for (int c = 0; c < values.components; ++c)
    {
      const double x = values.value(a, c), y = values.value(b, c);
      const bool noX = x != x, noY = y != y;
      if (noX != noY || (!noX && x != y))
      {
        return noX || noY ? noY : x < y;
      }
    }
    return a < b;
  };
  const auto same = [&](int a, int b)
  {
    for (int c = 0; c < values.components; ++c)
    {
      if (!(values.value(a, c) == values.value(b, c)))
      {
        return false;
      }
    }
    return true;
  };
  std::vector<int> classes(vertices.size());
  for (std::size_t v = 0; v + 1 < points.offsets.size(); ++v)
  {
    int* const begin = points.values.data() + points.offsets[v];
    int* const end = points.values.data() + points.offsets[v + 1];
    if (end - begin > 1)
    {
      std::sort(begin, end, before);
    }
    for (const int* p = begin; p != end; ++p)
    {
      classes[*p] = p != begin && same(p[-1], *p) ? classes[p[-1]] : *p;
    }
  }
  return classes;
}

Charts findCharts(const Mesh& welded,
  const Adjacency& adjacency,
  const std::vector<Triangle>& corners,
  const std::vector<int>& classes)
{
  const auto classAt = [&](int triangle, int vertex)
  { return classes[corners[triangle][cornerOf(welded.triangles[triangle], vertex)]]; };
  // Neighbours across an edge of two triangles, and whether an attribute jumps there.
  const auto eachNeighbour = [&](int triangle, auto&& visit)
  {
    for (const int edge : adjacency.triangleEdges[triangle])
    {
      if (edge >= 0 && adjacency.edges[edge].triangleCount == 2)
      {
        const int* pair = adjacency.trianglesBegin(edge);
        const int other = pair[0] == triangle ? pair[1] : pair[0];
        const MeshEdge& e = adjacency.edges[edge];
        visit(other,
          classAt(triangle, e.v0) != classAt(other, e.v0) || classAt(triangle, e.v1) != classAt(other, e.v1));
      }
    }
  };
  Charts charts{ std::vector<int>(welded.triangles.size(), -1), 0 };
  for (int seed = 0; seed < welded.triangleCount(); ++seed)
  {
    if (charts.of[seed] >= 0)
    {
      continue;
    }
    std::queue<int> queue({ seed });
    charts.of[seed] = charts.count;
    while (!queue.empty())
    {
      const int t = queue.front();
      queue.pop();
      eachNeighbour(t,
        [&](int other, bool seam)
        {
          if (seam || charts.of[other] >= 0)
          {
            return;
          }
          bool clash = false;
          eachNeighbour(other,
            [&](int beyond, bool jump) { clash = clash || (jump && charts.of[beyond] == charts.count); });
          if (!clash)
          {
            charts.of[other] = charts.count;
            queue.push(other);
          }
        });
    }
    ++charts.count;
  }
  return charts;
}

} // namespace oversketch
