// What the moves of remeshing ask of triangles and their normals.
#ifndef oversketch_kernels_remesh_shape_h
#define oversketch_kernels_remesh_shape_h

#include "Mesh/shape.h"
#include "Remesh/patch.h"

#include <cmath>

namespace oversketch
{

// A normal, given by vectors along it, turned by more than 60 degrees: too much for one move, and for an edge
// to be flipped.
inline bool turned(const Vector3& before, const Vector3& after)
{
  constexpr double limit = 0.25; // square of the cosine
  const double dot = before.dot(after);
  return dot < 0.0 || dot * dot < limit * (before.squaredNorm() * after.squaredNorm());
}

// How sharply folded an edge is: one over 100 degrees weighs more than all edges over 90 together, so that no
// move trades the latter for the former.
inline int foldWeight(const Vector3& a, const Vector3& b)
{
  return a.dot(b) < 0.0 ? (folded(a, b) ? 1001 : 1) : 0;
}

constexpr double calmCosine = 0.9743701; // of 13 degrees
// How much more a move may let the surface turn, in target lengths: as an edge that turns by 32 in place of
// 30 degrees. Without it rows of narrow triangles along a ridge stay for ever.
constexpr double turnSlack = 0.02;

// How much an edge of this length turns the surface more than 13 degrees; the triangles are given by vectors
// along their normals. Grows with the square of the angle: the same turn spread over more edges weighs less.
inline double turnWeight(const Vector3& a, const Vector3& b, double length)
{
  const double dot = a.dot(b), squared = a.squaredNorm() * b.squaredNorm();
  if (!(squared > 0.0) || (dot > 0.0 && dot * dot >= calmCosine * calmCosine * squared))
  {
    return 0.0;
  }
  return length * (calmCosine - dot / std::sqrt(squared));
}

} // namespace oversketch
#endif
