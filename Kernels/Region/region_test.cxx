#include "Harness/shapes.h"
#include "Region/border.h"
#include "Region/cut.h"
#include "Region/grow.h"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>
#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Two balls of radius 1 joined by a neck of radius 0.25 at x = 0: a surface of revolution.
Mesh dumbbell(int around, int along)
{
  const auto radius = [](double x)
  { return std::max(0.25, std::sqrt(std::max(0.0, 1.0 - (std::abs(x) - 1.2) * (std::abs(x) - 1.2)))); };
  Mesh mesh = gridSurface(around,
    along,
    true,
    false,
    [&](double u, double v)
    {
      const double x = 2.15 * (2.0 * v - 1.0);
      const double r = radius(x);
      return Vector3(x, r * std::cos(2 * pi * u), r * std::sin(2 * pi * u));
    });
  for (const int end : { 0, along }) // close the ends
  {
    const int pole = mesh.vertexCount();
    mesh.points.push_back({ end == 0 ? -2.2 : 2.2, 0, 0 });
    for (int i = 0; i < around; ++i)
    {
      const int a = end * around + i, b = end * around + (i + 1) % around;
      mesh.triangles.push_back(end == 0 ? Triangle{ pole, b, a } : Triangle{ pole, a, b });
    }
  }
  return mesh;
}

std::vector<char> where(const Mesh& mesh, const std::function<bool(const Vector3&)>& test)
{
  std::vector<char> flags(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), flags.begin(), test);
  return flags;
}

} // namespace

namespace
{

void expectTheNeck(const Mesh& mesh)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<Vector3> normals = vertexNormals(mesh);
  ASSERT_GT(normals[mesh.vertexCount() / 4].dot(mesh.points[mesh.vertexCount() / 4]), 0.0);
  const std::vector<double> diameter(mesh.points.size(), 0.6);
  const std::vector<char> seeds = where(mesh, [](const Vector3& p) { return p[0] > 1.9 && p[2] > 0; });
  for (const double border : { 0.55, -0.55 })
  {
    const std::vector<char> region = where(mesh,
      [border](const Vector3& p) { return p[0] > border + 0.08 * std::sin(5 * std::atan2(p[1], p[2])); });
    const std::vector<char> moved =
      cutAtJunction(mesh, adjacency, normals, findParts(mesh, adjacency), diameter, seeds, region);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (mesh.points[v][0] > 0.35)
      {
        EXPECT_TRUE(moved[v]) << mesh.points[v].transpose();
      }
      if (mesh.points[v][0] < -0.35)
      {
        EXPECT_FALSE(moved[v]) << mesh.points[v].transpose();
      }
    }
  }
}

} // namespace

TEST(Cut, MovesABorderToTheNeckFromEitherSide)
{
  expectTheNeck(dumbbell(48, 96));
}

TEST(Cut, AFineMeshIsCutInTwoStepsAtTheSamePlace)
{
  expectTheNeck(dumbbell(192, 384)); // over 20000 triangles in the band
}

TEST(Cut, APatchWithNoPlaceToCutStaysAsItIs)
{
  // On a ball every closed border can shrink; it must not shrink to the seeds.
  const Mesh mesh = icosphere(4);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<char> region = where(mesh, [](const Vector3& p) { return p[2] > 0.8; });
  const std::vector<char> seeds = where(mesh, [](const Vector3& p) { return p[2] > 0.99; });
  const std::vector<double> diameter(mesh.points.size(), 1.8);
  const std::vector<char> moved =
    cutAtJunction(mesh, adjacency, vertexNormals(mesh), findParts(mesh, adjacency), diameter, seeds, region);
  const auto size = [](const std::vector<char>& flags) { return std::count(flags.begin(), flags.end(), 1); };
  EXPECT_GE(2 * size(moved), size(region));
  for (std::size_t v = 0; v < seeds.size(); ++v)
  {
    EXPECT_LE(seeds[v], moved[v]);
  }
}

