#include "Harness/shapes.h"
#include "Silhouette/extract.h"

#include <gtest/gtest.h>

#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector3 y(0, 1, 0), z(0, 0, 1);

std::vector<Curve> extract(const Mesh& mesh, const View& view)
{
  return extractSilhouette(mesh, buildAdjacency(mesh), vertexNormals(mesh), view);
}

int pointCount(const std::vector<Curve>& curves)
{
  int count = 0;
  for (const Curve& curve : curves)
  {
    count += static_cast<int>(curve.points.size());
  }
  return count;
}

// Every two neighbours of every curve lie in one triangle.
void expectChained(const Mesh& mesh, const std::vector<Curve>& curves)
{
  for (const Curve& curve : curves)
  {
    const int n = static_cast<int>(curve.points.size());
    for (int i = 0; i + (curve.closed ? 0 : 1) < n; ++i)
    {
      std::set<int> both;
      for (const CurvePoint* p : { &curve.points[i], &curve.points[(i + 1) % n] })
      {
        both.insert(p->binding.vertices.begin(), p->binding.vertices.end());
      }
      const bool shared = std::any_of(mesh.triangles.begin(),
        mesh.triangles.end(),
        [&](const Triangle& t)
        {
          return std::all_of(
            both.begin(), both.end(), [&](int v) { return v == t[0] || v == t[1] || v == t[2]; });
        });
      EXPECT_TRUE(shared) << "points " << i << " and " << (i + 1) % n;
    }
  }
}

} // namespace

// A tube seen from the side with its vertices exactly on the silhouette: runs of edges meet in single
// vertices.
TEST(Extract, RunsOnOneVertexCollapse)
{
  const Mesh mesh = cylinder(1.0, 4.0, 8, 5);
  const auto curves = extract(mesh, orthographicView(Vector3(1, 0, 0), z, 50.0));
  ASSERT_EQ(curves.size(), 2u);
  for (const Curve& curve : curves)
  {
    EXPECT_FALSE(curve.closed);
    EXPECT_EQ(curve.points.size(), 6u);
    for (const CurvePoint& p : curve.points)
    {
      EXPECT_TRUE(p.binding.onVertex());
      EXPECT_NEAR(std::abs(p.position[1]), 1.0, 1e-12);
    }
  }
  expectChained(mesh, curves);
}

// The zero tolerance is relative: the same shape at any scale has the same bindings.
TEST(Extract, DoesNotDependOnScale)
{
  for (const double scale : { 1e-8, 1.0, 1e8 })
  {
    Mesh mesh = icosphere(2, scale);
    const auto curves = extract(mesh, perspectiveView(Vector3(0, 0, 3 * scale), y, 40.0));
    ASSERT_EQ(curves.size(), 1u) << scale;
    EXPECT_EQ(
      pointCount(curves), pointCount(extract(icosphere(2), perspectiveView(Vector3(0, 0, 3), y, 40.0))));
  }
}

// A vertex that alone touches the silhouette makes a loop round itself, which is no curve.
TEST(Extract, ASingleTouchingVertexIsNoCurve)
{
  Mesh mesh{ { { 0, 0, 0 } }, {} };
  std::vector<Vector3> normals{ { 1, 0, 0 } };
  for (int i = 0; i < 6; ++i)
  {
    mesh.points.push_back({ std::cos(i * pi / 3), std::sin(i * pi / 3), 0 });
    normals.push_back({ 0, 0, -1 });
    mesh.triangles.push_back({ 0, i + 1, (i + 1) % 6 + 1 });
  }
  EXPECT_TRUE(extractSilhouette(mesh, buildAdjacency(mesh), normals, orthographicView(z, y, 50.0)).empty());
}

TEST(Extract, ACollapsedTriangleDoesNotCutACurve)
{
  Mesh mesh = icosphere(2);
  const View view = orthographicView(Vector3(0.3, 0.2, 1), y, 100.0);
  const auto before = extract(mesh, view);
  const Binding cut = before[0].points[before[0].points.size() / 2].binding;
  mesh.triangles.push_back({ cut.vertices[0], cut.vertices[1], cut.vertices[0] });
  const auto after = extract(mesh, view);
  ASSERT_EQ(after.size(), 1u);
  EXPECT_TRUE(after[0].closed);
  EXPECT_EQ(after[0].points.size(), before[0].points.size());
}

