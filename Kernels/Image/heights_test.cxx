#include "Harness/shapes.h"
#include "Image/heights.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <sstream>

using namespace oversketch;
using oversketch_test::fact;

namespace
{

const double missing = std::numeric_limits<double>::quiet_NaN();

HeightImage imageOf(int width, int height, const std::function<double(int, int)>& gray)
{
  HeightImage image;
  image.width = width;
  image.height = height;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      image.samples.push_back(gray(i, j));
  return image;
}

TerrainRules quads(int columns, int rows)
{
  TerrainRules rules;
  rules.columns = columns;
  rules.rows = rows;
  return rules;
}

std::string saidOf(HeightImage image, const TerrainRules& rules)
{
  try
  {
    Terrain(std::move(image), rules).baseMesh();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadMesh);
    return error.what();
  }
  return "";
}

// Edges have one or two triangles, and the triangles round each vertex are one fan.
void expectManifold(const Mesh& mesh)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  for (const MeshEdge& edge : adjacency.edges)
    EXPECT_LE(edge.triangleCount, 2);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    int open = 0;
    for (const int w : adjacency.vertexVertices[v])
      open += adjacency.edges[adjacency.findEdge(v, w)].triangleCount == 1;
    EXPECT_GT(adjacency.vertexTriangles.size(v), 0) << "a vertex without a quad";
    EXPECT_LE(open, 2) << "two fans at vertex " << v;
  }
}

} // namespace

TEST(D7_1, CountsOfTheGridAndOfTwoRefinements)
{
  std::string figures;
  for (const auto& [nx, ny] : { std::pair<int, int>{ 1, 1 }, { 5, 3 }, { 19, 19 }, { 64, 40 } })
  {
    const Terrain terrain(imageOf(33, 21, [](int i, int j) { return i * j % 7; }), quads(nx, ny));
    const Mesh mesh = terrain.baseMesh();
    ASSERT_EQ(mesh.vertexCount(), (nx + 1) * (ny + 1));
    ASSERT_EQ(mesh.triangleCount(), 2 * nx * ny);
    // Each quad is a pair over its cut, the second vertex to the third; all turn left.
    std::set<std::pair<int, int>> cuts;
    for (int t = 0; t < mesh.triangleCount(); t += 2)
    {
      const Triangle &a = mesh.triangles[t], &b = mesh.triangles[t + 1];
      EXPECT_EQ(a[1], b[2]);
      EXPECT_EQ(a[2], b[1]);
      EXPECT_LT(a[2], a[1]) << "lower left to upper right";
      cuts.insert({ a[2], a[1] });
      EXPECT_GT(facetNormal(mesh, t)[2], 0.0);
      EXPECT_GT(facetNormal(mesh, t + 1)[2], 0.0);
    }
    EXPECT_EQ(cuts.size(), static_cast<std::size_t>(nx * ny));
    // Two refinements put a vertex on each cut, then on each side of a quad: on every edge of the grid.
    const int edges = static_cast<int>(buildAdjacency(mesh).edges.size());
    EXPECT_EQ(mesh.vertexCount() + edges, (2 * nx + 1) * (2 * ny + 1));
    figures += std::to_string(nx) + " x " + std::to_string(ny) + ": " + std::to_string(mesh.vertexCount()) +
               " points, " + std::to_string(mesh.triangleCount()) + " cells, " +
               std::to_string(mesh.vertexCount() + edges) + " points with the edges' middles; ";
  }
  figures.resize(figures.size() - 2);
  fact("D7_1", figures);
}