TEST(Bridges, ALimbBehindANarrowBridgeIsNotMeant)
{
  // On a sheet two strips, x < 1 and x > 1.4, joined between them where |y - 2| is less than half the
  // bridge's width.
  const Mesh mesh =
    gridSurface(96, 160, false, false, [](double u, double v) { return Vector3(2.4 * u, 4.0 * v, 0.0); });
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<double> diameter(mesh.points.size(), 0.8);
  const auto strips = [](double bridge)
  {
    return [bridge](const Vector3& p)
    { return p[1] > 0.5 && p[1] < 3.5 && (p[0] < 1.0 || p[0] > 1.4 || std::abs(p[1] - 2.0) < bridge / 2); };
  };
  const std::vector<char> seeds =
    where(mesh, [](const Vector3& p) { return p[0] < 0.5 && std::abs(p[1] - 1.5) < 0.2; });
  const std::vector<char> narrow = where(mesh, strips(0.4));
  const std::vector<char> cut =
    cutBridges(mesh, adjacency, findParts(mesh, adjacency), diameter, seeds, narrow);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const double x = mesh.points[v][0];
    if (x < 1.0)
    {
      EXPECT_EQ(cut[v], narrow[v]) << v;
    }
    else if (x > 1.4)
    {
      EXPECT_FALSE(cut[v]) << v;
    }
  }
  const std::vector<char> wide =
    where(mesh, strips(1.6)); // wider than the strip of 0.4 taken off on either side
  EXPECT_EQ(cutBridges(mesh, adjacency, findParts(mesh, adjacency), diameter, seeds, wide), wide);
  // The same piece of 3 units of area is no limb of a thickness of 1.1, but a patch.
  const std::vector<double> thick(mesh.points.size(), 1.1);
  EXPECT_EQ(cutBridges(mesh, adjacency, findParts(mesh, adjacency), thick, seeds, narrow), narrow);
  const std::vector<char> both =
    where(mesh, [](const Vector3& p) { return std::abs(p[0] - 1.2) > 0.6 && std::abs(p[1] - 1.5) < 0.2; });
  EXPECT_EQ(cutBridges(mesh, adjacency, findParts(mesh, adjacency), diameter, both, narrow),
    narrow); // seeds on either side: both are meant
}

TEST(Fork, WhatLeadsBackToTheBodyBothWaysIsNotMeant)
{
  // A ring with a limb drawn out of its outer side at angle 0; the region is the limb and two thirds of the
  // ring.
  const Mesh ring = torus(2.0, 0.5, 240, 60);
  Mesh limbed = ring;
  for (Vector3& p : limbed.points)
  {
    const double off = std::hypot(p[1], p[2]) / 0.35;
    p[0] += p[0] > 2.0 && off < 1.0 ? 3.0 * (1.0 - off) : 0.0;
  }
  const Adjacency adjacency = buildAdjacency(limbed);
  const MeshParts parts = findParts(limbed, adjacency);
  const auto numbers = [](const std::vector<char>& flags)
  {
    std::vector<int> result;
    for (int v = 0; v < static_cast<int>(flags.size()); ++v)
    {
      if (flags[v])
      {
        result.push_back(v);
      }
    }
    return result;
  };
  const auto angle = [](const Vector3& p) { return std::abs(std::atan2(p[1], p[0])); };
  const auto arc = [&](const Vector3& p) { return angle(p) < 2.0 * pi / 3.0; };
  const auto tip = [](const Vector3& p) { return p[0] > 3.0; };
  const std::vector<char> cut =
    cutAtFork(limbed, adjacency, parts, numbers(where(limbed, tip)), where(limbed, arc));
  for (int v = 0; v < limbed.vertexCount(); ++v)
  {
    const Vector3& p = limbed.points[v];
    if (p[0] > 2.6)
    {
      EXPECT_TRUE(cut[v]) << p.transpose();
    }
    else if (angle(p) > 0.6)
    {
      EXPECT_FALSE(cut[v]) << p.transpose();
    }
  }
  // A cup's handle drawn along its outer side is meant as a whole; so is what has one border.
  const Adjacency round = buildAdjacency(ring);
  const std::vector<char> handle = where(ring, arc);
  const std::vector<char> along =
    where(ring, [&](const Vector3& p) { return angle(p) < 1.7 && p.norm() > 2.49; });
  EXPECT_EQ(cutAtFork(ring, round, findParts(ring, round), numbers(along), handle), handle);
  const Mesh ball = icosphere(4);
  const Adjacency links = buildAdjacency(ball);
  const std::vector<char> cap = where(ball, [](const Vector3& p) { return p[2] > 0.3; });
  const std::vector<char> pole = where(ball, [](const Vector3& p) { return p[2] > 0.95; });
  EXPECT_EQ(cutAtFork(ball, links, findParts(ball, links), numbers(pole), cap), cap);
}

