#include "Harness/forest_shapes.h"
#include "Stellar/forest.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

TEST(D2_1, UniformRefinementsOfAQuad)
{
  const int points[] = { 4, 5, 9, 13, 25, 41, 81 };
  std::string reached;
  for (int g = 0; g <= 6; ++g)
  {
    Forest forest = quadForest(1, 1);
    refineAll(forest, g);
    EXPECT_EQ(forest.broken(), "");
    EXPECT_EQ(forest.faceCount(), 2 << g);
    EXPECT_EQ(forest.vertexCount(), points[g]);
    reached +=
      (g ? ", " : "") + std::to_string(forest.faceCount()) + " / " + std::to_string(forest.vertexCount());
  }
  fact("D2_1", "faces / points after 0 to 6 refinements: " + reached);
}

TEST(D2_2, ValencesInAUniformInterior)
{
  // Pairs and thirds in one mesh: the bunny-like case is a sphere of which some triangles stay alone.
  PairingOptions greedy;
  greedy.improvePairs = false;
  const Mesh mesh = subdivided(octahedron());
  std::map<int, int> newest, older, thirds, base;
  for (const PairingOptions& options : { greedy, PairingOptions() })
  {
    const BaseMesh made = pairTriangles(mesh, options, Context());
    std::vector<int> polygons(made.forest.vertices.size(), 0); // pairs and lone triangles round a point
    for (std::size_t r = 0; r < made.forest.faces.size(); ++r)
    {
      const Forest::Face& face = made.forest.faces[r];
      // A pair is told at its four corners once: by both roots at their apex, by the first at the diagonal's
      // ends.
      ++polygons[face.v[face.gen == 0 ? 0 : 1]];
      if (face.gen == 0 && static_cast<int>(r) < face.n[0])
      {
        ++polygons[face.v[1]];
        ++polygons[face.v[2]];
      }
    }
    for (int generations = 3; generations <= 6; ++generations)
    {
      Forest forest = made.forest;
      refineAll(forest, generations);
      for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
      {
        const Forest::Vertex& vertex = forest.vertices[v];
        int valence = 0;
        forest.link(v, [&](int) { ++valence; });
        if (vertex.parents[0] >= 0)
        {
          // A vertex of the generation before has not been reached by the splits that complete it.
          ++(vertex.level == generations ? newest : older)[valence];
          EXPECT_EQ(valence, vertex.level == generations ? 4 : 8);
        }
        else if (vertex.level == 1)
        {
          ++thirds[valence];
          EXPECT_EQ(valence, 6);
        }
        else
        {
          ++base[valence - 2 * polygons[v]];
          EXPECT_EQ(valence, 2 * polygons[v]);
        }
      }
    }
  }
  fact("D2_2",
    "sphere of pairs and thirds, generations 3 to 6: " + std::to_string(newest[4]) +
      " newest vertices of valence 4, " + std::to_string(older[8]) + " older of 8, " +
      std::to_string(thirds[6]) + " barycentres of 6, " + std::to_string(base[0]) +
      " base vertices of 2k, others: " +
      std::to_string(newest.size() + older.size() + thirds.size() + base.size() - 4));
}

TEST(D2_3, RefiningAtACornerStaysLocal)
{
  for (int generation : { 1, 2, 5, 10, 20, 40 })
  {
    Forest forest = quadForest(1, 1);
    for (bool more = true; more;)
    {
      more = false;
      std::vector<int> at;
      forest.star(0, [&](int f, int) { at.push_back(f); });
      for (int f : at)
      {
        if (forest.faces[f].gen < generation)
        {
          forest.refine(f, {});
          more = true;
          break;
        }
      }
    }
    EXPECT_EQ(forest.broken(), "");
    EXPECT_EQ(forest.faceCount(), 2 * generation + 2);
    if (generation == 10)
    {
      EXPECT_EQ(forest.vertexCount(), 19);
      fact("D2_3",
        "refined at a corner to generation 10: " + std::to_string(forest.faceCount()) + " faces, " +
          std::to_string(forest.vertexCount()) + " points");
    }
  }
}

