#include "Harness/shapes.h"
#include "Mesh/weld.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// The unit cube, each side with four points of its own, as a reader of flat-shaded faces leaves it.
Mesh splitCube()
{
  Mesh cube;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double height : { 0.0, 1.0 })
    {
      const int first = cube.vertexCount();
      for (const auto& [u, v] :
        { std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0) })
      {
        Vector3 p;
        p[axis] = height;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        cube.points.push_back(p);
      }
      cube.triangles.push_back({ first, first + 1, first + 2 });
      cube.triangles.push_back({ first, first + 2, first + 3 });
    }
  }
  return cube;
}

// A strip of quads along x, one unit each, split between x = 0 and `until` along y = 1: points of the upper
// row carry another value there.
struct Strip
{
  Mesh mesh;
  std::vector<double> values;
};

Strip splitStrip(int length, int until)
{
  Strip strip;
  const auto add = [&](double x, double y, double value)
  {
    strip.mesh.points.emplace_back(x, y, 0.0);
    strip.values.push_back(value);
    return strip.mesh.vertexCount() - 1;
  };
  std::vector<int> low, middle, upper, high;
  for (int i = 0; i <= length; ++i)
  {
    low.push_back(add(i, 0.0, 0.0));
    middle.push_back(add(i, 1.0, 0.0));
    upper.push_back(i < until ? add(i, 1.0, 7.0) : middle.back());
    high.push_back(add(i, 2.0, 0.0));
  }
  for (int i = 0; i < length; ++i)
  {
    for (const auto& [a, b] : { std::pair(&low, &middle), std::pair(&upper, &high) })
    {
      strip.mesh.triangles.push_back({ (*a)[i], (*a)[i + 1], (*b)[i + 1] });
      strip.mesh.triangles.push_back({ (*a)[i], (*b)[i + 1], (*b)[i] });
    }
  }
  return strip;
}

PointValues valuesOf(const std::vector<double>& values)
{
  return { 1, [&values](int point, int) { return values[point]; } };
}

} // namespace

TEST(Weld, NothingToWeldIsSaidByNothing)
{
  EXPECT_TRUE(weldPoints(icosphere(3).points).empty());
  EXPECT_TRUE(weldPoints({}).empty());
}

TEST(Weld, VerticesAreNumberedByTheirFirstPoints)
{
  const Vector3 a(1, 2, 3), b(0.1, 0.2, 0.3), c(-4, 0, 0);
  EXPECT_EQ(weldPoints({ b, a, b, c, a, a }), (std::vector<int>{ 0, 1, 0, 2, 1, 1 }));
  EXPECT_EQ(weldPoints({ c, Vector3(-4, -0.0, 0) }), (std::vector<int>{ 0, 0 })); // -0 is 0
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(weldPoints({ Vector3(nan, 0, 0), Vector3(nan, 0, 0) }).empty());
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(weldPoints({ a, Vector3(next, 2, 3) }).empty()); // the next number is another place
}

TEST(Weld, ACubeOfSixFacesIsClosed)
{
  const Mesh split = splitCube();
  ASSERT_EQ(split.vertexCount(), 24);
  const std::vector<int> vertices = weldPoints(split.points);
  const Mesh cube = weldedMesh(split, vertices);
  EXPECT_EQ(cube.vertexCount(), 8);
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    EXPECT_EQ(cube.points[vertices[i]], split.points[i]);
  }
  const Adjacency adjacency = buildAdjacency(cube);
  EXPECT_EQ(adjacency.edges.size(), 18u);
  for (const MeshEdge& edge : adjacency.edges)
  {
    EXPECT_EQ(edge.triangleCount, 2);
  }

  // The number of the face as an attribute: every point a class of its own, every face a chart.
  std::vector<double> face;
  face.reserve(split.vertexCount());
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    const int number = i / 4;
    face.push_back(number);
  }
  const std::vector<int> classes = attributeClasses(vertices, valuesOf(face));
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    EXPECT_EQ(classes[i], i);
  }
  const Charts charts = findCharts(cube, adjacency, split.triangles, classes);
  EXPECT_EQ(charts.count, 6);
  for (int t = 0; t < cube.triangleCount(); ++t)
  {
    EXPECT_EQ(charts.of[t], t / 2);
  }
  // Without one, nothing but splitting sets the faces apart.
  const std::vector<int> together = attributeClasses(vertices, PointValues());
  EXPECT_EQ(findCharts(cube, adjacency, split.triangles, together).count, 1);
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    EXPECT_EQ(split.points[together[i]], split.points[i]);
    EXPECT_LE(together[i], i);
  }
}

TEST(Weld, ClassesAreOfEqualValuesInOnePlace)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<int> vertices{ 0, 1, 0, 0, 1, 0, 0, 0 };
  EXPECT_EQ(attributeClasses(vertices, valuesOf({ 5, 5, 2, 5, 5, 2, nan, nan })),
    (std::vector<int>{ 0, 1, 2, 0, 1, 2, 6, 7 }));
  // All components count.
  const std::vector<double> x{ 1, 0, 1, 1, 0, 1, 1, 1 }, y{ 3, 0, 4, 3, 1, 3, 4, 4 };
  EXPECT_EQ(attributeClasses(vertices, { 2, [&](int p, int c) { return c == 0 ? x[p] : y[p]; } }),
    (std::vector<int>{ 0, 1, 2, 0, 4, 0, 2, 2 }));
}

TEST(Weld, ASeamThatEndsInsideAPatchSeparatesTwoCharts)
{
  const Strip strip = splitStrip(8, 4);
  const std::vector<int> vertices = weldPoints(strip.mesh.points);
  const Mesh welded = weldedMesh(strip.mesh, vertices);
  EXPECT_EQ(welded.vertexCount(), 3 * 9);
  const std::vector<int> classes = attributeClasses(vertices, valuesOf(strip.values));
  const Adjacency adjacency = buildAdjacency(welded);
  const Charts charts = findCharts(welded, adjacency, strip.mesh.triangles, classes);
  EXPECT_EQ(charts.count, 2);
  int seams = 0;
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    if (adjacency.edges[e].triangleCount != 2)
    {
      continue;
    }
    const int* t = adjacency.trianglesBegin(e);
    const auto classAt = [&](int triangle, int vertex)
    {
      const Triangle& c = welded.triangles[triangle];
      const int k = c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2;
      return classes[strip.mesh.triangles[triangle][k]];
    };
    const MeshEdge& edge = adjacency.edges[e];
    if (classAt(t[0], edge.v0) != classAt(t[1], edge.v0) || classAt(t[0], edge.v1) != classAt(t[1], edge.v1))
    {
      ++seams;
      EXPECT_NE(charts.of[t[0]], charts.of[t[1]]);
    }
  }
  EXPECT_EQ(seams, 4);
}
