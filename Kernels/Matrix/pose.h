// How a thing stands beside where it was: scaled, turned and moved.
#ifndef oversketch_kernels_matrix_pose_h
#define oversketch_kernels_matrix_pose_h

#include "Mesh/mesh.h"

#include <Eigen/Geometry>

namespace oversketch
{

// Three turns [degrees] about the axes x, then y, then z, which stay; and back, y from -90 to 90 degrees.
// Where y is one of these, x is 0.
Eigen::Matrix3d turnedBy(const Vector3& degrees);
Vector3 degreesOf(const Eigen::Matrix3d& rotation);

struct Pose
{
  Vector3 move = Vector3::Zero();  // [model length]
  Vector3 turn = Vector3::Zero();  // see turnedBy
  Vector3 scale = Vector3::Ones(); // factors along x, y and z, before it is turned

  bool isRest() const
  {
    return this->move.isZero(0.0) && this->turn.isZero(0.0) && this->scale == Vector3::Ones();
  }
  // The transform of one that is scaled and turned about its middle, which is then moved.
  Eigen::Affine3d about(const Vector3& middle) const;
};

} // namespace oversketch
#endif
