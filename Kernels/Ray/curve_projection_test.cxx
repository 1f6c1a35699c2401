// Facts of editors.md, section 13, curves: projecting.
#include "Ray/curve_projection.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Stroke/fit.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::vector<Vector2> pictureLine(const Vector2& a, const Vector2& b, double step = 0.5)
{
  const int steps = static_cast<int>((b - a).norm() / step);
  std::vector<Vector2> places;
  for (int i = 0; i <= steps; ++i)
  {
    places.emplace_back(a + (b - a) * i / steps);
  }
  return places;
}

std::vector<Vector2> pictureCircle(const Vector2& centre, double radius)
{
  const int count = static_cast<int>(4.0 * pi * radius);
  std::vector<Vector2> places;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * i / count;
    places.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

SurfaceRays surfaceFrom(Mesh mesh)
{
  return SurfaceRays(std::make_shared<const Mesh>(std::move(mesh)));
}

// Largest over smallest gap, less one.
double unevenness(const SurfaceCurve& run)
{
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  const std::size_t count = run.samples.size();
  for (std::size_t i = 1; i < count + run.closed; ++i)
  {
    const double gap = (run.samples[i % count].position - run.samples[i - 1].position).norm();
    least = std::min(least, gap);
    largest = std::max(largest, gap);
  }
  return largest / least - 1.0;
}

Mesh plateAt(double x0, double x1, double height)
{
  return gridSurface(
    8, 8, false, false, [=](double u, double v) { return Vector3(x0 + u * (x1 - x0), 2 * v - 1, height); });
}

std::string textOf(double x)
{
  std::ostringstream stream;
  stream << x;
  return stream.str();
}

} // namespace

TEST(B2_3, GapsOfARunAreEven)
{
  double worst = 0.0;
  // A plate in perspective, where even steps in the picture are not even on it, and a fine sphere.
  const Eigen::AngleAxisd turn(1.1, Vector3::UnitX());
  const SurfaceRays tilted = surfaceFrom(gridSurface(9,
    9,
    false,
    false,
    [&](double u, double v) { return Vector3(turn * Vector3(2 * u - 1, 2 * v - 1, 0)); }));
  const View near = perspectiveView({ 0.2, 0.1, 4 }, { 0, 1, 0 }, 30.0);
  const SurfaceRays sphere = surfaceFrom(icosphere(6));
  const View above = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 250.0);
  const struct
  {
    const SurfaceRays& surface;
    const View& view;
    std::vector<Vector2> picture;
    bool closed;
  } curves[] = { { tilted, near, pictureLine({ 330, 250 }, { 420, 340 }), false },
    { sphere, above, pictureLine({ 200, 260 }, { 560, 400 }), false },
    { sphere, above, pictureCircle({ 430, 320 }, 120), true } };
  for (const auto& curve : curves)
  {
    const std::vector<SurfaceCurve> runs =
      projectCurve(curve.surface, curve.view, curve.picture, curve.closed);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].closed, curve.closed);
    worst = std::max(worst, unevenness(runs[0]));
    for (std::size_t i = 1; i < runs[0].samples.size(); ++i)
    {
      EXPECT_GT(runs[0].samples[i].along, runs[0].samples[i - 1].along);
      EXPECT_EQ(runs[0].samples[i].position, positionOf(curve.surface.mesh(), runs[0].samples[i].at));
    }
  }
  EXPECT_LT(worst, 1e-3);
  // As published they are even in the picture.
  CurveRules published;
  published.spacing = 4.0;
  const std::vector<SurfaceCurve> plain = projectCurve(sphere, above, curves[1].picture, false, published);
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(plain[0].samples.size(),
    static_cast<std::size_t>(std::lround((Vector2(560, 400) - Vector2(200, 260)).norm() / 4.0)) + 1);
  for (std::size_t i = 1; i < plain[0].samples.size(); ++i)
  {
    const auto picture = [&](std::size_t k) { return above.toDisplay(plain[0].samples[k].position); };
    EXPECT_NEAR((picture(i) - picture(i - 1)).head<2>().norm(), 4.0, 0.05);
  }
  EXPECT_GT(unevenness(plain[0]), 0.5);
  fact("B2_3",
    "gaps of runs on a plate in perspective and on a sphere are equal within " + textOf(worst) +
      "; as published one is " + textOf(1.0 + unevenness(plain[0])) + " times another");
}

