#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Silhouette/facing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A model unit is a pixel.
const View facingView = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 1.0);

Mesh roundDisk(double radius, double z, bool front)
{
  constexpr int corners = 2000;
  Mesh mesh;
  mesh.points.emplace_back(0, 0, z);
  for (int i = 0; i < corners; ++i)
  {
    const double a = (front ? 2.0 : -2.0) * pi * i / corners;
    mesh.points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    mesh.triangles.push_back({ 0, i + 1, (i + 1) % corners + 1 });
  }
  return mesh;
}

Mesh turned(Mesh mesh)
{
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

} // namespace

TEST(BackShare, AClosedSurfaceShowsNoBackAndTurnedInsideOutNothingElse)
{
  const View perspective = perspectiveView(Vector3(3, 1, 4), Vector3(0, 1, 0), 40.0);
  for (const Mesh& mesh : { icosphere(4), torus(1.0, 0.3, 90, 40) })
  {
    for (const View& view : { orthographicView(Vector3(1, 2, 3), Vector3(0, 1, 0), 150.0), perspective })
    {
      EXPECT_EQ(backShare(mesh, view), 0.0);
      EXPECT_EQ(backShare(turned(mesh), view), 1.0);
    }
  }
}

TEST(BackShare, IsTheAreaOfTheBackThatLiesInFront)
{
  const Mesh front = roundDisk(200.0, 0.0, true), back = roundDisk(100.0, 0.0, false);
  // What two circles 240 px apart have in common is hidden of the smaller one.
  const double a = std::acos((240.0 * 240.0 + 200.0 * 200.0 - 100.0 * 100.0) / (2.0 * 240.0 * 200.0)),
               b = std::acos((240.0 * 240.0 + 100.0 * 100.0 - 200.0 * 200.0) / (2.0 * 240.0 * 100.0));
  const double seen =
    100.0 * 100.0 * (pi - b + std::sin(b) * std::cos(b)) - 200.0 * 200.0 * (a - std::sin(a) * std::cos(a));
  const double half = seen / (200.0 * 200.0 * pi + seen);
  for (const double z : { 5.0, 80.0 })
  {
    EXPECT_NEAR(backShare(joined(front, back, Vector3(0, 0, z)), facingView), 0.25, 2e-3);
    EXPECT_NEAR(backShare(joined(front, back, Vector3(60, 40, z)), facingView), 0.25, 2e-3);
    EXPECT_EQ(backShare(joined(front, back, Vector3(0, 0, -z)), facingView), 0.0); // hidden
    EXPECT_NEAR(backShare(joined(front, back, Vector3(240, 0, -z)), facingView), half, 2e-3);
  }
  // In perspective what is nearer is larger: at 3 of 4 units away 100 units look as 133 do.
  const View view = perspectiveView(Vector3(0, 0, 1600), Vector3(0, 1, 0), 40.0);
  EXPECT_NEAR(backShare(joined(front, back, Vector3(0, 0, 400)), view), std::pow(2.0 / 3.0, 2), 4e-3);
}

TEST(BackShare, WhatIsBehindTheEyeOrBesideThePictureShowsNothing)
{
  const View view = perspectiveView(Vector3(0, 0, 10), Vector3(0, 1, 0), 40.0);
  const Mesh ball = turned(icosphere(3));
  EXPECT_EQ(backShare(joined(icosphere(3), ball, Vector3(0, 0, 20)), view), 0.0);
  EXPECT_EQ(backShare(joined(icosphere(3), ball, Vector3(100, 0, 0)), view), 0.0);
  EXPECT_EQ(backShare(Mesh(), view), 0.0);
}

// Of places at one depth, as along an edge that two triangles share, neither order nor threads choose.
TEST(BackShare, IsTheSameInAnyOrderAndOnTwoThreads)
{
  Mesh mesh = joined(icosphere(3, 150.0), turned(icosphere(3, 150.0)), Vector3(40, 30, 20));
  mesh = joined(mesh, roundDisk(180.0, 30.0, false), Vector3(0, 0, 0));
  mesh = joined(mesh, roundDisk(180.0, 30.0, true), Vector3(0, 0, 0));
  const double share = backShare(mesh, facingView);
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.9);
  EXPECT_EQ(backShare(mesh, facingView, twoThreads()), share);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(3));
  EXPECT_EQ(backShare(mesh, facingView), share);
}
