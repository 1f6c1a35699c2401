// Facts of editors.md, section 13 (retriangulation), with edits that are known as functions.
#include "Remesh/retriangulate.h"

#include "Harness/enclosures.h"
#include "Harness/threads.h"
#include "Remesh/keep_apart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A scene with its region and, at each vertex, its share of the way from the reference to the boundary.
struct Edited
{
  Enclosure scene;
  std::vector<char> region;
  std::vector<double> shares;
  double meanEdge = 0.0;
  Movement movement;
  std::vector<Vector3> moved;
  bool asFloats = false;

  Edited(Enclosure of, const Movement& motion)
    : scene(std::move(of))
    , movement(motion)
  {
    const Mesh& mesh = this->scene.mesh;
    // Inside is what the boundary's edges part from the first vertex.
    const Adjacency adjacency = buildAdjacency(mesh);
    this->region.assign(mesh.points.size(), 0);
    for (const int v : this->scene.boundary)
    {
      this->region[v] = 1;
    }
    std::vector<int> front{ this->scene.reference.front() };
    this->region[front[0]] = 2;
    for (std::size_t i = 0; i < front.size(); ++i)
    {
      for (const int n : adjacency.vertexVertices[front[i]])
      {
        if (this->region[n] == 0)
        {
          this->region[n] = 2;
          front.push_back(n);
        }
      }
    }
    this->shares = sharesOf(this->scene, this->region);
    for (const MeshEdge& e : adjacency.edges)
    {
      this->meanEdge +=
        (mesh.points[e.v0] - mesh.points[e.v1]).norm() / static_cast<double>(adjacency.edges.size());
    }
    this->moved = this->movement(mesh.points, this->shares);
  }
  RetriangulateInput input() const
  {
    return { this->scene.mesh,
      this->moved,
      this->region,
      { this->scene.reference, this->scene.boundary },
      this->meanEdge,
      this->asFloats };
  }
  Retriangulated run(const Context& context = {}) const
  {
    return retriangulateEdit(this->input(), { 1, this->shares, this->movement }, context);
  }
  Mesh before() const { return { this->moved, this->scene.mesh.triangles }; }
};

double falloff(double share)
{
  return 1.0 - (3.0 * share * share - 2.0 * share * share * share);
}

// A drag of what is at the reference curve, less by the share of the way to the boundary.
Movement drag(const Vector3& way)
{
  return [way](const std::vector<Vector3>& points, const std::vector<double>& shares)
  {
    std::vector<Vector3> result;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      result.push_back(shares[i] >= 1.0 ? points[i] : Vector3(points[i] + falloff(shares[i]) * way));
    }
    return result;
  };
}

std::vector<char> regionOf(const Retriangulated& result, const std::vector<char>& region)
{
  std::vector<char> labels;
  auto mix = result.mixes.begin();
  for (const int source : result.pointSource)
  {
    if (source >= 0)
    {
      labels.push_back(region[source]);
      continue;
    }
    labels.push_back(1);
    for (const auto& [v, weight] : *mix)
    {
      labels.back() = weight > 0.0 && region[v] == 2 ? char(2) : labels.back();
    }
    ++mix;
  }
  return labels;
}

struct Look // at the faces with a vertex strictly inside
{
  double angle = 0.0;    // 5th percentile of the smallest angles [degrees]
  double dihedral = 0.0; // 95th percentile between faces' normals [degrees]
  double longest = 0.0;  // edge between vertices strictly inside
  int faces = 0;
};

double percentile(std::vector<double>& values, double share)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Look lookAt(const Mesh& mesh, const std::vector<char>& region)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  Look look;
  std::vector<double> angles, turns;
  std::vector<char> inside;
  for (const Triangle& t : mesh.triangles)
  {
    inside.push_back(region[t[0]] == 2 || region[t[1]] == 2 || region[t[2]] == 2);
    if (inside.back())
    {
      angles.push_back(smallestAngle(mesh, t));
      ++look.faces;
    }
  }
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    const int* sides = adjacency.trianglesBegin(static_cast<int>(e));
    if (edge.triangleCount == 2 && inside[sides[0]] && inside[sides[1]])
    {
      const Vector3 a = facetNormal(mesh, sides[0]), b = facetNormal(mesh, sides[1]);
      turns.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / pi);
      if (region[edge.v0] == 2 && region[edge.v1] == 2)
      {
        look.longest = std::max(look.longest, (mesh.points[edge.v0] - mesh.points[edge.v1]).norm());
      }
    }
  }
  look.angle = percentile(angles, 0.05);
  look.dihedral = percentile(turns, 0.95);
  return look;
}