namespace
{

// Random refinements, looked at one by one, then all new vertices away in random order.
void expectThereAndBack(const Mesh& mesh, unsigned seed, int refinements)
{
  std::mt19937 random(seed);
  Forest forest = baseOf(mesh);
  const Leaves base = canonicalLeaves(forest);
  const int characteristic = euler(forest), loops = boundaryLoops(forest);
  for (int i = 0; i < refinements; ++i)
  {
    int f = anyFace(forest, random);
    if (forest.faces[f].gen < 40)
    {
      forest.refine(f, {});
    }
    ASSERT_EQ(forest.broken(), "") << i;
    if (i % 16 == 0)
    {
      ASSERT_EQ(euler(forest), characteristic) << i;
      ASSERT_EQ(boundaryLoops(forest), loops) << i;
    }
  }
  const int faces = forest.faceCount();
  EXPECT_GT(faces, forest.rootCount + refinements);
  std::vector<int> order;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.vertices[v].parents[0] >= 0)
    {
      order.push_back(v);
    }
  }
  std::shuffle(order.begin(), order.end(), random);
  int welds = 0;
  for (int v : order)
  {
    if (forest.isVertex(v))
    {
      ++welds;
      ASSERT_TRUE(weldDown(forest, v));
      if (welds % 16 == 0)
      {
        ASSERT_EQ(forest.broken(), "");
      }
    }
  }
  EXPECT_TRUE(sameBytes(canonicalLeaves(forest), base));
  fact("D2_4",
    std::to_string(refinements) + " random refinements: " + std::to_string(forest.rootCount) + " to " +
      std::to_string(faces) + " faces, chi " + std::to_string(characteristic) + " and " +
      std::to_string(loops) +
      " boundary loops throughout; welded back in random order: the base byte for byte");
}

} // namespace

TEST(D2_4, RefinedAtRandomAndWeldedBack)
{
  expectThereAndBack(subdivided(octahedron()), 1, 400);
  expectThereAndBack(torus(1.0, 0.4, 9, 7), 2, 400);
  expectThereAndBack(cylinder(1.0, 2.0, 7, 3), 3, 400);
}

TEST(D2_4, MovedVerticesComeBackToTheSameConnectivity)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-0.01, 0.01);
  Forest forest = baseOf(subdivided(octahedron()));
  const Leaves base = canonicalLeaves(forest);
  for (int i = 0; i < 300; ++i)
  {
    forest.refine(anyFace(forest, random), {});
  }
  for (Forest::Vertex& v : forest.vertices)
  {
    v.position += Vector3(unit(random), unit(random), unit(random));
  }
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.vertices[v].parents[0] >= 0)
    {
      ASSERT_TRUE(weldDown(forest, v));
    }
  }
  const Leaves back = canonicalLeaves(forest);
  EXPECT_TRUE(sameBytes(back.triangles, base.triangles));
  EXPECT_TRUE(sameBytes(back.path, base.path));
  EXPECT_FALSE(sameBytes(back.points, base.points));
}

TEST(Forest, AStarGoesRoundCounterClockwiseAndEndsAtTheBoundary)
{
  Forest forest = quadForest(3, 3);
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i)
  {
    forest.refine(anyFace(forest, random), {});
  }
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    std::vector<int> link;
    forest.link(v, [&](int u) { link.push_back(u); });
    int faces = 0;
    forest.star(v, [&](int, int) { ++faces; });
    EXPECT_EQ(static_cast<int>(link.size()), faces + (forest.onBoundary(v) ? 1 : 0));
    double angle = 0.0;
    const Vector3& at = forest.vertices[v].position;
    for (std::size_t i = 0; i + (forest.onBoundary(v) ? 1 : 0) < link.size(); ++i)
    {
      const Vector3 x = forest.vertices[link[i]].position - at,
                    y = forest.vertices[link[(i + 1) % link.size()]].position - at;
      const double turn = std::atan2(x.cross(y).z(), x.dot(y));
      EXPECT_GT(turn, 0.0);
      angle += turn;
    }
    const bool edgeX = at.x() == 0.0 || at.x() == 1.0, edgeY = at.y() == 0.0 || at.y() == 1.0;
    EXPECT_EQ(forest.onBoundary(v), edgeX || edgeY);
    EXPECT_NEAR(angle, edgeX && edgeY ? pi / 2 : edgeX || edgeY ? pi : 2 * pi, 1e-12);
  }
}

