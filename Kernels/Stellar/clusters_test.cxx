#include "Harness/forest_shapes.h"
#include "Stellar/clusters.h"
#include "Stellar/defects.h"
#include "Stellar/refine.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Counts
{
  int vertices, edges, faces;
};

Counts countsOf(const Mesh& mesh)
{
  return { mesh.vertexCount(), static_cast<int>(buildAdjacency(mesh).edges.size()), mesh.triangleCount() };
}

Mesh jitteredPlane()
{
  Mesh mesh = quadPairs(14, 11);
  std::mt19937 random(71);
  std::uniform_real_distribution<double> unit(-0.25, 0.25);
  for (Vector3& p : mesh.points)
  {
    const bool inside = p.x() > 0.0 && p.x() < 1.0 && p.y() > 0.0 && p.y() < 1.0;
    p += inside ? Vector3(unit(random) / 14, unit(random) / 11, 0) : Vector3(0, 0, 0);
  }
  return mesh;
}

Vector3 someWeights(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const Vector3 w(unit(random), unit(random), unit(random));
  return w / w.sum();
}

Source sourceFor(const ClusterResult& result, const BaseMesh& base)
{
  return sourceOf(std::make_shared<const OriginalSurface>(
    OriginalSurface{ result.original, sourceRoots(result.faceFrom, base, result.mesh) }));
}

} // namespace

TEST(D5_1, EachWeldTakesAVertexThreeEdgesAndTwoFaces)
{
  int removed = 0, flips = 0;
  for (const Mesh& mesh : { icosphere(3), torus(1.0, 0.4, 24, 15) })
  {
    const Counts before = countsOf(mesh);
    const ClusterResult result = simplifyByClusters(mesh, {}, Context());
    const Counts after = countsOf(result.mesh);
    EXPECT_NO_THROW(checkManifold(result.mesh)); // no edge twice
    EXPECT_EQ(before.vertices - after.vertices, result.removed);
    EXPECT_EQ(before.edges - after.edges, 3 * result.removed);
    EXPECT_EQ(before.faces - after.faces, 2 * result.removed);
    EXPECT_LE(after.faces, before.faces / 4 + 1);
    EXPECT_GT(result.levels, 2);
    removed += result.removed;
    flips += result.flips;
    // Each operation by itself: faces of a removal, and of a flip.
    const Parametrisation& all = result.original;
    for (const Parametrisation::Record& record : all.records)
    {
      const bool isFlip = record.flatCount == 4 && record.oldCount == 2;
      EXPECT_EQ(record.oldCount - record.newCount, isFlip ? 0 : 2);
    }
  }
  fact("D5_1",
    std::to_string(removed) + " welds after " + std::to_string(flips) +
      " flips on a sphere and a torus: V - 1, E - 3, F - 2 each, no edge twice");
}

TEST(D5_1, RemovalsOfOneLevelShareNoFace)
{
  // One level: up to the point where the target ends it, no face made by a removal is taken by another.
  const Mesh mesh = icosphere(3);
  ClusterOptions options;
  options.targetFaces = mesh.triangleCount() - 60;
  const ClusterResult result = simplifyByClusters(mesh, options, Context());
  ASSERT_EQ(result.levels, 1);
  const Parametrisation& all = result.original;
  for (const Parametrisation::Record& record : all.records)
  {
    for (int f = record.firstNew; record.newCount < record.oldCount && f < record.firstNew + record.newCount;
         ++f)
    {
      EXPECT_EQ(all.goneBy[f], -1);
    }
  }
  EXPECT_EQ(result.removed, 30);
}

TEST(D6_2, APlaneIsItself)
{
  const Mesh mesh = jitteredPlane();
  const ClusterResult result = simplifyByClusters(mesh, {}, Context());
  EXPECT_NO_THROW(checkManifold(result.mesh));
  EXPECT_LT(result.mesh.triangleCount(), mesh.triangleCount() / 2);
  std::mt19937 random(72);
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const int t = static_cast<int>(random() % result.mesh.triangles.size());
    const Vector3 w = someWeights(random);
    Vector3 flat = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      flat += w[k] * result.mesh.points[result.mesh.triangles[t][k]];
    }
    worst = std::max(worst, (result.original.sample(result.faceFrom[t], w) - flat).norm());
  }
  EXPECT_LE(worst, 1e-10);
  fact("D6_2",
    "plane of " + std::to_string(mesh.triangleCount()) + " faces as " +
      std::to_string(result.mesh.triangleCount()) + ": samples off by at most " +
      std::to_string(worst * 1e15) + "e-15");
}

