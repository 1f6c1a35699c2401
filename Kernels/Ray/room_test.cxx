#include "Ray/room.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

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
