#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/nearest.h"
#include "Mesh/rotation.h"
#include "Mesh/shape.h"
#include "Mesh/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

Mesh octahedron()
{
  return {
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } }
  };
}

} // namespace

TEST(Adjacency, OctahedronHasTwelveEdgesOfTwoTriangles)
{
  const Mesh mesh = octahedron();
  const Adjacency adjacency = buildAdjacency(mesh);
  EXPECT_EQ(adjacency.edges.size(), 12u);
  for (const MeshEdge& e : adjacency.edges)
  {
    EXPECT_EQ(e.triangleCount, 2);
    EXPECT_LT(e.v0, e.v1);
  }
  for (int v = 0; v < 6; ++v)
  {
    EXPECT_EQ(adjacency.vertexVertices.size(v), 4);
    EXPECT_TRUE(std::is_sorted(adjacency.vertexVertices.begin(v), adjacency.vertexVertices.end(v)));
    EXPECT_EQ(adjacency.vertexTriangles.size(v), 4);
    EXPECT_FALSE(adjacency.borderVertex[v]);
  }
  EXPECT_EQ(adjacency.findEdge(0, 1), -1);
  EXPECT_EQ(adjacency.edges[adjacency.findEdge(4, 2)].v0, 2);
}

TEST(Adjacency, ToleratesAFinAndADegenerateTriangle)
{
  Mesh mesh = octahedron();
  mesh.points.push_back({ 2, 2, 2 });
  mesh.triangles.push_back({ 0, 2, 6 });
  mesh.triangles.push_back({ 1, 1, 3 });
  const Adjacency adjacency = buildAdjacency(mesh);
  EXPECT_EQ(adjacency.edges[adjacency.findEdge(0, 2)].triangleCount, 3);
  EXPECT_TRUE(adjacency.borderVertex[6]);
  EXPECT_EQ(adjacency.vertexTriangles.size(1), 5);
  EXPECT_EQ(adjacency.edges[adjacency.findEdge(1, 3)].triangleCount, 2);
  EXPECT_EQ(adjacency.triangleEdges.back(), (std::array<int, 3>{ -1, -1, -1 }));
}

TEST(VertexNormals, OctahedronNormalsArePositions)
{
  const Mesh mesh = octahedron();
  const auto normals = vertexNormals(mesh);
  for (int v = 0; v < 6; ++v)
  {
    EXPECT_LT((normals[v] - mesh.points[v]).norm(), 1e-15);
  }
}

TEST(EdgeDistances, FollowEdgesAndStopAtTheLimit)
{
  const Mesh mesh = octahedron();
  const auto distance = edgeDistances(mesh, buildAdjacency(mesh), { 0 });
  EXPECT_DOUBLE_EQ(distance[1], 2.0 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(distance[4], std::sqrt(2.0));
  EXPECT_TRUE(std::isinf(edgeDistances(mesh, buildAdjacency(mesh), { 0 }, 2.0)[1]));
}

TEST(View, DisplayAndWorldAreInverse)
{
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view(2, 3) = -5.0;
  for (const bool perspective : { false, true })
  {
    Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
    if (perspective)
    {
      projection.row(3) << 0, 0, -1, 0;
    }
    const View v(view, projection, 800, 600);
    EXPECT_EQ(v.perspective(), perspective);
    EXPECT_LT((v.normal() - Vector3(0, 0, 1)).norm(), 1e-15);
    EXPECT_LT((v.eye() - Vector3(0, 0, 5)).norm(), 1e-15);
    const Vector3 world(0.3, -0.2, 0.7);
    const Vector3 display = v.toDisplay(world);
    EXPECT_NEAR(display[2], -4.3, 1e-14);
    EXPECT_NEAR(display[0], (0.3 / (perspective ? 4.3 : 1.0) + 1.0) * 400.0, 1e-12);
    EXPECT_LT((v.toWorld(display.head<2>(), display[2]) - world).norm(), 1e-14);
  }
}

TEST(View, RefusesSingularAndNonFiniteMatrices)
{
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Eigen::Matrix4d bad = identity;
  bad(0, 0) = std::nan("");
  EXPECT_THROW(View(bad, identity, 8, 6), Error);
  EXPECT_THROW(View(Eigen::Matrix4d::Zero(), identity, 8, 6), Error);
  EXPECT_THROW(View(identity, identity, 0, 6), Error);
}

TEST(Rotation, TakesOneDirectionToTheOtherThePlainWay)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 from = any();
    const Vector3 to = i % 10 == 0 ? Vector3(-3.0 * from) : i % 10 == 1 ? Vector3(2.0 * from) : any();
    const Eigen::Quaterniond rotation = oversketch::rotationBetween(from, to);
    EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
    EXPECT_LT((rotation * from.normalized() - to.normalized()).norm(), 1e-7);
    // No more than the angle between them.
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    EXPECT_NEAR(2.0 * std::atan2(rotation.vec().norm(), rotation.w()), angle, 1e-6);
  }
}

// No place of the triangle is nearer, from wherever the corners are counted and far from the origin.
TEST(Nearest, PlaceOfATriangleIsTheNearestOfAll)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share;
  const auto any = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 a = any(), b = any(), c = i % 5 == 0 ? Vector3(0.5 * (a + b)) : any(), p = 2.0 * any();
    const double least = std::sqrt(squaredDistance(a, b, c, p));
    const double digits = i % 5 == 0 ? 1e-5 : 1e-12; // half of them without area
    EXPECT_NEAR(std::sqrt(squaredDistance(b, c, a, p)), least, digits);
    const Vector3 far(4.6e6, -1e6, 3e5);
    EXPECT_NEAR(
      std::sqrt(squaredDistance(a + far, b + far, c + far, p + far)), least, std::max(1e-8, digits));
    EXPECT_LE(least, distanceToSegment(p, a, b) + digits);
    for (int k = 0; k < 50; ++k)
    {
      double v = share(random), w = share(random);
      if (v + w > 1.0)
      {
        v = 1.0 - v;
        w = 1.0 - w;
      }
      EXPECT_LE(least, (a + v * (b - a) + w * (c - a) - p).norm() + digits);
      EXPECT_LE(distanceToSegment(p, a, b), (a + v * (b - a) - p).norm() + 1e-12);
    }
  }
}

TEST(Shape, SmallestAngleIsThatBetweenEdges)
{
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 t[3] = { any(), any(), any() };
    double least = 4.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
    EXPECT_NEAR(smallestAngle(t[0], t[1], t[2]), least, 1e-7);
  }
  EXPECT_EQ(narrowness(Vector3::Zero(), Vector3::UnitX(), Vector3(3.0, 0.0, 0.0)), 0.0);
  EXPECT_EQ(narrowness(Vector3::Zero(), Vector3::Zero(), Vector3::UnitX()), 0.0);
}

TEST(Context, EachIndexComesOnceAndNoneOnceCancelled)
{
  Context context;
  std::vector<int> calls(7, 0);
  context.each(7, [&](int i) { ++calls[i]; });
  context.eachUntilCancelled(7, [&](int i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(7, 2));
  int done = 0;
  context.cancelled = [&] { return done == 3; };
  context.eachUntilCancelled(7, [&](int) { ++done; });
  EXPECT_EQ(done, 3);
}
