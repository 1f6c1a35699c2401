#include "Mesh/mesh.h"

#include "Mesh/context.h"

#include <cmath>
#include <cstdint>
#include <queue>

namespace oversketch
{

namespace
{

// A side of a triangle, seen from its lower vertex: the higher one in the upper half of the number, then the
// half-edge, 3 t + k for edge k of triangle t.
using Side = std::uint64_t;

int endOf(Side side)
{
  return static_cast<int>(side >> 32);
}

int halfEdgeOf(Side side)
{
  return static_cast<int>(side & 0xffffffffu);
}

// Few numbers are sorted by counting how many are smaller: no branch can go wrong in that.
void sortSides(Side* begin, Side* end)
{
  constexpr std::ptrdiff_t few = 12;
  const std::ptrdiff_t count = end - begin;
  if (count > few)
  {
    std::sort(begin, end);
    return;
  }
  Side sides[few];
  int rank[few] = {};
  std::copy(begin, end, sides);
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    for (std::ptrdiff_t j = i + 1; j < count; ++j)
    {
      const int later = sides[j] < sides[i] ? 1 : 0;
      rank[i] += later;
      rank[j] += 1 - later;
    }
  }
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    begin[rank[i]] = sides[i];
  }
}

// The sides of some vertices, as many as one thread takes at a time: those of a vertex together, ascending.
struct Sides
{
  static constexpr int vertices = 4096;
  std::vector<Side> all;
  std::vector<int> counts; // per vertex
  int edges = 0;           // different ends, over all vertices

  // A collapsed triangle has no edges: the two that remain of it are one, and the triangles on either side of
  // it are true neighbours.
  void gather(const Mesh& mesh, const Lists& around, int begin, int end)
  {
    this->all.reserve(around.offsets[end] - around.offsets[begin]); // half of two a triangle, or so
    this->counts.reserve(end - begin);
    std::vector<Side> sides; // of one vertex, and room for one more
    for (int v = begin; v < end; ++v)
    {
      sides.resize(std::max(sides.size(), static_cast<std::size_t>(2 * around.size(v) + 1)));
      Side *const first = sides.data(), *last = first;
      // Without a branch: each would go wrong every other time.
      const auto add = [v, &last](int to, int halfEdge)
      {
        *last = static_cast<Side>(to) << 32 | static_cast<std::uint32_t>(halfEdge);
        last += to > v ? 1 : 0;
      };
      for (const int t : around[v])
      {
        const Triangle& c = mesh.triangles[t];
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
        {
          continue;
        }
        constexpr int next[3] = { 1, 2, 0 };
        const int k = (c[1] == v ? 1 : 0) + (c[2] == v ? 2 : 0), before = next[next[k]];
        add(c[next[k]], 3 * t + k);
        add(c[before], 3 * t + before);
      }
      sortSides(first, last);
      this->counts.push_back(static_cast<int>(last - first));
      for (const Side* side = first; side != last; ++side)
      {
        this->edges += side == first || endOf(*side) != endOf(side[-1]) ? 1 : 0;
      }
      this->all.insert(this->all.end(), first, last);
    }
  }
};

// Each vertex lists its lower neighbours, then its higher ones: both ascend because the edges do.
void listNeighbours(Adjacency& adjacency)
{
  const std::vector<int>& firstEdge = adjacency.firstEdge;
  const int vertices = static_cast<int>(firstEdge.size()) - 1;
  std::vector<int>& offsets = adjacency.vertexVertices.offsets;
  offsets.assign(firstEdge.size(), 0);
  adjacency.borderVertex.assign(vertices, 0);
  for (const MeshEdge& e : adjacency.edges)
  {
    ++offsets[e.v1 + 1];
    if (e.triangleCount == 1)
    {
      adjacency.borderVertex[e.v0] = adjacency.borderVertex[e.v1] = 1;
    }
  }
  for (int v = 0; v < vertices; ++v)
  {
    offsets[v + 1] += offsets[v] + firstEdge[v + 1] - firstEdge[v];
  }
  std::vector<int>& values = adjacency.vertexVertices.values;
  values.resize(offsets[vertices]);
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (int v = 0; v < vertices; ++v)
  {
    // All lower neighbours of v have entered themselves by now.
    for (int e = firstEdge[v]; e < firstEdge[v + 1]; ++e)
    {
      const int other = adjacency.edges[e].v1;
      values[next[v]++] = other;
      values[next[other]++] = v;
    }
  }
}

Vector3 unit(const Vector3& n)
{
  const double length = n.norm();
  return length > 0.0 ? Vector3(n / length) : Vector3(Vector3::Zero());
}

// The corners at the vertex are summed in the order of their triangles.
template <typename FacetNormal>
Vector3 normalAt(const Mesh& mesh, const Lists& around, int vertex, const FacetNormal& facet)
{
  Vector3 sum = Vector3::Zero();
  for (const int t : around[vertex])
  {
    const Triangle& c = mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      if (c[k] == vertex)
      {
        const Vector3& p = mesh.points[vertex];
        const Vector3 a = mesh.points[c[(k + 1) % 3]] - p;
        const Vector3 b = mesh.points[c[(k + 2) % 3]] - p;
        sum += std::atan2(a.cross(b).norm(), a.dot(b)) * facet(t);
      }
    }
  }
  return unit(sum);
}

} // namespace

std::vector<int> marked(const std::vector<char>& marks)
{
  std::vector<int> all;
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      all.push_back(static_cast<int>(i));
    }
  }
  return all;
}

int Adjacency::findEdge(int a, int b) const
{
  const auto [low, high] = std::minmax(a, b);
  const auto begin = this->edges.begin() + this->firstEdge[low];
  const auto end = this->edges.begin() + this->firstEdge[low + 1];
  const auto it = std::lower_bound(begin, end, high, [](const MeshEdge& e, int v) { return e.v1 < v; });
  return it != end && it->v1 == high ? static_cast<int>(it - this->edges.begin()) : -1;
}

