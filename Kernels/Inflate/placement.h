// Where a part of a model stands among the others.
#ifndef oversketch_kernels_inflate_placement_h
#define oversketch_kernels_inflate_placement_h

#include "Mesh/mesh.h"

#include <Eigen/Core>

namespace oversketch
{

// An affine transform. Source: image-assisted modelling, section 16: parts made from pictures of their own
// are placed by such. One that mirrors, its determinant below 0, turns a surface inside out: faces are then
// to be reversed.
class Placement
{
public:
  // Throws Error(Failure::BadMesh) for a matrix that is not finite, not affine (its last row is not 0 0 0 1)
  // or flattens the part.
  explicit Placement(const Eigen::Matrix4d& matrix);

  Vector3 operator()(const Vector3& point) const { return this->Linear * point + this->Shift; }
  bool mirrors() const { return this->Mirrors; }

private:
  Eigen::Matrix3d Linear;
  Vector3 Shift;
  bool Mirrors;
};

// The matrix by which one rectangle in x and y comes to fill another one, by a mean of both scales in z, and
// is then moved along z: left, bottom, right, top. The first one must have an extent.
Eigen::Matrix4d intoBox(const Eigen::Vector4d& from, const Eigen::Vector4d& box, double depth);

} // namespace oversketch
#endif
