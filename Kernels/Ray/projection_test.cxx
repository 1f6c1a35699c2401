#include "Harness/shapes.h"
#include "Ray/projection.h"

#include <gtest/gtest.h>

#include <sstream>
#include <thread>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

SurfaceRays surfaceOf(Mesh mesh)
{
  return SurfaceRays(std::make_shared<const Mesh>(std::move(mesh)));
}

// n x n quads on [-1, 1] x [-1, 1], moved and turned out of the axes.
Mesh tiltedPlate(int n, double scale, const Vector3& shift)
{
  const Eigen::AngleAxisd turn(0.4, Vector3(1, 2, 0.5).normalized());
  return gridSurface(n,
    n,
    false,
    false,
    [&](double u, double v) { return Vector3(shift + scale * (turn * Vector3(2 * u - 1, 2 * v - 1, 0))); });
}

// The plate z = `height` over [x0, x1] x [-1, 1].
Mesh plate(double x0, double x1, double height)
{
  return gridSurface(
    4, 4, false, false, [=](double u, double v) { return Vector3(x0 + u * (x1 - x0), 2 * v - 1, height); });
}

double longestStep(const std::vector<SurfaceCurve>& curves)
{
  double longest = 0.0;
  for (const SurfaceCurve& curve : curves)
    for (std::size_t i = 1; i < curve.samples.size(); ++i)
      longest = std::max(longest, (curve.samples[i].position - curve.samples[i - 1].position).norm());
  return longest;
}

std::vector<Vector2> line(const Vector2& a, const Vector2& b, int count)
{
  std::vector<Vector2> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    samples.emplace_back(a + (b - a) * i / (count - 1));
  return samples;
}

std::string figureOf(double x)
{
  std::ostringstream stream;
  stream << x;
  return stream.str();
}

// The view of `view` for a scene that is scaled, then shifted.
View follow(const View& view, double scale, const Vector3& shift)
{
  Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
  back.topLeftCorner<3, 3>() /= scale;
  back.topRightCorner<3, 1>() = -shift / scale;
  return View(view.viewTransform() * back, view.projectionTransform(), view.width(), view.height());
}

} // namespace

TEST(D3_3, KnownPointsOfAPlaneComeBack)
{
  const struct
  {
    double scale;
    Vector3 shift;
  } places[] = { { 1.0, Vector3::Zero() },
    { 1e-7, Vector3::Zero() },
    { 1e6, Vector3::Zero() },
    { 1.0, Vector3(500, -300, 100) } };
  double worst = 0.0;
  for (const auto& place : places)
  {
    const Mesh mesh = tiltedPlate(7, place.scale, place.shift);
    const SurfaceRays surface = surfaceOf(mesh);
    for (const View& home : { perspectiveView({ 0.5, -1, 4 }, { 0, 1, 0 }, 40.0),
           orthographicView({ 0.5, -1, 4 }, { 0.2, 1, 0 }, 180.0) })
    {
      const View view = follow(home, place.scale, place.shift);
      std::vector<Vector2> stroke;
      std::vector<Vector3> known;
      for (int i = 0; i < 300; ++i)
      {
        const SurfacePoint at{ (37 * i) % mesh.triangleCount(),
          { 0.2 + 0.5 * std::abs(std::sin(i)), 0.1, 0.7 - 0.5 * std::abs(std::sin(i)) } };
        known.push_back(positionOf(mesh, at));
        stroke.emplace_back(view.toDisplay(known.back()).head<2>());
      }
      const std::vector<SurfaceCurve> curves = projectStroke(surface, view, stroke, false, 0.0);
      ASSERT_EQ(curves.size(), 1u);
      ASSERT_EQ(curves[0].samples.size(), known.size());
      for (std::size_t i = 0; i < known.size(); ++i)
      {
        const SurfaceSample& sample = curves[0].samples[i];
        worst = std::max(worst, (sample.position - known[i]).norm() / surface.diagonal());
        EXPECT_EQ(sample.position, positionOf(mesh, sample.at));
        EXPECT_EQ(sample.along, static_cast<double>(i));
      }
    }
  }
  EXPECT_LT(worst, 1e-9);

  // A hole, one quad of a plate that is missing, cuts the curve in two that end at its rim.
  Mesh holed =
    gridSurface(5, 5, false, false, [](double u, double v) { return Vector3(2 * u - 1, 2 * v - 1, 0); });
  holed.triangles.erase(holed.triangles.begin() + 24, holed.triangles.begin() + 26);
  const View above = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  const std::vector<Vector2> across = line({ 253, 310 }, { 547, 290 }, 31);
  const SurfaceRays plateWithHole = surfaceOf(holed);
  EXPECT_EQ(projectStroke(plateWithHole, above, across, false, 0.0).size(), 2u);
  const std::vector<SurfaceCurve> pieces = projectStroke(plateWithHole, above, across, false, 1e-3);
  ASSERT_EQ(pieces.size(), 2u);
  const double rim = std::max(std::abs(pieces[0].samples.back().position[0] + 0.2),
    std::abs(pieces[1].samples.front().position[0] - 0.2));
  EXPECT_LT(rim * 200.0, 10.0 / 512.0); // a pair of samples, some 10 px, halved nine times
  fact("D3_3",
    "plane points project and come back to " + figureOf(worst) +
      " of the scene, both cameras, tiny, huge and shifted; a hole cuts the curve in two, " +
      figureOf(rim * 200.0) + " px from its rim");
}

