#include "Harness/shapes.h"
#include "Mesh/part.h"
#include "Silhouette/judgement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr int around = 6; // quads across the strip
constexpr int along = 12; // and along it

// A strip of unit quads that turns by the angle along the line x = 6.
Mesh foldedStrip(double degrees)
{
  const double a = degrees * pi / 180.0;
  return gridSurface(around,
    along,
    false,
    false,
    [=](double u, double v)
    {
      const double x = v * along, beyond = std::max(x - 6.0, 0.0);
      return Vector3(std::min(x, 6.0) + beyond * std::cos(a), u * around, beyond * std::sin(a));
    });
}

std::vector<char> all(std::size_t count)
{
  return std::vector<char>(count, 1);
}

// A triangle with one angle of the given size between two sides of length 1.
void addTriangle(Mesh& mesh, double degrees)
{
  const int first = mesh.vertexCount();
  const double a = degrees * pi / 180.0;
  mesh.points.insert(
    mesh.points.end(), { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(std::cos(a), std::sin(a), 0) });
  mesh.triangles.push_back({ first, first + 1, first + 2 });
}

// A disk of radius 150 px in the middle of the picture, and its view.
const View view = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 1.0);
constexpr double radius = 150.0;

Mesh disk()
{
  constexpr int corners = 3000; // its chords stay within 1e-4 px of the circle
  Mesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  for (int i = 0; i < corners; ++i)
  {
    const double a = 2.0 * pi * i / corners;
    mesh.points.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.0);
    mesh.triangles.push_back({ 0, i + 1, (i + 1) % corners + 1 });
  }
  return mesh;
}

// The upper half of a circle round a place beside the disk's middle.
Polyline halfCircle(double r, const Vector2& shift)
{
  Polyline stroke;
  for (int i = 0; i <= 500; ++i)
  {
    const double a = pi * i / 500;
    stroke.push_back(Vector2(400, 300) + shift + r * Vector2(std::cos(a), std::sin(a)));
  }
  return stroke;
}

// The mesh with its points scaled along x and y.
Mesh scaled(const Mesh& mesh, double x, double y)
{
  Mesh result = mesh;
  for (Vector3& p : result.points)
  {
    p = Vector3(x * p[0], y * p[1], p[2]);
  }
  return result;
}

Mesh plane(int size)
{
  return gridSurface(
    size, size, false, false, [=](double u, double v) { return Vector3(u * size, v * size, 0.0); });
}

} // namespace

TEST(Judgement, AStripFoldedOverAHundredDegreesHasAFoldPerEdgeOfTheLine)
{
  for (const double degrees : { 0.0, 60.0, 99.0, -99.0 })
  {
    const Mesh strip = foldedStrip(degrees);
    EXPECT_EQ(foldedEdges(strip, buildAdjacency(strip), all(strip.points.size())), 0) << degrees;
  }
  for (const double degrees : { 101.0, -101.0, 135.0, 179.0 })
  {
    const Mesh strip = foldedStrip(degrees);
    EXPECT_EQ(foldedEdges(strip, buildAdjacency(strip), all(strip.points.size())), around) << degrees;
  }
}

