// Facts of editors.md, section 13 (re-sketching): f from (0, 0) to (100, 0), spacing 1.
#include "Stroke/resketch.h"

#include "Harness/shapes.h"
#include "Stroke/correct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using oversketch::Blend;
using oversketch::NearestPlace;
using oversketch::Origin;
using oversketch::Polyline;
using oversketch::resketch;
using oversketch::Resketched;
using oversketch::ResketchRules;
using oversketch::Vector2;
using oversketch_test::fact;

namespace
{

Polyline line(double x0, double x1, double y)
{
  Polyline points;
  const int steps = static_cast<int>(std::abs(x1 - x0));
  for (int i = 0; i <= steps; ++i)
  {
    points.emplace_back(x0 + (x1 - x0) * i / steps, y);
  }
  return points;
}

const Polyline f = line(0.0, 100.0, 0.0);

// Height of a result that goes from left to right.
double heightAt(const Polyline& r, double x)
{
  for (size_t i = 1; i < r.size(); ++i)
  {
    if (r[i - 1][0] <= x && x <= r[i][0] && r[i - 1][0] < r[i][0])
    {
      const double t = (x - r[i - 1][0]) / (r[i][0] - r[i - 1][0]);
      return (1.0 - t) * r[i - 1][1] + t * r[i][1];
    }
  }
  return std::nan("");
}

} // namespace

TEST(B4_1, APartInTheMiddle)
{
  const Polyline m = line(40.0, 60.0, 2.0);
  const Resketched r = resketch(f, m);
  for (double x = 0.0; x <= 100.0; x += 0.5)
  {
    if (x <= 28.0 || x >= 72.0)
    {
      EXPECT_NEAR(heightAt(r.points, x), 0.0, 1e-9) << x;
    }
    else if (x >= 40.0 && x <= 60.0)
    {
      EXPECT_EQ(heightAt(r.points, x), 2.0) << x;
    }
    else
    {
      EXPECT_GT(heightAt(r.points, x), 0.0) << x;
    }
  }
  EXPECT_NEAR(heightAt(r.points, 34.0), 0.5, 0.02); // a plain splice or Hermite curve gives 1
  EXPECT_NEAR(heightAt(r.points, 66.0), 0.5, 0.02);
  EXPECT_EQ(r.points.front(), f.front());
  EXPECT_EQ(r.points.back(), f.back());
  // Every sample of the new curve, and those of the old one outside, are there as they were.
  for (const Vector2& p : m)
  {
    EXPECT_NE(std::find(r.points.begin(), r.points.end(), p), r.points.end());
  }
  for (int i = 0; i < 28; ++i)
  {
    EXPECT_EQ(r.points[i], f[i]);
  }
  // With half the reach the old curve is left later.
  const Resketched k3 = resketch(f, m, { 3.0 });
  EXPECT_NEAR(heightAt(k3.points, 34.0), 0.0, 1e-9);
  EXPECT_GT(heightAt(k3.points, 35.0), 0.0);
  fact("B4_1",
    "y = 0 up to 28 and from 72 on, 2 from 40 to 60, " + std::to_string(heightAt(r.points, 34.0)) +
      " at 34 and " + std::to_string(heightAt(r.points, 66.0)) + " at 66; with k = 3 it is left at 34");
}

TEST(B4_2, TheDirectionOfTheNewCurveDoesNotMatter)
{
  const Resketched r = resketch(f, line(40.0, 60.0, 2.0)), back = resketch(f, line(60.0, 40.0, 2.0));
  ASSERT_EQ(r.points.size(), back.points.size());
  for (size_t i = 0; i < r.points.size(); ++i)
  {
    EXPECT_EQ(r.points[i], back.points[i]);
  }
  fact(
    "B4_2", "drawn from right to left: the same " + std::to_string(r.points.size()) + " points to the bit");
}

TEST(B4_3, OverAnEnd)
{
  const Resketched r = resketch(f, line(95.0, 130.0, 1.0));
  EXPECT_EQ(r.points.back(), Vector2(130.0, 1.0));
  EXPECT_NEAR(heightAt(r.points, 89.0), 0.0, 1e-9);
  EXPECT_GT(heightAt(r.points, 90.0), 0.0);
  const Polyline longer = line(-10.0, 110.0, 1.0);
  const Resketched whole = resketch(f, longer);
  EXPECT_EQ(whole.points, longer);
  const Resketched start = resketch(f, line(5.0, 50.0, 1.0)); // S' = -0.01
  EXPECT_EQ(start.points.front(), Vector2(5.0, 1.0));
  EXPECT_EQ(start.points.back(), f.back());
  fact("B4_3",
    "over the end: left at 89, ends at (130, 1); over both: the new curve; from (5, 1) on: begins there");
}

