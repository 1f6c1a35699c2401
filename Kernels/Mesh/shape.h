// Areas of triangles, and how narrow they are.
#ifndef oversketch_kernels_mesh_shape_h
#define oversketch_kernels_mesh_shape_h

#include "Mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

// Twice the area between two sides of a triangle, positive where b is to the left of a.
inline double cross(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// [rad] From a to b, positive to the left.
inline double turnAngle(const Vector2& a, const Vector2& b)
{
  return std::atan2(cross(a, b), a.dot(b));
}

// Area of the counter-clockwise triangle a, b, c; negative for a clockwise one.
inline double signedArea(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return 0.5 * cross(b - a, c - a);
}

// The sine squared of the smallest angle, 0 for a triangle without area; cross is twice the area times the
// normal.
inline double narrowness(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& cross)
{
  const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  const double shortest = std::min({ ab, bc, ca });
  const double others = ab == shortest ? bc * ca : bc == shortest ? ab * ca : ab * bc;
  return others > 0.0 ? cross.squaredNorm() / others : 0.0;
}

inline double narrowness(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return narrowness(a, b, c, (b - a).cross(c - a));
}

// [rad]
inline double smallestAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return std::asin(std::min(1.0, std::sqrt(narrowness(a, b, c))));
}

} // namespace oversketch
#endif
