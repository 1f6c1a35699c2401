#include "Harness/shapes.h"
#include "Mesh/roughness.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Roughness of(const Mesh& mesh)
{
  return roughness(mesh, buildAdjacency(mesh), std::vector<char>(mesh.points.size(), 1));
}

// Two unit right triangles that meet in the edge from (0, 0, 0) to (0, 1, 0), their normals `turn` degrees
// apart.
Mesh hinge(double turn)
{
  const double a = turn * pi / 180.0;
  return { { { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { std::cos(a), 0, std::sin(a) } },
    { { 0, 1, 2 }, { 0, 3, 1 } } };
}

} // namespace

TEST(Roughness, IsTheAngleOfAHingeWhicheverWayItsTrianglesAreWound)
{
  for (const double turn : { 1e-7, 10.0, 39.999, 40.001, 90.0, 179.0 })
  {
    Mesh mesh = hinge(turn);
    for (int winding = 0; winding < 4; ++winding)
    {
      std::swap(mesh.triangles[winding % 2][0], mesh.triangles[winding % 2][1]);
      const Roughness found = of(mesh);
      EXPECT_NEAR(found.meanAngle, turn, 1e-9) << winding;
      EXPECT_EQ(found.sharpShare, turn > sharpAngle ? 1.0 : 0.0) << turn;
    }
  }
}

TEST(Roughness, CountsAnglesByEdgesAndSharpnessByLength)
{
  // Of a unit cube 12 edges of length 1 are sharp and 6 of length sqrt(2) are flat.
  const Mesh cube{ { { 0, 0, 0 },
                     { 1, 0, 0 },
                     { 1, 1, 0 },
                     { 0, 1, 0 },
                     { 0, 0, 1 },
                     { 1, 0, 1 },
                     { 1, 1, 1 },
                     { 0, 1, 1 } },
    { { 0, 2, 1 },
      { 0, 3, 2 },
      { 4, 5, 6 },
      { 4, 6, 7 },
      { 0, 1, 5 },
      { 0, 5, 4 },
      { 1, 2, 6 },
      { 1, 6, 5 },
      { 2, 3, 7 },
      { 2, 7, 6 },
      { 3, 0, 4 },
      { 3, 4, 7 } } };
  const Roughness found = of(cube);
  EXPECT_NEAR(found.meanAngle, 90.0 * 12.0 / 18.0, 1e-9);
  EXPECT_NEAR(found.sharpShare, 12.0 / (12.0 + 6.0 * std::sqrt(2.0)), 1e-12);
}

TEST(Roughness, OfATubeFallsWithItsEdges)
{
  // Two thirds of the edges of an even lattice turn the surface; n quads around turn by 360 / n each.
  for (const int around : { 6, 12, 48 })
  {
    const Roughness found = of(cylinder(1.0, 20.0, around, 40));
    EXPECT_NEAR(found.meanAngle, 360.0 / around / 3.0, 360.0 / around * 0.02);
    EXPECT_EQ(found.sharpShare > 0.0, 360.0 / around > sharpAngle);
  }
}

TEST(Roughness, LooksAtTheEdgesOfTheRegionOnly)
{
  const int base = hinge(60.0).vertexCount();
  const Mesh mesh = joined(hinge(60.0), hinge(20.0), Vector3(10, 0, 0));
  const Adjacency adjacency = buildAdjacency(mesh);
  std::vector<char> region(mesh.points.size(), 0);
  EXPECT_EQ(roughness(mesh, adjacency, region).meanAngle, 0.0);
  region[base] = 1; // one end of the second hinge
  EXPECT_NEAR(roughness(mesh, adjacency, region).meanAngle, 20.0, 1e-9);
  region[1] = 1;
  EXPECT_NEAR(roughness(mesh, adjacency, region).meanAngle, 40.0, 1e-9);
  EXPECT_NEAR(roughness(mesh, adjacency, region).sharpShare, 0.5, 1e-12);
}

TEST(Roughness, PassesOverBordersWallsAndTrianglesWithoutArea)
{
  Mesh mesh = hinge(30.0);
  mesh.points.emplace_back(0, 0.5, -1);
  mesh.triangles.push_back({ 0, 1, 4 }); // a third triangle at the edge
  EXPECT_EQ(of(mesh).meanAngle, 0.0);
  mesh.triangles.pop_back();
  EXPECT_NEAR(of(mesh).meanAngle, 30.0, 1e-9);
  mesh.points[3] = { 0, 0.25, 0 }; // on the edge
  EXPECT_EQ(of(mesh).meanAngle, 0.0);
  EXPECT_EQ(of(Mesh()).sharpShare, 0.0);
}

TEST(Roughness, HasABoundOnEachOfItsTwoFigures)
{
  const Roughness plain{ 8.0, 0.02 };
  EXPECT_FALSE(rougher(plain, plain));
  EXPECT_FALSE(rougher({ 10.99, 0.0299 }, plain));
  EXPECT_TRUE(rougher({ 11.01, 0.0 }, plain));
  EXPECT_TRUE(rougher({ 0.0, 0.0301 }, plain));
}