void expectSound(const Edited& edited, const Retriangulated& result)
{
  EXPECT_TRUE(isManifold(result.mesh));
  EXPECT_EQ(eulerNumber(result.mesh.triangles), eulerNumber(edited.scene.mesh.triangles));
  ASSERT_EQ(result.pointSource.size(), result.mesh.points.size());
  ASSERT_EQ(result.triangleSource.size(), result.mesh.triangles.size());
  // Outside every point and face is there, in its order.
  std::vector<int> left;
  for (std::size_t v = 0; v < result.pointSource.size(); ++v)
  {
    const int source = result.pointSource[v];
    if (source >= 0)
    {
      EXPECT_EQ(result.mesh.points[v], edited.moved[source]);
      if (edited.region[source] != 2)
      {
        left.push_back(source);
      }
    }
  }
  std::vector<int> expected;
  for (int v = 0; v < edited.scene.mesh.vertexCount(); ++v)
  {
    if (edited.region[v] != 2)
    {
      expected.push_back(v);
    }
  }
  EXPECT_EQ(left, expected);
  for (const auto& mix : result.mixes)
  {
    double sum = 0.0;
    for (const auto& [v, weight] : mix)
    {
      sum += weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
  }
  // Curves are chains of edges with the points that they had.
  const std::vector<int>* const chains[2] = { &edited.scene.reference, &edited.scene.boundary };
  for (int i = 0; i < 2; ++i)
  {
    std::vector<int> chain;
    std::size_t known = 0;
    for (const CurveVertex& v : result.curves[i])
    {
      chain.push_back(v.vertex);
      if (v.t == 0.0)
      {
        EXPECT_EQ(result.pointSource[v.vertex], (*chains[i])[known++]);
      }
    }
    EXPECT_EQ(known, chains[i]->size());
    EXPECT_TRUE(isChainOfEdges(result.mesh, chain));
  }
}

// Halfway from the reference to the boundary of a sheet.
double halfWidth(int reach)
{
  return std::sqrt(0.75) * reach;
}

// A limb drawn out of a sphere: the region from z = 0.5 up as an icosphere has it, ragged.
Enclosure roughCap(int levels)
{
  Enclosure scene;
  scene.mesh = icosphere(levels);
  const Mesh& mesh = scene.mesh;
  const Adjacency adjacency = buildAdjacency(mesh);
  std::vector<int> next(mesh.points.size(), -1);
  const auto inside = [&](int t)
  {
    const Triangle& c = mesh.triangles[t];
    return mesh.points[c[0]][2] + mesh.points[c[1]][2] + mesh.points[c[2]][2] > 1.5;
  };
  int start = -1;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; inside(t) && k < 3; ++k)
    {
      const int* sides = adjacency.trianglesBegin(adjacency.triangleEdges[t][k]);
      if (!inside(sides[0] == t ? sides[1] : sides[0]))
      {
        start = mesh.triangles[t][k];
        next[start] = mesh.triangles[t][(k + 1) % 3];
      }
    }
  }
  scene.boundary.push_back(start);
  do
  {
    scene.boundary.push_back(next[scene.boundary.back()]);
  } while (scene.boundary.back() != start);
  // From the vertex nearest to one place, always to the neighbour nearest to the next.
  const auto nearestTo = [&](const Vector3& place)
  {
    return static_cast<int>(
      std::min_element(mesh.points.begin(),
        mesh.points.end(),
        [&](const Vector3& a, const Vector3& b) { return (a - place).norm() < (b - place).norm(); }) -
      mesh.points.begin());
  };
  const Vector3 from = Vector3(-0.4, 0.03, 1).normalized(), to = Vector3(0.4, 0.03, 1).normalized();
  scene.reference.push_back(nearestTo(from));
  for (const int goal = nearestTo(to); scene.reference.back() != goal;)
  {
    const int v = scene.reference.back();
    scene.reference.push_back(*std::min_element(adjacency.vertexVertices.begin(v),
      adjacency.vertexVertices.end(v),
      [&](int a, int b)
      { return (mesh.points[a] - mesh.points[goal]).norm() < (mesh.points[b] - mesh.points[goal]).norm(); }));
  }
  return scene;
}

} // namespace

