// CGAL's kernel of exact predicates, which is under the LGPL; its triangulations are under the GPL and stay
// out of this library.
#include "Planar/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace oversketch
{
namespace
{

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

Exact::Point_2 exact(const Vector2& p)
{
  return { p[0], p[1] };
}

} // namespace

int orientation(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c)));
}

int inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  return static_cast<int>(CGAL::side_of_oriented_circle(exact(a), exact(b), exact(c), exact(d)));
}

bool between(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const int axis = a[0] != b[0] ? 0 : 1;
  return (a[axis] < c[axis] && c[axis] < b[axis]) || (b[axis] < c[axis] && c[axis] < a[axis]);
}

bool segmentsMeet(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  const int sc = orientation(a, b, c), sd = orientation(a, b, d);
  const int sa = orientation(c, d, a), sb = orientation(c, d, b);
  if (sc * sd < 0 && sa * sb < 0)
  {
    return true;
  }
  return (sc == 0 && between(a, b, c)) || (sd == 0 && between(a, b, d)) || (sa == 0 && between(c, d, a)) ||
         (sb == 0 && between(c, d, b)) || (a == c && b == d) || (a == d && b == c);
}

} // namespace oversketch
