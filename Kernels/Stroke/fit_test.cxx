#include "Stroke/fit.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace oversketch;
using oversketch_test::pi;

namespace
{

Polyline circleSamples(double radius, int count)
{
  Polyline samples;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * i / count;
    samples.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return samples;
}

Polyline pictureOf(const FittedStroke& fitted)
{
  Polyline picture;
  for (const SplinePlace& place : fitted.places)
  {
    picture.push_back(place.of(fitted.controls));
  }
  return picture;
}

// What de Boor's recurrence makes of the knots and control points that a file holds.
Vector2 deBoor(const std::vector<double>& knots, std::vector<Vector2> controls, int degree, double t)
{
  int piece = degree;
  while (piece + 1 < static_cast<int>(controls.size()) && t >= knots[piece + 1])
  {
    ++piece;
  }
  for (int d = 1; d <= degree; ++d)
  {
    for (int i = piece; i > piece - degree + d - 1; --i)
    {
      const double a = (t - knots[i]) / (knots[i + degree + 1 - d] - knots[i]);
      controls[i] = (1.0 - a) * controls[i - 1] + a * controls[i];
    }
  }
  return controls[piece];
}

} // namespace

TEST(Fit, PlacesAreEvenAndTheEndsAreTheStrokes)
{
  Polyline samples;
  for (int i = 0; i <= 200; ++i)
  {
    samples.emplace_back(2.0 * i, 60.0 * std::sin(0.05 * i));
  }
  const FittedStroke fitted = fitStroke(samples, false);
  const Polyline picture = pictureOf(fitted);
  EXPECT_EQ(picture.front(), samples.front());
  EXPECT_LT((picture.back() - samples.back()).norm(), 1e-12);
  for (std::size_t i = 1; i < picture.size(); ++i)
  {
    EXPECT_NEAR((picture[i] - picture[i - 1]).norm(), 0.5, 0.02);
    EXPECT_GT(fitted.parameters[i], fitted.parameters[i - 1]);
  }
  FitRules through;
  through.interpolate = true;
  const NearestPlace nearest(pictureOf(fitStroke(samples, false, through)));
  for (const int kept : fitted.kept)
  {
    EXPECT_LT(nearest(samples[kept]).distance, 0.05);
  }
}

TEST(Fit, KnotsAndControlPointsMakeTheSameCurve)
{
  for (const int count : { 2, 3, 4, 9 })
  {
    for (const bool closed : { false, true })
    {
      if (closed && count < 3)
      {
        continue;
      }
      FitRules rules;
      rules.cutLoops = false;
      const FittedStroke fitted = fitStroke(circleSamples(200.0, count), closed, rules);
      std::vector<Vector2> controls;
      for (const int i : fitted.order)
      {
        controls.push_back(fitted.controls[i]);
      }
      ASSERT_EQ(fitted.knots.size(), controls.size() + fitted.degree + 1);
      for (std::size_t i = 0; i < fitted.places.size(); i += 7)
      {
        const Vector2 expected = fitted.places[i].of(fitted.controls);
        EXPECT_LT(
          (deBoor(fitted.knots, controls, fitted.degree, fitted.parameters[i]) - expected).norm(), 1e-9)
          << count << " " << closed << " " << fitted.parameters[i];
      }
    }
  }
}

TEST(Fit, LoopsAreCutAndTheLongerPartStays)
{
  // A circle with a small loop outwards at its right side, begun at any sample.
  Polyline ring = circleSamples(100.0, 60);
  Polyline loop;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = pi - 2.0 * pi * (i + 0.5) / 8;
    loop.emplace_back(110.0 + 12.0 * std::cos(angle), 12.0 * std::sin(angle));
  }
  ring.insert(ring.begin() + 1, loop.begin(), loop.end());
  for (int turn = 0; turn < static_cast<int>(ring.size()); ++turn)
  {
    Polyline turned = ring;
    std::rotate(turned.begin(), turned.begin() + turn, turned.end());
    Polyline cut;
    double farthest = 0.0;
    for (const int i : withoutLoops(turned))
    {
      cut.push_back(turned[i]);
      farthest = std::max(farthest, turned[i].norm());
    }
    EXPECT_GE(cut.size(), 59u) << turn;
    EXPECT_EQ(withoutLoops(cut).size(), cut.size());
    EXPECT_LE(cut.size(), 62u) << turn;
  }
  // Of a figure eight the larger half; what does not cross itself stays as it is.
  Polyline eight;
  for (const double t : { 0.1, 0.4, 0.7, 1.0, 1.3, 1.6, 1.9, 2.2, 2.5, 2.8, 3.3, 3.8, 4.3, 4.8, 5.3, 5.8 })
  {
    eight.emplace_back((t < pi ? 200.0 : 100.0) * std::sin(t), 80.0 * std::sin(2.0 * t));
  }
  for (const int i : withoutLoops(eight))
  {
    EXPECT_GT(eight[i][0], 0.0);
  }
  EXPECT_EQ(withoutLoops(circleSamples(50.0, 30)).size(), 30u);
}

TEST(Fit, WhatIsLeftNeverCrossesItself)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(0.0, 400.0);
  for (int trial = 0; trial < 200; ++trial)
  {
    Polyline scribble;
    for (int i = 0; i < 3 + trial % 20; ++i)
    {
      const double x = value(random);
      scribble.emplace_back(x, value(random));
    }
    Polyline left;
    for (const int i : withoutLoops(scribble))
    {
      left.push_back(scribble[i]);
    }
    ASSERT_GE(left.size(), 2u); // of a bow-tie
    EXPECT_EQ(withoutLoops(left).size(), left.size());
  }
}

TEST(Fit, HostileStrokesAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const Polyline& samples, bool closed)
  {
    try
    {
      fitStroke(samples, closed);
    }
    catch (const Error& error)
    {
      return error.failure() == Failure::BadStroke;
    }
    return false;
  };
  EXPECT_TRUE(refused({}, false));
  EXPECT_TRUE(refused({ { 3, 4 } }, false));
  EXPECT_TRUE(refused({ { 3, 4 }, { 3, 4 }, { 3, 4 } }, false));
  EXPECT_TRUE(refused({ { 3, 4 }, { nan, 4 } }, false));
  EXPECT_TRUE(refused({ { 0, 0 }, { 1e9, 0 } }, false));
  EXPECT_TRUE(refused({ { 0, 0 }, { 50, 0 } }, true));
  EXPECT_TRUE(refused(circleSamples(2.0, 40), true)); // a dot
  EXPECT_FALSE(refused({ { 0, 0 }, { 1, 0 } }, false));
}