TEST(D7_2, RampsStayPlanesAndConstantsAreExact)
{
  HeightImage ramp = imageOf(40, 30, [](int i, int j) { return 3.0 + 0.25 * i - 0.75 * j; });
  ramp.spacing = { 2.0, 0.5 };
  TerrainRules rules = quads(13, 7);
  rules.scale = 1.5;
  rules.offset = -2.0;
  const Terrain terrain(ramp, rules);
  double worst = 0.0;
  const auto plane = [](double x, double y) { return -2.0 + 1.5 * (3.0 + 0.25 * x / 2.0 - 0.75 * y / 0.5); };
  const Mesh mesh = terrain.baseMesh();
  for (const Vector3& p : mesh.points)
    worst = std::max(worst, std::abs(p[2] - plane(p[0], p[1])));
  for (int k = 0; k < 500; ++k)
  {
    const double x = 78.0 * std::abs(std::sin(k)), y = 14.5 * std::abs(std::cos(3 * k));
    worst = std::max(worst, std::abs(terrain.heightAt(x, y) - plane(x, y)));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_NEAR(mesh.points.back()[0], 78.0, 1e-12);
  EXPECT_NEAR(mesh.points.back()[1], 14.5, 1e-12);
  const Terrain flat(imageOf(9, 9, [](int, int) { return 130.0; }), rules);
  for (const Vector3& p : flat.baseMesh().points)
    EXPECT_EQ(p[2], -2.0 + 1.5 * 130.0);
  std::ostringstream text;
  text << "a ramp of 40 x 30 samples over 13 x 7 quads is off its plane by " << worst
       << "; a constant 130 gives z0 + 130 k exactly";
  fact("D7_2", text.str());
}

TEST(Heights, BilinearAndClamped)
{
  const HeightImage image = imageOf(3, 2, [](int i, int j) { return i * i + 10.0 * j; });
  EXPECT_EQ(image.at(0, 0), 0.0);
  EXPECT_EQ(image.at(2, 1), 14.0);
  EXPECT_EQ(image.at(1.5, 0.5), 0.5 * (1 + 4) + 5.0);
  EXPECT_EQ(image.at(-3, 9), 10.0);
  EXPECT_EQ(image.at(7, -1), 4.0);
  EXPECT_TRUE(std::isnan(image.at(std::nan(""), 0)));
}

TEST(Heights, TheDefaultGridIsSquareAndSixtyFourLong)
{
  const auto flat = [](int, int) { return 0.0; };
  const Terrain wide(imageOf(403, 344, flat), {});
  EXPECT_EQ(wide.columns(), 64);
  EXPECT_EQ(wide.rows(), 55);
  const Terrain tall(imageOf(10, 37, flat), {});
  EXPECT_EQ(tall.columns(), 16);
  EXPECT_EQ(tall.rows(), 64);
  EXPECT_EQ(Terrain(imageOf(11, 21, flat), quads(0, 8)).columns(), 4);
  EXPECT_EQ(Terrain(imageOf(3, 100000, flat), quads(1, 0)).rows(), 50000);
  TerrainRules rules = quads(4, 2);
  rules.quad = { 3.0, 0.5 };
  const Mesh mesh = Terrain(imageOf(9, 9, flat), rules).baseMesh();
  EXPECT_EQ(mesh.points.back(), Vector3(12.0, 1.0, 0.0));
}

TEST(Heights, NarrowGapsAreFilledAndPlanesExactly)
{
  const auto plane = [](int i, int j) { return 3.0 + 0.25 * i - 0.75 * j; };
  std::mt19937 random(7);
  std::set<std::pair<int, int>> gaps = { { 0, 0 }, { 79, 59 }, { 79, 0 } };
  for (int k = 0; k < 240; ++k) // 5 % of them
  {
    gaps.insert({ static_cast<int>(random() % 80), static_cast<int>(random() % 57) });
  }
  for (int i = 0; i < 80; ++i) // a line that was not scanned, a column of the border, two rows of it
  {
    gaps.insert({ i, 30 });
    gaps.insert({ 0, i % 60 });
    gaps.insert({ i, 58 });
    gaps.insert({ i, 59 });
  }
  const auto isGap = [&](int i, int j) { return gaps.count({ i, j }) > 0; };
  const auto torn = [&](const auto& height)
  { return imageOf(80, 60, [&, height](int i, int j) { return isGap(i, j) ? missing : height(i, j); }); };
  HeightImage image = torn(plane);
  const FilledSamples samples = fillNarrowGaps(image);
  EXPECT_EQ(samples.filled, gaps.size());
  EXPECT_EQ(samples.left, 0U);
  HeightImage waves = torn([](int i, int j) { return std::sin(0.2 * i) + std::cos(0.2 * j); });
  fillNarrowGaps(waves);
  for (int j = 0; j < 60; ++j)
  {
    for (int i = 0; i < 80; ++i)
    {
      const std::size_t at = 80 * j + i;
      EXPECT_NEAR(image.samples[at], plane(i, j), isGap(i, j) ? 1e-12 : 0.0) << i << ", " << j;
      // Second derivatives are 0.04 at most, and samples up to three away, on one side of it at a border.
      EXPECT_NEAR(waves.samples[at], std::sin(0.2 * i) + std::cos(0.2 * j), 0.3) << i << ", " << j;
    }
  }
  EXPECT_EQ(Terrain(image, quads(79, 59)).baseMesh().triangleCount(), 2 * 79 * 59);
  EXPECT_LT(Terrain(torn(plane), quads(20, 15)).baseMesh().triangleCount(), 20 * 15) << "half, unfilled";
  HeightImage flat = torn([](int, int) { return 130.1; });
  fillNarrowGaps(flat);
  EXPECT_EQ(flat.samples, std::vector<double>(80 * 60, 130.1)) << "to the bit";
}

TEST(Heights, HolesOfThreeByThreeStayHoles)
{
  const std::vector<std::string> map = { // x is missing
    "..........xx",
    ".xxx......xx",
    ".xxxx.......",
    ".xxx...xx...",
    ".......xx...",
    "xx...xxxx...",
    "............",
    "xxx........x",
    "xxx......xxx",
    "xxx......xxx"
  };
  HeightImage image =
    imageOf(12, 10, [&](int i, int j) { return map[j][i] == 'x' ? missing : i + 10.0 * j; });
  const FilledSamples samples = fillNarrowGaps(image);
  EXPECT_EQ(samples.left, 9U + 9U);
  EXPECT_EQ(samples.filled, 22U);
  for (int j = 0; j < 10; ++j)
  {
    for (int i = 0; i < 12; ++i)
    {
      const double height = image.samples[12 * j + i];
      const bool isHole = (i >= 1 && i <= 3 && j >= 1 && j <= 3) || (i <= 2 && j >= 7);
      EXPECT_TRUE(isHole ? std::isnan(height) : std::abs(height - (i + 10.0 * j)) < 1e-12) << i << ", " << j;
    }
  }
  HeightImage none = imageOf(2, 2, [](int, int) { return missing; });
  EXPECT_EQ(fillNarrowGaps(none).left, 4U);
  Context stopped;
  stopped.cancelled = [] { return true; };
  EXPECT_THROW(fillNarrowGaps(image, stopped), Error);
}

TEST(Heights, QuadsOverMissingSamplesAreLeftOut)
{
  // One sample in the middle of four quads, then one inside a single coarse quad.
  const auto holed = [](int i, int j) { return i == 4 && j == 4 ? missing : 1.0; };
  const Mesh four = Terrain(imageOf(9, 9, holed), quads(8, 8)).baseMesh();
  EXPECT_EQ(four.triangleCount(), 2 * (64 - 4));
  EXPECT_EQ(four.vertexCount(), 81 - 1);
  expectManifold(four);
  const auto inside = [](int i, int j) { return i == 3 && j == 5 ? missing : 1.0; };
  EXPECT_EQ(Terrain(imageOf(9, 9, inside), quads(4, 4)).baseMesh().triangleCount(), 2 * 15);
  // An infinite one is missing too; a number that stands for nothing is the reader's affair.
  const auto endless = [](int i, int j) { return i == 0 && j == 0 ? -1.0 / 0.0 : 1.0; };
  EXPECT_EQ(Terrain(imageOf(3, 3, endless), quads(2, 2)).baseMesh().triangleCount(), 2 * 3);
}

TEST(Heights, WhatHangsOnByACornerGoes)
{
  // Samples at 4 k belong to quad corners only; a quad is taken out by the sample in its middle.
  const std::vector<std::string> map = { // upper row first; x is missing
    "..x..",
    "..x.x",
    "xx.xx",
    "..x..",
    "...x."
  };
  const auto gray = [&](int i, int j)
  {
    const bool middle = i % 2 == 1 && j % 2 == 1;
    return middle && map[4 - j / 2][i / 2] == 'x' ? missing : 1.0;
  };
  const Terrain terrain(imageOf(11, 11, gray), quads(5, 5));
  const Mesh mesh = terrain.baseMesh();
  expectManifold(mesh);
  // The one in the middle has no neighbour and touches four others: it goes. So does one of the two that meet
  // in the lower right; all else stays.
  std::set<std::pair<int, int>> left;
  for (int t = 0; t < mesh.triangleCount(); t += 2)
  {
    const Vector3& corner = mesh.points[mesh.triangles[t][2]];
    left.insert(
      { static_cast<int>(std::lround(corner[0] / 2)), static_cast<int>(std::lround(corner[1] / 2)) });
  }
  EXPECT_EQ(left.count({ 2, 2 }), 0u);
  EXPECT_EQ(left.count({ 2, 0 }) + left.count({ 3, 1 }), 1u);
  EXPECT_EQ(left.size(), 25u - 9u - 2u);
  EXPECT_EQ(left.count({ 0, 4 }), 1u);
  EXPECT_EQ(left.count({ 3, 3 }), 1u) << "joined by a side above";
  // Whatever is missing, what is left is a manifold.
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round)
  {
    const unsigned share = 2 + random() % 8;
    try
    {
      expectManifold(Terrain(
        imageOf(25, 19, [&](int, int) { return random() % 10 < share ? 1.0 : missing; }), quads(24, 18))
                       .baseMesh());
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find("No quad"), std::string::npos);
    }
  }
}

