#include "Inflate/placement.h"

#include "Mesh/context.h"

#include <Eigen/LU>

#include <cmath>

namespace oversketch
{

Placement::Placement(const Eigen::Matrix4d& matrix)
  : Linear(matrix.topLeftCorner<3, 3>())
  , Shift(matrix.topRightCorner<3, 1>())
  , Mirrors(false)
{
  if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
  {
    throw Error(Failure::BadMesh,
      "A part's placement must be an affine matrix: 16 finite numbers row by row, the last ones 0 0 0 1.");
  }
  // Determinant of columns of length 1, so that a small part is not taken for a flat one.
  const Vector3 lengths = this->Linear.colwise().norm();
  const double determinant = this->Linear.determinant() / lengths.prod();
  if (!(std::abs(determinant) > 1e-9))
  {
    throw Error(Failure::BadMesh, "A part's placement flattens it; no scale of it may be 0.");
  }
  this->Mirrors = determinant < 0.0;
}

Eigen::Matrix4d intoBox(const Eigen::Vector4d& from, const Eigen::Vector4d& box, double depth)
{
  const Eigen::Vector2d size = from.tail<2>() - from.head<2>();
  const Eigen::Vector2d scale = (box.tail<2>() - box.head<2>()).cwiseQuotient(size);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.diagonal().head<3>() << scale[0], scale[1], std::sqrt(scale[0] * scale[1]);
  matrix.topRightCorner<2, 1>() = box.head<2>() - scale.cwiseProduct(from.head<2>());
  matrix(2, 3) = depth;
  return matrix;
}

} // namespace oversketch
