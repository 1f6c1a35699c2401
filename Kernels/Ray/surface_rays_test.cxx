#include "Harness/shapes.h"
#include "Mesh/nearest.h"
#include "Ray/surface_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

SurfaceRays raysOf(Mesh mesh)
{
  return SurfaceRays(std::make_shared<const Mesh>(std::move(mesh)));
}

// Where the line meets a triangle, by Cramer's rule: along, or infinity.
double cramer(const Mesh& mesh, int triangle, const Ray& ray)
{
  const Triangle& t = mesh.triangles[triangle];
  Eigen::Matrix3d m;
  m.col(0) = mesh.points[t[1]] - mesh.points[t[0]];
  m.col(1) = mesh.points[t[2]] - mesh.points[t[0]];
  m.col(2) = -ray.direction;
  if (std::abs(m.determinant()) < 1e-14)
    return std::numeric_limits<double>::infinity();
  const Vector3 x = m.inverse() * (ray.origin - mesh.points[t[0]]);
  return x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 ? x[2] : std::numeric_limits<double>::infinity();
}

Mesh scrambled(int triangles, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mesh soup;
  for (int i = 0; i < triangles; ++i)
  {
    const Vector3 middle(uniform(random), uniform(random), uniform(random));
    for (int k = 0; k < 3; ++k)
      soup.points.push_back(middle + 0.3 * Vector3(uniform(random), uniform(random), uniform(random)));
    soup.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return soup;
}

Mesh moved(Mesh mesh, double scale, const Vector3& shift)
{
  for (Vector3& p : mesh.points)
    p = scale * p + shift;
  return mesh;
}

void expectSame(const SurfaceHit& a, const SurfaceHit& b)
{
  EXPECT_EQ(a.at.triangle, b.at.triangle);
  EXPECT_EQ(a.at.weights, b.at.weights);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.distance, b.distance);
}

} // namespace

TEST(SurfaceRays, FindsWhatTryingEveryTriangleFinds)
{
  const Mesh soup = scrambled(400, 3);
  const SurfaceRays surface = raysOf(soup);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  int met = 0, crossings = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Ray ray{ { uniform(random), uniform(random), uniform(random) },
      Vector3(uniform(random), uniform(random), uniform(random)) };
    std::vector<std::pair<double, int>> expected;
    double first = std::numeric_limits<double>::infinity();
    for (int t = 0; t < soup.triangleCount(); ++t)
    {
      const double along = cramer(soup, t, ray) * ray.direction.norm();
      if (std::isfinite(along))
      {
        expected.emplace_back(along, t);
        first = along >= 0 ? std::min(first, along) : first;
      }
    }
    std::sort(expected.begin(), expected.end());
    const SurfaceHit nearest = surface.nearest(ray);
    ASSERT_EQ(nearest.found(), std::isfinite(first)) << i;
    if (nearest.found())
    {
      EXPECT_NEAR(nearest.distance, first, 1e-12);
      EXPECT_NEAR((nearest.position - ray.origin - first * ray.direction.normalized()).norm(), 0, 1e-12);
      ++met;
    }
    const std::vector<SurfaceHit> all = surface.all(ray);
    ASSERT_EQ(all.size(), expected.size()) << i;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      EXPECT_EQ(all[k].at.triangle, expected[k].second);
      EXPECT_NEAR(all[k].distance, expected[k].first, 1e-12);
    }
    crossings += static_cast<int>(all.size());

    const Vector3 point = 2.0 * ray.origin;
    double squared = std::numeric_limits<double>::infinity();
    for (const Triangle& t : soup.triangles)
      squared =
        std::min(squared, squaredDistance(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]], point));
    EXPECT_NEAR(surface.closest(point).distance, std::sqrt(squared), 1e-12);
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(crossings, 2000);
}

