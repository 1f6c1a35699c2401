// Curves on a mesh: the silhouette and what becomes of it.
#ifndef oversketch_curves_h
#define oversketch_curves_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

// A point on a mesh: up to three vertices of one triangle and their weights (sum 1). A vertex-based
// silhouette point has weights (1, 0, 0), an edge-based one (alpha, 1 - alpha, 0); unused vertices repeat the
// first.
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

struct CurvePoint
{
  Binding binding;
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); // interpolated and re-normalised
};

struct Curve
{
  std::vector<CurvePoint> points; // the first is not repeated at the end of a closed curve
  bool closed = false;
};

} // namespace oversketch
#endif
