// Exact sides in space, by CGAL's predicates, which are under the LGPL. Not installed.
#ifndef oversketch_kernels_intersection_sides_h
#define oversketch_kernels_intersection_sides_h

#include "Mesh/mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace oversketch
{

using Corners = std::array<Vector3, 3>;
using ExactSides = CGAL::Exact_predicates_inexact_constructions_kernel;

// 1, -1 or 0: the side of d of the plane through a, b, c; 1 where those turn left as seen from d.
inline int sideOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const auto at = [](const Vector3& p) { return ExactSides::Point_3(p[0], p[1], p[2]); };
  return static_cast<int>(CGAL::orientation(at(a), at(b), at(c), at(d)));
}

// The turn of a, b, c, seen along an axis: the sign of that part of their normal.
inline int turnOf(int axis, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto at = [x, y](const Vector3& p) { return ExactSides::Point_2(p[x], p[y]); };
  return static_cast<int>(CGAL::orientation(at(a), at(b), at(c)));
}

// An axis along which the triangle is seen with an area, or 3.
inline int openAxis(const Corners& t)
{
  int axis = 0;
  while (axis < 3 && turnOf(axis, t[0], t[1], t[2]) == 0)
  {
    ++axis;
  }
  return axis;
}

} // namespace oversketch
#endif
