// Facts of editors.md, section 13, operators and handles.
#include "Matrix/logarithm.h"

#include "Harness/shapes.h"
#include "Harness/transformations.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <unsupported/Eigen/MatrixFunctions>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

double difference(const Matrix4& a, const Matrix4& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

void expectRefused(const Matrix4& matrix, const std::string& what)
{
  try
  {
    logarithm(matrix);
    ADD_FAILURE() << "not refused: " << what;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::SolveFailed);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

} // namespace

TEST(B10_1, HalfOfATransformation)
{
  const Matrix4 quarter = turn(Vector3::UnitZ(), 90.0), stretch = scale(4.0, 9.0, 1.0),
                step = shift(2.0, 0.0, 0.0), screw = Matrix4(shift(0.0, 0.0, 3.0) * quarter);
  double worst = difference(shareOf(quarter, 0.5), turn(Vector3::UnitZ(), 45.0));
  worst = std::max(worst, difference(shareOf(stretch, 0.5), scale(2.0, 3.0, 1.0)));
  worst = std::max(worst, difference(shareOf(step, 0.5), shift(1.0, 0.0, 0.0)));
  worst = std::max(
    worst, difference(shareOf(screw, 0.5), Matrix4(shift(0.0, 0.0, 1.5) * turn(Vector3::UnitZ(), 45.0))));
  for (const Matrix4& a : { quarter, stretch, step, screw })
  {
    const Matrix4 half = shareOf(a, 0.5);
    worst = std::max(worst, difference(half * half, a));
    EXPECT_EQ(half.row(3), Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0));
    worst = std::max(worst, difference(between(a, a, 0.3), a));
  }
  EXPECT_LT(worst, 1e-13);
  fact("B10_1",
    "half of a turn by 90 degrees, diag(4, 9, 1), a shift by 2, a screw of 90 degrees and 3, and its square: "
    "within " +
      std::to_string(worst * 1e15) + "e-15");
}

TEST(B10_2, TwoTurnsAtOnce)
{
  const Matrix4 x = turn(Vector3::UnitX(), 90.0), y = turn(Vector3::UnitY(), 90.0);
  const Matrix4 both = together(x, y);
  const Eigen::AngleAxisd turned(Eigen::Matrix3d(both.topLeftCorner<3, 3>()));
  EXPECT_NEAR(turned.angle() * 180.0 / pi, 90.0 * std::sqrt(2.0), 1e-9);
  EXPECT_LT((turned.axis() - Vector3(1.0, 1.0, 0.0).normalized()).norm(), 1e-12);
  EXPECT_EQ(both, together(y, x));
  EXPECT_GT(difference(x * y, both), 0.1); // one after the other is something else
  // Where the order does not matter it is the product.
  const Matrix4 z30 = turn(Vector3::UnitZ(), 30.0), z50 = turn(Vector3::UnitZ(), 50.0);
  EXPECT_LT(difference(together(z30, z50), z30 * z50), 1e-14);
  fact("B10_2",
    "90 degrees about x and about y at once: " + std::to_string(turned.angle() * 180.0 / pi) +
      " degrees about (1, 1, 0), either order to the bit");
}

TEST(B10_4, ReflectionsAndHalfTurnsAreRefused)
{
  int refused = 0;
  for (const Vector3& axis : { Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(1, 2, 3), Vector3(-0.3, 0.2, 5) })
  {
    for (const Vector3& centre : { Vector3(0, 0, 0), Vector3(1, -20, 3) })
    {
      const Matrix4 there = shift(centre[0], centre[1], centre[2]),
                    back = shift(-centre[0], -centre[1], -centre[2]);
      expectRefused(there * turn(axis, 180.0) * back, "180 degrees");
      const Matrix4 mirror = Matrix4::Identity() - [&]
      {
        Matrix4 m = Matrix4::Zero();
        m.topLeftCorner<3, 3>() = 2.0 * axis.normalized() * axis.normalized().transpose();
        return m;
      }();
      expectRefused(there * mirror * back, "reflection");
      Matrix4 flat = turn(axis, 30.0) * scale(1.0, 0.0, 2.0);
      expectRefused(there * flat * back, "singular");
      refused += 3;
    }
  }
  expectRefused(Matrix4::Zero(), "singular");
  expectRefused(scale(1.0, std::nan(""), 1.0), "not finite");
  // A stretch by 4 and a turn by 150 degrees about another axis: real negative eigenvalues.
  expectRefused(turn(Vector3::UnitZ(), 150.0) * scale(4.0, 1.0, 1.0), "reflection");
  // One drag may turn by 179 degrees.
  const Matrix4 nearly = turn(Vector3(1, 2, 3), 179.0);
  EXPECT_LT(difference(shareOf(nearly, 0.5), turn(Vector3(1, 2, 3), 89.5)), 1e-12);
  fact("B10_4",
    std::to_string(refused) +
      " reflections, half turns and singular matrices are refused by name; a turn by 179 "
      "degrees is not");
}

TEST(Logarithm, NothingIsNothingAndAShiftIsItself)
{
  EXPECT_EQ(logarithm(Matrix4::Identity()), Matrix4::Zero());
  Matrix4 expected = Matrix4::Zero();
  expected.topRightCorner<3, 1>() = Vector3(0.1, -2.3, 1e6);
  EXPECT_EQ(logarithm(shift(0.1, -2.3, 1e6)), expected);
  // Far from the origin, too.
  const Matrix4 about = shift(1e6, -2e6, 5e6) * turn(Vector3(1, 2, 3), 100.0) * shift(-1e6, 2e6, -5e6);
  EXPECT_LT((exponential(logarithm(about)) - about).norm(), 1e-12 * about.norm());
}

// The oracle: of X with eigenvalues in the strip, log(exp X) is X.
TEST(B10_1, OfTenThousandRandomMatricesTheLogarithmComesBack)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  double worst = 0.0, residual = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    Matrix4 x = Matrix4::Zero();
    const bool affine = i % 4 != 0;
    for (int r = 0; r < (affine ? 3 : 4); ++r)
    {
      for (int c = 0; c < 4; ++c)
      {
        x(r, c) = value(random);
      }
    }
    x *= 0.7 * (1.0 + value(random)); // within the strip: no norm above pi
    if (x.norm() >= 3.1)
    {
      x *= 3.0 / x.norm();
    }
    Matrix4 a = x.exp();
    if (affine)
    {
      a.row(3) << 0.0, 0.0, 0.0, 1.0; // Eigen's is that to rounding
    }
    const Matrix4 log = logarithm(a);
    worst = std::max(worst, (log - x).norm());
    residual = std::max(residual, (exponential(log) - a).norm() / a.norm());
    if (affine)
    {
      ASSERT_TRUE(log.row(3).isZero(0.0));
    }
  }
  EXPECT_LT(worst, 1e-11);
  EXPECT_LT(residual, 1e-13);
  fact("B10_1",
    "of 10,000 exponentials by Eigen the logarithm is back within " + std::to_string(1e12 * worst) +
      "e-12, residual " + std::to_string(1e15 * residual) + "e-15");
}
