#include "Harness/shapes.h"
#include "Mesh/context.h"
#include "Stroke/stroke.h"

#include <gtest/gtest.h>

using namespace oversketch;
using oversketch_test::pi;

namespace
{

Polyline arc(double radius, double from, double to, int count)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    const double a = (from + (to - from) * i / (count - 1)) * pi / 180.0;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return points;
}

// Down one side of a limb, round its tip, up the other side.
Polyline hairpin(double length, double width)
{
  Polyline points;
  for (double y = length; y > 0.0; y -= 3.0)
    points.emplace_back(-width / 2, y);
  for (const Vector2& p : arc(width / 2, 180.0, 360.0, 20))
    points.push_back(p);
  for (double y = 3.0; y <= length; y += 3.0)
    points.emplace_back(width / 2, y);
  return points;
}

std::string refusal(const Polyline& samples)
{
  try
  {
    cleanStroke(samples);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    return error.what();
  }
  return "";
}

} // namespace

TEST(Polyline, NearestPlaceAgreesWithExhaustiveSearch)
{
  Polyline points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(200 * std::cos(0.05 * i) + 0.3 * i, 150 * std::sin(0.083 * i));
  for (const bool closed : { false, true })
  {
    const NearestPlace nearest(points, closed);
    for (int k = 0; k < 200; ++k)
    {
      const Vector2 p(300 * std::sin(1.7 * k), 200 * std::cos(2.9 * k));
      double best = 1e300;
      for (std::size_t i = 0; i + 1 < points.size() + (closed ? 1 : 0); ++i)
      {
        const Vector2 a = points[i], d = points[(i + 1) % points.size()] - a;
        const double t = std::min(1.0, std::max(0.0, (p - a).dot(d) / d.squaredNorm()));
        best = std::min(best, (p - a - t * d).norm());
      }
      const NearestPlace::Answer answer = nearest(p);
      EXPECT_NEAR(answer.distance, best, 1e-12);
      EXPECT_NEAR((answer.place - p).norm(), best, 1e-12);
      EXPECT_EQ(nearest(p, 0.5 * best).segment, -1);
    }
  }
}

TEST(Polyline, MeanDistanceIsThatOfEachPointByItself)
{
  for (const double far : { 0.0, 1e9, 1e17 })
  {
    Polyline line, points;
    for (int i = 0; i < 700; ++i)
    {
      line.emplace_back(far + 90 * std::cos(0.03 * i) + 0.2 * i, far - 60 * std::sin(0.07 * i));
      // On the line, on it again, beside it, and now and then far away.
      points.push_back(i % 2 ? points.back() : line.back());
      points.back() += i % 3 ? Vector2(0, 0) : Vector2(i % 50, i % 7 ? 0.1 : 400);
    }
    for (const bool closed : { false, true })
    {
      const NearestPlace nearest(line, closed);
      double sum = 0.0;
      for (const Vector2& p : points)
        sum += nearest(p).distance;
      EXPECT_EQ(nearest.meanDistance(points), sum / static_cast<double>(points.size())) << far;
    }
  }
  EXPECT_EQ(NearestPlace({}).meanDistance({ { 0, 0 }, { 1, 0 } }), std::numeric_limits<double>::infinity());
}

TEST(Polyline, UniformSamplingKeepsEndsAndSpacing)
{
  const Polyline curve = arc(100.0, 0.0, 180.0, 2001);
  const Polyline samples = uniformPolyline(curve, 2.0);
  EXPECT_EQ(samples.size(), 158u); // pi * 100 / 2 = 157.08 steps
  EXPECT_EQ(samples.front(), curve.front());
  EXPECT_EQ(samples.back(), curve.back());
  for (std::size_t i = 1; i < samples.size(); ++i)
    EXPECT_NEAR((samples[i] - samples[i - 1]).norm(), 2.0, 0.002);
  // Coincident points have no place of their own.
  const Polyline doubled{ { 0, 0 }, { 0, 0 }, { 4, 0 }, { 4, 0 }, { 8, 0 }, { 8, 0 } };
  for (const Vector2& p : uniformPolyline(doubled, 2.0))
    EXPECT_TRUE(p.allFinite());
}