TEST(Forest, RefineEdgeSplitsThatEdge)
{
  std::mt19937 random(6);
  for (const Mesh& mesh : { quadPairs(2, 2), subdivided(octahedron()) })
  {
    Forest forest = baseOf(mesh);
    for (int i = 0; i < 200; ++i)
    {
      const Forest::Face& face = forest.faces[anyFace(forest, random)];
      const int k = static_cast<int>(random() % 3), a = face.v[k], b = face.v[(k + 1) % 3];
      const int m = forest.refineEdge(a, b, {});
      ASSERT_GE(m, 0);
      EXPECT_TRUE(std::is_permutation(
        forest.vertices[m].parents, forest.vertices[m].parents + 2, &std::array<int, 2>{ a, b }[0]));
      EXPECT_LT(forest.faceWithEdge(a, b), 0);
      EXPECT_EQ(forest.refineEdge(a, b, {}), -1);
    }
    EXPECT_EQ(forest.broken(), "");
  }
}

TEST(Forest, BirthsTellWhichSlotsCameOfWhich)
{
  Forest forest = quadForest(2, 2);
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i)
  {
    const std::vector<Forest::Face> before = forest.faces;
    std::vector<Forest::Birth> births;
    forest.refine(anyFace(forest, random), {}, &births);
    EXPECT_EQ(before.size() + births.size(), forest.faces.size());
    std::vector<std::size_t> origin(forest.faces.size());
    for (const Forest::Birth& birth : births)
    {
      const std::size_t parent = birth.parent;
      origin[birth.child] = parent < before.size() ? parent : origin[parent];
      const Forest::Face &old = before[origin[birth.child]], &born = forest.faces[birth.child];
      EXPECT_EQ(born.root, old.root);
      EXPECT_EQ(born.path >> (born.gen - old.gen), old.path);
    }
  }
}

TEST(Forest, AVertexIsWeldedAfterAllThatHangsOnIt)
{
  Forest forest = quadForest(1, 1);
  refineAll(forest, 4);
  EXPECT_FALSE(weldDown(forest, 0)); // a base vertex
  EXPECT_TRUE(weldDown(forest, 4));  // of the quad's middle
  EXPECT_EQ(forest.broken(), "");
  EXPECT_EQ(forest.faceCount(), 2);
}

TEST(Forest, ATriangleIsNotSplitForEver)
{
  Forest forest = quadForest(1, 1);
  const auto drill = [&]
  {
    for (;;)
    {
      forest.refine(forest.vertices[0].face, {});
    }
  };
  EXPECT_THROW(drill(), Error);
  EXPECT_EQ(forest.broken(), "");
  EXPECT_GE(
    std::max_element(
      forest.faces.begin(), forest.faces.end(), [](const auto& a, const auto& b) { return a.gen < b.gen; })
      ->gen,
    Forest::maximumDepth);
}

TEST(Forest, NewVerticesFollowTheCurveThatBothEndsAreSnappedTo)
{
  std::vector<Vector3> circle;
  circle.reserve(400);
  for (int i = 0; i < 400; ++i)
  {
    circle.emplace_back(std::cos(2 * pi * i / 400), std::sin(2 * pi * i / 400), 0.0);
  }
  const FeatureCurves curves{ featureCurve(circle, true) };
  // One pair whose diagonal is a chord of the circle, across its first point.
  Mesh mesh = quadPairs(1, 1);
  mesh.points[0] = circle[390];
  mesh.points[3] = circle[20];
  mesh.points[1] = Vector3(2, 0, 0);
  mesh.points[2] = Vector3(0.2, 0, 0);
  const auto snapped = [&](int a, int c)
  {
    Forest forest = forestOfPairs(mesh);
    forest.vertices[0].curveId = a;
    forest.vertices[3].curveId = c;
    forest.vertices[0].curveParam = curves[0].arc[390];
    forest.vertices[3].curveParam = curves[0].arc[20];
    const int m = forest.refine(0, { &curves, {}, 0.0 });
    return forest.vertices[m];
  };
  const Forest::Vertex on = snapped(0, 0);
  EXPECT_LT((on.position - circle[5]).norm(), 1e-12);
  EXPECT_EQ(on.curveId, 0);
  EXPECT_EQ(on.moved, Forest::Placed);
  EXPECT_NEAR(on.curveParam, curves[0].arc[5], 1e-12);
  const Forest::Vertex off = snapped(0, -1);
  EXPECT_LT((off.position - 0.5 * (circle[390] + circle[20])).norm(), 1e-15);
  EXPECT_EQ(off.curveId, -1);
  EXPECT_EQ(off.moved, 0);
}

