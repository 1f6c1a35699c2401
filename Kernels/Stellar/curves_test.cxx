#include "Harness/shapes.h"
#include "Mesh/context.h"
#include "Stellar/curves.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace oversketch;
using oversketch_test::pi;

namespace
{

FeatureCurve curveThrough(const std::vector<Vector3>& points, bool closed = false)
{
  FeatureCurve curve;
  curve.points = points;
  curve.closed = closed;
  curve.measure();
  return curve;
}

} // namespace

TEST(Curves, PositionFollowsArcLengthAndGoesRoundAClosedCurve)
{
  const std::vector<Vector3> square{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const FeatureCurve open = curveThrough(square), closed = curveThrough(square, true);
  EXPECT_EQ(open.length, 3.0);
  EXPECT_EQ(closed.length, 4.0);
  EXPECT_EQ(open.position(1.5), Vector3(1, 0.5, 0));
  EXPECT_EQ(open.position(9.0), Vector3(0, 1, 0));
  EXPECT_EQ(open.position(-1.0), Vector3(0, 0, 0));
  EXPECT_EQ(closed.position(3.5), Vector3(0, 0.5, 0));
  EXPECT_EQ(closed.position(4.5), Vector3(0.5, 0, 0));
  EXPECT_EQ(closed.position(-0.5), Vector3(0, 0.5, 0));
  EXPECT_EQ(closed.apart(0.25, 3.75), 0.5);
  EXPECT_EQ(open.apart(0.25, 2.75), 2.5);
  EXPECT_EQ(closed.between(0.25, 3.25), 3.75);
  EXPECT_EQ(closed.between(1.0, 2.0), 1.5);
}

// Two fifths of the room, and no more than the way from where there is less.
TEST(Curves, LimitsFollowTheRoom)
{
  const double none = std::numeric_limits<double>::infinity();
  FeatureCurve curve = curveThrough({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 3, 0 } });
  EXPECT_TRUE(curve.limits(true).empty());
  curve.room = { { none, 2.0 }, { 0.4, none }, { none, none }, { 1.0, none } };
  const std::vector<double> down = curve.limits(false), up = curve.limits(true);
  const double wantedDown[] = { 1.16, 0.16, 1.16, 0.4 }, wantedUp[] = { 0.8, 1.8, 2.8, 5.8 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(down[i], wantedDown[i], 1e-12) << i;
    EXPECT_NEAR(up[i], wantedUp[i], 1e-12) << i;
  }
  curve.closed = true;
  curve.measure();
  EXPECT_NEAR(curve.limits(true)[3], 0.8 + std::sqrt(13.0), 1e-12);
  curve.room.assign(4, { none, none });
  EXPECT_EQ(curve.limits(true)[2], none);
}

TEST(Curves, NearestIsWhatLookingAtEverySegmentFinds)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto anywhere = [&] { return Vector3(unit(random), unit(random), unit(random)); };
  std::vector<Vector3> points;
  points.reserve(203);
  for (int i = 0; i < 203; ++i)
  {
    points.push_back(anywhere());
  }
  const FeatureCurves curves{ curveThrough(points, true) };
  const CurveSearch search(curves);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 x = anywhere();
    double best = std::numeric_limits<double>::infinity();
    for (int s = 0; s < 203; ++s)
    {
      const Vector3 &p = points[s], &q = points[(s + 1) % 203];
      const double t = std::clamp((q - p).dot(x - p) / (q - p).squaredNorm(), 0.0, 1.0);
      best = std::min(best, (x - p - t * (q - p)).norm());
    }
    const NearestOnCurve found = search.nearest(0, x);
    EXPECT_NEAR(found.distance, best, 1e-14);
    EXPECT_NEAR((curves[0].position(found.parameter) - found.point).norm(), 0.0, 1e-12);
    EXPECT_EQ(search.nearest(0, x, found.distance).segment, -1); // nearer than the limit, not as near
  }
}

TEST(Curves, EquallyNearSegmentsGiveTheLower)
{
  std::vector<Vector3> circle;
  circle.reserve(64);
  for (int i = 0; i < 64; ++i) // the same square, sixteen times
  {
    circle.emplace_back(i % 4 == 0 || i % 4 == 3 ? -1 : 1, i % 4 < 2 ? -1 : 1, 0);
  }
  const FeatureCurves curves{ curveThrough(circle, true) };
  EXPECT_EQ(CurveSearch(curves).nearest(0, Vector3(0, 0, 1)).segment, 0);
  EXPECT_EQ(CurveSearch(curves).nearest(0, Vector3(0.5, 0.2, 0)).segment, 1);
}

TEST(Curves, WhatIsNoCurveIsRefused)
{
  const FeatureCurve good = curveThrough({ { 0, 0, 0 }, { 1, 0, 0 } });
  EXPECT_NO_THROW(checkCurves({ good }));
  const auto refused = [&](const std::function<void(FeatureCurve&)>& spoil)
  {
    FeatureCurve bad = good;
    spoil(bad);
    try
    {
      checkCurves({ good, bad });
    }
    catch (const Error& e)
    {
      return e.failure() == Failure::BadStroke && std::string(e.what()).find("curve 1") != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.points.pop_back(); }));
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.points[1].z() = NAN; }));
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.points[1] = c.points[0], c.measure(); }));
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.normals.resize(1); }));
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.arc.clear(); }));
  for (double r : { 0.0, -1.0, double(NAN), double(INFINITY) })
  {
    EXPECT_TRUE(refused([&](FeatureCurve& c) { c.radius = r; }));
  }
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.height = NAN; }));
  EXPECT_TRUE(refused([](FeatureCurve& c) { c.sharpness = -0.1; }));
}

TEST(Curves, TheDigestKnowsPointsAndClosure)
{
  const FeatureCurve a = curveThrough({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } });
  FeatureCurve b = a, c = a, d = a;
  b.points[2].z() = 1e-300;
  c.closed = true;
  d.points[0].x() = -0.0;
  EXPECT_NE(digest({ a }), digest({ b }));
  EXPECT_NE(digest({ a }), digest({ c }));
  EXPECT_EQ(digest({ a }), digest({ d }));
  EXPECT_NE(digest({ a, b }), digest({ b, a }));
}
