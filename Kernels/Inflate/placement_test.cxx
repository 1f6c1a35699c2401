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
  EXPECT_THROW(Placement(Eigen::Matrix4d::Zero()), Error);
}
