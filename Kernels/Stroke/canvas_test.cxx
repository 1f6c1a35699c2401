// Facts of image-assisted.md, sections 1 and 2.
#include "Stroke/canvas.h"
#include "Stroke/correct.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

constexpr double halfTurn = 3.14159265358979323846;

// Parallel, along -z, `scale` world units high, as a window of 800 x 600 px sees it.
View above(double scale)
{
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity(), projection = Eigen::Matrix4d::Identity();
  view(2, 3) = -5.0;
  projection(0, 0) = 2.0 / (scale * 800.0 / 600.0);
  projection(1, 1) = 2.0 / scale;
  projection(2, 2) = -0.1;
  return View(view, projection, 800, 600);
}

View tilted()
{
  const Eigen::Affine3d turn(Eigen::AngleAxisd(0.7, Vector3(1.0, 0.3, 0.1).normalized()));
  Eigen::Matrix4d view = (Eigen::Translation3d(0.1, -0.2, -4.0) * turn).matrix();
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 2.0 * 600.0 / 800.0;
  projection(1, 1) = 2.0;
  projection(2, 2) = -1.02;
  projection(2, 3) = -0.2;
  projection(3, 2) = -1.0;
  return View(view, projection, 800, 600);
}

Polyline arc(double from, double to, double radius, int count)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = from + (to - from) * i / (count - 1);
    points.push_back(radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Polyline circle(double radius, int count)
{
  Polyline points = arc(0.0, 2.0 * halfTurn, radius, count + 1);
  points.pop_back();
  return points;
}

} // namespace

TEST(C1_2, ADragAtTwiceTheZoomIsHalfAsLong)
{
  const Vector2 a(130.0, 220.0), b(512.0, 77.0);
  const auto drag = [&](double scale)
  {
    const View view = above(scale);
    return (*ontoCanvas(view, b) - *ontoCanvas(view, a)).eval();
  };
  const double off = (drag(2.0) - 2.0 * drag(1.0)).norm();
  EXPECT_LT(off, 1e-12);
  // Under a tilted perspective camera the place projects back to where the pen was: it is on z = 0.
  const View view = tilted();
  double back = 0.0;
  for (double x = 50.0; x < 800.0; x += 93.0)
  {
    for (double y = 30.0; y < 600.0; y += 71.0)
    {
      const auto place = ontoCanvas(view, Vector2(x, y));
      ASSERT_TRUE(place);
      const Vector3 shown = view.toDisplay(Vector3((*place)[0], (*place)[1], 0.0));
      back = std::max(back, (shown.head<2>() - Vector2(x, y)).norm());
    }
  }
  EXPECT_LT(back, 1e-9);
  // A ray along the plane meets it nowhere.
  Eigen::Matrix4d side = Eigen::Matrix4d::Identity();
  side.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.5 * halfTurn, Vector3::UnitX()).toRotationMatrix();
  EXPECT_FALSE(ontoCanvas(View(side, above(1.0).projectionTransform(), 800, 600), a));
  oversketch_test::fact("C1_2",
    "the same drag at zoom 2: half as long to " + std::to_string(off * 1e12) + "e-12" +
      "; tilted perspective: places project back within " + std::to_string(back * 1e9) + "e-9 px");
}

TEST(C1_2, APicturesRectangleHasItsSamplesInTheMiddleOfSquares)
{
  const Canvas canvas = pictureCanvas(Vector2(0.0, 0.0), Vector2(1.0, 1.0), 640, 480);
  EXPECT_EQ(canvas.corner, Vector2(-0.5, -0.5));
  EXPECT_EQ(canvas.size, Vector2(640.0, 480.0));
  EXPECT_EQ(canvas.longest(), 640.0);
  EXPECT_THROW(pictureCanvas(Vector2(0.0, 0.0), Vector2(1.0, -1.0), 640, 480), Error);
  EXPECT_GT(samplesRound(circle(100.0, 60), canvas), 0u);
  EXPECT_EQ(samplesRound(arc(0.0, 6.0, 100.0, 60), canvas), 0u);
  EXPECT_EQ(samplesRound(arc(0.0, 0.1, 100.0, 60), canvas), 0u); // a dab
}

