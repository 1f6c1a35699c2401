#include "Inflate/placement.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

TEST(Placement, MovesAndTellsMirrors)
{
  Eigen::Matrix4d matrix;
  matrix << 0, -2, 0, 5, 3, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1;
  const Placement placement(matrix);
  EXPECT_EQ(placement(Vector3(1, 2, 3)), Vector3(1, 9, 10));
  EXPECT_FALSE(placement.mirrors());
  matrix.row(2) *= -1.0;
  EXPECT_TRUE(Placement(matrix).mirrors());
  Eigen::Matrix4d tiny = 1e-30 * Eigen::Matrix4d::Identity();
  tiny(3, 3) = 1.0;
  EXPECT_FALSE(Placement(tiny).mirrors());
}

TEST(Placement, ARectangleFillsABox)
{
  const Eigen::Vector4d from(10, 20, 30, 60), box(-1, 0, 3, 36);
  const Placement placement(intoBox(from, box, 5.0));
  EXPECT_TRUE(placement(Vector3(10, 20, 0)).isApprox(Vector3(-1, 0, 5), 1e-14));
  EXPECT_TRUE(placement(Vector3(30, 60, 0)).isApprox(Vector3(3, 36, 5), 1e-14));
  // Scales of 0.2 and 0.9: their geometric mean in z.
  EXPECT_NEAR(placement(Vector3(10, 20, 1)).z(), 5.0 + std::sqrt(0.2 * 0.9), 1e-15);
}

TEST(Placement, RefusesWhatPlacesNothing)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  const auto refused = [&](int row, int column, double value)
  {
    Eigen::Matrix4d wrong = matrix;
    wrong(row, column) = value;
    EXPECT_THROW(Placement{ wrong }, Error) << row << " " << column << " " << value;
  };
  refused(3, 0, 0.5);
  refused(3, 3, 2.0);
  refused(1, 1, 0.0);
  refused(0, 3, std::nan(""));
  refused(0, 3, std::numeric_limits<double>::infinity());
  EXPECT_THROW(Placement{ Eigen::Matrix4d::Zero() }, Error);
}