TEST(Judgement, APartIsJudgedAsTheWholeIs)
{
  std::mt19937 random(5);
  const auto share = [&random] { return static_cast<double>(random() % 1001) / 1000.0; };
  int folds = 0;
  for (int round = 0; round < 20; ++round)
  {
    Mesh mesh = icosphere(3);
    for (Vector3& p : mesh.points)
    {
      p *= 0.7 + 0.6 * share();
    }
    for (int i = 0; i < 5; ++i) // edges of three triangles, of the same direction, of none
    {
      Triangle t = mesh.triangles[random() % mesh.triangles.size()];
      std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
      mesh.triangles.push_back({ t[0], t[0], t[1] });
    }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    const Vector3 middle = mesh.points[random() % mesh.points.size()];
    const double radius = 0.2 + share();
    std::vector<char> region(mesh.points.size());
    std::transform(mesh.points.begin(),
      mesh.points.end(),
      region.begin(),
      [&](const Vector3& p) { return static_cast<char>((p - middle).norm() < radius); });
    const Adjacency adjacency = buildAdjacency(mesh);
    MeshPart part({ std::vector<Vector3>(mesh.points.size(), Vector3::Zero()), mesh.triangles }, region);
    part.place(mesh);
    const Roughness rough = roughness(mesh, adjacency, region),
                    own = roughness(part.mesh, part.adjacency, part.region);
    EXPECT_EQ(foldedEdges(part.mesh, part.adjacency, part.region), foldedEdges(mesh, adjacency, region));
    EXPECT_EQ(own.meanAngle, rough.meanAngle);
    EXPECT_EQ(own.sharpShare, rough.sharpShare);
    EXPECT_LT(MeshPart(mesh, std::vector<char>(mesh.points.size(), 0)).mesh.vertexCount(), 1);
    folds += foldedEdges(mesh, adjacency, region);
  }
  EXPECT_GT(folds, 100);
}

TEST(Judgement, FoldsCountInTheRegionAndTwoRingsRoundIt)
{
  const Mesh strip = foldedStrip(120.0);
  const auto foldsOf = [&](double from, double to)
  {
    std::vector<char> region(strip.points.size(), 0);
    for (int v = 0; v < strip.vertexCount(); ++v)
    {
      const int row = v / (around + 1);
      region[v] = row >= from && row <= to;
    }
    return foldedEdges(strip, buildAdjacency(strip), region);
  };
  EXPECT_EQ(foldsOf(6, 6), around);
  EXPECT_EQ(foldsOf(0, 5), around);
  EXPECT_EQ(foldsOf(0, 3), 0); // three rings off
  EXPECT_EQ(foldsOf(9, 12), 0);
  EXPECT_EQ(foldsOf(20, 21), 0); // nothing chosen
}

TEST(Judgement, AnglesUnderThirtyDegreesAreNarrow)
{
  Mesh mesh;
  for (const double degrees : { 60.0, 31.0, 29.0, 119.0, 121.0 })
  {
    addTriangle(mesh, degrees); // the last has angles of 29.5 degrees at its base
  }
  EXPECT_DOUBLE_EQ(narrowShare(mesh, { 1, 1, 1, 1, 1 }), 2.0 / 5.0);
  EXPECT_DOUBLE_EQ(narrowShare(mesh, { 1, 1, 0, 1, 0 }), 0.0);
  EXPECT_DOUBLE_EQ(narrowShare(mesh, { 0, 1, 1, 0, 0 }), 0.5);
  EXPECT_DOUBLE_EQ(narrowShare(mesh, { 0, 0, 0, 0, 0 }), 0.0);
}

TEST(Judgement, RemeshingIsWantedWhereEdgesGrowByHalf)
{
  const Mesh before = plane(10);
  const std::vector<char> region = all(before.points.size());
  EXPECT_FALSE(wantsRemeshing(before, before, region));
  EXPECT_FALSE(wantsRemeshing(before, scaled(before, 1.5 - 1e-9, 1.5 - 1e-9), region));
  EXPECT_TRUE(wantsRemeshing(before, scaled(before, 1.5 + 1e-9, 1.5 + 1e-9), region));
  // Only triangles wholly in the region are asked.
  EXPECT_FALSE(wantsRemeshing(before, scaled(before, 3.0, 3.0), std::vector<char>(region.size(), 0)));
  // One percent of the edges may be longer: of 600 corners' edges a pulled corner point of one triangle
  // stretches two, an inner point twelve.
  Mesh pulled = before;
  pulled.points[10] += Vector3(3, -3, 0); // of the one triangle at the corner (10, 0)
  EXPECT_FALSE(wantsRemeshing(before, pulled, region));
  pulled = before;
  pulled.points[60][2] += 3.0;
  EXPECT_TRUE(wantsRemeshing(before, pulled, region));
}

