// Facts of image-assisted.md, section 4, and of thinning and corner cutting in system D.
#include "Stroke/resample.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace oversketch;
using oversketch_test::fact;
using oversketch_test::pi;

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

Polyline cut(const Polyline& points, bool closed)
{
  return placed(chaikinPass(static_cast<int>(points.size()), closed), points);
}

Polyline thinOut(const Polyline& samples, double spacing)
{
  Polyline result;
  for (const int i : thinStroke(samples, spacing))
  {
    result.push_back(samples[i]);
  }
  return result;
}

// A pen that hurries, rests, crosses its own way and goes back over it.
Polyline restlessHand(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(-1.5, 1.5), rest(0.0, 1.0);
  Polyline samples{ { 300, 200 } };
  for (int i = 1; i < count; ++i)
  {
    const double pace = rest(random) < 0.3 ? 0.01 : 4.0;
    samples.push_back(samples.back() + pace * Vector2(std::cos(0.02 * i), std::sin(0.05 * i)) +
                      Vector2(step(random), step(random)));
  }
  return samples;
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

TEST(D3_1, OnePassOfChaikinCutsTheCorner)
{
  const Polyline corner{ { 0, 0 }, { 4, 0 }, { 4, 4 } };
  EXPECT_EQ(cut(corner, false), (Polyline{ { 0, 0 }, { 3, 0 }, { 4, 1 }, { 4, 4 } }));
  // Round a square no end is held: eight corners, each a quarter from an old one.
  const Polyline square{ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  EXPECT_EQ(cut(square, true),
    (Polyline{ { 1, 0 }, { 3, 0 }, { 4, 1 }, { 4, 3 }, { 3, 4 }, { 1, 4 }, { 0, 3 }, { 0, 1 } }));
  // Its limit is a quadratic B-spline, which takes 7/8 of a square's area at the first pass and 5/6 in the
  // end.
  Polyline ring = square;
  double area = 0.0;
  for (int pass = 0; pass < 8; ++pass)
  {
    ring = cut(ring, true);
    area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]) / 16.0;
    }
    EXPECT_NEAR(area, 5.0 / 6.0 + std::pow(0.25, pass + 1) / 6.0, 1e-12);
  }
  fact("D3_1",
    "(0,0),(4,0),(4,4) becomes (0,0),(3,0),(4,1),(4,4) exactly; a square keeps 7/8 of its area, after 8 "
    "passes " +
      std::to_string(area) + " (limit 5/6)");
}

TEST(D3_2, ThinnedGapsAndNothingTwice)
{
  const Polyline samples = restlessHand(5000);
  double least = std::numeric_limits<double>::infinity();
  for (const double spacing : { 0.0, 1.0, 4.0, 17.0 })
  {
    const Polyline thin = thinOut(samples, spacing);
    EXPECT_EQ(thin.front(), samples.front());
    EXPECT_EQ(thin.back(), samples.back());
    for (std::size_t i = 1; i + 1 < thin.size(); ++i)
    {
      ASSERT_GE((thin[i] - thin[i - 1]).norm(), spacing);
      least = spacing == 4.0 ? std::min(least, (thin[i] - thin[i - 1]).norm()) : least;
    }
    EXPECT_EQ(thinOut(thin, spacing), thin) << spacing;
  }
  EXPECT_EQ(thinOut(samples, 0.0), samples);
  fact("D3_2",
    "5,000 samples of a restless hand, 4 px: " + std::to_string(thinOut(samples, 4.0).size()) +
      " stay, least gap " + std::to_string(least) + " px, a second pass changes nothing at 0, 1, 4, 17 px");
}

TEST(Thinning, AStrokeThatCrossesItselfLosesNothingThere)
{
  // A figure of eight through the same place twice: only the last sample kept is asked.
  Polyline eight;
  for (int i = 0; i < 200; ++i)
    eight.emplace_back(300 * std::sin(2 * pi * i / 200), 200 * std::sin(4 * pi * i / 200));
  EXPECT_EQ(thinOut(eight, 4.0), eight);
}

TEST(Thinning, PointsDotsAndRings)
{
  EXPECT_TRUE(thinStroke({}, 4.0).empty());
  EXPECT_EQ(thinStroke({ { 3, 3 } }, 4.0), std::vector<int>{ 0 });
  EXPECT_EQ(thinStroke({ { 3, 3 }, { 4, 3 }, { 3, 4 } }, 4.0), (std::vector<int>{ 0, 2 }));
  // The last sample of a ring is one like any other.
  Polyline ring;
  for (int i = 0; i < 100; ++i)
    ring.emplace_back(50 * std::cos(2 * pi * i / 100), 50 * std::sin(2 * pi * i / 100));
  const std::vector<int> kept = thinStroke(ring, 10.0, true);
  for (std::size_t i = 1; i < kept.size(); ++i)
    EXPECT_GE((ring[kept[i]] - ring[kept[i - 1]]).norm(), 10.0);
}

TEST(Chaikin, FewPointsAndEnds)
{
  EXPECT_TRUE(chaikinPass(0, false).empty());
  EXPECT_EQ(cut({ { 5, 6 } }, false), (Polyline{ { 5, 6 } }));
  EXPECT_EQ(cut({ { 5, 6 }, { 7, 9 } }, false), (Polyline{ { 5, 6 }, { 7, 9 } }));
  const Polyline line = cut({ { 0, 0 }, { 4, 4 }, { 8, 8 }, { 12, 12 } }, false);
  ASSERT_EQ(line.size(), 6u);
  for (const Vector2& p : line)
    EXPECT_EQ(p[0], p[1]) << "a straight line stays one";
}