TEST(Islands, AllButTheLargestRestByAreaAreFilled)
{
  const Mesh mesh = icosphere(4);
  const Adjacency adjacency = buildAdjacency(mesh);
  // A belt: the smaller cap joins it. Finer triangles would not make the cap count for more.
  std::vector<char> region = where(mesh, [](const Vector3& p) { return p[2] > 0.3 && p[2] < 0.6; });
  fillIslands(findParts(mesh, adjacency), adjacency, region);
  EXPECT_EQ(region, where(mesh, [](const Vector3& p) { return p[2] > 0.3; }));
}

TEST(Islands, ASeparatePartIsNoIsland)
{
  Mesh mesh = icosphere(3);
  const int first = mesh.vertexCount();
  const Mesh eye = icosphere(2, 0.1);
  for (const Vector3& p : eye.points)
  {
    mesh.points.push_back(p + Vector3(2, 0, 0));
  }
  for (const Triangle& t : eye.triangles)
  {
    mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  std::vector<char> region = where(mesh, [](const Vector3& p) { return p[2] > 0.5 && p[0] < 1.5; });
  const std::vector<char> before = region;
  const Adjacency adjacency = buildAdjacency(mesh);
  fillIslands(findParts(mesh, adjacency), adjacency, region);
  EXPECT_EQ(region, before);
}

TEST(Seeds, AreExpandedOnlyWhenTooFewNearestFirstWithinTolerance)
{
  const Mesh mesh = icosphere(4);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<int> seeds{ 10, 20 };
  EXPECT_EQ(expandSeeds(mesh, adjacency, seeds, 2, 1.0), seeds);
  const std::vector<int> twelve = expandSeeds(mesh, adjacency, seeds, 12, 1.0);
  EXPECT_EQ(twelve.size(), 12u);
  const std::vector<double> distance = edgeDistances(mesh, adjacency, seeds);
  double farthest = 0.0;
  for (int v : twelve)
  {
    farthest = std::max(farthest, distance[v]);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (distance[v] < farthest)
    {
      EXPECT_TRUE(std::binary_search(twelve.begin(), twelve.end(), v));
    }
  }
  EXPECT_EQ(expandSeeds(mesh, adjacency, seeds, 12, 1e-3), seeds);
}

TEST(Runaway, ARegionOfMoreThanHalfIsGrownAgainNearTheSection)
{
  const Mesh mesh = icosphere(4);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<Vector3> normals = vertexNormals(mesh);
  const MeshParts parts = findParts(mesh, adjacency);
  RegionEvidence evidence;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.points[v][2] > 0.99)
    {
      evidence.seeds.push_back(v);
    }
    // Growth likes four fifths of the ball.
    evidence.ratio.push_back(mesh.points[v][2] > -0.6 ? 1.0 : -5.0);
  }
  evidence.diameter.assign(mesh.points.size(), 1.8);
  evidence.sectionLength = 0.5;
  RegionOptions options;
  options.cutAtJunction = false;
  const std::vector<char> limited = detectRegion(mesh, adjacency, normals, parts, evidence, options);
  const std::vector<double> distance = edgeDistances(mesh, adjacency, evidence.seeds);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    EXPECT_EQ(limited[v] != 0, distance[v] <= 0.5) << v;
  }
  options.limitRunaway = false;
  const std::vector<char> published = detectRegion(mesh, adjacency, normals, parts, evidence, options);
  EXPECT_GT(2 * std::count(published.begin(), published.end(), 1), mesh.vertexCount());
  std::fill(evidence.ratio.begin(), evidence.ratio.end(), 5.0);
  EXPECT_THROW(detectRegion(mesh, adjacency, normals, parts, evidence, options), Error);
}