TEST(SurfaceRays, NothingSlipsThroughAnEdgeAndTheLowestIdCounts)
{
  // Rays through every corner and every middle of an edge of a closed body enter and leave it.
  const Mesh sphere = icosphere(3);
  const SurfaceRays surface = raysOf(sphere);
  const Adjacency adjacency = buildAdjacency(sphere);
  std::vector<Vector3> places = sphere.points;
  for (const MeshEdge& edge : adjacency.edges)
    places.emplace_back(0.5 * (sphere.points[edge.v0] + sphere.points[edge.v1]));
  for (const Vector3& p : places)
  {
    const SurfaceHit hit = surface.nearest({ 3.0 * p, -p });
    ASSERT_TRUE(hit.found());
    EXPECT_NEAR((hit.position - p).norm(), 0, 1e-12);
    EXPECT_NEAR(hit.distance, 2.0 * p.norm(), 1e-12);
    EXPECT_NEAR((surface.closest(p).position - p).norm(), 0, 1e-15);
    EXPECT_GE(surface.all({ Vector3::Zero(), p }).size(), 2u);
  }
  // Three facets in one place, in any order.
  Mesh same{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 1, 2, 0 }, { 0, 1, 2 }, { 0, 2, 1 } } };
  const SurfaceRays stack = raysOf(same);
  const Ray down{ { 0.2, 0.3, 5 }, { 0, 0, -1 } };
  EXPECT_EQ(stack.nearest(down).at.triangle, 0);
  EXPECT_EQ(stack.all(down).size(), 3u);
  EXPECT_EQ(stack.closest({ 0.2, 0.3, 0.1 }).at.triangle, 0);
}

TEST(SurfaceRays, FacetsAreMetFromEitherSideAndBehindTheOriginNot)
{
  const SurfaceRays plate = raysOf({ { { -9, -9, 2 }, { 9, -9, 2 }, { 0, 9, 2 } }, { { 0, 1, 2 } } });
  EXPECT_NEAR(plate.nearest({ { 0, 0, 5 }, { 0, 0, -1 } }).distance, 3.0, 1e-14);
  EXPECT_NEAR(plate.nearest({ { 0, 0, 0 }, { 0, 0, 7 } }).distance, 2.0, 1e-14);
  EXPECT_FALSE(plate.nearest({ { 0, 0, 5 }, { 0, 0, 1 } }).found());
  EXPECT_NEAR(plate.all({ { 0, 0, 5 }, { 0, 0, 1 } }).front().distance, -3.0, 1e-14);
  EXPECT_FALSE(plate.nearest({ { 0, 0, 2.5 }, { 1, 0, 0 } }).found()); // along it
  EXPECT_FALSE(plate.nearest({ { 0, 50, 5 }, { 0, 0, -1 } }).found());
}

TEST(SurfaceRays, FarAwayTinyAndHugeModelsAreTheSameModel)
{
  const Mesh home = torus(1.0, 0.4, 60, 30);
  const SurfaceRays here = raysOf(home);
  const struct
  {
    double scale;
    Vector3 shift;
    double tolerance;
  } places[] = { { 1e-7, Vector3::Zero(), 1e-13 },
    { 1e9, Vector3::Zero(), 1e-13 },
    { 1e-150, Vector3::Zero(), 1e-13 },
    { 1.0, Vector3(5e6, -3e6, 1e6), 1e-8 } };
  for (const auto& place : places)
  {
    const SurfaceRays there = raysOf(moved(home, place.scale, place.shift));
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 from(1.3 * std::cos(i), 1.3 * std::sin(i), 1e3); // an eye 300 diagonals away
      const Vector3 at(1.01 * std::cos(1.1 * i), 1.01 * std::sin(1.1 * i), 0.2);
      const SurfaceHit a = here.nearest({ from, at - from });
      const SurfaceHit b = there.nearest({ place.scale * from + place.shift, place.scale * (at - from) });
      ASSERT_TRUE(a.found() && b.found());
      EXPECT_NEAR(((b.position - place.shift) / place.scale - a.position).norm(), 0, place.tolerance);
      EXPECT_NEAR(b.distance / place.scale / a.distance, 1.0, place.tolerance);
      const SurfaceHit c = here.closest(at), d = there.closest(place.scale * at + place.shift);
      EXPECT_NEAR(((d.position - place.shift) / place.scale - c.position).norm(), 0, place.tolerance);
    }
  }
}

