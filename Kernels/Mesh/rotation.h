// The rotation between two directions.
#ifndef oversketch_kernels_mesh_rotation_h
#define oversketch_kernels_mesh_rotation_h

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace oversketch
{

// The smallest rotation that takes the direction of `from` to that of `to`; half a turn about any
// perpendicular where they are opposite. Ours, and not Eigen's FromTwoVectors, because that brings a singular
// value decomposition for the last case, which takes ten seconds to compile; the numbers are the same in all
// others.
inline Eigen::Quaterniond rotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond rotation;
  if (cosine < -1.0 + Eigen::NumTraits<double>::dummy_precision())
  {
    const double half = (1.0 + std::max(cosine, -1.0)) * 0.5;
    rotation.w() = std::sqrt(half);
    rotation.vec() = a.unitOrthogonal() * std::sqrt(1.0 - half);
    return rotation;
  }
  const double s = std::sqrt((1.0 + cosine) * 2.0);
  rotation.vec() = a.cross(b) * (1.0 / s);
  rotation.w() = s * 0.5;
  return rotation;
}

} // namespace oversketch
#endif