TEST(Region, EvidenceIsAskedForWhereGrowingReadsIt)
{
  const Mesh mesh = icosphere(6);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<Vector3> normals = vertexNormals(mesh);
  const MeshParts parts = findParts(mesh, adjacency);
  for (const double height : { 0.8, -0.6 }) // a cap, and more than half of the ball
  {
    RegionEvidence all;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (mesh.points[v][2] > 0.99)
      {
        all.seeds.push_back(v);
      }
      all.ratio.push_back(mesh.points[v][2] > height ? 1.0 : -5.0);
    }
    all.diameter.assign(mesh.points.size(), 1.8);
    all.sectionLength = 0.5;
    RegionEvidence some = all;
    some.ratio.assign(mesh.points.size(), std::numeric_limits<double>::quiet_NaN());
    some.diameter.assign(mesh.points.size(), 0.0);
    std::vector<char> asked(mesh.points.size(), 0);
    some.require = [&](const std::vector<int>& vertices)
    {
      for (const int v : vertices)
      {
        asked[v] = 1;
        some.ratio[v] = all.ratio[v];
        some.diameter[v] = all.diameter[v];
      }
    };
    EXPECT_EQ(detectRegion(mesh, adjacency, normals, parts, some, RegionOptions()),
      detectRegion(mesh, adjacency, normals, parts, all, RegionOptions()));
    // The cap is a tenth; of the ball growing goes no further than half.
    EXPECT_LT(std::count(asked.begin(), asked.end(), 1),
      (height > 0.0 ? 0.2 : 0.6) * static_cast<double>(asked.size()));
  }
}

// Islands of many sizes on bodies of one part and of two: what is filled is what a walk over all of the rest
// says.
TEST(Region, IslandsAreFoundFromTheRegionAsFromTheWhole)
{
  Mesh two = torus(1.0, 0.4, 40, 20);
  const Mesh ball = icosphere(3);
  const int first = two.vertexCount();
  for (const Vector3& p : ball.points)
  {
    two.points.push_back(p + Vector3(5, 0, 0));
  }
  for (const Triangle& t : ball.triangles)
  {
    two.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
  int filled = 0;
  const std::vector<Mesh> meshes{ ball, two, cylinder(1.0, 6.0, 16, 40) };
  for (const Mesh& mesh : meshes)
  {
    const Adjacency adjacency = buildAdjacency(mesh);
    const MeshParts parts = findParts(mesh, adjacency);
    for (int trial = 0; trial < 200; ++trial)
    {
      std::vector<char> region(mesh.points.size());
      const double frequency = 1.0 + trial % 7, level = -0.8 + 0.016 * (trial % 100);
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        const Vector3& p = mesh.points[v];
        region[v] =
          std::sin(frequency * p[0] + trial) + std::cos(1.3 * frequency * p[1]) * std::sin(frequency * p[2]) >
          level;
      }
      // All of the rest, walked piece by piece.
      std::vector<char> expected = region;
      std::vector<int> piece(region.size(), -1);
      std::vector<double> area;
      for (int start = 0; start < mesh.vertexCount(); ++start)
      {
        if (region[start] || piece[start] >= 0)
        {
          continue;
        }
        std::vector<int> stack{ start };
        piece[start] = int(area.size());
        area.push_back(0.0);
        while (!stack.empty())
        {
          const int v = stack.back();
          stack.pop_back();
          area.back() += parts.areas[v];
          for (const int n : adjacency.vertexVertices[v])
          {
            if (!region[n] && piece[n] < 0)
            {
              piece[n] = piece[start];
              stack.push_back(n);
            }
          }
        }
      }
      std::vector<double> largest(parts.count, 0.0);
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        largest[parts.of[v]] = std::max(largest[parts.of[v]], piece[v] >= 0 ? area[piece[v]] : 0.0);
      }
      bool tie = false; // of symmetric bodies: which one stays is another matter
      std::vector<int> champion(parts.count, -1);
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        if (piece[v] >= 0 && area[piece[v]] > (1.0 - 1e-9) * largest[parts.of[v]])
        {
          int& kept = champion[parts.of[v]];
          tie = tie || (kept >= 0 && kept != piece[v]);
          kept = piece[v];
        }
      }
      if (tie)
      {
        continue;
      }
      for (int v = 0; v < mesh.vertexCount(); ++v)
      {
        expected[v] = region[v] || piece[v] != champion[parts.of[v]];
      }
      std::vector<char> found = region;
      fillIslands(parts, adjacency, found);
      ASSERT_EQ(found, expected) << trial;
      filled += found != region;
    }
  }
  EXPECT_GT(filled, 100);
}

