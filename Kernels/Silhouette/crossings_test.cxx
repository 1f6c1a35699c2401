#include "Silhouette/crossings.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;

namespace
{

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
  const auto cross = [](const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; };
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
