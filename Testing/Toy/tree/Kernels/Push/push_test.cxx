#include "Harness/shapes.h"
#include "Push/push.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0);
const std::vector<Vector2> left{ { 350, 100 }, { 350, 500 } }, right{ { 450, 100 }, { 450, 500 } };

} // namespace

TEST(Push, WhatLiesBetweenTheLinesGoesAlongItsNormal)
{
  const Mesh ball = icosphere(3);
  const std::vector<Vector3> points = pushBetween(ball, view, left, right, { 2, 1, { 0.0, 1.0 } }, 0.25, {});
  int pushed = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double x = ball.points[i].x();
    if (x > 0.01 && x < 0.49)
    {
      EXPECT_NEAR(points[i].norm(), 1.25, 0.01) << x; // a vertex's normal is nearly its radius
      ++pushed;
    }
    else if (x < -0.01 || x > 0.51)
    {
      EXPECT_EQ(points[i], ball.points[i]) << x;
    }
  }
  EXPECT_GT(pushed, 50);
}

TEST(Push, LinesRoundNothingAreRefused)
{
  const std::vector<Vector2> outside{ { 10, 10 }, { 20, 20 } };
  EXPECT_THROW(
    pushBetween(icosphere(2), view, outside, { { 10, 20 }, { 20, 30 } }, { 1, 1, { 1.0 } }, 0.1, {}), Error);
}
