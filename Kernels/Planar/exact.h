// CGAL's kernel of exact predicates, which is under the LGPL; its triangulations are under the GPL and stay
// out of this library. For where the calls of predicates.h take too long; not installed.
#ifndef oversketch_kernels_planar_exact_h
#define oversketch_kernels_planar_exact_h

#include "Mesh/mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace oversketch
{

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline ExactKernel::Point_2 exactPoint(const Vector2& p)
{
  return { p[0], p[1] };
}

// As orientation and inCircle.
inline int exactTurn(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return static_cast<int>(CGAL::orientation(exactPoint(a), exactPoint(b), exactPoint(c)));
}

inline int exactCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  return static_cast<int>(
    CGAL::side_of_oriented_circle(exactPoint(a), exactPoint(b), exactPoint(c), exactPoint(d)));
}

} // namespace oversketch
#endif