TEST(B11_2, ByCurvatureAFlatEvenRegionStays)
{
  const Edited still(sheet(10), drag(Vector3::Zero()));
  const Retriangulated result = retriangulateByCurvature(still.input(), {});
  EXPECT_EQ(result.splits + result.collapses + result.flips, 0);
  EXPECT_EQ(result.mesh.points, still.scene.mesh.points);
  EXPECT_EQ(result.mesh.triangles, still.scene.mesh.triangles);

  // A region whose boundary has edges of twelve mean edges: what is beside them cannot be halved for ever.
  Enclosure coarse = sheet(2);
  for (Vector3& p : coarse.mesh.points)
  {
    p *= 12.0;
  }
  Edited fan(coarse, drag(Vector3::Zero()));
  fan.meanEdge = 1.0;
  const Retriangulated filled = retriangulateByCurvature(fan.input(), {});
  expectSound(fan, filled);
  EXPECT_LT(filled.mesh.triangleCount(), 20000);
  EXPECT_GT(filled.splits, 10);
  fact("B11_2",
    "a flat even region: 0 operations; beside edges of 12 mean edges it ends after " +
      std::to_string(filled.splits) + " splits");
}

TEST(B11_2, ByCurvatureRoundPlacesGetFinerAndFlatOnesCoarser)
{
  const Edited sphere(roughCap(3), drag(Vector3(0, 0, 0.3)));
  const Retriangulated result = retriangulateByCurvature(sphere.input(), {});
  expectSound(sphere, result);
  EXPECT_GT(result.splits, 0);
  // A sheet of a third of the mean edge is made coarser.
  Edited fine(sheet(12), drag(Vector3::Zero()));
  fine.meanEdge = 3.0;
  const Retriangulated coarser = retriangulateByCurvature(fine.input(), {});
  expectSound(fine, coarser);
  EXPECT_GT(coarser.collapses, 50);
  EXPECT_EQ(coarser.splits, 0);
}

TEST(B11_3, WithoutAMotionNothingChanges)
{
  for (const Enclosure& scene : { sheet(10), ringedSphere(24, 32), roughCap(4) })
  {
    const Edited still(scene, drag(Vector3::Zero()));
    const Retriangulated result = still.run();
    EXPECT_EQ(result.splits + result.collapses + result.flips, 0);
    EXPECT_EQ(result.mesh.points, scene.mesh.points);
    EXPECT_EQ(result.mesh.triangles, scene.mesh.triangles);
    EXPECT_TRUE(result.mixes.empty());
    expectSound(still, result);
    // Nor does a motion that nothing is stretched by.
    const Motion motion =
      motionBetween(scene.mesh, buildAdjacency(scene.mesh), scene.mesh.points, twoThreads());
    const Retriangulated known = retriangulateEdit(still.input(), motion, {});
    EXPECT_EQ(known.splits + known.collapses + known.flips, 0);
    EXPECT_EQ(known.mesh.points, scene.mesh.points);
  }
  fact("B11_3", "without a motion: 0 operations, points and triangles bit for bit, of three meshes");
}

TEST(B11_4, ADragLeavesEvenTriangles)
{
  struct Case
  {
    const char* name;
    Enclosure scene;
    double height;
    double least; // of the 5th percentile of the smallest angles
  };
  const Case cases[] = { { "sheet 12", sheet(12), 1.5 * halfWidth(12), 24.0 },
    { "sheet 24", sheet(24), 1.5 * halfWidth(24), 24.0 },
    { "ball 5k", roughCap(4), 1.5, 24.0 },
    { "ball 20k", roughCap(5), 1.5, 24.0 },
    { "ball 1k", roughCap(3), 1.5, 19.0 } };
  std::string figures;
  for (const Case& each : cases)
  {
    SCOPED_TRACE(each.name);
    const Edited edited(each.scene, drag(Vector3(0, 0, each.height)));
    const std::clock_t begin = std::clock();
    const Retriangulated result = edited.run();
    const double took = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    expectSound(edited, result);
    const Look before = lookAt(edited.before(), edited.region);
    const Look after = lookAt(result.mesh, regionOf(result, edited.region));
    std::cout << each.name << ": angle " << before.angle << " -> " << after.angle << ", dihedral "
              << before.dihedral << " -> " << after.dihedral << ", longest "
              << before.longest / edited.meanEdge << " -> " << after.longest / edited.meanEdge << ", faces "
              << before.faces << " -> " << after.faces << ", " << result.splits << " splits, "
              << result.collapses << " collapses, " << result.flips << " flips, "
              << took / after.faces * 1000.0 << " ms per 1000 faces" << std::endl;
    EXPECT_GE(after.angle, each.least);
    EXPECT_GT(after.angle, before.angle);
    EXPECT_LT(after.dihedral, before.dihedral);
    EXPECT_LE(after.longest, 4.0 / 3.0 * edited.meanEdge * (1.0 + 1e-9));
    figures += std::string(each.name) + ": angles p5 " + std::to_string(before.angle) + " to " +
               std::to_string(after.angle) + ", dihedral p95 " + std::to_string(before.dihedral) + " to " +
               std::to_string(after.dihedral) + ", longest edge " +
               std::to_string(after.longest / edited.meanEdge) + " mean edges; ";
  }
  fact("B11_4", figures.substr(0, figures.size() - 2));
}