Lists trianglesAround(const Mesh& mesh)
{
  const auto eachCorner = [&mesh](auto&& visit)
  {
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      const Triangle& v = mesh.triangles[t];
      visit(v[0], t);
      if (v[1] != v[0])
        visit(v[1], t);
      if (v[2] != v[0] && v[2] != v[1])
        visit(v[2], t);
    }
  };
  return Lists::gathered(mesh.points.size(), eachCorner);
}

Adjacency buildAdjacency(const Mesh& mesh)
{
  return buildAdjacency(mesh, Context());
}

Adjacency buildAdjacency(const Mesh& mesh, const Context& context)
{
  const int vertices = mesh.vertexCount();
  Adjacency adjacency;
  adjacency.vertexTriangles = trianglesAround(mesh);
  const Lists& around = adjacency.vertexTriangles;
  // Edges come out ascending: each belongs to its lower vertex.
  std::vector<Sides> parts((vertices + Sides::vertices - 1) / Sides::vertices);
  const auto eachPart = [&](auto&& visit)
  {
    context.each(static_cast<int>(parts.size()),
      [&](int part)
      { visit(part, part * Sides::vertices, std::min((part + 1) * Sides::vertices, vertices)); });
  };
  eachPart([&](int part, int begin, int end) { parts[part].gather(mesh, around, begin, end); });
  std::vector<int> firstEdge(parts.size() + 1, 0), firstSide(parts.size() + 1, 0); // of a part
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    firstEdge[part + 1] = firstEdge[part] + parts[part].edges;
    firstSide[part + 1] = firstSide[part] + static_cast<int>(parts[part].all.size());
  }
  adjacency.edges.resize(firstEdge.back());
  adjacency.firstEdge.resize(vertices + 1);
  adjacency.firstEdge[vertices] = firstEdge.back();
  adjacency.edgeTriangles.resize(firstSide.back());
  adjacency.triangleEdges.assign(mesh.triangles.size(), { -1, -1, -1 });
  eachPart(
    [&](int part, int begin, int end)
    {
      const Side* side = parts[part].all.data();
      int place = firstSide[part], e = firstEdge[part] - 1;
      for (int v = begin; v < end; ++v)
      {
        adjacency.firstEdge[v] = e + 1;
        int last = -1;
        for (const Side* stop = side + parts[part].counts[v - begin]; side != stop; ++side, ++place)
        {
          if (endOf(*side) != last)
          {
            last = endOf(*side);
            adjacency.edges[++e] = { v, last, place, 0 };
          }
          const int h = halfEdgeOf(*side);
          ++adjacency.edges[e].triangleCount;
          adjacency.edgeTriangles[place] = h / 3;
          adjacency.triangleEdges[h / 3][h % 3] = e;
        }
      }
      parts[part] = Sides();
    });
  listNeighbours(adjacency);
  return adjacency;
}

bool isOneFan(const Adjacency& adjacency, int v)
{
  const int total = adjacency.vertexTriangles.size(v);
  const int start = total ? *adjacency.vertexTriangles.begin(v) : -1;
  int seen = total ? 1 : 0;
  for (int side = 0; side < 2 && total; ++side)
  {
    int t = start, through = -1;
    while (true)
    {
      // The edge of t at v that was not come through; on the first step the one that the side asks for.
      int edge = -1, order = 0;
      for (int k = 0; k < 3; ++k)
      {
        const int e = adjacency.triangleEdges[t][k];
        if (e < 0)
        {
          return true;
        }
        const MeshEdge& candidate = adjacency.edges[e];
        if ((candidate.v0 == v || candidate.v1 == v) && e != through && (through >= 0 || order++ == side))
        {
          edge = e;
        }
      }
      const int* around = adjacency.trianglesBegin(edge);
      if (adjacency.edges[edge].triangleCount > 2)
      {
        return true;
      }
      if (adjacency.edges[edge].triangleCount == 1)
      {
        break;
      }
      t = around[0] == t ? around[1] : around[0];
      if (t == start)
      {
        return seen == total;
      }
      through = edge;
      ++seen;
    }
  }
  return seen == total;
}

Vector3 facetNormal(const Mesh& mesh, int triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  return unit((mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]));
}

double facetArea(const Mesh& mesh, int triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  return 0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm();
}

Vector3 vertexNormal(const Mesh& mesh, const Lists& around, int vertex)
{
  return normalAt(mesh, around, vertex, [&mesh](int t) { return facetNormal(mesh, t); });
}

std::vector<Vector3> vertexNormals(const Mesh& mesh)
{
  return vertexNormals(mesh, trianglesAround(mesh), Context());
}

std::vector<Vector3> vertexNormals(const Mesh& mesh, const Lists& around, const Context& context)
{
  std::vector<Vector3> facets(mesh.triangles.size()), normals(mesh.points.size());
  context.each(mesh.triangleCount(), [&](int t) { facets[t] = facetNormal(mesh, t); });
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      normals[v] = normalAt(mesh, around, v, [&facets](int t) -> const Vector3& { return facets[t]; });
    });
  return normals;
}

double boundingDiagonal(const Mesh& mesh)
{
  return mesh.points.empty() ? 0.0 : boxRound(mesh.points).diagonal().norm();
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
    for (const int n : adjacency.vertexVertices[v])
    {
      const double through = d + (mesh.points[n] - mesh.points[v]).norm();
      if (through <= limit && through < distance[n])
      {
        distance[n] = through;
        queue.push({ through, n });
      }
    }
  }
  return distance;
}

} // namespace oversketch