TEST(ReachEnds, OnATubeTheBorderMovesUpAllRound)
{
  const int around = 48, along = 40;
  const Mesh mesh = cylinder(1.0, 4.0, around, along);
  const Adjacency adjacency = buildAdjacency(mesh);
  const auto near = [&](const Vector3& place)
  {
    const auto closer = [&](const Vector3& a, const Vector3& b)
    { return (a - place).norm() < (b - place).norm(); };
    return int(std::min_element(mesh.points.begin(), mesh.points.end(), closer) - mesh.points.begin());
  };
  const auto below = [&](double z) { return where(mesh, [&](const Vector3& p) { return p[2] < z + 0.01; }); };
  const std::vector<char> region = below(1.0);
  const int left = near({ -1, 0, 2.0 }), right = near({ 1, 0, 2.0 }), high = near({ 1, 0, 3.0 });

  EXPECT_EQ(reachEnds(mesh, adjacency, { { { left }, { right } } }, 1.5, region), below(2.0));
  // Nothing lies outside, or too far off: nothing changes.
  EXPECT_EQ(reachEnds(mesh, adjacency, { { { near({ -1, 0, 0.5 }) }, {} } }, 1.5, region), region);
  EXPECT_EQ(reachEnds(mesh, adjacency, { { { high }, { high } } }, 1.5, region), region);
  // An end that does not move, but is there, keeps the border.
  const std::vector<char> oneSide =
    reachEnds(mesh, adjacency, { { { left }, { near({ 1, 0, 1.0 }) } } }, 1.5, region);
  EXPECT_TRUE(oneSide[left]);
  EXPECT_FALSE(oneSide[near({ 1, 0, 1.2 })]);
  // Unlike ends: the border rises from one to the other.
  const std::vector<char> slanted = reachEnds(mesh, adjacency, { { { left }, { high } } }, 2.5, region);
  EXPECT_TRUE(slanted[left] && slanted[high]);
  EXPECT_FALSE(slanted[near({ -1, 0, 2.2 })] || slanted[near({ 1, 0, 3.2 })]);
  EXPECT_TRUE(slanted[near({ 0, 1, 2.2 })] && slanted[near({ 0, -1, 2.2 })]);
  EXPECT_FALSE(slanted[near({ 0, 1, 2.8 })] || slanted[near({ 0, -1, 2.8 })]);
}

TEST(Confine, KeepsWhatIsNearToASeedAndShiftedBordersMoveByTheirLength)
{
  // Unit squares: along a row an edge path is as long as the way.
  constexpr int size = 20;
  const Mesh mesh = gridSurface(
    size, size, false, false, [](double u, double v) { return Vector3(size * u, size * v, 0.0); });
  const Adjacency adjacency = buildAdjacency(mesh);
  const auto upTo = [&](double x) { return where(mesh, [x](const Vector3& p) { return p[0] <= x + 1e-9; }); };
  std::vector<int> seeds;
  const std::vector<char> isSeed = upTo(2.0);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (isSeed[v])
    {
      seeds.push_back(v);
    }
  }
  EXPECT_EQ(confineRegion(mesh, adjacency, seeds, 5.0, upTo(12.0)), upTo(7.0));
  EXPECT_EQ(confineRegion(mesh, adjacency, seeds, 5.0, upTo(4.0)), upTo(4.0));
  EXPECT_EQ(confineRegion(mesh, adjacency, seeds, 100.0, upTo(12.0)), upTo(12.0));
  EXPECT_EQ(shiftBorder(mesh, adjacency, isSeed, 3.0, upTo(8.0)), upTo(11.0));
  EXPECT_EQ(shiftBorder(mesh, adjacency, isSeed, -3.0, upTo(8.0)), upTo(5.0));
  EXPECT_EQ(shiftBorder(mesh, adjacency, isSeed, -50.0, upTo(8.0)), upTo(2.0)); // seeds stay
  EXPECT_EQ(shiftBorder(mesh, adjacency, isSeed, 0.5, upTo(8.0)), upTo(8.0));
}