// A fin on a crossed edge: every triangle there starts or ends a curve of its own, and none is lost.
TEST(Extract, CurvesEndAtNonManifoldEdges)
{
  Mesh mesh = icosphere(2);
  const View view = orthographicView(Vector3(0.3, 0.2, 1), y, 100.0);
  const Binding cut = extract(mesh, view)[0].points[3].binding;
  const Vector3 tip = 2.0 * cut.of(mesh.points);
  const auto normals = [&]
  {
    std::vector<Vector3> n = mesh.points;
    for (Vector3& v : n)
      v.normalize();
    return n;
  };
  mesh.triangles.push_back({ cut.vertices[0], cut.vertices[1], mesh.vertexCount() });
  mesh.points.push_back(tip);
  const auto curves = extractSilhouette(mesh, buildAdjacency(mesh), normals(), view);
  ASSERT_EQ(curves.size(), 2u);
  int segments = 0, crossedTriangles = 0;
  for (const Curve& curve : curves)
  {
    segments += static_cast<int>(curve.points.size()) - (curve.closed ? 0 : 1);
  }
  for (const Triangle& t : mesh.triangles)
  {
    const auto front = [&](int v) { return normals()[v].dot(view.normal()) >= 0.0; };
    crossedTriangles += front(t[0]) != front(t[1]) || front(t[1]) != front(t[2]);
  }
  EXPECT_EQ(segments, crossedTriangles);
  expectChained(mesh, curves);
}

// Rough, open, not manifold, far from the origin, large fans, vertices exactly on the silhouette.
TEST(Extract, CurvesOfHostileBodiesRunFromTriangleToTriangle)
{
  Mesh rough = icosphere(4);
  for (int v = 0; v < rough.vertexCount(); ++v)
  {
    rough.points[v] *= 1.0 + 0.05 * std::sin(17.0 * v);
  }
  Mesh far = torus(1.0, 0.4, 60, 30);
  for (Vector3& p : far.points)
  {
    p += Vector3(1e6, -1e6, 2e5);
  }
  Mesh fin = icosphere(2);
  fin.triangles.push_back({ fin.triangles[0][0], fin.triangles[0][1], fin.vertexCount() });
  fin.triangles.push_back({ fin.triangles[0][0], fin.triangles[0][1], fin.vertexCount() + 1 });
  fin.points.push_back({ 0, 0, 3 });
  fin.points.push_back({ 0, 3, 0 });
  fin.points.push_back({ 9, 9, 9 }); // loose
  Mesh drum{ { { 0, 0, 1 }, { 0, 0, -1 } }, {} };
  constexpr int spokes = 300;
  for (int i = 0; i < spokes; ++i)
  {
    const double a = 2 * pi * i / spokes;
    drum.points.push_back({ std::cos(a), std::sin(a), 0.2 * std::cos(5 * a) });
    const int next = (i + 1) % spokes + 2;
    drum.triangles.push_back({ 0, i + 2, next });
    drum.triangles.push_back({ 1, next, i + 2 });
  }
  std::size_t count = 0;
  const Mesh loose{ { { 1, 2, 3 } }, {} };
  const std::vector<Mesh> meshes{ rough, far, fin, drum, cylinder(1.0, 4.0, 8, 5), Mesh(), loose };
  for (const Mesh& mesh : meshes)
  {
    const Adjacency adjacency = buildAdjacency(mesh);
    const std::vector<Vector3> normals = vertexNormals(mesh);
    const Vector3 middle = mesh.points.empty() ? Vector3(0, 0, 0) : mesh.points[0];
    for (int k = 0; k < 20; ++k)
    {
      const Vector3 from(std::cos(0.5 * pi * (k % 10)), std::sin(0.7 * (k % 10)), 0.3 * (k % 3));
      const View view = k % 2 == 0 ? orthographicView(from, Vector3(0.1, 0.2, 1), 100.0)
                                   : perspectiveView(middle + (2 + k % 4) * from, Vector3(0.1, 0.2, 1), 40.0);
      const auto curves = extractSilhouette(mesh, adjacency, normals, view);
      expectChained(mesh, curves);
      for (const Curve& curve : curves)
      {
        count += curve.points.size();
      }
    }
  }
  EXPECT_GT(count, 10000u);
}