// Edges whose faces turn by over 120 degrees.
int foldsIn(const Mesh& mesh)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  int folds = 0;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
  {
    const int* sides = adjacency.trianglesBegin(static_cast<int>(e));
    folds += adjacency.edges[e].triangleCount == 2 &&
             facetNormal(mesh, sides[0]).dot(facetNormal(mesh, sides[1])) < -0.5;
  }
  return folds;
}

TEST(Retriangulate, WhereAnEditFoldsNothingNewTrianglesFoldNothing)
{
  // Triangles of all shapes, over which a drag stretches and bends some edges far more than those beside
  // them.
  int found = 0;
  for (const double narrow : { 1.0, 0.5, 0.25 })
  {
    Enclosure scene = sheet(12);
    std::vector<char> isHeld(scene.mesh.points.size(), 0);
    for (const std::vector<int>* curve : { &scene.reference, &scene.boundary })
    {
      for (const int v : *curve)
      {
        isHeld[v] = 1;
      }
    }
    for (int v = 0; v < scene.mesh.vertexCount(); ++v)
    {
      const double shift = isHeld[v] ? 0.0 : 0.35;
      scene.mesh.points[v] += shift * Vector3(std::sin(12.9898 * v), std::sin(78.233 * v), 0.0);
      scene.mesh.points[v][1] *= narrow;
    }
    for (const double height : { 4.0, 8.0, 12.0, 16.0 })
    {
      for (const double steep : { 1.0, 3.0, 9.0 })
      {
        const Movement motion = [&](const std::vector<Vector3>& points, const std::vector<double>& shares)
        {
          std::vector<Vector3> result;
          for (std::size_t i = 0; i < points.size(); ++i)
          {
            const double weight = shares[i] >= 1.0 ? 0.0 : std::pow(falloff(shares[i]), steep);
            result.emplace_back(
              weight == 0.0 ? points[i] : Vector3(points[i] + weight * height * Vector3(0.5, 0, 1)));
          }
          return result;
        };
        const Edited edited(scene, motion);
        const Retriangulated result = edited.run();
        const int before = foldsIn(edited.before()), after = foldsIn(result.mesh);
        EXPECT_LE(after, before) << narrow << ", " << height << ", " << steep;
        found += before == 0;
      }
    }
  }
  EXPECT_GT(found, 6);
}

TEST(Retriangulate, ValuesAreMixedAsPlacesAre)
{
  const Edited edited(sheet(12), drag(Vector3(0, 0, halfWidth(12))));
  const Retriangulated result = edited.run();
  // x and y do not change in this drag: the mix of the input's gives them where nothing was relaxed onto the
  // moved surface's facets, and nearly so elsewhere.
  auto mix = result.mixes.begin();
  double worst = 0.0;
  for (int v = 0; v < result.mesh.vertexCount(); ++v)
  {
    if (result.pointSource[v] < 0)
    {
      Vector3 rest = Vector3::Zero();
      for (const auto& [u, weight] : *mix)
      {
        rest += weight * edited.scene.mesh.points[u];
      }
      worst = std::max(worst, (rest.head<2>() - result.mesh.points[v].head<2>()).norm());
      ++mix;
    }
  }
  EXPECT_EQ(mix, result.mixes.end());
  EXPECT_LT(worst, 1e-9);
}

TEST(Retriangulate, WildDragsLeaveSoundMeshes)
{
  // Sideways over the boundary, down through the sheet's far side, to nothing, and all to one point.
  const Movement toAPoint = [](const std::vector<Vector3>& points, const std::vector<double>& shares)
  {
    std::vector<Vector3> result;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double weight = shares[i] >= 1.0 ? 0.0 : falloff(shares[i]);
      result.push_back(weight == 0.0 ? points[i] : Vector3((1.0 - weight) * points[i]));
    }
    return result;
  };
  for (const auto& [scene, size] : { std::make_pair(sheet(10), 10.0), std::make_pair(roughCap(3), 1.0) })
  {
    for (const Movement& motion : { drag(size * Vector3(3, 0, 0)),
           drag(size * Vector3(2, 1, -4)),
           drag(size * Vector3(0, 0, 1e-4)),
           drag(size * Vector3(0, 0, 6)),
           toAPoint })
    {
      const Edited edited(scene, motion);
      expectSound(edited, edited.run());
      expectSound(edited, retriangulateByCurvature(edited.input(), {}));
    }
  }
}

