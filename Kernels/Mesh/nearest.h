// The places of a segment and of a triangle that are nearest to a point.
#ifndef oversketch_kernels_mesh_nearest_h
#define oversketch_kernels_mesh_nearest_h

#include "Mesh/mesh.h"

#include <algorithm>
#include <array>

namespace oversketch
{

// The share of the way along a segment of its place nearest to a point, from the begin of which that lies at
// `offset`; 0 for a segment of no length.
template <typename Offset, typename Along>
double nearestShare(const Eigen::MatrixBase<Offset>& offset, const Eigen::MatrixBase<Along>& along)
{
  const double square = along.squaredNorm();
  return square > 0.0 ? std::clamp(offset.dot(along) / square, 0.0, 1.0) : 0.0;
}

template <typename Vector>
double distanceToSegment(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector offset = p - a, along = b - a;
  return (offset - nearestShare(offset, along) * along).norm();
}

// Barycentric weights of the point of triangle (a, b, c) nearest to p: by the Voronoi region of the triangle
// that p falls in, corners, then edges, then the inside.
inline std::array<double, 3> closestWeights(const Vector3& a,
  const Vector3& b,
  const Vector3& c,
  const Vector3& p)
{
  // A share in [0, 1]; 0 on an edge without length.
  const auto ratio = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { 0.0, 1.0, 0.0 };
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = ratio(d1, d1 - d3);
    return { 1.0 - v, v, 0.0 };
  }
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = ratio(d2, d2 - d6);
    return { 1.0 - w, 0.0, w };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
    return { 0.0, 1.0 - w, w };
  }
  const double sum = va + vb + vc;
  const double v = ratio(vb, sum), w = ratio(vc, sum);
  return { 1.0 - v - w, v, w };
}

// Far from the origin, too, no digits are lost.
inline double squaredDistance(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p)
{
  const std::array<double, 3> w = closestWeights(a, b, c, p);
  return (w[1] * (b - a) + w[2] * (c - a) - (p - a)).squaredNorm();
}

} // namespace oversketch
#endif