TEST(Judgement, RemeshingIsWantedWhereTrianglesAreSqueezed)
{
  const Mesh before = plane(10); // angles of 45 degrees
  const std::vector<char> region = all(before.points.size());
  EXPECT_FALSE(wantsRemeshing(before, scaled(before, 1.0, 0.6), region)); // 31 degrees
  EXPECT_TRUE(wantsRemeshing(before, scaled(before, 1.0, 0.55), region)); // 29 degrees
}

TEST(Judgement, TheOutlineOfADiskIsAsFarAsItsCircle)
{
  const Mesh mesh = disk();
  // Beyond 50 px the whole picture is looked at.
  for (const double distance : { 0.0, 7.0, -7.0, 49.0, 80.0 })
  {
    const OutlineError error = outlineError({ mesh, view, halfCircle(radius + distance, Vector2::Zero()) });
    EXPECT_NEAR(error.mean, std::abs(distance), 0.01) << distance;
    EXPECT_NEAR(error.worst, std::abs(distance), 0.02) << distance;
  }
}

TEST(Judgement, WhatIsMissedBesideTheDiskIsWhatLiesOutside)
{
  const Mesh mesh = disk();
  for (const double distance : { -30.0, -7.0, 7.0, 80.0 })
  {
    const double missed = missedBeside({ mesh, view, halfCircle(radius + distance, Vector2::Zero()) });
    EXPECT_NEAR(missed, std::max(distance, 0.0), 0.02) << distance;
  }
}

TEST(Judgement, AShiftedCircleIsMeasuredOverItsMiddle)
{
  const Mesh mesh = disk();
  const Vector2 shift(0.0, 12.0);
  Polyline stroke = halfCircle(radius, shift);
  double mean = 0.0, worst = 0.0;
  int counted = 0;
  for (int i = 100; i <= 400; ++i)
  {
    const double distance = std::abs((stroke[i] - Vector2(400, 300)).norm() - radius);
    mean += distance;
    worst = std::max(worst, distance);
    ++counted;
  }
  EXPECT_NEAR(worst, 12.0, 1e-9); // where the circle was shifted to
  const OutlineError error = outlineError({ mesh, view, stroke });
  EXPECT_NEAR(error.mean, mean / counted, 0.05);
  EXPECT_NEAR(error.worst, worst, 0.02);
  // What its ends do does not count.
  for (int i = 0; i < 60; ++i)
  {
    stroke[i][0] += 4.0;
    stroke[500 - i][0] -= 4.0;
  }
  EXPECT_NEAR(outlineError({ mesh, view, stroke }).worst, worst, 0.02);
}

// A ball before a disk twice as large: its outline is inside the disk's.
TEST(Judgement, ASilhouetteInsideTheOutlineIsWhatItsStrokeIsJudgedBy)
{
  Mesh mesh = disk();
  const int first = mesh.vertexCount();
  double across = 0.0;
  for (const Vector3& p : mesh.points)
  {
    across = std::max(across, p.norm());
  }
  Mesh ball = icosphere(5, 0.5 * across);
  mesh = joined(mesh, ball, Vector3::Zero());
  std::vector<char> region(mesh.points.size(), 0);
  std::fill(region.begin() + first, region.end(), 1);
  const auto lines = regionContours(mesh, buildAdjacency(mesh), vertexNormals(mesh), region, view);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].closed);
  const Polyline stroke = halfCircle(0.5 * radius + 4.0, Vector2::Zero());
  EXPECT_GT(outlineError({ mesh, view, stroke }).mean, 0.4 * radius);
  EXPECT_NEAR(outlineError({ mesh, view, stroke }, lines).mean, 4.0, 0.2);
  // Half of the ball: the line ends where the region does.
  for (int v = first; v < mesh.vertexCount(); ++v)
  {
    region[v] = mesh.points[v][0] > 0.0;
  }
  for (const OutlineLoop& line :
    regionContours(mesh, buildAdjacency(mesh), vertexNormals(mesh), region, view))
  {
    EXPECT_FALSE(line.closed);
    for (const Vector2& p : line.points)
    {
      EXPECT_GT(p[0], 395.0);
    }
  }
}

