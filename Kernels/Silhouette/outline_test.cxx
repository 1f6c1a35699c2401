#include "Harness/shapes.h"
#include "Silhouette/attach.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector3 front(0, 0, 1), up(0, 1, 0);

double area(const Polyline& loop)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

std::vector<OutlineLoop> outlineOf(const Mesh& mesh, const View& view, const Polyline& stroke = {})
{
  return traceOutline(mesh, view, outlineWindow(mesh, view, stroke));
}

// A flat annulus in the plane z = 0.
Mesh annulus(double inner, double outer, int around)
{
  return gridSurface(around,
    4,
    true,
    false,
    [=](double u, double v)
    {
      const double r = inner + v * (outer - inner);
      return Vector3(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 0.0);
    });
}

} // namespace

TEST(Outline, OfATurnedRectangleHasNeitherBiasNorStairs)
{
  const View view = orthographicView(front, up, 1.0);
  for (const double degrees : { 3.0, 17.0, 45.0, 71.0 })
  {
    const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180), w = 150.3, h = 40.7;
    Mesh mesh;
    for (const Vector2& p : { Vector2(-w, -h), Vector2(w, -h), Vector2(w, h), Vector2(-w, h) })
      mesh.points.emplace_back(c * p[0] - s * p[1], s * p[0] + c * p[1], 0.3);
    mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
    const auto loops = outlineOf(mesh, view);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_TRUE(loops[0].closed);
    EXPECT_FALSE(loops[0].hole);
    double worst = 0.0;
    for (const Vector2& p : loops[0].points)
    {
      const Vector2 d = p - Vector2(400, 300);
      const double x = std::abs(c * d[0] + s * d[1]), y = std::abs(-s * d[0] + c * d[1]);
      worst = std::max(worst, std::min(std::abs(x - w), std::abs(y - h)));
    }
    EXPECT_LT(worst, 1e-9) << degrees; // every point on the true boundary
    EXPECT_NEAR(area(loops[0].points), 4 * w * h, 2.0);
    const double length = arcLengths(smoothLoop(loops[0].points, true), true).back();
    EXPECT_NEAR(length / (4 * (w + h)), 1.0, 0.012) << degrees; // corners are cut by a pixel
  }
}

TEST(Outline, OfAnAnnulusHasAHole)
{
  for (const bool perspective : { false, true })
  {
    const View view = perspective ? perspectiveView(Vector3(0, 0, 5), up, 2 * std::atan(0.3) * 180 / pi)
                                  : orthographicView(front, up, 200.0); // 200 px a unit at z = 0, both
    const auto loops = outlineOf(annulus(0.5, 1.2, 720), view);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_FALSE(loops[0].hole);
    EXPECT_TRUE(loops[1].hole);
    for (int l = 0; l < 2; ++l)
    {
      const double radius = l == 0 ? 240.0 : 100.0, sign = l == 0 ? 1.0 : -1.0;
      EXPECT_NEAR(sign * area(loops[l].points) / (pi * radius * radius), 1.0, 2e-4);
      const Polyline smooth = smoothLoop(loops[l].points, true);
      EXPECT_NEAR(arcLengths(smooth, true).back() / (2 * pi * radius), 1.0, 1e-3);
      for (const Vector2& p : smooth)
        EXPECT_NEAR((p - Vector2(400, 300)).norm(), radius, 0.02);
    }
  }
}

TEST(Outline, SmallTrianglesCoverWhatOneLargeOneCovers)
{
  // Most of the 20480 triangles cover no pixel centre; their union does.
  const View view = orthographicView(Vector3(1, 2, 3), up, 20.0);
  const auto loops = outlineOf(icosphere(5), view);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(area(loops[0].points) / (pi * 400.0), 1.0, 0.003);
}

TEST(Outline, PixelsThatTouchAtACornerAreJoined)
{
  // Two squares of one pixel each, diagonal neighbours.
  const View view = orthographicView(front, up, 1.0);
  Mesh mesh;
  for (const int k : { 0, 1 })
  {
    const int first = mesh.vertexCount();
    for (const Vector2& p : { Vector2(0, 0), Vector2(1, 0), Vector2(1, 1), Vector2(0, 1) })
      mesh.points.emplace_back(p[0] + k, p[1] + k, 0.0);
    mesh.triangles.push_back({ first, first + 1, first + 2 });
    mesh.triangles.push_back({ first, first + 2, first + 3 });
  }
  EXPECT_EQ(outlineOf(mesh, view).size(), 1u);
}

