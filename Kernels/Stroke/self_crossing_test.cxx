#include "Stroke/self_crossing.h"

#include <gtest/gtest.h>

using oversketch::Polyline;
using oversketch::selfCrossing;
using oversketch::Vector2;

namespace
{

void expectCrossing(const Polyline& line, const Vector2& place)
{
  const auto found = selfCrossing(line, 0.1);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - place).norm(), 1e-12) << found->transpose();
}

} // namespace

TEST(SelfCrossing, ALoopIsFoundWhereItCrosses)
{
  const Polyline loop = { { 0, 0 }, { 0.75, 0.5 }, { 0.25, 0.5 }, { 1, 0 } };
  expectCrossing(loop, { 0.5, 1.0 / 3.0 });
  expectCrossing(Polyline(loop.rbegin(), loop.rend()), { 0.5, 1.0 / 3.0 });
}

TEST(SelfCrossing, PointsOfTheLineMayBeWhereItCrosses)
{
  expectCrossing(
    { { 0, 0 }, { 0.5, 0.25 }, { 1, 0.5 }, { 0.5, 1 }, { 0.5, 0.25 }, { 0.5, -1 } }, { 0.5, 0.25 });
  expectCrossing({ { 0, 0 }, { 1, 0.5 }, { 0.5, 1 }, { 0.5, 0.25 }, { 0.5, -1 } }, { 0.5, 0.25 });
}

TEST(SelfCrossing, WhatIsSmallOrGoesBackIsNone)
{
  const Polyline trembling = { { 0, 0 }, { 0.51, 0.01 }, { 0.49, 0.01 }, { 1, 0 } };
  EXPECT_FALSE(selfCrossing(trembling, 0.1));
  EXPECT_TRUE(selfCrossing(trembling, 0.01));
  EXPECT_FALSE(selfCrossing({ { 0, 0 }, { 0.5, 0 }, { 0.5, 3 }, { 0.5, 0 }, { 1, 0 } }, 0.1)); // up and down
  EXPECT_FALSE(selfCrossing({ { 0, 0 }, { 0.7, 0.3 }, { 0.2, 0.5 }, { 1, 0.7 } }, 0.1));       // a Z
  EXPECT_FALSE(selfCrossing({}, 0.1));
  EXPECT_FALSE(selfCrossing({ { 0, 0 } }, 0.1));
}
