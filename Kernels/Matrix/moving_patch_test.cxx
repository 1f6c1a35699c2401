#include "Matrix/moving_patch.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct CapScene
{
  Mesh mesh = icosphere(4);
  Adjacency links = buildAdjacency(this->mesh);
  std::vector<int> moving;

  CapScene()
  {
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      if (this->mesh.points[v][2] > 0.6)
      {
        this->moving.push_back(v);
      }
    }
  }
  std::vector<Vector3> places(const std::function<Vector3(const Vector3&)>& move) const
  {
    std::vector<Vector3> there;
    for (const int v : this->moving)
    {
      there.push_back(move(this->mesh.points[v]));
    }
    return there;
  }
};

bool same(const Vector3& a, const Vector3& b)
{
  return (a - b).cwiseAbs().maxCoeff() < 1e-14;
}

constexpr auto both = MovingPatch::Normals::OfBoth, none = MovingPatch::Normals::None;

} // namespace

TEST(MovingPatch, HasTheNormalsOfTheWholeMesh)
{
  const CapScene scene;
  MovingPatch patch(scene.mesh, scene.links, scene.moving);
  // Only half of them move.
  const auto places = scene.places(
    [](const Vector3& p) { return p[0] > 0.0 ? Vector3(p + Vector3(0.1, 0.2, p[0] * 0.3)) : p; });
  Mesh after = scene.mesh;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    after.points[scene.moving[i]] = places[i];
  }
  const std::vector<Vector3> before = vertexNormals(scene.mesh), whole = vertexNormals(after);
  const MovingPatch::Shape one = patch.shapeAt(places, both, {}),
                           two = patch.shapeAt(places, both, twoThreads());
  EXPECT_EQ(one.vertexNormals, two.vertexNormals);
  std::vector<char> known(whole.size(), 0);
  for (const auto& [v, normal] : one.vertexNormals)
  {
    EXPECT_TRUE(same(normal, whole[v])) << v;
    known[v] = 1;
  }
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    EXPECT_TRUE(known[v] || same(before[v], whole[v])) << v; // nothing else changed
  }
  std::size_t changed = 0;
  for (int t = 0; t < after.triangleCount(); ++t)
  {
    changed += same(facetNormal(after, t), facetNormal(scene.mesh, t)) ? 0 : 1;
  }
  EXPECT_GE(one.faceNormals.size(), changed);
  for (const auto& [t, normal] : one.faceNormals)
  {
    EXPECT_TRUE(same(normal, facetNormal(after, t)));
  }
  EXPECT_EQ(one.foldedEdges, 0);
  EXPECT_TRUE(patch.shapeAt(places, none, {}).vertexNormals.empty());
  // At rest nothing changes, whatever was before.
  const MovingPatch::Shape rest = patch.shapeAt(scene.places([](const Vector3& p) { return p; }), both, {});
  EXPECT_TRUE(rest.vertexNormals.empty());
  EXPECT_TRUE(rest.faceNormals.empty());
  EXPECT_EQ(rest.foldedEdges, 0);
}

TEST(MovingPatch, CountsFoldsThatWereNotThere)
{
  // A strip folded over along one of its lines: 4 edges there.
  Mesh strip = gridSurface(6, 4, false, false, [](double u, double v) { return Vector3(u, v, 0.0); });
  const Adjacency links = buildAdjacency(strip);
  std::vector<int> moving;
  std::vector<Vector3> folded, bent;
  for (int v = 0; v < strip.vertexCount(); ++v)
  {
    if (strip.points[v][0] > 0.51)
    {
      const Vector3 p = strip.points[v];
      moving.push_back(v);
      folded.emplace_back(1.0 - p[0], p[1], 0.01 * p[0]);
      bent.emplace_back(0.5, p[1], p[0] - 0.5); // by 90 degrees
    }
  }
  MovingPatch patch(strip, links, moving);
  EXPECT_EQ(patch.shapeAt(folded, none, {}).foldedEdges, 4);
  EXPECT_EQ(patch.shapeAt(bent, none, {}).foldedEdges, 0);
  // Folded at rest: nothing new.
  Mesh before = strip;
  for (std::size_t i = 0; i < moving.size(); ++i)
  {
    before.points[moving[i]] = folded[i];
  }
  MovingPatch known(before, links, moving);
  std::vector<Vector3> further = folded;
  for (Vector3& p : further)
  {
    p[2] += 0.001 * p[1];
  }
  EXPECT_EQ(known.shapeAt(further, none, {}).foldedEdges, 0);
}

TEST(MovingPatch, AnglesOfNeedlesAreExact)
{
  // Fans of triangles of all shapes: the normals of their middles are sums by angle.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int round = 0; round < 200; ++round)
  {
    Mesh fan;
    fan.points.emplace_back(0, 0, 0);
    const double thin = std::pow(10.0, -6.0 * std::abs(value(random)));
    for (int k = 0; k < 7; ++k)
    {
      const double a = 2.0 * pi * (k + 0.9 * std::abs(value(random))) / 7.0;
      fan.points.emplace_back(std::cos(a), thin * std::sin(a), 0.3 * value(random));
      fan.triangles.push_back({ 0, 1 + k, 1 + (k + 1) % 7 });
    }
    MovingPatch patch(fan, buildAdjacency(fan), { 0 });
    fan.points[0] = Vector3(0.1 * value(random), 0.0, 0.2);
    const MovingPatch::Shape shape = patch.shapeAt({ fan.points[0] }, both, {});
    ASSERT_EQ(shape.vertexNormals.size(), 8u);
    const std::vector<Vector3> exact = vertexNormals(fan);
    for (const auto& [v, normal] : shape.vertexNormals)
    {
      EXPECT_LT((normal - exact[v]).norm(), 1e-10); // the area of a needle is a difference
    }
  }
}

// A mesh may have points without faces, first or last, and they may move.
TEST(MovingPatch, PointsWithoutFacesMoveToo)
{
  CapScene scene;
  scene.mesh.points.emplace_back(0.0, 0.0, 3.0);
  scene.links = buildAdjacency(scene.mesh);
  const auto moved = [](const Vector3& p) { return Vector3(p + Vector3(0.0, 0.1, 0.0)); };
  MovingPatch without(scene.mesh, scene.links, scene.moving);
  const MovingPatch::Shape expected = without.shapeAt(scene.places(moved), both, Context());
  scene.moving.push_back(scene.mesh.vertexCount() - 1);
  MovingPatch patch(scene.mesh, scene.links, scene.moving);
  EXPECT_EQ(patch.rest().back(), Vector3(0.0, 0.0, 3.0));
  const MovingPatch::Shape shape = patch.shapeAt(scene.places(moved), both, Context());
  EXPECT_EQ(shape.vertexNormals, expected.vertexNormals);
  EXPECT_EQ(shape.faceNormals, expected.faceNormals);
  EXPECT_EQ(shape.foldedEdges, expected.foldedEdges);
  // Nothing but such a point.
  MovingPatch alone(scene.mesh, scene.links, { scene.mesh.vertexCount() - 1 });
  EXPECT_TRUE(alone.shapeAt({ Vector3(1.0, 0.0, 0.0) }, both, Context()).vertexNormals.empty());
}