TEST(D3_4, AStrokeOverARimIsCutAndDoesNotLeap)
{
  // One plate one unit above the other, and steps of three.
  const SurfaceRays two = surfaceOf(joined(plate(-1, 1, 0), plate(-1, 0, 1), Vector3::Zero()));
  Mesh stairs = joined(plate(-1, 1, 0), plate(-1, 0.01, 0.5), Vector3::Zero());
  stairs = joined(stairs, plate(-1, 0, 1), Vector3::Zero());
  const SurfaceRays three = surfaceOf(stairs);
  const double r = 0.03 * two.diagonal();
  const View views[] = { orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0),
    perspectiveView({ 0.7, 0.2, 5 }, { 0, 1, 0 }, 30.0) };
  double longest = 0.0, published = 0.0;
  for (const View& view : views)
  {
    const std::vector<Vector2> stroke =
      line(view.toDisplay({ -0.8, -0.1, 1 }).head<2>(), view.toDisplay({ 0.8, 0.15, 0 }).head<2>(), 80);
    const std::vector<SurfaceCurve> curves = projectStroke(two, view, stroke, false, 6e-4 * two.diagonal());
    ASSERT_EQ(curves.size(), 2u);
    longest = std::max(longest, longestStep(curves));
    for (const SurfaceSample& sample : curves[0].samples)
      EXPECT_NEAR(sample.position[2], 1.0, 1e-12);
    for (const SurfaceSample& sample : curves[1].samples)
      EXPECT_NEAR(sample.position[2], 0.0, 1e-12);
    // As published: one curve that steps down through the air.
    const std::vector<SurfaceCurve> plain = projectStroke(two, view, stroke, false, 0.0);
    ASSERT_EQ(plain.size(), 1u);
    published = longestStep(plain);
    EXPECT_GT(published, 1.0);
    EXPECT_EQ(plain[0].samples.size(), stroke.size());
    // The middle of the long step is on the middle plate, exactly half-way: not believed.
    const std::vector<Vector2> pair =
      line(view.toDisplay({ -0.06, 0, 1 }).head<2>(), view.toDisplay({ 0.07, 0, 0 }).head<2>(), 2);
    EXPECT_LT(longestStep(projectStroke(three, view, pair, false, 6e-4 * three.diagonal())), r);
  }
  EXPECT_LT(longest, r);
  fact("D3_4",
    "a rim one unit above a plate: two curves, longest segment " + figureOf(longest / r) +
      " r; as published one, with a segment of " + figureOf(published));
}

TEST(Projection, ACurvedSurfaceIsFollowedWithinTheTolerance)
{
  const SurfaceRays sphere = surfaceOf(icosphere(5));
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 250.0);
  const std::vector<Vector2> sparse = line({ 160, 300 }, { 640, 310 }, 3);
  const double tolerance = 1e-3;
  const std::vector<SurfaceCurve> curves = projectStroke(sphere, view, sparse, false, tolerance);
  ASSERT_EQ(curves.size(), 1u);
  const std::vector<SurfaceSample>& samples = curves[0].samples;
  EXPECT_GT(samples.size(), 40u);
  EXPECT_LT(samples.size(), 300u);
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    EXPECT_GT(samples[i].along, samples[i - 1].along);
    const Vector3 middle = 0.5 * (samples[i].position + samples[i - 1].position);
    EXPECT_NEAR(middle.norm(), 1.0, 3 * tolerance);
  }
}

