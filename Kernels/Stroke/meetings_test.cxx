#include "Stroke/meetings.h"

#include "Mesh/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

void expectCrossing(const Polyline& line, const Vector2& place)
{
  const auto found = selfCrossing(line, 0.1);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - place).norm(), 1e-12) << found->transpose();
}

std::vector<ImageSegment> segmentsOf(const std::vector<std::vector<Vector2>>& curves)
{
  std::vector<ImageSegment> segments;
  for (int c = 0; c < static_cast<int>(curves.size()); ++c)
  {
    for (int i = 0; i + 1 < static_cast<int>(curves[c].size()); ++i)
    {
      segments.push_back({ c, i, i + 1, curves[c][i], curves[c][i + 1] });
    }
  }
  return segments;
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

TEST(Crossings, TwoCurvesMeetAtTheRightPlaces)
{
  const auto crossings =
    findCrossings(segmentsOf({ { { 0, 0 }, { 4, 0 } }, { { 1, -1 }, { 1, 3 }, { 3, -1 } } }));
  ASSERT_EQ(crossings.size(), 4u);
  EXPECT_EQ(crossings[0].segment, 0);
  EXPECT_DOUBLE_EQ(crossings[0].place, 0.25);
  EXPECT_EQ(crossings[1].segment, 0);
  EXPECT_DOUBLE_EQ(crossings[1].place, 0.625);
  EXPECT_EQ(crossings[2].segment, 1);
  EXPECT_DOUBLE_EQ(crossings[2].place, 0.25);
  EXPECT_EQ(crossings[3].segment, 2);
  EXPECT_DOUBLE_EQ(crossings[3].place, 0.75);
}

TEST(Crossings, ACurveThroughAPointOfAnotherCrossesOnceAndATouchNever)
{
  EXPECT_EQ(
    findCrossings(segmentsOf({ { { -1, 0 }, { 0, 0 }, { 1, 0 } }, { { 0, -1 }, { 0, 0 }, { 0, 1 } } }))
      .size(),
    2u);
  EXPECT_EQ(
    findCrossings(segmentsOf({ { { -1, 0 }, { 1, 0 } }, { { -1, 1 }, { 0, 0 }, { 1, 1 } } })).size() % 4, 0u);
  EXPECT_TRUE(findCrossings(segmentsOf({ { { 0, 0 }, { 1, 0 }, { 1, 1 } } })).empty());
}

// All pairs against the grid, with a point thrown far out as perspective does.
TEST(Crossings, TheGridFindsWhatAllPairsDo)
{
  std::vector<Vector2> curve;
  for (int i = 0; i < 400; ++i)
  {
    const double a = 0.37 * i;
    curve.push_back(Vector2(300 * std::sin(1.3 * a) + 20 * std::cos(7 * a), 200 * std::sin(a)));
  }
  curve[200] = Vector2(1e9, -1e8);
  const auto segments = segmentsOf({ curve });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = i + 2; j < segments.size(); ++j)
    {
      const auto& [p, q] = std::pair<const ImageSegment&, const ImageSegment&>(segments[i], segments[j]);
      const Vector2 dp = p.to - p.from, dq = q.to - q.from;
      pairs += (cross(dp, q.from - p.from) >= 0) != (cross(dp, q.to - p.from) >= 0) &&
               (cross(dq, p.from - q.from) >= 0) != (cross(dq, p.to - q.from) >= 0);
    }
  }
  EXPECT_GT(pairs, 1000u);
  EXPECT_EQ(findCrossings(segments).size(), 2 * pairs);
}

TEST(Meetings, TheyAreThoseOfEveryPairOfSegments)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  for (int run = 0; run < 60; ++run)
  {
    std::vector<PlaneCurve> curves(4);
    for (PlaneCurve& curve : curves)
    {
      for (int i = 0; i < 3 + run % 3; ++i)
      {
        curve.points.emplace_back(place(random), place(random));
      }
      curve.points.push_back(curve.points.back() + Vector2(0.5, 3.0));
    }
    // Of all pairs of segments, by solving for the crossing.
    std::vector<int> expected(4, -1);
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < 4; ++b)
      {
        for (std::size_t i = 0; i + 1 < curves[a].points.size(); ++i)
        {
          for (std::size_t j = 0; j + 1 < curves[b].points.size(); ++j)
          {
            if (a == b && (i > j ? i - j : j - i) < 2)
            {
              continue;
            }
            Eigen::Matrix2d m;
            m << curves[a].points[i + 1] - curves[a].points[i], curves[b].points[j] - curves[b].points[j + 1];
            const Vector2 t = m.inverse() * (curves[b].points[j] - curves[a].points[i]);
            if (t.minCoeff() >= 0.0 && t.maxCoeff() <= 1.0 &&
                (expected[a] < 0 || static_cast<int>(i) < expected[a]))
            {
              expected[a] = static_cast<int>(i);
            }
          }
        }
      }
    }
    const std::vector<Meeting> found = meetings(curves, Context());
    for (int a = 0; a < 4; ++a)
    {
      EXPECT_EQ(found[a].segment, expected[a]) << run;
    }
  }
}
