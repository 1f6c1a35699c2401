#include "Stellar/quality.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A sheet of cells `wide` along x and 1 / 40 along y, from 0 to 1, and a line along its middle.
Mesh sheet(int columns)
{
  return gridSurface(columns, 40, false, false, [](double u, double v) { return Vector3(u, v, 0.0); });
}

FeatureCurves middleLine(double y = 0.5)
{
  FeatureCurve curve;
  curve.points = { { 0.2, y, 0.0 }, { 0.8, y, 0.0 } };
  curve.measure();
  return { curve };
}

} // namespace

// Triangles of legs 1 / columns and 1 / 40: the smallest angle is 45 degrees for 40 columns, and 11 for 8.
TEST(ThinTriangles, shareOfThoseNearTheLine)
{
  EXPECT_EQ(neighbourhoodOf(sheet(40), middleLine(), 0.05, Context()).thinShare, 0.0);
  EXPECT_EQ(neighbourhoodOf(sheet(8), middleLine(), 0.05, Context()).thinShare, 1.0);
  // Edges of up to 0.127 are short for a feature 0.6 wide.
  EXPECT_EQ(neighbourhoodOf(sheet(8), middleLine(), 0.6, Context()).thinShare, 0.0);
  // Thin ones far from the line do not matter.
  Mesh mesh = sheet(40);
  for (Vector3& p : mesh.points)
  {
    p[0] = p[1] > 0.7 ? 8.0 * p[0] : p[0];
  }
  EXPECT_EQ(neighbourhoodOf(mesh, middleLine(), 0.05, Context()).thinShare, 0.0);
  EXPECT_GT(neighbourhoodOf(mesh, middleLine(0.7), 0.05, Context()).thinShare, 0.5);
}

// What is nearer than the radius, and a ring of triangles round that.
TEST(ThinTriangles, verticesRoundTheLine)
{
  const Mesh mesh = sheet(40);
  const CurveNeighbourhood found = neighbourhoodOf(mesh, middleLine(), 0.1, Context());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Vector3& p = mesh.points[v];
    const double distance = std::hypot(std::max({ 0.2 - p[0], p[0] - 0.8, 0.0 }), p[1] - 0.5);
    if (distance < 0.1)
    {
      EXPECT_TRUE(found.vertices[v]) << p.transpose();
    }
    if (distance > 0.1 * 9 / 8 + 2 * std::sqrt(2.0) / 40)
    {
      EXPECT_FALSE(found.vertices[v]) << p.transpose();
    }
  }
}

// A triangle that is far larger than the radius is found where the line runs through its middle.
TEST(ThinTriangles, largeTriangles)
{
  const Mesh mesh{ { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, { 10, 10, 0 } }, { { 0, 1, 2 }, { 1, 3, 2 } } };
  FeatureCurve curve;
  curve.points = { { 3, 3, 0 }, { 3.2, 3.1, 0 } };
  curve.measure();
  EXPECT_EQ(neighbourhoodOf(mesh, { curve }, 0.1, Context()).vertices, (std::vector<char>{ 1, 1, 1, 1 }));
  curve.points = { { 3, 3, 1 }, { 3.2, 3.1, 1 } };
  EXPECT_EQ(neighbourhoodOf(mesh, { curve }, 0.1, Context()).vertices, (std::vector<char>{ 0, 0, 0, 0 }));
}

TEST(ThinTriangles, sameOnTwoThreads)
{
  const Mesh mesh = sheet(8);
  const CurveNeighbourhood one = neighbourhoodOf(mesh, middleLine(), 0.1, Context()),
                           two = neighbourhoodOf(mesh, middleLine(), 0.1, twoThreads());
  EXPECT_EQ(one.thinShare, two.thinShare);
  EXPECT_EQ(one.vertices, two.vertices);
}