// Places that are different numbers, but as floats the same.
TEST(Retriangulate, VerticesAtOnePlaceAreMovedApart)
{
  const Mesh square{
    { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.5, 1 }, { 0.5, 0.5 + 1e-9, 1 } },
    { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 5 }, { 3, 0, 5 }, { 4, 2, 5 }, { 0, 4, 5 } }
  };
  const std::vector<char> movable{ 0, 0, 0, 0, 0, 1 };
  Mesh apart = square;
  EXPECT_EQ(keepApart(apart, movable, false), 0);
  EXPECT_EQ(apart.points, square.points);
  EXPECT_EQ(keepApart(apart, movable, true), 0);
  EXPECT_EQ(std::vector<Vector3>(apart.points.begin(), apart.points.end() - 1),
    std::vector<Vector3>(square.points.begin(), square.points.end() - 1));
  EXPECT_NE(apart.points[5].cast<float>(), apart.points[4].cast<float>());
  EXPECT_LT((apart.points[5] - square.points[5]).norm(), 1e-4);
  EXPECT_EQ(apart.points[5].cast<float>().cast<double>(), apart.points[5]);
  // Where none may move they stay, and it is said.
  Mesh fixed = square;
  EXPECT_EQ(keepApart(fixed, std::vector<char>(6, 0), true), 0); // nothing that moved, nothing to look for
  fixed.points[5] = fixed.points[4];
  const Mesh before = fixed;
  EXPECT_EQ(keepApart(fixed, { 1, 0, 0, 0, 0, 0 }, true), 0);
  EXPECT_EQ(fixed.points, before.points);
  Mesh heap{ std::vector<Vector3>(3, Vector3(1, 2, 3)), { { 0, 1, 2 } } };
  EXPECT_EQ(keepApart(heap, { 1, 1, 1 }, true), 2);
}

TEST(Retriangulate, WhatWouldTakeTooManyTrianglesIsRefused)
{
  const Edited edited(sheet(10), drag(Vector3(0, 0, 1e7)));
  for (const bool byEdit : { true, false })
  {
    try
    {
      byEdit ? edited.run() : retriangulateByCurvature(edited.input(), {});
      ADD_FAILURE();
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), Failure::Torn);
      EXPECT_NE(std::string(error.what()).find("smaller edit"), std::string::npos);
    }
  }
}

TEST(Retriangulate, SameForAnyNumberOfThreads)
{
  const Edited edited(roughCap(4), drag(Vector3(0.2, 0, 1)));
  const Retriangulated one = edited.run(), two = edited.run(twoThreads());
  EXPECT_EQ(one.mesh.points, two.mesh.points);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
  EXPECT_EQ(retriangulateByCurvature(edited.input(), {}).mesh.points,
    retriangulateByCurvature(edited.input(), twoThreads()).mesh.points);
}

TEST(Retriangulate, AKnownMotionIsNearlyTheFunction)
{
  // Of the drag's own function and of the motion that two meshes show.
  const Edited edited(sheet(24), drag(Vector3(0, 0, halfWidth(24))));
  const Motion motion =
    motionBetween(edited.scene.mesh, buildAdjacency(edited.scene.mesh), edited.moved, twoThreads());
  const std::vector<Vector3> again = motion.movement(edited.scene.mesh.points, motion.values);
  for (std::size_t v = 0; v < again.size(); ++v)
  {
    EXPECT_LT((again[v] - edited.moved[v]).norm(), 1e-9);
  }
  const Retriangulated known = retriangulateEdit(edited.input(), motion, {});
  expectSound(edited, known);
  const Retriangulated exact = edited.run();
  EXPECT_NEAR(known.mesh.triangleCount(), exact.mesh.triangleCount(), 0.1 * exact.mesh.triangleCount());
}

TEST(Retriangulate, RefusesAndCancels)
{
  Edited edited(sheet(12), drag(Vector3(0, 0, 9)));
  Context stopped;
  stopped.cancelled = [] { return true; };
  EXPECT_THROW(edited.run(stopped), Error);
  EXPECT_THROW(retriangulateByCurvature(edited.input(), stopped), Error);
  edited.meanEdge = 0.0;
  try
  {
    edited.run();
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadRegion);
  }
}