TEST(Forest, TheShorterWayRoundMayBeTooLongToFollow)
{
  // A hairpin: both ends of the edge are on the curve, which is far longer between them than the edge.
  const FeatureCurves curves{ featureCurve({ { 0, 0, 0 }, { 5, 0.5, 0 }, { 1, 1, 0 } }) };
  Forest forest = quadForest(1, 1);
  for (int v : { 0, 3 })
  {
    forest.vertices[v].curveId = 0;
    forest.vertices[v].curveParam = v == 0 ? 0.0 : curves[0].length;
  }
  const int m = forest.refine(0, { &curves, {}, 0.0 });
  EXPECT_EQ(forest.vertices[m].curveId, -1);
  EXPECT_EQ(forest.vertices[m].position, Vector3(0.5, 0.5, 0));
}

TEST(Forest, NewVerticesFollowTheSourceWhereTheirParentsLieOnIt)
{
  // The source lifts the unit square to a paraboloid; it knows roots, weights and where the mesh has the
  // point.
  const auto height = [](const Vector3& x) { return Vector3(x.x(), x.y(), x.x() * x.x() + x.y() * x.y()); };
  Mesh mesh = quadPairs(4, 4);
  for (Vector3& p : mesh.points)
  {
    p = height(p);
  }
  Forest forest = forestOfPairs(mesh);
  const Source source = [&](const SourcePlace& at)
  {
    const Triangle& t = mesh.triangles[at.root];
    Vector3 flat = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      flat += at.weights[k] * mesh.points[t[k]];
    }
    EXPECT_NEAR(flat.x(), at.position.x(), 1e-15);
    EXPECT_NEAR(flat.y(), at.position.y(), 1e-15);
    return height(flat);
  };
  const Vector3 away(0, 0, 1);
  forest.vertices[0].position += away; // no longer on the source
  std::mt19937 random(8);
  for (int i = 0; i < 300; ++i)
  {
    forest.refine(anyFace(forest, random), { nullptr, source, 1e-9 });
  }
  int sampled = 0, plain = 0;
  for (const Forest::Vertex& v : forest.vertices)
  {
    if (v.parents[0] < 0)
    {
      continue;
    }
    const Vector3 &a = forest.vertices[v.parents[0]].position, &c = forest.vertices[v.parents[1]].position;
    const bool both = (a - height(a)).norm() <= 1e-9 && (c - height(c)).norm() <= 1e-9;
    ++(both ? sampled : plain);
    EXPECT_LT((v.position - (both ? height(v.position) : Vector3(0.5 * (a + c)))).norm(), 1e-12);
  }
  EXPECT_GT(sampled, 200);
  EXPECT_GT(plain, 0);
}

TEST(Forest, BaseNormalsAreWeightedByAnglesAndGoOn)
{
  Forest forest = baseOf(octahedron());
  needBaseNormals(forest, twoThreads());
  for (const Forest::Vertex& v : forest.vertices)
  {
    if (v.level == 0)
    {
      EXPECT_LT((v.baseNormal - v.position).norm(), 1e-12);
    }
  }
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i)
  {
    const int m = forest.refine(anyFace(forest, random), {});
    const Forest::Vertex& v = forest.vertices[m];
    const Vector3 sum = forest.vertices[v.parents[0]].baseNormal + forest.vertices[v.parents[1]].baseNormal;
    EXPECT_LT((v.baseNormal - sum.normalized()).norm(), 1e-15);
  }
}
