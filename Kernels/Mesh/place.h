// Places on a mesh: by vertices and weights, which outlive a change of positions, or in one triangle; and
// points as weighted means of others.
#ifndef oversketch_kernels_mesh_place_h
#define oversketch_kernels_mesh_place_h

#include "Mesh/mesh.h"

#include <array>
#include <utility>
#include <vector>

namespace oversketch
{

// A point that hangs on a mesh: up to three vertices of one triangle and their weights (sum 1). A
// vertex-based silhouette point has weights (1, 0, 0), an edge-based one (alpha, 1 - alpha, 0); unused
// vertices repeat the first.
struct Binding
{
  std::array<int, 3> vertices{ -1, -1, -1 };
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };

  static Binding vertex(int v) { return { { v, v, v }, { 1.0, 0.0, 0.0 } }; }
  static Binding edge(int v0, int v1, double alpha)
  {
    return { { v0, v1, v0 }, { alpha, 1.0 - alpha, 0.0 } };
  }
  bool onVertex() const { return this->weights[1] == 0.0 && this->weights[2] == 0.0; }
  Vector3 of(const std::vector<Vector3>& values) const
  {
    return this->weights[0] * values[this->vertices[0]] + this->weights[1] * values[this->vertices[1]] +
           this->weights[2] * values[this->vertices[2]];
  }
};

inline bool operator==(const Binding& a, const Binding& b)
{
  return a.vertices == b.vertices && a.weights == b.weights;
}

inline bool operator!=(const Binding& a, const Binding& b)
{
  return !(a == b);
}

// A place on a mesh: a triangle and barycentric weights of its corners, sum 1, exactly zero for corners that
// take no part (a place on an edge has one zero, on a vertex two).
struct SurfacePoint
{
  int triangle = -1;
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
};

// The corners of a triangle.
inline std::array<SurfacePoint, 3> wholeTriangle(int t)
{
  return { { { t, { 1.0, 0.0, 0.0 } }, { t, { 0.0, 1.0, 0.0 } }, { t, { 0.0, 0.0, 1.0 } } } };
}

inline Vector3 positionOf(const Mesh& mesh, const SurfacePoint& at)
{
  const Triangle& t = mesh.triangles[at.triangle];
  return at.weights[0] * mesh.points[t[0]] + at.weights[1] * mesh.points[t[1]] +
         at.weights[2] * mesh.points[t[2]];
}

// Points and their weights, which add up to 1.
using Mix = std::vector<std::pair<int, double>>;

// A mix with its points ascending and each of them once; none whose weight is rounding (below 1e-12).
Mix normalisedMix(Mix mix);

// Whether two normalised mixes are the same place: weights to within 1e-9.
bool sameMix(const Mix& a, const Mix& b);

} // namespace oversketch
#endif
