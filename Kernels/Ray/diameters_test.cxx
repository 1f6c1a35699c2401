// Diameters where they are asked for: the same as all at once, whatever is asked for in whatever order.
#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Ray/shape_diameter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

void append(Mesh& mesh, const Mesh& other)
{
  const int first = mesh.vertexCount();
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
  {
    mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

Mesh sheetAt(double z)
{
  return gridSurface(8, 8, false, false, [z](double u, double v) { return Vector3(u, v, z); });
}

// A closed body; one that cuts itself; a cup, whose outer side sees the inner one and whose bottom is a hole;
// a body with an open sheet and a loose point beside it; sheets alone.
std::vector<std::pair<const char*, Mesh>> models()
{
  Mesh spiky = icosphere(4);
  std::mt19937 random(7);
  for (Vector3& p : spiky.points)
  {
    p *= 0.8 + 0.4 * static_cast<double>(random() % 1000) / 1000.0;
  }
  Mesh cup = icosphere(4);
  cup.triangles.erase(std::remove_if(cup.triangles.begin(),
                        cup.triangles.end(),
                        [&](const Triangle& t) { return cup.points[t[0]][2] < -0.2; }),
    cup.triangles.end());
  Mesh mixed = torus(1.0, 0.4, 40, 20);
  append(mixed, sheetAt(3.0));
  mixed.points.emplace_back(5, 5, 5);
  Mesh sheets = sheetAt(0.0);
  append(sheets, sheetAt(4.0));
  return { { "torus", torus(1.0, 0.4, 60, 30) },
    { "spiky", spiky },
    { "cup", cup },
    { "mixed", mixed },
    { "sheets", sheets } };
}

ShapeDiameterOptions castOn(Backend backend)
{
  ShapeDiameterOptions options;
  options.backend = backend;
  return options;
}

} // namespace

TEST(Diameters, AreTheSameInAnyOrderAndCompany)
{
  for (const Backend backend : { Backend::Host, Backend::OpenCL })
  {
    for (const auto& [name, mesh] : models())
    {
      SCOPED_TRACE(name);
      const Adjacency adjacency = buildAdjacency(mesh);
      const std::vector<Vector3> normals = vertexNormals(mesh);
      const ShapeDiameter whole = computeShapeDiameter(mesh, adjacency, normals, castOn(backend), Context());
      EXPECT_EQ(std::count(whole.diameter.begin(), whole.diameter.end(), 0.0), 0);
      std::vector<int> order(mesh.points.size());
      std::iota(order.begin(), order.end(), 0);
      std::mt19937 random(11);
      for (const int size : { 1, 7, 400 })
      {
        std::shuffle(order.begin(), order.end(), random);
        Diameters some(mesh, adjacency, normals, castOn(backend), Context());
        std::vector<char> asked(mesh.points.size(), 0);
        // A third of them, then all.
        for (int first = 0; first < mesh.vertexCount() / 3; first += size)
        {
          const int last = std::min(first + size, mesh.vertexCount());
          some.require({ order.begin() + first, order.begin() + last }, withThreads(3));
          std::for_each(order.begin() + first, order.begin() + last, [&](int v) { asked[v] = 1; });
        }
        for (int v = 0; v < mesh.vertexCount(); ++v)
        {
          ASSERT_TRUE(some.knows(v) || !asked[v]) << v;
          ASSERT_EQ(some.values()[v], some.knows(v) ? whole.diameter[v] : 0.0) << v;
        }
        some.requireAll(withThreads(3));
        EXPECT_EQ(some.values(), whole.diameter);
        EXPECT_EQ(some.result().measured, whole.measured);
        EXPECT_EQ(some.result().raysCast, whole.raysCast);
      }
    }
  }
}

TEST(Diameters, RaysAreCastWhereTheyAreAskedForAndOnce)
{
  const Mesh mesh = torus(1.0, 0.4, 60, 30);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<Vector3> normals = vertexNormals(mesh);
  Diameters some(mesh, adjacency, normals, castOn(Backend::Host), Context());
  EXPECT_EQ(some.result().raysCast, 0);
  some.require({ 3, 5, 900 }, Context());
  EXPECT_EQ(some.result().raysCast, 3 * 32);
  some.rest();
  some.require({ 900, 3, 4 }, Context());
  EXPECT_EQ(some.result().raysCast, 4 * 32);
  some.requireAll(Context());
  EXPECT_EQ(some.result().raysCast, 32LL * mesh.vertexCount());
}

TEST(Diameters, ACancelledRequestLeavesWhatWasKnownAndIsMadeGood)
{
  for (const Backend backend : { Backend::Host, Backend::OpenCL })
  {
    const Mesh mesh = icosphere(5);
    const Adjacency adjacency = buildAdjacency(mesh);
    const std::vector<Vector3> normals = vertexNormals(mesh);
    Diameters some(mesh, adjacency, normals, castOn(backend), Context());
    some.require({ 1, 2, 3 }, Context());
    const double known = some.values()[2];
    Context context;
    double reached = 0.0;
    context.progress = [&](double done) { reached = done; };
    context.cancelled = [&] { return reached > 0.5; };
    EXPECT_THROW(some.requireAll(context), Error);
    EXPECT_EQ(some.values()[2], known);
    some.requireAll(Context());
    EXPECT_EQ(
      some.values(), computeShapeDiameter(mesh, adjacency, normals, castOn(backend), Context()).diameter);
  }
}