TEST(D6_2, RemovedVerticesAndSamplesAreOnTheOriginal)
{
  const Mesh mesh = icosphere(4);
  const ClusterResult result = simplifyByClusters(mesh, {}, Context());
  double worst = 0.0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const auto [face, weights] = result.original.place(v);
    EXPECT_EQ(result.original.goneBy[face], -1);
    worst = std::max(worst, (result.original.sample(face, weights) - mesh.points[v]).norm());
  }
  EXPECT_LE(worst, 1e-9);
  std::mt19937 random(73);
  double off = 0.0, chord = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const int t = static_cast<int>(random() % result.mesh.triangles.size());
    const Vector3 w = someWeights(random);
    const SurfacePoint at = result.original.original(result.faceFrom[t], w);
    ASSERT_LT(at.triangle, mesh.triangleCount());
    const Vector3 s = result.original.sample(result.faceFrom[t], w), n = facetNormal(mesh, at.triangle);
    off = std::max(off, std::abs(n.dot(s - mesh.points[mesh.triangles[at.triangle][0]])));
    const Triangle& c = result.mesh.triangles[t];
    chord = std::max(chord, 1.0 - (0.5 * (result.mesh.points[c[0]] + result.mesh.points[c[1]])).norm());
  }
  EXPECT_LE(off, 1e-9);
  EXPECT_GT(chord, 1e-3);
  fact("D6_2",
    "sphere of " + std::to_string(mesh.triangleCount()) + " faces as " +
      std::to_string(result.mesh.triangleCount()) + ": removed vertices come back within " +
      std::to_string(worst * 1e12) + "e-12, samples within " + std::to_string(off * 1e15) +
      "e-15, middles of chords " + std::to_string(chord) + " off");
}

TEST(Clusters, ARefinementFollowsTheOriginal)
{
  const Mesh mesh = icosphere(4);
  const ClusterResult result = simplifyByClusters(mesh, {}, Context());
  PairingOptions greedy;
  greedy.improvePairs = false; // so that there are thirds
  const BaseMesh base = pairTriangles(result.mesh, greedy, Context());
  ASSERT_GT(base.unpaired, 0);
  const MidpointRule rule{ nullptr, sourceFor(result, base), 1e-9 };
  Forest plain = base.forest, sampled = base.forest;
  putOnSource(sampled, rule.source);
  for (int g = 0; g < 4; ++g)
  {
    for (Forest* forest : { &plain, &sampled })
    {
      const int count = static_cast<int>(forest->faces.size());
      for (int f = 0; f < count; ++f)
      {
        if (forest->faces[f].gen == g)
        {
          forest->refine(f, forest == &plain ? MidpointRule() : rule);
        }
      }
    }
  }
  const auto innermost = [](const Forest& forest)
  {
    double least = 2.0;
    for (const Forest::Vertex& v : forest.vertices)
    {
      least = std::min(least, v.position.norm());
    }
    return least;
  };
  EXPECT_GT(innermost(sampled), 0.998); // the facets of the original
  EXPECT_LT(innermost(plain), 0.995);
}

TEST(Clusters, ARefinementComesWithinItsToleranceOfTheOriginal)
{
  const Mesh mesh = icosphere(4);
  const ClusterResult result = simplifyByClusters(mesh, {}, Context());
  BaseMesh base = pairTriangles(result.mesh, {}, Context());
  const Source source = sourceFor(result, base);
  putOnSource(base.forest, source);
  int last = base.forest.faceCount();
  for (double tolerance : { 4e-3, 1e-3 })
  {
    const Forest forest = refineToSource(base.forest, source, { tolerance, 16, 100000 }, Context());
    EXPECT_EQ(forest.broken(), "");
    EXPECT_GT(forest.faceCount(), last);
    last = forest.faceCount();
    for (int f = 0; f < forest.faceCount(); ++f)
    {
      // The middles lie within the sphere by what facets of the original do, and the tolerance.
      const Forest::Face& face = forest.faces[f];
      const Vector3 middle = (forest.vertices[face.v[0]].position + forest.vertices[face.v[1]].position +
                               forest.vertices[face.v[2]].position) /
                             3.0;
      EXPECT_GT(middle.norm(), 1.0 - tolerance - 2e-3);
    }
    EXPECT_TRUE(sameForest(refineToSource(forest, source, { tolerance, 16, 100000 }, Context()), forest));
  }
  EXPECT_THROW(refineToSource(base.forest, source, { 1e-9, 40, 5000 }, Context()), Error);
  EXPECT_THROW(refineToSource(base.forest, source, { 0.0, 16, 5000 }, Context()), Error);
}

