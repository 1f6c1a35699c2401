// A triangle mesh as the kernels see it, its adjacency, vertex normals and edge-path distances.
// Adjacency is lists, not half-edges: non-manifold edges, borders and loose points are legal everywhere.
#ifndef oversketch_kernels_mesh_mesh_h
#define oversketch_kernels_mesh_mesh_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace oversketch
{

struct Context;

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Triangle = std::array<int, 3>;

// The corner that a vertex is of a triangle, or -1.
inline int cornerOf(const Triangle& t, int vertex)
{
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : t[2] == vertex ? 2 : -1;
}

// Whether a triangle has the edge in the direction from a to b.
inline bool runsAlong(const Triangle& t, int a, int b)
{
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

struct Mesh
{
  std::vector<Vector3> points;
  std::vector<Triangle> triangles; // vertex indices, counter-clockwise seen from outside
  int vertexCount() const { return static_cast<int>(this->points.size()); }
  int triangleCount() const { return static_cast<int>(this->triangles.size()); }
};

// Lists of lists in two arrays: list i is values[offsets[i]] .. values[offsets[i + 1] - 1].
struct Lists
{
  std::vector<int> offsets; // #lists + 1
  std::vector<int> values;
  const int* begin(int i) const { return this->values.data() + this->offsets[i]; }
  const int* end(int i) const { return this->values.data() + this->offsets[i + 1]; }
  int size(int i) const { return this->offsets[i + 1] - this->offsets[i]; }

  // A list to be walked over.
  struct Range
  {
    const int *first = nullptr, *last = nullptr;
    const int* begin() const { return this->first; }
    const int* end() const { return this->last; }
  };
  Range operator[](int i) const { return { this->begin(i), this->end(i) }; }

  // Makes so many lists: each(visit) calls visit(list, value) for the values in their order, and does so
  // twice.
  template <typename Each>
  static Lists gathered(std::size_t count, const Each& each)
  {
    Lists lists;
    lists.offsets.assign(count + 1, 0);
    each([&](int i, int) { ++lists.offsets[i + 1]; });
    std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
    lists.values.resize(lists.offsets.back());
    std::vector<int> next(lists.offsets.begin(), lists.offsets.end() - 1);
    each([&](int i, int value) { lists.values[next[i]++] = value; });
    return lists;
  }
};

// The places that are marked, ascending.
std::vector<int> marked(const std::vector<char>& marks);

// 1 at some of so many places, 0 elsewhere.
inline std::vector<char> marksAt(const std::vector<int>& places, std::size_t count)
{
  std::vector<char> marks(count, 0);
  for (const int place : places)
  {
    marks[place] = 1;
  }
  return marks;
}

// Where each of so many numbers stands in a list; -1 where it does not.
inline std::vector<int> placesIn(const std::vector<int>& list, std::size_t count)
{
  std::vector<int> places(count, -1);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    places[list[i]] = static_cast<int>(i);
  }
  return places;
}

// The results of a function, or a member, for all values in order.
template <typename Values, typename Function>
auto mapped(const Values& values, const Function& function)
{
  std::vector<std::decay_t<std::invoke_result_t<Function, decltype(*std::begin(values))>>> results;
  results.reserve(std::size(values));
  for (const auto& value : values)
  {
    results.push_back(std::invoke(function, value));
  }
  return results;
}

// The values at some places; empty stays empty.
template <typename Value>
std::vector<Value> valuesAt(const std::vector<Value>& values, const std::vector<int>& places)
{
  std::vector<Value> result(values.empty() ? 0 : places.size());
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = values[places[i]];
  }
  return result;
}

// Sorts values and leaves each once.
template <typename Value>
void sortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

struct MeshEdge
{
  int v0, v1;            // v0 < v1
  int firstTriangle = 0; // into Adjacency::edgeTriangles
  int triangleCount = 0; // 1 on a border, 2 inside, more where the mesh is not manifold
};

struct Adjacency
{
  Lists vertexTriangles;                         // ascending triangle ids
  Lists vertexVertices;                          // ascending vertex ids, each neighbour once
  std::vector<MeshEdge> edges;                   // ascending by (v0, v1)
  std::vector<int> firstEdge;                    // per vertex, of its edges to higher ones; #vertices + 1
  std::vector<int> edgeTriangles;                // ascending per edge
  std::vector<std::array<int, 3>> triangleEdges; // edge k of a triangle joins its corners k and (k + 1) % 3
  std::vector<char> borderVertex;                // 1 where an edge with exactly one triangle ends

  // The edge between a and b, or -1.
  int findEdge(int a, int b) const;
  const int* trianglesBegin(int edge) const
  {
    return this->edgeTriangles.data() + this->edges[edge].firstTriangle;
  }
  const int* trianglesEnd(int edge) const
  {
    return this->trianglesBegin(edge) + this->edges[edge].triangleCount;
  }
  Lists::Range trianglesAt(int edge) const
  {
    return { this->trianglesBegin(edge), this->trianglesEnd(edge) };
  }
};

// Per vertex its triangles, ascending; a triangle with a repeated vertex is there once.
Lists trianglesAround(const Mesh& mesh);

// A triangle with a repeated vertex has no edges (-1 in triangleEdges); it stays in the lists of its
// vertices.
Adjacency buildAdjacency(const Mesh& mesh);
Adjacency buildAdjacency(const Mesh& mesh, const Context& context);

// Whether the triangles round a vertex are one fan. Where an edge has more than two triangles, or a triangle
// none, this says nothing: true.
bool isOneFan(const Adjacency& adjacency, int v);

// Unit vertex normals, each incident triangle weighted by its angle at the vertex; zero for a vertex without
// a triangle of positive area. `around`: see trianglesAround.
std::vector<Vector3> vertexNormals(const Mesh& mesh);
std::vector<Vector3> vertexNormals(const Mesh& mesh, const Lists& around, const Context& context);
// The normal of one vertex.
Vector3 vertexNormal(const Mesh& mesh, const Lists& around, int vertex);

// Unit facet normal, zero for a degenerate triangle.
Vector3 facetNormal(const Mesh& mesh, int triangle);
double facetArea(const Mesh& mesh, int triangle);

// Box round points in the plane or in space.
template <int axes>
Eigen::AlignedBox<double, axes> boxRound(const std::vector<Eigen::Matrix<double, axes, 1>>& points)
{
  Eigen::AlignedBox<double, axes> box;
  for (const Eigen::Matrix<double, axes, 1>& p : points)
  {
    box.extend(p);
  }
  return box;
}
double boundingDiagonal(const Mesh& mesh); // of that box; 0 without points

// Length of the shortest edge path from the nearest source [model length], infinity beyond limit.
std::vector<double> edgeDistances(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& sources,
  double limit = std::numeric_limits<double>::infinity());

} // namespace oversketch
#endif
