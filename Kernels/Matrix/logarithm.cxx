#include "Matrix/logarithm.h"

#include "Mesh/context.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <complex>
#include <utility>

namespace oversketch
{
namespace
{

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// Matrices of any size: the compiler would instantiate Eigen's matrix functions once more for each fixed
// size, which took it a minute.
MatrixXd exponentialOf(const MatrixXd& matrix)
{
  return matrix.exp();
}

MatrixXd logarithmOf(const MatrixXd& matrix)
{
  return matrix.log();
}

[[noreturn]] void refuse(const Message& why)
{
  throw Error(Failure::SolveFailed,
    "The transformation %1: it cannot be applied in part. Give one that turns by less than 180 degrees and "
    "scales by more than 0.",
    why);
}

bool isAffine(const Matrix4& matrix)
{
  return matrix.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
}

// Against what the logarithm does not say by itself.
void checkEigenvalues(const Matrix4& matrix)
{
  // The decomposition is that of the logarithm, so that the compiler instantiates no other.
  const Eigen::Vector4cd values =
    Eigen::ComplexSchur<MatrixXcd>(matrix.cast<std::complex<double>>(), false).matrixT().diagonal();
  const double largest = values.cwiseAbs().maxCoeff();
  for (const std::complex<double>& value : values)
  {
    if (!(std::abs(value) > 1e-12 * largest))
    {
      refuse("is singular");
    }
    // A double eigenvalue is found to the root of the rounding only.
    if (value.real() < 0.0 && std::abs(value.imag()) <= 1e-6 * std::abs(value))
    {
      refuse("is a reflection or turns by 180 degrees");
    }
  }
}

// exp L and V, the integral of exp(s L) over s in [0, 1]: exp [L I; 0 0] = [exp L, V; 0 I].
std::pair<Eigen::Matrix3d, Eigen::Matrix3d> wayOf(const Eigen::Matrix3d& linear)
{
  Eigen::Matrix<double, 6, 6> both = Eigen::Matrix<double, 6, 6>::Zero();
  both.topLeftCorner<3, 3>() = linear;
  both.topRightCorner<3, 3>().setIdentity();
  const Eigen::Matrix<double, 6, 6> grown = exponentialOf(both);
  return { grown.topLeftCorner<3, 3>(), grown.topRightCorner<3, 3>() };
}

// Logarithms of linear part and shift one after the other, which gives zeros where zeros belong, and a shift
// itself: that of [A a] is [log A, V^-1 a], with V = the integral of exp(s log A) over s in [0, 1].
Matrix4 affineLogarithm(const Matrix4& matrix)
{
  Matrix4 result = Matrix4::Zero();
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  if (linear == Eigen::Matrix3d::Identity())
  {
    result.topRightCorner<3, 1>() = matrix.topRightCorner<3, 1>();
    return result;
  }
  const Eigen::Matrix3d log = logarithmOf(linear);
  result.topLeftCorner<3, 3>() = log;
  result.topRightCorner<3, 1>() = wayOf(log).second.partialPivLu().solve(matrix.topRightCorner<3, 1>());
  return result;
}

} // namespace

Matrix4 logarithm(const Matrix4& matrix)
{
  if (!matrix.allFinite())
  {
    refuse("is not finite");
  }
  checkEigenvalues(matrix);
  Matrix4 result = isAffine(matrix) ? affineLogarithm(matrix) : Matrix4(logarithmOf(matrix));
  if (!result.allFinite() || !((exponential(result) - matrix).norm() <= 1e-9 * matrix.norm()))
  {
    refuse("has no logarithm");
  }
  return result;
}

Matrix4 exponential(const Matrix4& matrix)
{
  if (!matrix.row(3).isZero(0.0))
  {
    return exponentialOf(matrix);
  }
  // A large shift would cost the linear part its digits.
  Matrix4 result = Matrix4::Identity();
  const auto [linear, way] = wayOf(matrix.topLeftCorner<3, 3>());
  result.topLeftCorner<3, 3>() = linear;
  result.topRightCorner<3, 1>() = way * matrix.topRightCorner<3, 1>();
  return result;
}

Matrix4 shareOf(const Matrix4& a, double share)
{
  return exponential(share * logarithm(a));
}

Matrix4 together(const Matrix4& a, const Matrix4& b)
{
  return exponential(logarithm(a) + logarithm(b));
}

Matrix4 between(const Matrix4& a, const Matrix4& b, double t)
{
  return exponential((1.0 - t) * logarithm(a) + t * logarithm(b));
}

} // namespace oversketch