TEST(Heights, RefusesWhatIsNoTerrain)
{
  const auto flat = [](int, int) { return 0.0; };
  EXPECT_NE(saidOf(imageOf(1, 9, flat), {}).find("1 x 9 samples"), std::string::npos);
  EXPECT_NE(saidOf({}, {}).find("0 x 0 samples"), std::string::npos);
  HeightImage torn = imageOf(4, 4, flat);
  torn.samples.pop_back();
  EXPECT_NE(saidOf(torn, {}).find("4 x 4"), std::string::npos);
  EXPECT_NE(saidOf(imageOf(4, 4, flat), quads(-1, 2)).find("not negative"), std::string::npos);
  EXPECT_NE(saidOf(imageOf(4, 4, flat), quads(100000, 100000)).find("10000000000 quads"), std::string::npos);
  TerrainRules rules;
  rules.scale = missing;
  EXPECT_NE(saidOf(imageOf(4, 4, flat), rules).find("finite"), std::string::npos);
  EXPECT_NE(saidOf(imageOf(4, 4, [](int, int) { return missing; }), {}).find("No quad"), std::string::npos);
  Context stopped;
  stopped.cancelled = [] { return true; };
  EXPECT_THROW(Terrain(imageOf(9, 9, flat), {}).baseMesh(stopped), Error);
}