TEST(Projection, AClosedStrokeIsARingAndWhatIsCutJoinsAtItsStart)
{
  const SurfaceRays wide = surfaceOf(plate(-1, 1, 0));
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  std::vector<Vector2> ring;
  ring.reserve(60);
  for (int i = 0; i < 60; ++i)
    ring.emplace_back(400 + 100 * std::cos(2 * pi * i / 60), 300 + 100 * std::sin(2 * pi * i / 60));
  const std::vector<SurfaceCurve> whole = projectStroke(wide, view, ring, true, 1e-2);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_TRUE(whole[0].closed);
  EXPECT_EQ(whole[0].samples.size(), 60u);
  EXPECT_NE(whole[0].samples.front().position, whole[0].samples.back().position);
  // The left third of the plate is missing: one open piece that runs through the ring's first sample.
  const SurfaceRays part = surfaceOf(plate(-0.2, 1, 0));
  const std::vector<SurfaceCurve> pieces = projectStroke(part, view, ring, true, 1e-3);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_FALSE(pieces[0].closed);
  const std::vector<SurfaceSample>& samples = pieces[0].samples;
  EXPECT_LT(samples.front().position[1], 0.0);
  EXPECT_GT(samples.back().position[1], 0.0);
  EXPECT_GT(samples.back().along, 60.0);
  for (std::size_t i = 1; i < samples.size(); ++i)
    EXPECT_LT((samples[i].position - samples[i - 1].position).norm(), 0.1);
}

TEST(Projection, OffTheModelPointsAndWhatIsBehindTheEye)
{
  const SurfaceRays sphere = surfaceOf(icosphere(3));
  const View view = perspectiveView({ 0, 0, 4 }, { 0, 1, 0 }, 40.0);
  EXPECT_TRUE(projectStroke(sphere, view, {}, false, 1e-3).empty());
  EXPECT_TRUE(projectStroke(sphere, view, { { 400, 300 } }, false, 1e-3).empty());
  EXPECT_TRUE(projectStroke(sphere, view, { { 400, 300 }, { 400, 300 } }, false, 1e-3).empty());
  EXPECT_TRUE(projectStroke(sphere, view, line({ 0, 0 }, { 700, 5 }, 50), false, 1e-3).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(projectStroke(sphere, view, { { 400, nan }, { nan, 300 } }, false, 1e-3).empty());
  // From inside, what is seen is the far wall, before the eye.
  const std::vector<SurfaceCurve> inside = projectStroke(sphere,
    perspectiveView({ 0, 0, 0.5 }, { 0, 1, 0 }, 40.0),
    line({ 300, 300 }, { 500, 320 }, 20),
    false,
    1e-3);
  ASSERT_EQ(inside.size(), 1u);
  for (const SurfaceSample& sample : inside[0].samples)
    EXPECT_LT(sample.position[2], 0.0);
}

TEST(Projection, ThreadsDoNotMatter)
{
  const SurfaceRays surface = surfaceOf(torus(1.0, 0.4, 80, 40));
  const View view = perspectiveView({ 2, -3, 4 }, { 0, 1, 0 }, 40.0);
  std::vector<Vector2> scribble;
  scribble.reserve(3000);
  for (int i = 0; i < 3000; ++i)
    scribble.emplace_back(400 + 200 * std::sin(0.37 * i), 300 + 200 * std::cos(0.23 * i));
  Context two;
  two.parallelFor = [](int count, const Context::Body& body)
  {
    std::thread other([&] { body(0, count / 2); });
    body(count / 2, count);
    other.join();
  };
  const std::vector<SurfaceCurve> a = projectStroke(surface, view, scribble, false, 1e-3);
  const std::vector<SurfaceCurve> b = projectStroke(surface, view, scribble, false, 1e-3, two);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_GT(a.size(), 10u);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_EQ(a[i].samples.size(), b[i].samples.size());
    for (std::size_t k = 0; k < a[i].samples.size(); ++k)
    {
      EXPECT_EQ(a[i].samples[k].position, b[i].samples[k].position);
      EXPECT_EQ(a[i].samples[k].at.triangle, b[i].samples[k].at.triangle);
    }
  }
  Context stopped;
  stopped.cancelled = [] { return true; };
  EXPECT_THROW(projectStroke(surface, view, scribble, false, 1e-3, stopped), Error);
}