TEST(Resketch, RunningOnFromAnEndExtends)
{
  for (const bool backwards : { false, true })
  {
    Polyline on = line(102.0, 150.0, 0.0), ahead = line(-2.0, -50.0, 0.0);
    if (backwards)
    {
      std::reverse(on.begin(), on.end());
      std::reverse(ahead.begin(), ahead.end());
    }
    const Resketched r = resketch(f, on), l = resketch(f, ahead);
    EXPECT_EQ(r.points.front(), f.front());
    EXPECT_EQ(r.points.back(), Vector2(150.0, 0.0));
    EXPECT_EQ(l.points.front(), Vector2(-50.0, 0.0));
    EXPECT_EQ(l.points.back(), f.back());
    for (const Resketched& one : { r, l })
    {
      EXPECT_TRUE(std::is_sorted(one.points.begin(),
        one.points.end(),
        [](const Vector2& a, const Vector2& b) { return a[0] < b[0]; }));
    }
  }
}

TEST(B4_4, ABulgeStays)
{
  Polyline arc;
  for (int i = 0; i <= 40; ++i)
  {
    const double angle = M_PI * i / 40.0;
    arc.emplace_back(50.0 - 10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  const Resketched r = resketch(f, arc);
  double highest = 0.0;
  for (const Vector2& p : r.points)
  {
    highest = std::max(highest, p[1]);
  }
  EXPECT_GE(highest, 9.9);
  // As published every sample goes to one of the two ends, but for the one in the middle.
  ResketchRules published;
  published.middle = ResketchRules::Middle::Closest;
  const Resketched collapsed = resketch(f, arc, published);
  std::vector<double> heights;
  for (const Vector2& p : collapsed.points)
  {
    heights.push_back(p[1]);
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_LT(heights[heights.size() - 2], 0.5); // the arc is a polyline
  fact("B4_4",
    "a semicircle of radius 10: " + std::to_string(highest) +
      " high; by closest places all but one sample are at " + "most " +
      std::to_string(heights[heights.size() - 2]) + " high");
}

TEST(Resketch, ClosestPlacesOfAFlatCurve)
{
  ResketchRules published;
  published.middle = ResketchRules::Middle::Closest;
  const Polyline m = line(40.0, 60.0, 2.0);
  const Resketched r = resketch(f, m, published);
  const NearestPlace nearest(m);
  int middle = 0;
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    if (r.origins[i].weight == 1.0)
    {
      EXPECT_NEAR((nearest(r.origins[i].before.of(f)).place - r.points[i]).norm(), 0.0, 1e-12);
      EXPECT_NEAR((r.origins[i].after.of(m) - r.points[i]).norm(), 0.0, 1e-12);
      ++middle;
    }
  }
  EXPECT_EQ(middle, 21); // both ends and 41 to 59
}

TEST(Resketch, RawTangentsAreStepsOfTheCurves)
{
  ResketchRules published;
  published.rawTangents = true;
  const Resketched r = resketch(f, line(40.0, 60.0, 2.0), published);
  // A step of 1 where the way is 12 long: at u = 1/2, a quarter of (T0 - T1) / 2 is nothing, so y is the same
  // there; x of the Hermite curve is that of straight ways but for the tangents' share.
  EXPECT_NEAR(heightAt(r.points, 34.0), 0.5, 0.02);
  const auto first = std::find_if(
    r.origins.begin(), r.origins.end(), [](const Origin& o) { return o.weight > 0.0 && o.weight < 1.0; });
  const std::size_t i = static_cast<std::size_t>(first - r.origins.begin());
  const double c = first->weight;
  // Hermite's curve with both tangents (1, 0): x = 28 + 12 c + (2u^3 - 3u^2 + u), c = 3u^2 - 2u^3.
  double u = 0.5;
  for (int k = 0; k < 60; ++k)
  {
    u -= (3.0 * u * u - 2.0 * u * u * u - c) / (6.0 * u - 6.0 * u * u);
  }
  const double hermite = 28.0 + 12.0 * c + (2.0 * u * u * u - 3.0 * u * u + u);
  EXPECT_NEAR(r.points[i][0], (1.0 - c) * (28.0 + 12.0 * u) + c * hermite, 1e-6);
  EXPECT_NEAR(r.points[i][1], c * 2.0 * c, 1e-9);
}

TEST(Resketch, NewSamplesTakeThePlacesOfTheOldOnes)
{
  const auto places = [](const Resketched& r)
  {
    std::vector<double> x;
    for (const Origin& origin : r.origins)
    {
      x.push_back(origin.before.of(f)[0]);
    }
    return x;
  };
  for (const auto& [from, to] : { std::make_pair(40.0, 60.0),
         std::make_pair(60.0, 40.0),
         std::make_pair(-10.0, 110.0),
         std::make_pair(95.0, 130.0) })
  {
    const std::vector<double> x = places(resketch(f, line(from, to, 1.0)));
    EXPECT_TRUE(std::is_sorted(x.begin(), x.end()));
    EXPECT_NEAR(x.front(), 0.0, 1e-12);
    EXPECT_NEAR(x.back(), 100.0, 1e-12);
  }
}

TEST(Resketch, AClosedCurveByThePublishedRules)
{
  // A circle, a flat stroke over its right side: every new sample is one of the closest.
  Polyline circle;
  for (int i = 0; i < 200; ++i)
  {
    circle.emplace_back(100.0 * std::cos(2.0 * M_PI * i / 200.0), 100.0 * std::sin(2.0 * M_PI * i / 200.0));
  }
  Polyline chord;
  for (int i = -40; i <= 40; ++i)
  {
    chord.emplace_back(95.0, i);
  }
  ResketchRules published;
  published.middle = ResketchRules::Middle::Closest;
  const Resketched r = oversketch::resketchClosed(circle, chord, published);
  int onChord = 0, kept = 0;
  for (std::size_t i = 0; i < r.points.size(); ++i)
  {
    if (r.origins[i].weight == 1.0)
    {
      EXPECT_NEAR(r.points[i][0], 95.0, 1e-12);
      ++onChord;
    }
    kept += r.origins[i].weight == 0.0 ? 1 : 0;
  }
  EXPECT_GT(onChord, 20);
  EXPECT_GT(kept, 100);
}

// The way in, the middle and the way out are measured from different ends; they meet to the last bit.
TEST(Resketch, SourcesOfAnOpenCurveNeverFall)
{
  int fell = 0;
  for (int steps = 7; steps <= 61; steps += 9)
  {
    Polyline section;
    for (int i = 0; i <= steps; ++i)
    {
      const double x = static_cast<double>(i) / steps;
      section.emplace_back(x, 0.03 * std::sin(7.0 * x));
    }
    const std::vector<double> lengths = oversketch::arcLengths(section);
    for (int k = 1; k <= 60; ++k)
    {
      // From a place on the section to another one, to rounding.
      const Vector2 begin = oversketch::placeAt(lengths, steps + 1, 0.0061 * k * lengths.back()).of(section);
      const Vector2 end =
        oversketch::placeAt(lengths, steps + 1, (1.0 - 0.0067 * k) * lengths.back()).of(section);
      Polyline arch;
      for (int i = 0; i <= 100; ++i)
      {
        const double t = i / 100.0;
        arch.push_back((1.0 - t) * begin + t * end + Vector2(0.0, 0.3 * std::sin(oversketch_test::pi * t)));
      }
      const Resketched r = resketch(section, arch, { 6.0, 0.002 });
      const std::vector<double> sources = oversketch::sourcesOf(r.origins, section);
      ASSERT_EQ(sources.size(), r.points.size());
      EXPECT_TRUE(std::is_sorted(sources.begin(), sources.end())) << steps << ' ' << k;
      double before = 0.0;
      for (size_t i = 0; i < sources.size(); ++i)
      {
        const double own = r.origins[i].before.of(lengths) / lengths.back();
        EXPECT_NEAR(sources[i], own, 1e-14);
        fell += own < before ? 1 : 0;
        before = own;
      }
    }
  }
  EXPECT_GT(fell, 0); // as they come some do, so that this tests something
}

TEST(Resketch, OriginsGiveTheSamplesBack)
{
  // An affine value of the old curve and of the new one, carried along, is that value at the result.
  std::vector<double> old, fresh;
  const Polyline m = line(60.0, 40.0, 0.0); // on the curve itself, so no sample moves sideways
  for (const Vector2& p : f)
  {
    old.push_back(3.0 * p[0]);
  }
  for (const Vector2& p : m)
  {
    fresh.push_back(3.0 * p[0]);
  }
  const Resketched r = resketch(f, m);
  ASSERT_EQ(r.points.size(), r.origins.size());
  for (size_t i = 0; i < r.points.size(); ++i)
  {
    EXPECT_NEAR(r.origins[i].of(old, fresh), 3.0 * r.points[i][0], 1e-12);
  }
  const Resketched above = resketch(f, line(60.0, 40.0, 2.0));
  for (size_t i = 0; i < above.points.size(); ++i)
  {
    EXPECT_NEAR(above.origins[i].of(old, fresh) / 3.0, above.points[i][0], 12.0); // a run is 12 px long
  }
}

TEST(Resketch, NothingToReplace)
{
  const Polyline dot(5, Vector2(50.0, 3.0)), across{ { 50.0, 4.0 }, { 50.0, 9.0 } };
  EXPECT_EQ(resketch(f, dot).points, f);
  EXPECT_EQ(resketch(f, across).points, f); // both ends nearest to the same inner place
  EXPECT_EQ(resketch(dot, f).points, dot);
  EXPECT_EQ(resketch(f, {}).points, f);
  EXPECT_TRUE(resketch({}, f).points.empty());
}
