// Transformations by their names, for tests. Header-only.
#ifndef oversketch_testing_harness_transformations_h
#define oversketch_testing_harness_transformations_h

#include "Matrix/logarithm.h"
#include "Mesh/mesh.h"

#include <Eigen/Geometry>

namespace oversketch_test
{

inline oversketch::Matrix4 turn(const oversketch::Vector3& axis, double degrees)
{
  return Eigen::Affine3d(Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180.0, axis.normalized()))
    .matrix();
}

inline oversketch::Matrix4 scale(double x, double y, double z)
{
  return Eigen::Vector4d(x, y, z, 1.0).asDiagonal();
}

inline oversketch::Matrix4 shift(double x, double y, double z)
{
  return Eigen::Affine3d(Eigen::Translation3d(x, y, z)).matrix();
}

} // namespace oversketch_test
#endif