TEST(Canvas, WhatRunsPastTheStartIsLeftOut)
{
  const Canvas canvas{ { 0.0, 0.0 }, { 1024.0, 768.0 } };
  const double turn = 2.0 * halfTurn;
  for (const double beside : { -8.0, -5.0, 0.0, 5.0, 8.0 })
  {
    for (const double past : { 0.02, 0.12, 0.3 }) // rad
    {
      SCOPED_TRACE(testing::Message() << beside << " px beside, " << past << " rad past");
      Polyline ring;
      for (int i = 0; i <= 400; ++i)
      {
        const double angle = (turn + past) * i / 400.0;
        const double radius = 300.0 + beside * angle / turn;
        ring.emplace_back(512.0 + radius * std::cos(angle), 384.0 + radius * std::sin(angle));
      }
      const std::size_t kept = samplesRound(ring, canvas);
      ASSERT_GT(kept, 350u);
      ASSERT_LE(kept, 401u);
      // Once round, and the last step leads on: by no more than 45 degrees it turns.
      const Vector2 before = ring[kept - 1] - ring[kept - 2], last = ring[0] - ring[kept - 1];
      EXPECT_GT(before.normalized().dot(last.normalized()), 0.7);
      EXPECT_GT(last.dot(ring[1] - ring[0]), 0.0);
    }
  }
  // A spiral of two turns is none, nor what comes back beside itself the other way.
  Polyline spiral, hairpin;
  for (int i = 0; i <= 400; ++i)
  {
    const double angle = 2.0 * turn * i / 400.0;
    spiral.emplace_back(
      512.0 + (100.0 + 2.0 * angle) * std::cos(angle), 384.0 + (100.0 + 2.0 * angle) * std::sin(angle));
    hairpin.emplace_back(100.0 + 400.0 * std::min(i, 400 - i) / 200.0, i < 200 ? 300.0 : 306.0);
  }
  EXPECT_EQ(samplesRound(spiral, canvas), 0u);
  EXPECT_EQ(samplesRound(hairpin, canvas), hairpin.size());
}

TEST(Canvas, ATinyCircleClosesAndAShortArcDoesNot)
{
  const Canvas canvas{ { 0.0, 0.0 }, { 1024.0, 768.0 } };
  const double twoTurns = 2.0 * halfTurn;
  for (const double diameter : { 6.0, 8.0, 12.0, 40.0, 400.0 })
  {
    SCOPED_TRACE(diameter);
    for (const int samples : { 8, 20 }) // a hand that is quick leaves few
    {
      EXPECT_GT(samplesRound(arc(0.0, twoTurns, 0.5 * diameter, samples), canvas), 0u);
      // It goes on beyond its begin, and stops short of it, by a twentieth of a turn: of a large one that is
      // over 0.02 longest sides.
      // Of few samples of a large one no end lies beside the beginning.
      EXPECT_EQ(samplesRound(arc(0.0, twoTurns + 0.3, 0.5 * diameter, samples), canvas) > 0,
        diameter < 100.0 || samples == 20);
      EXPECT_EQ(
        samplesRound(arc(0.0, twoTurns - 0.3, 0.5 * diameter, samples), canvas) > 0, diameter < 100.0);
      EXPECT_EQ(samplesRound(arc(0.0, 0.7 * twoTurns, 0.5 * diameter, samples), canvas), 0u) << "a C";
      EXPECT_EQ(samplesRound(arc(0.0, 0.5 * twoTurns, 0.5 * diameter, samples), canvas), 0u) << "a bow";
    }
    EXPECT_EQ(samplesRound({ { 0.0, 0.0 }, { 0.5 * diameter, 1.0 }, { diameter, 0.0 } }, canvas), 0u);
  }
}

TEST(C1_3, ThirtyDegreesOfACircleAreCorrected)
{
  const double h = 0.005, radius = 0.3;
  const Polyline old = circle(radius, 400);
  double worst = 0.0;
  int same = 0;
  for (const double start : { 1.0, -halfTurn / 12.0, -0.01, 6.1 }) // the second and third across its start
  {
    for (const bool turned : { false, true })
    {
      for (const double offset : { 0.0, 0.002, -0.004 })
      {
        Polyline fresh = arc(start, start + halfTurn / 6.0, radius + offset, 40);
        if (turned)
        {
          std::reverse(fresh.begin(), fresh.end());
        }
        const std::vector<CanvasStroke> strokes{ { arc(0.0, 1.0, 0.7, 20), false }, { old, true } };
        const Correction correction = corrected(strokes, fresh, 0.02, h);
        ASSERT_EQ(correction.kind, Correction::Replacement);
        ASSERT_EQ(correction.stroke, 1);
        const Polyline& result = correction.result.points;
        ASSERT_EQ(correction.result.origins.size(), result.size());
        const NearestPlace drawn(fresh);
        // Blends reach six times the offset beyond either end.
        const double reach = 6.0 * std::abs(offset) / radius + 0.02;
        for (int i = 0; i < 400; ++i)
        {
          const double angle =
            std::remainder(2.0 * halfTurn * i / 400 - (start + halfTurn / 12.0), 2.0 * halfTurn);
          const bool stays = std::find(result.begin(), result.end(), old[i]) != result.end();
          if (std::abs(angle) > halfTurn / 12.0 + reach)
          {
            EXPECT_TRUE(stays) << i;
            same += stays;
          }
        }
        for (const Vector2& p : result)
        {
          const double angle =
            std::remainder(std::atan2(p[1], p[0]) - (start + halfTurn / 12.0), 2.0 * halfTurn);
          if (std::abs(angle) < halfTurn / 12.0)
          {
            worst = std::max(worst, drawn(p).distance);
          }
        }
        // Still one turn round, in the old direction, closed without a gap.
        double area = 0.0;
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          const Vector2 p = result[i], q = result[(i + 1) % result.size()];
          area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
          EXPECT_LT((p - q).norm(), 2.0 * h);
        }
        EXPECT_NEAR(area, halfTurn * radius * radius, 0.02 * halfTurn * radius * radius);
        for (std::size_t i = 0; i < result.size(); ++i)
        {
          EXPECT_LT((correction.result.origins[i].of(old, fresh) - result[i]).norm(), 0.02);
        }
      }
    }
  }
  EXPECT_LT(worst, h);
  oversketch_test::fact("C1_3",
    "24 corrections of 30 degrees of a circle: one stroke in place of one, " + std::to_string(same) +
      " untouched samples to the bit, replaced ones within " + std::to_string(worst / h) +
      " h of the new stroke");
}

