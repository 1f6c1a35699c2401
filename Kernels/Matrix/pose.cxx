#include "Matrix/pose.h"

#include <cmath>

namespace oversketch
{

namespace
{

constexpr double perDegree = M_PI / 180.0;
constexpr double upright = 1e-9; // cosine of y, below which x and z are one turn

Eigen::AngleAxisd turnAbout(const Vector3& degrees, int axis)
{
  return Eigen::AngleAxisd(degrees[axis] * perDegree, Vector3::Unit(axis));
}

} // namespace

Eigen::Matrix3d turnedBy(const Vector3& degrees)
{
  return (turnAbout(degrees, 2) * turnAbout(degrees, 1) * turnAbout(degrees, 0)).toRotationMatrix();
}

Vector3 degreesOf(const Eigen::Matrix3d& rotation)
{
  const double cosine = std::hypot(rotation(0, 0), rotation(1, 0));
  const double y = std::atan2(-rotation(2, 0), cosine);
  return (cosine < upright
             ? Vector3(0.0, y, std::atan2(-rotation(0, 1), rotation(1, 1)))
             : Vector3(
                 std::atan2(rotation(2, 1), rotation(2, 2)), y, std::atan2(rotation(1, 0), rotation(0, 0)))) /
         perDegree;
}

// So that a move alone adds nothing but itself.
Eigen::Affine3d Pose::about(const Vector3& middle) const
{
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = turnedBy(this->turn) * this->scale.asDiagonal();
  transform.translation() = this->move + (middle - transform.linear() * middle);
  return transform;
}

} // namespace oversketch