TEST(Judgement, ASecondDeformationIsBetterWhereItIsNearerOrLessFolded)
{
  const Judgement first{ { 1.0, 3.0 }, 2 };
  const auto better = [](double mean, double worst, int folds, const Judgement& than) {
    return Judgement{ { mean, worst }, folds }.betterThan(than);
  };
  EXPECT_FALSE(first.betterThan(first));
  EXPECT_TRUE(better(1.0, 3.0, 1, first));  // fewer folds
  EXPECT_TRUE(better(1.0, 2.9, 10, first)); // nearer, with folds that are tolerable twice over
  EXPECT_FALSE(better(1.0, 2.9, 11, first));
  EXPECT_FALSE(better(1.1, 2.9, 2, first)); // the mean has grown
  EXPECT_FALSE(better(1.0, 3.1, 0, first)); // the first's folds are few enough

  const Judgement folded{ { 1.0, 3.0 }, 20 };
  EXPECT_TRUE(better(1.5, 3.0, 19, folded));
  EXPECT_FALSE(better(1.5, 3.1, 0, folded));
  EXPECT_FALSE(better(1.5, 3.0, 20, folded));
  EXPECT_TRUE(better(0.9, 2.9, 20, folded));
  const Judgement near{ { 0.5, 1.0 }, 20 };
  EXPECT_TRUE(better(1.5, 2.0, 19, near)); // up to 2 px for fewer folds
  EXPECT_FALSE(better(1.5, 2.1, 0, near));
}

TEST(Judgement, ARemeshedResultIsKeptWhereItIsAsGood)
{
  const Judgement plain{ { 1.0, 3.0 }, 2 };
  const auto kept = [&](double mean, double worst, int folds) {
    return Judgement{ { mean, worst }, folds }.keptAgainst(plain);
  };
  EXPECT_TRUE(plain.keptAgainst(plain));
  EXPECT_TRUE(kept(1.5, 3.5, 2)); // half a pixel off is as good
  EXPECT_FALSE(kept(1.6, 3.0, 2));
  EXPECT_FALSE(kept(1.0, 3.6, 2));
  EXPECT_FALSE(kept(1.0, 3.0, 3)); // one more fold is not
  EXPECT_TRUE(kept(1.0, 2.5, 5));  // half a pixel nearer, with folds that are tolerable
  EXPECT_FALSE(kept(1.0, 2.5, 6));
  EXPECT_FALSE(kept(1.0, 2.6, 5));
  EXPECT_FALSE(kept(1.1, 2.5, 5));
}

TEST(Judgement, WhatIsTurnedInsideOutIsWorse)
{
  const auto shown = [](double worst, double back) { return Judgement{ { 1.0, worst }, 2, {}, back }; };
  EXPECT_TRUE(shown(3.0, 0.002).keptAgainst(shown(3.0, 0.0)));
  EXPECT_FALSE(shown(1.0, 0.003).keptAgainst(shown(3.0, 0.0)));
  EXPECT_TRUE(shown(3.0, 0.003).keptAgainst(shown(3.0, 0.003)));
}

TEST(Judgement, ARemeshedResultThatIsRougherIsNotKept)
{
  const Judgement plain{ { 1.0, 3.0 }, 2, { 8.0, 0.02 } };
  const auto kept = [&](double worst, double meanAngle, double sharpShare) {
    return Judgement{ { 1.0, worst }, 2, { meanAngle, sharpShare } }.keptAgainst(plain);
  };
  EXPECT_TRUE(kept(3.0, 10.9, 0.029));
  EXPECT_FALSE(kept(3.0, 11.1, 0.02));
  EXPECT_FALSE(kept(3.0, 8.0, 0.031));
  EXPECT_FALSE(kept(1.0, 11.1, 0.02)); // however near to the stroke
}