TEST(Correct, AnEndThatIsNearExtendsAndNoneIsNew)
{
  const Polyline old{ { 0.0, 0.0 }, { 0.1, 0.0 }, { 0.2, 0.0 }, { 0.3, 0.0 } };
  const std::vector<CanvasStroke> strokes{ { old, false } };
  for (const bool turned : { false, true })
  {
    Polyline fresh{ { 0.25, 0.0 }, { 0.35, 0.1 }, { 0.45, 0.2 } };
    if (turned)
    {
      std::reverse(fresh.begin(), fresh.end());
    }
    const Correction extension = corrected(strokes, fresh, 0.02, 0.01);
    ASSERT_EQ(extension.kind, Correction::Extension);
    EXPECT_EQ(extension.result.points.front(), old.front());
    EXPECT_EQ(extension.result.points.back(), Vector2(0.45, 0.2));
    EXPECT_EQ(std::count(extension.result.points.begin(), extension.result.points.end(), old.back()), 0);
  }
  // Beside the stroke, running back over it: still from the foot to the free end that is nearer.
  const Polyline back{ { 0.05, 0.01 }, { -0.02, 0.1 }, { -0.2, 0.3 } };
  const Correction other = corrected(strokes, back, 0.02, 0.01);
  ASSERT_EQ(other.kind, Correction::Extension);
  EXPECT_EQ(other.result.points.front(), back.back());
  EXPECT_EQ(other.result.points.back(), old.back());
  for (std::size_t i = 0; i < other.result.points.size(); ++i)
  {
    EXPECT_LT((other.result.origins[i].of(old, back) - other.result.points[i]).norm(), 0.02) << i;
  }
  EXPECT_EQ(corrected(strokes, { { 0.1, 0.5 }, { 0.2, 0.5 } }, 0.02, 0.01).kind, Correction::New);
  EXPECT_EQ(corrected({}, back, 0.02, 0.01).kind, Correction::New);
  EXPECT_THROW(corrected(strokes, { { 1.0, 1.0 } }, 0.02, 0.01), Error);
}

TEST(Correct, AWholeTurnReplacesTheWholeCurve)
{
  const Polyline old = circle(0.3, 200);
  const Polyline fresh = arc(0.5, 0.5 + 2.0 * halfTurn - 0.001, 0.305, 200);
  const Correction correction = corrected({ { old, true } }, fresh, 0.02, 0.005);
  ASSERT_EQ(correction.kind, Correction::Replacement);
  EXPECT_EQ(correction.result.points, fresh);
}

TEST(Correct, AWholeTurnThatEndsShortOrGoesOnIsOneTurn)
{
  const Polyline old = circle(0.3, 200);
  for (const double beyond : { -0.3, -0.06, -0.02, 0.0, 0.01, 0.06, 0.3, 2.0 })
  {
    for (const double way : { 1.0, -1.0 })
    {
      const Polyline fresh = arc(0.5, 0.5 + way * (2.0 * halfTurn + beyond), 0.305, 300);
      const Correction correction = corrected({ { old, true } }, fresh, 0.02, 0.005);
      ASSERT_EQ(correction.kind, Correction::Replacement) << beyond;
      const Polyline& points = correction.result.points;
      ASSERT_EQ(points.size(), correction.result.origins.size());
      double turned = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Vector2 &a = points[i], &b = points[(i + 1) % points.size()];
        turned += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
        EXPECT_GE(a.norm(), 0.3 * std::cos(halfTurn / 200) - 1e-9); // on a chord
        EXPECT_LE(a.norm(), 0.305 + 1e-9);
        EXPECT_GT(a[0] * b[1] - a[1] * b[0], 0.0) << "in the old curve's direction, " << beyond;
        const Origin& origin = correction.result.origins[i];
        if (origin.weight == 1.0)
        {
          EXPECT_LT((origin.after.of(fresh) - a).norm(), 1e-12);
        }
      }
      EXPECT_NEAR(turned, 2.0 * halfTurn, 1e-9) << beyond;
    }
  }
}