TEST(SurfaceRays, WhatIsNotFiniteOrNotThereIsNotFound)
{
  const SurfaceRays sphere = raysOf(icosphere(2));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(sphere.nearest({ { 0, 0, 3 }, { 0, 0, 0 } }).found());
  EXPECT_FALSE(sphere.nearest({ { nan, 0, 3 }, { 0, 0, -1 } }).found());
  EXPECT_FALSE(sphere.nearest({ { 0, 0, 3 }, { 0, inf, -1 } }).found());
  EXPECT_FALSE(sphere.nearest({ { 0, 0, inf }, { 0, 0, -1 } }).found());
  EXPECT_TRUE(sphere.all({ { 0, nan, 3 }, { 0, 0, -1 } }).empty());
  EXPECT_FALSE(sphere.closest({ 0, nan, 0 }).found());
  EXPECT_FALSE(sphere.closest({ 0, inf, 0 }).found());
  EXPECT_NEAR(sphere.closest({ 0, 0, 1e20 }).distance / 1e20, 1.0, 1e-6);
  EXPECT_TRUE(sphere.nearest({ { 0, 0, 1e-200 }, { 0, 0, -1e-200 } }).found());
  const SurfaceRays nothing = raysOf({});
  EXPECT_FALSE(nothing.nearest({ { 0, 0, 3 }, { 0, 0, -1 } }).found());
  EXPECT_FALSE(nothing.closest({ 0, 0, 3 }).found());
  // Degenerate facets and one that is not finite beside a good one.
  const SurfaceRays dirty = raysOf({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 0, 0, nan } },
    { { 0, 0, 0 }, { 0, 1, 3 }, { 0, 1, 4 }, { 0, 1, 2 } } });
  EXPECT_EQ(dirty.nearest({ { 0.25, 0.25, 1 }, { 0, 0, -1 } }).at.triangle, 3);
  EXPECT_FALSE(dirty.nearest({ { 1.5, 0, 1 }, { 0, 0, -1 } }).found());
  EXPECT_NEAR((dirty.closest({ 2, 0, 1 }).position - Vector3(2, 0, 0)).norm(), 0, 0);
}

TEST(SurfaceRays, ThreadsFindTheSameAndACancelledBuildSaysSo)
{
  const SurfaceRays surface = raysOf(scrambled(2000, 5));
  const auto hits = [&surface](std::vector<SurfaceHit>& found)
  {
    for (int i = 0; i < 500; ++i)
    {
      const Ray ray{ { std::sin(i), std::cos(i), 3 }, { -0.2 * std::sin(3 * i), 0.1, -1 } };
      found.push_back(surface.nearest(ray));
      found.push_back(surface.closest(ray.origin));
    }
  };
  std::vector<SurfaceHit> alone, first, second;
  hits(alone);
  std::thread a(hits, std::ref(first)), b(hits, std::ref(second));
  a.join();
  b.join();
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    expectSame(alone[i], first[i]);
    expectSame(alone[i], second[i]);
  }
  Context stopped;
  stopped.cancelled = [] { return true; };
  try
  {
    const SurfaceRays never(std::make_shared<const Mesh>(scrambled(50000, 5)), stopped);
    ADD_FAILURE() << "not cancelled";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::Cancelled);
  }
}

namespace
{

// Some triangles are gone, some are split in three, one of which stays in its place, and a vertex has moved;
// vertices are numbered backwards.
Mesh changedHereAndThere(const Mesh& mesh)
{
  Mesh changed;
  std::vector<Triangle> added;
  changed.points.assign(mesh.points.rbegin(), mesh.points.rend());
  const int last = mesh.vertexCount() - 1;
  changed.points[last - mesh.triangles[500][0]] *= 1.001;
  for (int i = 0; i < mesh.triangleCount(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    const Triangle now{ last - t[0], last - t[1], last - t[2] };
    if (i % 97 == 0)
    {
      continue;
    }
    if (i % 151 != 0)
    {
      changed.triangles.push_back(now);
      continue;
    }
    const int middle = changed.vertexCount();
    changed.points.emplace_back(
      (changed.points[now[0]] + changed.points[now[1]] + changed.points[now[2]]) / 3.0);
    changed.triangles.push_back({ now[0], now[1], middle });
    added.push_back({ now[1], now[2], middle });
    added.push_back({ now[2], now[0], middle });
  }
  changed.triangles.insert(changed.triangles.end(), added.begin(), added.end());
  return changed;
}

void expectSameAnswers(const SurfaceRays& one, const SurfaceRays& other)
{
  EXPECT_EQ(one.diagonal(), other.diagonal());
  EXPECT_EQ(one.centre(), other.centre());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  std::uniform_int_distribution<int> vertex(0, one.mesh().vertexCount() - 1);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 place(uniform(random), uniform(random), uniform(random));
    const Vector3& corner = one.mesh().points[vertex(random)]; // where several are equally near
    const Ray ray{ place, (i % 2 ? corner : Vector3::Zero()) - place };
    expectSame(one.nearest(ray), other.nearest(ray));
    expectSame(one.closest(i % 2 ? 1.5 * corner : place), other.closest(i % 2 ? 1.5 * corner : place));
    const std::vector<SurfaceHit> all = one.all(ray), others = other.all(ray);
    ASSERT_EQ(all.size(), others.size());
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      expectSame(all[k], others[k]);
    }
  }
}

} // namespace