TEST(Outline, RowsAndColumnsSeeTheSame)
{
  // A wavy ring of small triangles over two others, and the same turned over the picture's diagonal.
  const View view = orthographicView(front, up, 100.0);
  Mesh mesh;
  for (const Vector3& at : { Vector3(0, 0, 0), Vector3(1.1, 0.4, -1), Vector3(0.3, -0.9, 1) })
  {
    Mesh ring = annulus(0.37, 1.0, 300);
    const int first = mesh.vertexCount();
    for (const Vector3& p : ring.points)
    {
      mesh.points.push_back((1.0 + 0.1 * std::sin(7.0 * std::atan2(p[1], p[0]))) * p + at);
    }
    for (const Triangle& t : ring.triangles)
    {
      mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  Mesh turned = mesh;
  for (Vector3& p : turned.points)
  {
    std::swap(p[0], p[1]);
  }
  const Vector2 middle = view.toDisplay(Vector3::Zero()).head<2>();
  const auto loops = outlineOf(mesh, view), others = outlineOf(turned, view);
  ASSERT_EQ(loops.size(), others.size());
  std::vector<Vector2> expected;
  for (const OutlineLoop& loop : others)
  {
    for (const Vector2& p : loop.points)
    {
      expected.push_back(Vector2(p[1] - middle[1], p[0] - middle[0]) + middle);
    }
  }
  std::size_t points = 0;
  for (const OutlineLoop& loop : loops)
  {
    points += loop.points.size();
    for (const Vector2& p : loop.points)
    {
      EXPECT_TRUE(std::any_of(
        expected.begin(), expected.end(), [&p](const Vector2& other) { return (other - p).norm() < 1e-9; }))
        << p.transpose();
    }
  }
  EXPECT_EQ(points, expected.size());
  EXPECT_GT(points, 1000u);
}

TEST(Outline, AHugePictureIsTracedRoundTheStroke)
{
  const View view = orthographicView(front, up, 50000.0);
  const Mesh mesh = annulus(0.5, 1.0, 20000);
  const Polyline stroke{ { 50400, 200 }, { 50400, 400 } };
  const PixelWindow window = outlineWindow(mesh, view, stroke);
  EXPECT_LE(window.width, 4096);
  EXPECT_LE(window.height, 4096);
  const auto loops = traceOutline(mesh, view, window);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_FALSE(loops[0].closed); // what the window cuts is no outline
  for (const Vector2& p : loops[0].points)
    EXPECT_NEAR((p - Vector2(400, 300)).norm(), 50000.0, 0.01);
  EXPECT_GT(arcLengths(loops[0].points).back(), 4000.0);
}

TEST(Outline, WhatIsBehindTheEyeHasNoPicture)
{
  const View view = perspectiveView(Vector3(0, 0, 5), up, 40.0);
  Mesh mesh = annulus(0.5, 1.0, 90);
  const std::size_t seen = mesh.points.size();
  for (std::size_t v = 0; v < seen; ++v)
    mesh.points.push_back(mesh.points[v] + Vector3(0.2, 0, 8)); // behind
  for (std::size_t t = 0, count = mesh.triangles.size(); t < count; ++t)
  {
    Triangle triangle = mesh.triangles[t];
    for (int& v : triangle)
      v += static_cast<int>(seen);
    mesh.triangles.push_back(triangle);
  }
  mesh.triangles.push_back({ 0, 1, static_cast<int>(seen) }); // through the eye's plane
  EXPECT_EQ(outlineOf(mesh, view).size(), 2u);
  for (Vector3& p : mesh.points)
    p[2] += 20.0;
  EXPECT_TRUE(outlineOf(mesh, view).empty());
}

TEST(Outline, SilhouettePointsAreAttachedInOrderAndOthersAreNot)
{
  const View view = orthographicView(front, up, 200.0);
  const auto loops = outlineOf(annulus(0.4, 1.0, 720), view);
  ASSERT_EQ(loops.size(), 2u);
  const auto ring = [](double radius, int count, double from, double to)
  {
    Polyline points;
    for (int i = 0; i < count; ++i)
    {
      const double a = from + (to - from) * i / count;
      points.emplace_back(400 + radius * std::cos(a), 300 + radius * std::sin(a));
    }
    return points;
  };
  std::vector<VisibleCurve> curves;
  curves.push_back({ ring(198.5, 100, 2 * pi, 0.0), {}, true }); // along the outer loop, the other way round
  curves.push_back({ ring(82.0, 30, 0.5, 2.5), {}, false });     // part of the hole
  curves.push_back({ ring(150.0, 50, 0.0, 2 * pi), {}, true });  // inside, 50 px away
  Polyline ray;
  for (double r = 150.0; r <= 200.0; r += 0.7)
    ray.emplace_back(400 + r * std::cos(1.0), 300 + r * std::sin(1.0));
  curves.push_back({ ray, {}, false }); // an inner contour that meets the outline at a right angle
  const auto outlines = attachSilhouette(loops, curves, 3.0, false);
  std::vector<int> attached(curves.size(), 0);
  for (std::size_t l = 0; l < outlines.size(); ++l)
  {
    double along = 0.0, last = -1.0;
    for (std::size_t i = 0; i < outlines[l].size(); ++i)
    {
      const OutlineStation& station = outlines[l][i];
      along += i > 0 ? (station.display - outlines[l][i - 1].display).norm() : 0.0;
      if (station.curve < 0)
      {
        continue;
      }
      ++attached[station.curve];
      EXPECT_EQ(station.curve, static_cast<int>(l));
      EXPECT_NEAR(
        (station.display + station.offset - curves[station.curve].display[station.point]).norm(), 0.0, 1e-9);
      EXPECT_NEAR(station.offset.norm(), l == 0 ? 1.5 : 2.0, 0.05);
      EXPECT_GT(along, last);
      last = along;
    }
  }
  EXPECT_EQ(attached, std::vector<int>({ 100, 30, 0, 0 }));
  // A point's own reach counts where it is shorter: those of the first curve lie 1.5 px off.
  curves[0].reach.assign(100, 1.4);
  curves[1].reach.assign(30, 9.0);
  std::fill(attached.begin(), attached.end(), 0);
  for (const auto& outline : attachSilhouette(loops, curves, 3.0, false))
  {
    for (const OutlineStation& station : outline)
    {
      if (station.curve >= 0)
      {
        ++attached[station.curve];
      }
    }
  }
  EXPECT_EQ(attached, std::vector<int>({ 0, 30, 0, 0 }));
}

TEST(Outline, EveryEdgeOfTheLoopIsBoundWhereItIsSeen)
{
  for (const bool perspective : { false, true })
  {
    const View view = perspective ? perspectiveView(Vector3(1, 0.6, 2.4), up, 50.0)
                                  : orthographicView(Vector3(1, 0.6, 2.4), up, 150.0);
    // A flat sheet: no silhouette at all, its border is the outline.
    const Mesh mesh = gridSurface(
      12, 7, false, false, [](double u, double v) { return Vector3(2 * u - 1, v - 0.5, 0.3 * u); });
    const auto loops = outlineOf(mesh, view);
    ASSERT_EQ(loops.size(), 1u);
    const Adjacency adjacency = buildAdjacency(mesh);
    for (std::size_t i = 0; i < loops[0].points.size(); ++i)
    {
      const Binding& edge = loops[0].edges[i];
      ASSERT_GE(edge.vertices[0], 0);
      EXPECT_EQ(adjacency.edges[adjacency.findEdge(edge.vertices[0], edge.vertices[1])].triangleCount, 1);
      // The bound place on the mesh is seen where the loop point is, also in perspective.
      EXPECT_NEAR((view.toDisplay(edge.of(mesh.points)).head<2>() - loops[0].points[i]).norm(), 0.0, 1e-9);
    }
    const auto stations = attachSilhouette(loops, {}, 3.0, true);
    std::size_t bound = 0;
    for (const OutlineStation& station : stations[0])
    {
      bound += station.bound();
      if (station.bound())
      {
        EXPECT_NEAR(
          (view.toDisplay(station.edge.of(mesh.points)).head<2>() - station.display - station.offset).norm(),
          0.0,
          1e-9);
      }
    }
    EXPECT_NEAR(
      static_cast<double>(bound), 38.0, 1.0); // 2 * (12 + 7) border edges; the loop's start may halve one
    EXPECT_EQ(stations[0].size(), loops[0].points.size());
    const auto loose = attachSilhouette(loops, {}, 3.0, false);
    for (const OutlineStation& station : loose[0])
      EXPECT_FALSE(station.bound());
  }
}
