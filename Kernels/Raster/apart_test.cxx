#include "Raster/apart.h"

#include "Harness/drawing_shapes.h"
#include "Stroke/meetings.h"
#include "Stroke/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double spacing = 5.12;

// A needle of two flanks that shake, 1.5 px apart in the mean, by samples 0.3 to 2.5 px apart.
DrawnStroke shakenNeedle(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.3, 2.5), shake(-1.0, 1.0);
  Polyline points;
  for (double x = 730.0; x < 799.0; x += step(random))
  {
    points.emplace_back(x, 400.75 + shake(random));
  }
  for (double x = 800.0; x > 730.0; x -= step(random))
  {
    points.emplace_back(x, 399.25 + shake(random));
  }
  return closedStroke(points);
}

std::vector<int> crossed(const DrawnStroke& stroke, const std::vector<Blend>& places)
{
  Polyline points;
  for (const Blend& place : places)
  {
    points.push_back(place.of(stroke.points));
  }
  return meetingSegments({ { points, stroke.closed } }, Context()).front();
}

std::vector<Blend> drawn(const DrawnStroke& stroke)
{
  std::vector<Blend> places;
  places.reserve(stroke.points.size());
  for (int i = 0; i < static_cast<int>(stroke.points.size()); ++i)
  {
    places.push_back(Blend::point(i));
  }
  return places;
}

bool isSame(const std::vector<Blend>& a, const std::vector<Blend>& b)
{
  return std::equal(a.begin(),
    a.end(),
    b.begin(),
    b.end(),
    [](const Blend& p, const Blend& q) { return p.from == q.from && p.to == q.to && p.t == q.t; });
}

} // namespace

// The end of an antelope's hoof as a shaking hand drew it, the place that this was found at.
TEST(Apart, ASampleThatKeepsATipOpenIsPutBack)
{
  const DrawnStroke hoof = closedStroke({ { 806.15, 227.72 },
    { 807.36, 223.3 },
    { 806.74, 218.52 },
    { 806.73, 213.42 },
    { 799.13, 209.41 },
    { 796.3, 209.82 },
    { 796.77, 208.86 },
    { 807.66, 210.21 },
    { 813.0, 217.0 },
    { 813.0, 227.72 } });
  ASSERT_TRUE(crossed(hoof, drawn(hoof)).empty());
  const std::vector<Blend> without = resampled(hoof.points, spacing, true);
  EXPECT_EQ(crossed(hoof, without).size(), 2u);
  std::vector<std::vector<Blend>> places{ without };
  keepApart(pixelFrame(), { hoof }, spacing, places, Context());
  EXPECT_TRUE(crossed(hoof, places[0]).empty());
  EXPECT_TRUE(std::any_of(
    places[0].begin(), places[0].end(), [](const Blend& place) { return place.from == 6 && place.to == 6; }));
}

TEST(Apart, WhatCrossesNothingAsDrawnCrossesNothingResampled)
{
  int clear = 0, mended = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    const DrawnStroke needle = shakenNeedle(seed);
    const std::vector<Blend> without = resampled(needle.points, spacing, true);
    std::vector<std::vector<Blend>> places{ without };
    keepApart(pixelFrame(), { needle }, spacing, places, Context());
    if (!crossed(needle, drawn(needle)).empty())
    {
      continue; // the hand itself crossed
    }
    ++clear;
    const bool bad = !crossed(needle, without).empty();
    mended += bad;
    EXPECT_TRUE(crossed(needle, places[0]).empty()) << seed;
    EXPECT_EQ(isSame(places[0], without), !bad) << seed;
  }
  EXPECT_GT(clear, 50);
  EXPECT_GT(mended, 10);
}

TEST(Apart, OtherStrokesAreKeptClearOfToo)
{
  // The dropped sample of the first leads it round the second's end.
  const DrawnStroke first =
    openStroke({ { 100, 100 }, { 104, 100 }, { 105, 102 }, { 110, 100 }, { 120, 100 } });
  const DrawnStroke second = openStroke({ { 105.0, 101.0 }, { 105, 90 }, { 105, 80 } });
  std::vector<std::vector<Blend>> places{ resampled(first.points, spacing),
    resampled(second.points, spacing) };
  ASSERT_EQ(places[0].size(), 6u); // without the third sample, one put into each of two gaps
  keepApart(pixelFrame(), { first, second }, spacing, places, Context());
  EXPECT_TRUE(std::any_of(
    places[0].begin(), places[0].end(), [](const Blend& place) { return place.from == 2 && place.to == 2; }));
}

TEST(Apart, WhatIsDrawnAcrossItselfStaysSoAndWhatLeavesTheRasterIsLeft)
{
  Polyline eight;
  for (int i = 0; i < 300; ++i)
  {
    const double angle = turn * (i + 0.5) / 300;
    eight.emplace_back(500 + 100 * std::cos(angle), 500 + 60 * std::sin(2 * angle));
  }
  const std::vector<DrawnStroke> strokes{ closedStroke(eight),
    openStroke({ { -900, 3 }, { -899, 3 }, { 9e5, 3 } }) };
  std::vector<std::vector<Blend>> places{ resampled(eight, spacing, true),
    resampled(strokes[1].points, spacing) };
  const std::vector<Blend> outside = places[1];
  keepApart(pixelFrame(), strokes, spacing, places, Context());
  EXPECT_EQ(crossed(strokes[0], places[0]).size(), 2u);
  EXPECT_TRUE(isSame(places[1], outside));
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(keepApart(pixelFrame(), strokes, spacing, places, cancelled), Error);
}