TEST(SurfaceRays, AfterAChangeTheyAreThoseMadeAnew)
{
  const auto before = std::make_shared<const Mesh>(icosphere(4));
  const auto now = std::make_shared<const Mesh>(changedHereAndThere(*before));
  const auto again = std::make_shared<const Mesh>(changedHereAndThere(*now));
  auto first = std::make_unique<const SurfaceRays>(before);
  const auto second = SurfaceRays::after(*first, now);
  ASSERT_TRUE(second);
  expectSameAnswers(*second, SurfaceRays(now));
  // Of rays that are themselves after others, which are gone by then, and back.
  const auto third = SurfaceRays::after(*second, again);
  ASSERT_TRUE(third);
  first = nullptr;
  expectSameAnswers(*third, SurfaceRays(again));
  const auto back = SurfaceRays::after(*third, before);
  ASSERT_TRUE(back);
  expectSameAnswers(*back, SurfaceRays(before));
  // Another body, another size, too much of another.
  EXPECT_FALSE(SurfaceRays::after(*second, std::make_shared<const Mesh>(torus(0.7, 0.3, 60, 30))));
  EXPECT_FALSE(SurfaceRays::after(*second, std::make_shared<const Mesh>(moved(*now, 8.0, Vector3::Zero()))));
  EXPECT_FALSE(SurfaceRays::after(*second, std::make_shared<const Mesh>(icosphere(3))));
  // Whoever asks for what somebody holds is given that.
  const auto held = sharedRays(now);
  EXPECT_EQ(sharedRays(now), held);
  expectSameAnswers(*sharedRays(again), SurfaceRays(again));
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(sharedRays(std::make_shared<const Mesh>(torus(0.7, 0.3, 60, 30)), context), Error);
  // What was given up is begun again with the device that both have.
  EXPECT_THROW(SurfaceRays::after(*second, again, context), Error);
  EXPECT_TRUE(SurfaceRays::after(*second, again));
}

namespace
{

SurfaceRays sceneOf(const Mesh& mesh)
{
  return SurfaceRays(std::make_shared<const Mesh>(mesh));
}

} // namespace

// Two spheres of radius 1 whose centres are 3 apart: 2 thick, and a gap of 1 between them.
TEST(Room, thicknessAndGap)
{
  const Mesh one = icosphere(4);
  const SurfaceRays rays = sceneOf(joined(one, one, { 3, 0, 0 }));
  const Room between = roomAt(rays, { 1, 0, 0 }, { 1, 0, 0 });
  EXPECT_NEAR(between.inward, 2.0, 0.01);
  EXPECT_NEAR(between.outward, 1.0, 0.01);
  const Room beyond = roomAt(rays, { -1, 0, 0 }, { -2, 0, 0 });
  EXPECT_NEAR(beyond.inward, 2.0, 0.01);
  EXPECT_TRUE(std::isinf(beyond.outward));
}

// A sheet has no other side.
TEST(Room, endlessWhereNothingIsMet)
{
  const SurfaceRays rays = sceneOf(cylinder(1.0, 4.0, 60, 20));
  EXPECT_TRUE(std::isinf(roomAt(rays, { 1, 0, 2 }, { 1, 0, 0 }).outward));
  EXPECT_NEAR(roomAt(rays, { 1, 0, 2 }, { 1, 0, 0 }).inward, 2.0, 0.01);
  const Mesh sheet = gridSurface(4, 4, false, false, [](double u, double v) { return Vector3(u, v, 0.0); });
  EXPECT_TRUE(std::isinf(roomAt(sceneOf(sheet), { 0.4, 0.4, 0 }, { 0, 0, 1 }).inward));
}

// At 0.8 of the radius the chord through a sphere is 1.2 long.
TEST(Room, depthOfAnOutline)
{
  const SurfaceRays rays = sceneOf(icosphere(5));
  EXPECT_NEAR(depthAt(rays, { 0.8, 0, 0 }, { 0, 0, 1 }), 0.6, 0.01);
  EXPECT_NEAR(depthAt(rays, { 0.8, 0, 0.1 }, { 0, 0, -1 }), 0.7, 0.01);
  EXPECT_EQ(depthAt(rays, { 1.1, 0, 0 }, { 0, 0, 1 }), 0.0);
}
