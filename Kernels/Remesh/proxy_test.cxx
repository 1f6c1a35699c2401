#include "Harness/edges.h"
#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Remesh/proxy.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Neither edges of more than two triangles nor points of more than one fan; borders where the mesh has some.
void expectManifold(const Mesh& mesh, bool closed)
{
  const Adjacency around = buildAdjacency(mesh);
  int borders = 0;
  for (const MeshEdge& edge : around.edges)
  {
    EXPECT_LE(edge.triangleCount, 2);
    borders += edge.triangleCount == 1 ? 1 : 0;
  }
  EXPECT_EQ(borders == 0, closed);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_TRUE(isOneFan(around, v)) << v;
    EXPECT_GT(around.vertexTriangles.size(v), 0) << v;
  }
  for (const Triangle& t : mesh.triangles)
  {
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
  }
}

void expectProxy(const Mesh& mesh, int target, bool closed = true)
{
  const Proxy proxy = makeProxy(mesh, target);
  expectManifold(proxy.mesh, closed);
  EXPECT_EQ(eulerNumber(proxy.mesh.triangles), eulerNumber(mesh.triangles));
  EXPECT_NEAR(proxy.mesh.triangleCount(), target, 0.3 * target);
  ASSERT_EQ(proxy.pointFrom.size(), proxy.mesh.points.size());
  for (int v = 0; v < proxy.mesh.vertexCount(); ++v)
  {
    EXPECT_EQ(proxy.mesh.points[v], mesh.points[proxy.pointFrom[v]]);
  }
}

Mesh scaled(Mesh mesh, const Vector3& by)
{
  for (Vector3& p : mesh.points)
  {
    p = p.cwiseProduct(by);
  }
  return mesh;
}

Mesh noisy(Mesh mesh, double by)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-by, by);
  for (Vector3& p : mesh.points)
  {
    p *= 1.0 + share(random);
  }
  return mesh;
}

} // namespace

TEST(MakeProxy, KeepsTheKindOfASurface)
{
  expectProxy(icosphere(5), 1500);
  expectProxy(noisy(icosphere(5), 0.004), 1500);
  expectProxy(torus(1.0, 0.4, 150, 60), 1000);
  expectProxy(cylinder(1.0, 4.0, 100, 100), 1000, false);
}

TEST(MakeProxy, KeepsBothSidesOfAThinPlateApart)
{
  expectProxy(scaled(icosphere(5), { 1.0, 1.0, 0.02 }), 1500);
}

TEST(MakeProxy, KeepsPartsThinnerThanACell)
{
  const Mesh ring = torus(1.0, 0.02, 300, 12);
  const Proxy proxy = makeProxy(ring, 600);
  expectManifold(proxy.mesh, true);
  EXPECT_EQ(eulerNumber(proxy.mesh.triangles), 0);
}

TEST(MakeProxy, TurnsNoTriangleOver)
{
  const Proxy proxy = makeProxy(icosphere(5), 1500);
  for (int t = 0; t < proxy.mesh.triangleCount(); ++t)
  {
    EXPECT_GT(facetNormal(proxy.mesh, t).dot(proxy.mesh.points[proxy.mesh.triangles[t][0]]), -0.3) << t;
  }
}

TEST(MakeProxy, MakesNoMoreOfWhatIsNoManifold)
{
  Mesh mesh = icosphere(5); // with a fin: its edge has three triangles
  const Triangle fin = mesh.triangles[0];
  mesh.points.emplace_back(0.0, 0.0, 3.0);
  mesh.triangles.push_back({ fin[0], fin[1], mesh.vertexCount() - 1 });
  EXPECT_NEAR(makeProxy(mesh, 1500).mesh.triangleCount(), 1500, 450);
}

TEST(MakeProxy, RefusesWhatReachesSoFarThatNoCellsAreSmallEnough)
{
  Mesh mesh = icosphere(5);
  mesh.points.emplace_back(1e8, 0.0, 0.0);
  try
  {
    makeProxy(mesh, 1500);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadMesh);
    EXPECT_NE(std::string(error.what()).find("far from the rest"), std::string::npos) << error.what();
  }
}

TEST(MakeProxy, IsTheSameForAnyThreadsAndEndsWhenCancelled)
{
  const Mesh mesh = noisy(icosphere(5), 0.004);
  const Proxy proxy = makeProxy(mesh, 1500), three = makeProxy(mesh, 1500, withThreads(3));
  EXPECT_EQ(three.mesh.points, proxy.mesh.points);
  EXPECT_EQ(three.mesh.triangles, proxy.mesh.triangles);
  EXPECT_EQ(three.pointFrom, proxy.pointFrom);
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(makeProxy(mesh, 1500, cancelled), Error);
  EXPECT_THROW(makeProxy({ { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }, { { 0, 1, 2 } } }, 1500), Error);
}
