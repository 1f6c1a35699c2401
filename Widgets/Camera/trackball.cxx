#include "trackball.h"

#include "Mesh/rotation.h"

#include <cmath>

namespace oversketch
{

Eigen::Quaterniond trackballTurn(const Eigen::Vector3d& centre,
  const Eigen::Vector3d& picked,
  const Line& press,
  const Line& now)
{
  const Eigen::Vector3d from = picked - centre;
  const double radius = from.norm();
  if (!(radius > 0.0))
  {
    return Eigen::Quaterniond::Identity();
  }
  // The picked point lies beyond the foot of the perpendicular from the centre when it is on the far side.
  const double side = press.direction().dot(from) > 0.0 ? 1.0 : -1.0;
  const Eigen::Vector3d foot = now.projection(centre) - centre;
  const double inside = radius * radius - foot.squaredNorm();
  const Eigen::Vector3d to =
    inside > 0.0 ? Eigen::Vector3d(foot + side * std::sqrt(inside) * now.direction()) : foot;
  return rotationBetween(from, to);
}

} // namespace oversketch
