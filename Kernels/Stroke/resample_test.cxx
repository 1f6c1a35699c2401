// Facts of image-assisted.md, section 4.
#include "Stroke/resample.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

Polyline placed(const std::vector<Blend>& places, const Polyline& points)
{
  Polyline result;
  for (const Blend& place : places)
  {
    result.push_back(place.of(points));
  }
  return result;
}

Polyline restless(unsigned seed, int count, double step)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-step, step);
  Polyline points{ { 0.0, 0.0 } };
  for (int i = 1; i < count; ++i)
  {
    points.push_back(points.back() + Vector2(move(random), move(random)));
  }
  return points;
}

} // namespace

TEST(C4_1, SpacingIsWithinHalfAndWhole)
{
  double least = 1e9, most = 0.0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    const double h = 1.0;
    const bool closed = seed % 2 == 1;
    const Polyline points = restless(seed, 5 + seed, seed % 3 == 0 ? 0.2 : 4.0);
    Polyline result = placed(resampled(points, h, closed), points);
    EXPECT_EQ(result.front(), points.front());
    if (closed)
    {
      result.push_back(result.front());
    }
    else
    {
      EXPECT_EQ(result.back(), points.back());
    }
    for (std::size_t i = 1; i < result.size(); ++i)
    {
      const double gap = (result[i] - result[i - 1]).norm();
      // All but the one segment of a stroke that ends nearer than that to its start.
      if (result.size() > 2)
      {
        least = std::min(least, gap / h);
        most = std::max(most, gap / h);
      }
    }
  }
  EXPECT_GE(least, 0.5 - 1e-8);
  EXPECT_LE(most, 1.0 + 1e-8);
  oversketch_test::fact("C4_1",
    "200 restless strokes, open and closed: gaps of " + std::to_string(least) + " to " +
      std::to_string(most) + " h");
}

TEST(C4_2, TwoPointsBecomeEleven)
{
  const Polyline points{ { 3.0, 1.0 }, { 4.0, 1.0 } };
  EXPECT_EQ(resampled(points, 0.1).size(), 11u);
  for (const Polyline& refused : { Polyline{},
         Polyline{ { 1, 1 } },
         Polyline{ { 1, 1 }, { 1, 1 }, { 1, 1 } },
         Polyline{ { 0, 0 }, { 1, std::nan("") } } })
  {
    EXPECT_THROW(resampled(refused, 0.1), Error);
  }
  EXPECT_THROW(resampled(points, 0.0), Error);
  EXPECT_THROW(resampled(points, 1e-9), Error);
  oversketch_test::fact(
    "C4_2", "two points 1 apart, h = 0.1: 11 points; no point, one, three equal ones, NaN refused");
}

TEST(C4_3, KeptSamplesStayAndASecondRunChangesNothing)
{
  int kept = 0, put = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    const bool closed = seed % 2 == 1;
    const Polyline points = restless(seed, 40, 2.0);
    const std::vector<Blend> places = resampled(points, 1.0, closed);
    for (const Blend& place : places)
    {
      (place.from == place.to ? kept : put) += 1;
      EXPECT_TRUE(place.from == place.to || (place.t > 0.0 && place.t < 1.0));
    }
    const Polyline once = placed(places, points);
    EXPECT_EQ(placed(resampled(once, 1.0, closed), once), once) << seed;
  }
  Polyline even{ { 0.0, 0.0 } };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.5, 1.0), turn(-0.5, 0.5);
  for (double angle = 0.0; even.size() < 100; angle += turn(random))
  {
    even.push_back(even.back() + step(random) * Vector2(std::cos(angle), std::sin(angle)));
  }
  EXPECT_EQ(placed(resampled(even, 1.0), even), even);
  oversketch_test::fact("C4_3",
    std::to_string(kept) + " samples kept and " + std::to_string(put) +
      " put between them; a second run, and one on samples h/2 to h apart, change no bit");
}
