// Poses: the order of turns, the way back, what stays where it is.
#include "Matrix/pose.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;

TEST(Pose, TurnsAboutXThenYThenZ)
{
  // y goes to z, then to x, then to y again.
  const Eigen::Matrix3d turn = turnedBy({ 90.0, 90.0, 90.0 });
  EXPECT_LT((turn * Vector3::UnitY() - Vector3::UnitY()).norm(), 1e-14);
  EXPECT_LT((turn * Vector3::UnitX() + Vector3::UnitZ()).norm(), 1e-14);
  EXPECT_LT((turn * Vector3::UnitZ() - Vector3::UnitX()).norm(), 1e-14);
}

TEST(Pose, DegreesComeBack)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-180.0, 180.0), half(-89.0, 89.0);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 degrees(any(random), half(random), any(random));
    EXPECT_LT((degreesOf(turnedBy(degrees)) - degrees).norm(), 1e-9);
  }
  for (const double y : { -90.0, 90.0 })
  {
    const Eigen::Matrix3d turn = turnedBy({ 31.0, y, -12.0 });
    EXPECT_EQ(degreesOf(turn)[0], 0.0);
    EXPECT_LT((turnedBy(degreesOf(turn)) - turn).norm(), 1e-9);
  }
}

TEST(Pose, ScalesThenTurnsThenMoves)
{
  Pose pose;
  EXPECT_TRUE(pose.isRest());
  pose.scale = { 2.0, 1.0, 1.0 };
  pose.turn = { 0.0, 0.0, 90.0 };
  pose.move = { 10.0, 0.0, 0.0 };
  EXPECT_FALSE(pose.isRest());
  const Vector3 middle(1.0, 2.0, 3.0);
  const Eigen::Affine3d transform = pose.about(middle);
  EXPECT_LT((transform * middle - (middle + pose.move)).norm(), 1e-12);
  EXPECT_LT((transform * Vector3(2.0, 2.0, 3.0) - Vector3(11.0, 4.0, 3.0)).norm(), 1e-12);
  EXPECT_LT((transform * Vector3(1.0, 3.0, 3.0) - Vector3(10.0, 2.0, 3.0)).norm(), 1e-12);
}

TEST(Pose, AMoveAloneIsExact)
{
  Pose pose;
  pose.move = { 0.1, -0.2, 1e-9 };
  const Vector3 middle(0.7, 12.3, 1e6), place(0.3, 5.1, 7e5);
  EXPECT_EQ(Vector3(pose.about(middle) * place), Vector3(place + pose.move));
}
