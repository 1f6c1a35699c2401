#include "Intersection/exact_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>

namespace oversketch
{

namespace
{

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

// 1, -1 or 0: the side of d of the plane through a, b, c.
int sideOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const auto at = [](const Vector3& p) { return Exact::Point_3(p[0], p[1], p[2]); };
  return static_cast<int>(CGAL::orientation(at(a), at(b), at(c), at(d)));
}

// The turn of a, b, c, seen along an axis.
int turnOf(int axis, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto at = [x, y](const Vector3& p) { return Exact::Point_2(p[x], p[y]); };
  return static_cast<int>(CGAL::orientation(at(a), at(b), at(c)));
}

// An axis along which the triangle is seen with an area, or 3.
int openAxis(const Corners& t)
{
  int axis = 0;
  while (axis < 3 && turnOf(axis, t[0], t[1], t[2]) == 0)
  {
    ++axis;
  }
  return axis;
}

// Segments of one plane that are not on one line.
bool segmentsCross(int axis, const Vector3& a, const Vector3& b, const Vector3& p, const Vector3& q)
{
  const int sa = turnOf(axis, p, q, a), sb = turnOf(axis, p, q, b);
  return (sa != 0 || sb != 0) && sa * sb <= 0 && turnOf(axis, a, b, p) * turnOf(axis, a, b, q) <= 0;
}

// A segment in the plane of the triangle. One on the line of an edge that holds the whole edge crosses the
// two others at their ends.
bool meetsInPlane(const Vector3& a, const Vector3& b, const Corners& t)
{
  const int axis = openAxis(t), turn = turnOf(axis, t[0], t[1], t[2]);
  const auto holds = [&](const Vector3& p)
  {
    return turnOf(axis, t[0], t[1], p) * turn >= 0 && turnOf(axis, t[1], t[2], p) * turn >= 0 &&
           turnOf(axis, t[2], t[0], p) * turn >= 0;
  };
  return holds(a) || holds(b) || segmentsCross(axis, a, b, t[0], t[1]) ||
         segmentsCross(axis, a, b, t[1], t[2]) || segmentsCross(axis, a, b, t[2], t[0]);
}

// A segment whose ends are on the given sides of the triangle's plane.
bool segmentMeets(const Vector3& a, const Vector3& b, int sideA, int sideB, const Corners& t)
{
  if (sideA * sideB > 0)
  {
    return false;
  }
  if (sideA == 0 && sideB == 0)
  {
    return meetsInPlane(a, b, t);
  }
  bool left = false, right = false;
  for (int k = 0; k < 3 && !(left && right); ++k)
  {
    const int side = sideOf(a, b, t[k], t[(k + 1) % 3]);
    left |= side > 0;
    right |= side < 0;
  }
  return !(left && right);
}

// The sides of a triangle's corners from `first` on of another's plane.
struct Sides
{
  std::array<int, 3> of{};
  bool apart; // all of those strictly on one side

  Sides(const Corners& t, const Corners& plane, int first)
  {
    for (int k = first; k < 3; ++k)
    {
      this->of[k] = sideOf(plane[0], plane[1], plane[2], t[k]);
    }
    this->apart =
      this->of[1] != 0 && this->of[1] == this->of[2] && (first == 1 || this->of[0] == this->of[1]);
  }
};

// Whether rounded sums show that a plane across the way keeps the triangles apart; any way may be tried. The
// corners of b from `first` on are looked at, those of a likewise, as seen from b[0].
bool keptApart(const Vector3& way, const Corners& a, const Corners& b, int first)
{
  double least = std::numeric_limits<double>::infinity(), most = first == 0 ? 0.0 : -least, size = 0.0;
  for (int k = first; k < 3; ++k)
  {
    const Vector3 toA = a[k] - b[0];
    least = std::min(least, way.dot(toA));
    size = std::max(size, toA.lpNorm<1>());
  }
  for (int k = 1; k < 3; ++k)
  {
    const Vector3 toB = b[k] - b[0];
    most = std::max(most, way.dot(toB));
    size = std::max(size, toB.lpNorm<1>());
  }
  // Each sum is off by less than six roundings of its terms; what is below the smallest normal number decides
  // nothing.
  const double error = 1e-15 * size * way.lpNorm<Eigen::Infinity>() + 1e-290;
  return first == 0 ? least - most > 2.0 * error : least > error && most < -error;
}

} // namespace

bool hasExactArea(const Corners& t)
{
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite() && openAxis(t) < 3;
}

bool trianglesMeet(const Corners& a, const Corners& b)
{
  const Vector3 way = (a[0] - b[0]) + (a[1] - b[1]) + (a[2] - b[2]);
  if (keptApart(way, a, b, 0))
  {
    return false;
  }
  const Sides sidesA(a, b, 0);
  if (sidesA.apart)
  {
    return false;
  }
  const Sides sidesB(b, a, 0);
  if (sidesB.apart)
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (segmentMeets(a[k], a[next], sidesA.of[k], sidesA.of[next], b) ||
        segmentMeets(b[k], b[next], sidesB.of[k], sidesB.of[next], a))
    {
      return true;
    }
  }
  return false;
}

// From the common corner each way that both hold leaves one of them first, through its opposite edge.
bool fansMeet(const Corners& a, const Corners& b)
{
  const auto middle = [](const Corners& t) -> Vector3
  { return (t[1] - t[0]).normalized() + (t[2] - t[0]).normalized(); };
  if (keptApart(middle(a) - middle(b), a, b, 1))
  {
    return false;
  }
  const Sides sidesA(a, b, 1);
  if (sidesA.apart)
  {
    return false;
  }
  const Sides sidesB(b, a, 1);
  return !sidesB.apart && (segmentMeets(a[1], a[2], sidesA.of[1], sidesA.of[2], b) ||
                            segmentMeets(b[1], b[2], sidesB.of[1], sidesB.of[2], a));
}

} // namespace oversketch