TEST(CurveProjection, ARunEndsWhereTheSurfaceLeapsOrEnds)
{
  // A plate one unit above another: two runs, which end at the rim and behind it.
  const SurfaceRays two = surfaceFrom(joined(plateAt(-1, 1, 0), plateAt(-1, 0, 1), Vector3::Zero()));
  for (const View& view : { orthographicView({ 0.3, 0, 1 }, { 0, 1, 0 }, 200.0),
         perspectiveView({ 0.7, 0.2, 5 }, { 0, 1, 0 }, 30.0) })
  {
    const Vector2 a = view.toDisplay({ -0.6, -0.1, 1 }).head<2>(),
                  b = view.toDisplay({ 0.9, 0.1, 0 }).head<2>();
    const std::vector<SurfaceCurve> runs = projectCurve(two, view, pictureLine(a, b), false);
    ASSERT_EQ(runs.size(), 2u);
    for (const SurfaceSample& sample : runs[0].samples)
    {
      EXPECT_NEAR(sample.position[2], 1.0, 1e-12);
    }
    for (const SurfaceSample& sample : runs[1].samples)
    {
      EXPECT_NEAR(sample.position[2], 0.0, 1e-12);
    }
    // Half a pixel halved twelve times.
    EXPECT_NEAR(runs[0].samples.back().position[0], 0.0, 1e-5);
    EXPECT_NEAR(
      (view.toDisplay(runs[0].samples.back().position) - view.toDisplay(runs[1].samples.front().position))
        .head<2>()
        .norm(),
      0.0,
      1e-3);
  }
  // A wall seen nearly edge-on is steep, but no leap: nothing is cut.
  const double steep = 0.005;
  const SurfaceRays ramp = surfaceFrom(gridSurface(12,
    4,
    false,
    false,
    [=](double u, double v)
    {
      const double x = std::clamp(3.0 * u - 1.0, 0.0, 1.0);
      return Vector3(u < 1.0 / 3 ? 3 * u - 1 : x < 1.0 ? steep * x : steep + 3 * u - 2, 2 * v - 1, -x);
    }));
  const View above = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  const std::vector<SurfaceCurve> whole =
    projectCurve(ramp, above, pictureLine({ 300.2, 310 }, { 500.1, 290 }), false);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_LT(unevenness(whole[0]), 0.5);
  // Beside the model, and half beside it.
  EXPECT_TRUE(projectCurve(two, above, pictureLine({ 5, 5 }, { 90, 5 }), false).empty());
  const std::vector<SurfaceCurve> half =
    projectCurve(two, above, pictureLine({ 300, 300 }, { 780, 300 }), false);
  ASSERT_EQ(half.size(), 2u);
  EXPECT_NEAR(half[1].samples.back().position[0], 1.0, 1e-5);
}

TEST(CurveProjection, ARingThatIsCutGoesOnThroughItsStart)
{
  const SurfaceRays part = surfaceFrom(plateAt(-0.2, 1, 0));
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  const std::vector<Vector2> ring = pictureCircle({ 400, 300 }, 100);
  const std::vector<SurfaceCurve> runs = projectCurve(part, view, ring, true);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_FALSE(runs[0].closed);
  EXPECT_GT(runs[0].samples.back().along, static_cast<double>(ring.size()));
  for (const SurfaceSample* end : { &runs[0].samples.front(), &runs[0].samples.back() })
  {
    EXPECT_NEAR(end->position[0], -0.2, 1e-5);
  }
  CurveRules published;
  published.spacing = 4.0;
  const std::vector<SurfaceCurve> plain = projectCurve(part, view, ring, true, published);
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_GT(plain[0].samples.back().along, static_cast<double>(ring.size()));
  const std::vector<SurfaceCurve> whole =
    projectCurve(surfaceFrom(plateAt(-1, 1, 0)), view, ring, true, published);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_TRUE(whole[0].closed);
  EXPECT_EQ(whole[0].samples.size(), static_cast<std::size_t>(std::lround(2 * pi * 100 / 4.0)));
}

TEST(CurveProjection, HostileCurvesAndThreads)
{
  const SurfaceRays sphere = surfaceFrom(icosphere(3));
  const View view = perspectiveView({ 0, 0, 4 }, { 0, 1, 0 }, 40.0);
  EXPECT_TRUE(projectCurve(sphere, view, {}, false).empty());
  EXPECT_TRUE(projectCurve(sphere, view, { { 400, 300 } }, true).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(projectCurve(sphere, view, { { nan, 300 }, { 400, nan } }, false).empty());
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(projectCurve(sphere, view, pictureCircle({ 400, 300 }, 60), true, {}, cancelled), Error);
  const std::vector<Vector2> ring = pictureCircle({ 500, 300 }, 150);
  const std::vector<SurfaceCurve> one = projectCurve(sphere, view, ring, true);
  const std::vector<SurfaceCurve> both = projectCurve(sphere, view, ring, true, {}, twoThreads());
  ASSERT_EQ(one.size(), both.size());
  ASSERT_FALSE(one.empty());
  for (std::size_t r = 0; r < one.size(); ++r)
  {
    ASSERT_EQ(one[r].samples.size(), both[r].samples.size());
    for (std::size_t i = 0; i < one[r].samples.size(); ++i)
    {
      EXPECT_EQ(one[r].samples[i].position, both[r].samples[i].position);
    }
  }
}
