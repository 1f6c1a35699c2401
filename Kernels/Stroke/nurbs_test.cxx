// Facts of editors.md, section 13, curves: the pixel filter and the fit.
#include "Stroke/nurbs.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"
#include "Stroke/resample.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using oversketch_test::fact;
using oversketch_test::pi;

namespace
{

std::vector<double> keptOf(int count)
{
  Polyline samples;
  for (int x = 0; x < count; ++x)
  {
    samples.emplace_back(x, 3.0);
  }
  std::vector<double> kept;
  for (const int i : thinEvenly(samples, 10.0))
  {
    kept.push_back(samples[i][0]);
  }
  return kept;
}

Polyline ring(int count, double radius)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

Polyline randomStroke(std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> value(0.0, 500.0);
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    const double x = value(random);
    points.emplace_back(x, value(random));
  }
  return points;
}

} // namespace

TEST(B2_1, ThePixelFilterKeepsFirstAndLast)
{
  EXPECT_EQ(keptOf(96), (std::vector<double>{ 0, 10, 20, 30, 40, 50, 60, 70, 80, 95 }));
  const std::vector<double> eleven = keptOf(101);
  ASSERT_EQ(eleven.size(), 11u);
  EXPECT_EQ(eleven.back(), 100.0);
  EXPECT_EQ(keptOf(7), (std::vector<double>{ 0, 6 }));
  EXPECT_EQ(keptOf(1), (std::vector<double>{ 0 }));
  EXPECT_TRUE(keptOf(0).empty());
  fact("B2_1", "96 events 1 px apart: 0, 10 ... 80, 95; 101 events: 11 points");
}

TEST(B2_2, TheCurveLiesWithinItsPoints)
{
  std::mt19937 random(3);
  double leastWeight = 1.0;
  for (int count = 2; count <= 40; ++count)
  {
    const Polyline points = randomStroke(random, count);
    const Nurbs curve(count);
    EXPECT_EQ(curve.degree(), std::min(3, count - 1));
    EXPECT_EQ(curve.at(0.0).of(points), points.front());
    EXPECT_EQ(curve.at(1.0).of(points), points.back());
    for (int i = 0; i <= 500; ++i)
    {
      // In the hull: a mean with no negative weight.
      const SplinePlace place = curve.at(i / 500.0);
      double sum = 0.0;
      for (int k = 0; k < place.count; ++k)
      {
        sum += place.weights[k];
        leastWeight = std::min(leastWeight, place.weights[k]);
      }
      ASSERT_NEAR(sum, 1.0, 1e-14);
    }
  }
  EXPECT_GE(leastWeight, 0.0);
  // 63 points on a circle, some 10 px apart.
  const Polyline circle = ring(63, 100.0);
  const Nurbs closed(63, true);
  double radius = 0.0;
  for (int i = 0; i < 63; ++i)
  {
    radius = closed.at(closed.parameterOf(i)).of(circle).norm();
    EXPECT_NEAR(radius, 99.834, 0.01);
  }
  EXPECT_LT((closed.at(0.0).of(circle) - closed.at(1.0).of(circle)).norm(), 1e-12);
  fact("B2_2",
    "curves of 2 to 40 points begin and end at the first and last to the bit, all weights at least " +
      std::to_string(leastWeight) + "; a circle's knots at " + std::to_string(radius));
}

TEST(B2_5, AClosedStrokeClosesWithAnEvenGap)
{
  // A square whose last event is 9 px from the first.
  Polyline samples;
  for (int i = 0; i <= 391; ++i)
  {
    const int side = i / 100, along = i % 100;
    samples.push_back(side == 0   ? Vector2(along, 0)
                      : side == 1 ? Vector2(100, along)
                      : side == 2 ? Vector2(100 - along, 100)
                                  : Vector2(0, 100 - along));
  }
  ASSERT_EQ((samples.back() - samples.front()).norm(), 9.0);
  const std::vector<int> kept = thinEvenly(samples, 10.0, true);
  Polyline points;
  for (const int i : kept)
  {
    points.push_back(samples[i]);
  }
  EXPECT_EQ(points.size(), 40u);
  EXPECT_EQ(points.back(), Vector2(0, 10));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_GE((points[i] - points[(i + 1) % points.size()]).norm(), 10.0);
  }
  const Nurbs curve(static_cast<int>(points.size()), true);
  EXPECT_LT((curve.at(0.0).of(points) - curve.at(1.0).of(points)).norm(), 1e-12);
  fact("B2_5",
    "a last event 9 px from the first is dropped: 40 points, every gap at least 10 px, first point = last");
}

TEST(Nurbs, SmoothEverywhere)
{
  // Twice differentiable across knots and the seam: third differences of an even walk vanish like h^2.
  std::mt19937 random(6);
  for (const bool closed : { false, true })
  {
    const Polyline points = randomStroke(random, 12);
    const Nurbs curve(12, closed);
    double worst = 0.0;
    const double h = 1e-5;
    for (int i = closed ? 0 : 40; i < 4000 - (closed ? 0 : 40); ++i)
    {
      const auto at = [&](double t) { return curve.at(t - std::floor(t)).of(points); };
      const double t = i / 4000.0;
      const Vector2 third = at(t + 2 * h) - 3.0 * at(t + h) + 3.0 * at(t) - at(t - h);
      worst = std::max(worst, third.norm() / (h * h));
    }
    // A jump of the second derivative would be of its own size, some 1e5.
    EXPECT_LT(worst, 2e3) << closed;
  }
}

TEST(Nurbs, InterpolatedPointsAreOnTheCurve)
{
  std::mt19937 random(8);
  for (const bool closed : { false, true })
  {
    for (const int count : { 3, 4, 5, 6, 7, 40, 41, 2000 })
    {
      const Polyline points = randomStroke(random, count);
      Eigen::MatrixXd values(count, 2);
      for (int i = 0; i < count; ++i)
      {
        values.row(i) = points[i];
      }
      const Nurbs curve(count, closed);
      const Eigen::MatrixXd control = curve.interpolating(values);
      Polyline fitted;
      for (int i = 0; i < count; ++i)
      {
        fitted.push_back(control.row(i));
      }
      double worst = 0.0;
      for (int i = 0; i < count; ++i)
      {
        worst = std::max(worst, (curve.at(curve.parameterOf(i)).of(fitted) - points[i]).norm());
      }
      EXPECT_LT(worst, 1e-9) << count << ' ' << closed;
    }
  }
}

TEST(Nurbs, OddDegreesAndRefusals)
{
  // Three points of a closed curve: degree 2, the same at each point.
  const Polyline triangle = ring(3, 10.0);
  const Nurbs closed(3, true);
  EXPECT_EQ(closed.degree(), 2);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_LT((closed.at(closed.parameterOf(i)).of(triangle) - 0.625 * triangle[i]).norm(), 1e-12);
  }
  EXPECT_THROW(Nurbs(1), Error);
  EXPECT_THROW(Nurbs(2, true), Error);
  const Polyline two{ { 0, 0 }, { 4, 2 } };
  EXPECT_EQ(Nurbs(2).at(0.25).of(two), Vector2(1, 0.5));
  EXPECT_EQ(Nurbs(2).at(-3.0).of(two), two.front());
  EXPECT_EQ(Nurbs(2).at(7.0).of(two), two.back());
}
