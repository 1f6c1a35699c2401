// Forests with known answers and what is asked of them, for tests. Header-only.
#ifndef oversketch_testing_harness_forest_shapes_h
#define oversketch_testing_harness_forest_shapes_h

#include "Harness/data.h"
#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Mesh/context.h"
#include "Stellar/leaves.h"
#include "Stellar/pairing.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <thread>

namespace oversketch_test
{

// nx x ny quads over [0, width] x [0, height] as pairs, diagonals from the lower left to the upper right.
inline Mesh quadPairs(int nx, int ny, double width = 1.0, double height = 1.0)
{
  Mesh mesh;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i)
      mesh.points.emplace_back(width * i / nx, height * j / ny, 0.0);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
    {
      const int a = j * (nx + 1) + i, b = a + 1, d = a + nx + 1, c = d + 1;
      mesh.triangles.push_back({ b, c, a });
      mesh.triangles.push_back({ d, a, c });
    }
  return mesh;
}

inline Forest quadForest(int nx, int ny, double width = 1.0, double height = 1.0)
{
  return forestOfPairs(quadPairs(nx, ny, width, height));
}

inline Mesh octahedron()
{
  return {
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } }
  };
}

// Every triangle in four, new points on the unit sphere.
inline Mesh subdivided(const Mesh& mesh)
{
  Mesh m = mesh;
  m.triangles.clear();
  std::map<std::pair<int, int>, int> middle;
  const auto mid = [&](int a, int b)
  {
    const auto it = middle.emplace(std::minmax(a, b), m.vertexCount());
    if (it.second)
    {
      m.points.push_back((m.points[a] + m.points[b]).normalized());
    }
    return it.first->second;
  };
  for (const Triangle& t : mesh.triangles)
  {
    const int a = mid(t[0], t[1]), b = mid(t[1], t[2]), c = mid(t[2], t[0]);
    m.triangles.insert(m.triangles.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
  }
  return m;
}

inline Forest baseOf(const Mesh& mesh, const PairingOptions& options = {})
{
  return pairTriangles(mesh, options, Context()).forest;
}

// Splits every leaf of the lowest generation that there is, so many times.
inline void refineAll(Forest& forest, int times)
{
  for (int g = 0; g < times; ++g)
  {
    const int count = static_cast<int>(forest.faces.size());
    for (int f = 0; f < count; ++f)
    {
      if (forest.isFace(f) && forest.faces[f].gen == g)
      {
        forest.refine(f, {});
      }
    }
  }
}

inline int anyFace(const Forest& forest, std::mt19937& random)
{
  int f = -1;
  do
  {
    f = static_cast<int>(random() % forest.faces.size());
  } while (!forest.isFace(f));
  return f;
}

inline std::set<std::pair<int, int>> edgesOf(const Forest& forest)
{
  std::set<std::pair<int, int>> edges;
  for (const Forest::Face& face : forest.faces)
    for (int i = 0; i < 3 && face.root >= 0; ++i)
      edges.insert(std::minmax(face.v[i], face.v[(i + 1) % 3]));
  return edges;
}

// V - E + F of the vertices that have faces.
inline int euler(const Forest& forest)
{
  std::set<int> used;
  for (const auto& [a, b] : edgesOf(forest))
    used.insert({ a, b });
  return static_cast<int>(used.size()) - static_cast<int>(edgesOf(forest).size()) + forest.faceCount();
}

inline int boundaryLoops(const Forest& forest)
{
  std::map<int, int> next;
  for (const Forest::Face& face : forest.faces)
    for (int i = 0; i < 3 && face.root >= 0; ++i)
      if (face.n[i] < 0)
        next[face.v[(i + 1) % 3]] = face.v[(i + 2) % 3];
  int loops = 0;
  for (; !next.empty(); ++loops)
    for (auto at = next.begin(); at != next.end();)
    {
      const int to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  return loops;
}

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool sameBytes(const Leaves& a, const Leaves& b)
{
  return sameBytes(a.points, b.points) && sameBytes(a.triangles, b.triangles) && sameBytes(a.root, b.root) &&
         sameBytes(a.path, b.path) && sameBytes(a.gen, b.gen) && sameBytes(a.moved, b.moved) &&
         sameBytes(a.curveId, b.curveId) && sameBytes(a.curveParam, b.curveParam) &&
         sameBytes(a.baseNormal, b.baseNormal) && sameBytes(a.displacement, b.displacement) &&
         sameBytes(a.feature, b.feature);
}

// Whether two forests are the same in all that the arrays do not say as well.
inline bool sameForest(const Forest& a, const Forest& b)
{
  const auto sameFace = [](const Forest::Face& x, const Forest::Face& y)
  {
    return x.path == y.path && x.root == y.root && x.gen == y.gen && std::equal(x.v, x.v + 3, y.v) &&
           std::equal(x.n, x.n + 3, y.n);
  };
  const auto sameVertex = [](const Forest::Vertex& x, const Forest::Vertex& y)
  { return x.level == y.level && x.face == y.face && std::equal(x.parents, x.parents + 2, y.parents); };
  return sameBytes(emit(a), emit(b)) && a.rootCount == b.rootCount &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), sameFace) &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), sameVertex);
}

inline Leaves canonicalLeaves(const Forest& forest)
{
  return emit(canonical(forest, Context()).forest);
}

inline FeatureCurve featureCurve(const std::vector<Vector3>& points, bool closed = false)
{
  FeatureCurve curve;
  curve.points = points;
  curve.closed = closed;
  curve.measure();
  return curve;
}

// The triangles of a shared .obj or .off file; empty where it is absent.
inline Mesh sharedMesh(const std::string& name)
{
  Mesh mesh;
  std::ifstream file(sharedData("meshes/" + name));
  std::string line, word;
  Vector3 p;
  if (name.find(".off") != std::string::npos)
  {
    int points = 0, triangles = 0, corners = 0;
    file >> word >> points >> triangles >> corners;
    for (int i = 0; i < points && file >> p[0] >> p[1] >> p[2]; ++i)
      mesh.points.push_back(p);
    Triangle t;
    for (int i = 0; i < triangles && file >> corners >> t[0] >> t[1] >> t[2]; ++i)
      mesh.triangles.push_back(t);
    return mesh;
  }
  while (std::getline(file, line))
  {
    std::istringstream in(line);
    in >> word;
    if (word == "v" && in >> p[0] >> p[1] >> p[2])
    {
      mesh.points.push_back(p);
    }
    else if (word == "f")
    {
      std::string a, b, c;
      in >> a >> b >> c;
      mesh.triangles.push_back({ std::stoi(a) - 1, std::stoi(b) - 1, std::stoi(c) - 1 });
    }
  }
  return mesh;
}

// Welds w and, before that, the finer vertices that stand in its way. False where it has no parents.
inline bool weldDown(Forest& forest, int w)
{
  if (forest.vertices[w].parents[0] < 0)
  {
    return false;
  }
  while (!forest.weldable(w))
  {
    int finest = -1;
    forest.link(w,
      [&](int u)
      {
        const bool finer = finest < 0 || forest.vertices[u].level > forest.vertices[finest].level;
        finest = finer ? u : finest;
      });
    if (!weldDown(forest, finest))
    {
      return false;
    }
  }
  forest.weld(w);
  return true;
}

} // namespace oversketch_test
#endif