TEST(Stroke, JitterIsDroppedAndEndsAreKept)
{
  // A pen that rests: many samples within a pixel, then a straight line of 100 px.
  Polyline samples;
  for (int i = 0; i < 50; ++i)
    samples.emplace_back(0.5 * std::sin(7.0 * i) - 0.5 * std::sin(0.0), 0.5 * std::sin(11.0 * i));
  for (int i = 1; i <= 50; ++i)
    samples.emplace_back(2.0 * i + 1.0, 0.0);
  for (int i = 0; i < 20; ++i)
    samples.emplace_back(101.0 + 0.3 * std::sin(5.0 * i), 0.3 * std::sin(3.0 * i));
  const std::vector<Blend> places = cleanStroke(samples);
  EXPECT_EQ(places.front().of(samples), samples.front());
  EXPECT_EQ(places.back().of(samples), samples.back());
  double length = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i)
    length += (places[i].of(samples) - places[i - 1].of(samples)).norm();
  EXPECT_NEAR(length, 101.0, 0.5); // the resting pen would add some 50 px
}

TEST(Stroke, ClosedOnesAreRefusedAndHairpinsPass)
{
  EXPECT_NE(refusal(arc(80.0, 0.0, 360.0, 200)).find("closed"), std::string::npos);
  EXPECT_NE(refusal(arc(80.0, 0.0, 340.0, 200)).find("closed"), std::string::npos); // ends 28 px apart of 475
  EXPECT_EQ(refusal(arc(80.0, 0.0, 300.0, 200)), "");
  EXPECT_EQ(refusal(hairpin(100.0, 30.0)), "");
  EXPECT_EQ(refusal(hairpin(300.0, 8.0)), ""); // a thin tail: ends 1.3 % of the length apart
  EXPECT_NE(refusal(hairpin(300.0, 2.5)).find("closed"), std::string::npos);
}

TEST(Stroke, RefusalsNameTheCause)
{
  EXPECT_NE(refusal({}).find("0 samples"), std::string::npos);
  EXPECT_NE(refusal({ { 1, 1 } }).find("1 sample;"), std::string::npos);
  EXPECT_NE(
    refusal({ { 0, 0 }, { 5, 0 }, { std::nan(""), 3 }, { 30, 0 } }).find("sample 2"), std::string::npos);
  EXPECT_NE(refusal({ { 0, 0 }, { 9, 0 } }).find("9 px long"), std::string::npos);
  EXPECT_NE(refusal({ { 3, 3 }, { 3, 3 }, { 3, 3 } }).find("0 px long"), std::string::npos);
  EXPECT_EQ(refusal({ { 0, 0 }, { 10, 0 } }), "");
}

TEST(Stroke, ScribblesAndSamplesFarBesideTheViewportAreRefused)
{
  StrokeRules rules;
  rules.maximumLength = 8.0;
  rules.closedFraction = 0.0;
  rules.viewport = Vector2(400, 300); // a diagonal of 500 px
  const auto zigzag = [](int times)
  {
    Polyline line;
    for (int i = 0; i <= times; ++i)
      line.emplace_back(i % 2 ? 350.0 : 50.0, 20.0 + i);
    return line;
  };
  const auto said = [&](const Polyline& samples)
  {
    try
    {
      cleanStroke(samples, rules);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), Failure::BadStroke);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said(zigzag(13)), ""); // 3,900 px
  EXPECT_NE(said(zigzag(14)).find("4200 px long, 8 times the diagonal"), std::string::npos);
  // As far beside it as it is large, and farther.
  EXPECT_EQ(said({ { -399, 10 }, { 200, 590 } }), "");
  EXPECT_NE(said({ { 10, 10 }, { 801, 10 } }).find("sample 1 lies at (801, 10) px"), std::string::npos);
  EXPECT_NE(
    said({ { 10, 10 }, { 20, 10 }, { 1e7, 10 } }).find("sample 2 lies at (1e+07, 10) px"), std::string::npos);
  // Without a limit or without a viewport neither is looked at.
  rules.viewport = Vector2::Zero();
  EXPECT_EQ(said(zigzag(14)), "");
  rules.viewport = Vector2(400, 300);
  rules.maximumLength = 0.0;
  EXPECT_EQ(said(zigzag(14)), "");
  EXPECT_EQ(said({ { 10, 10 }, { 801, 10 } }), "");
}

TEST(Stroke, WhatComesBackIsARing)
{
  Polyline ring;
  for (int i = 0; i < 40; ++i)
    ring.emplace_back(50 * std::cos(2 * pi * i / 40), 50 * std::sin(2 * pi * i / 40));
  EXPECT_TRUE(comesBack(ring, 8.0)); // its ends are 7.8 px apart
  EXPECT_FALSE(comesBack(ring, 7.0));
  EXPECT_FALSE(comesBack(ring, 0.0));
  EXPECT_FALSE(comesBack({ { 0, 0 }, { 4, 0 }, { 4, 4 } }, 8.0)) << "a hook of 8 px";
  EXPECT_FALSE(comesBack({ { 0, 0 }, { 4, 0 } }, 8.0));
  EXPECT_FALSE(comesBack({}, 8.0));
}