TEST(D6_2, RealSurfacesComeBack)
{
  for (const char* name : { "bunny_5k.obj", "hand_closed.obj", "skull_genus2.off", "hand_open_wrist.off" })
  {
    const Mesh mesh = sharedMesh(name);
    if (mesh.triangles.empty())
    {
      GTEST_SKIP() << "no shared data";
    }
    const ClusterResult result = simplifyByClusters(mesh, {}, Context());
    EXPECT_NO_THROW(checkManifold(result.mesh));
    EXPECT_EQ(euler(baseOf(result.mesh)), euler(baseOf(mesh)));
    EXPECT_EQ(boundaryLoops(baseOf(result.mesh)), boundaryLoops(baseOf(mesh)));
    double worst = 0.0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const auto [face, weights] = result.original.place(v);
      worst = std::max(worst, (result.original.sample(face, weights) - mesh.points[v]).norm());
    }
    EXPECT_LE(worst, 1e-9 * boundingDiagonal(mesh)) << name;
    fact("D6_2",
      std::string(name) + ", " + std::to_string(mesh.triangleCount()) + " to " +
        std::to_string(result.mesh.triangleCount()) + " faces: removed vertices within " +
        std::to_string(1e12 * worst / boundingDiagonal(mesh)) + "e-12 diagonals");
  }
}

// A needle of the base stays one whatever is split: none comes that was not there.
TEST(Clusters, NoNeedlesComeThatWereNotThere)
{
  int looked = 0;
  for (const char* name : { "bunny_5k.obj", "cat.off", "hand_closed.obj", "armadillo_29k.obj" })
  {
    const Mesh mesh = sharedMesh(name);
    if (mesh.triangles.empty())
    {
      continue;
    }
    ++looked;
    const Mesh made = simplifyByClusters(mesh, {}, Context()).mesh;
    EXPECT_GE(smallestAngle(made), std::min(15.0, smallestAngle(mesh)) - 1e-9) << name;
    EXPECT_LE(made.triangleCount(), mesh.triangleCount() / 4 + 2) << name;
  }
  const Mesh plane = jitteredPlane();
  EXPECT_GE(smallestAngle(simplifyByClusters(plane, {}, Context()).mesh),
    std::min(15.0, smallestAngle(plane)) - 1e-9);
  if (looked == 0)
  {
    GTEST_SKIP() << "no shared data";
  }
}

TEST(Clusters, FeaturesBoundariesAndBoundsHold)
{
  // A box of finely divided sides: only what is inside the sides and along the boundary of a plane may go.
  const Mesh plane = jitteredPlane();
  const ClusterResult flat = simplifyByClusters(plane, {}, Context());
  double area = 0.0;
  for (int t = 0; t < flat.mesh.triangleCount(); ++t)
  {
    const Triangle& c = flat.mesh.triangles[t];
    area += 0.5 * (flat.mesh.points[c[1]] - flat.mesh.points[c[0]])
                    .cross(flat.mesh.points[c[2]] - flat.mesh.points[c[0]])
                    .z();
  }
  EXPECT_NEAR(area, 1.0, 1e-12);
  for (int corner : { 0, 14, 11 * 15, 12 * 15 - 1 })
  {
    EXPECT_LT(flat.original.removedBy[corner], 0);
  }
  ClusterOptions bounded;
  bounded.maximumError = 1e-3;
  const ClusterResult near = simplifyByClusters(icosphere(3), bounded, Context()),
                      any = simplifyByClusters(icosphere(3), {}, Context());
  EXPECT_GT(near.mesh.triangleCount(), any.mesh.triangleCount());
  // A roof of 90 degrees keeps its ridge.
  Mesh roof = quadPairs(10, 10);
  for (Vector3& p : roof.points)
  {
    p.z() = -std::abs(p.x() - 0.5);
  }
  const ClusterResult kept = simplifyByClusters(roof, {}, Context());
  for (int v = 0; v < roof.vertexCount(); ++v)
  {
    if (roof.points[v].z() == 0.0)
    {
      EXPECT_LT(kept.original.removedBy[v], 0);
    }
  }
  EXPECT_GT(kept.removed, 20);
  EXPECT_THROW(simplifyByClusters({ { { 0, 0, 0 } }, { { 0, 0, 0 } } }, {}, Context()), Error);
  EXPECT_EQ(simplifyByClusters({}, {}, Context()).mesh.triangleCount(), 0);
  EXPECT_EQ(simplifyByClusters({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                                 { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } },
              {},
              Context())
              .mesh.triangleCount(),
    4); // a tetrahedron is as small as it gets
}
