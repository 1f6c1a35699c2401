#include "Print/print_facts.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector3 zero = Vector3::Zero();

Mesh cube(double side)
{
  return box(zero, Vector3::Constant(side));
}

Mesh turned(Mesh mesh)
{
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

int facesWith(const PrintCheck& check, int fault)
{
  return static_cast<int>(std::count_if(
    check.faults.begin(), check.faults.end(), [fault](int bits) { return (bits & fault) != 0; }));
}

// The text of the facts that are faults, but for the verdict.
std::vector<std::string> faultsOf(const PrintCheck& check, double wall = 0.0, double unit = 1.0)
{
  std::vector<std::string> faults;
  const std::vector<PrintFact> facts = printFacts(check, wall, unit);
  for (std::size_t i = 0; i + 1 < facts.size(); ++i)
  {
    if (facts[i].isFault)
    {
      faults.push_back(facts[i].words.text());
    }
  }
  EXPECT_EQ(facts.back().isFault, !check.isReady(wall));
  return faults;
}

} // namespace

TEST(PrintCheck, ACubeIsReadyAndItsWallsAreItsSides)
{
  const PrintCheck check = checkPrint(cube(10.0));
  EXPECT_TRUE(check.isReady(9.999));
  EXPECT_FALSE(check.isReady(10.001));
  EXPECT_EQ(check.bodies.size(), 1u);
  EXPECT_NEAR(check.volume, 1000.0, 1e-9);
  EXPECT_EQ(check.size, Vector3::Constant(10.0));
  for (const double wall : check.walls)
  {
    EXPECT_NEAR(wall, 10.0, 1e-12);
  }
  EXPECT_NEAR(check.thinArea(10.001), 600.0, 1e-9);
  EXPECT_TRUE(faultsOf(check).empty());
  EXPECT_EQ(printFacts(check, 0.0, 1.0)[3].words.text(), "Oriented: faces look outward.");
  EXPECT_EQ(printFacts(check, 0.0, 25.4)[0].words.text(), "Size: 254 x 254 x 254 mm.");
}

TEST(PrintCheck, AThinSlabIsAsThinAsItIs)
{
  const PrintCheck check = checkPrint(box(zero, { 10.0, 10.0, 0.4 }));
  EXPECT_NEAR(check.leastWall, 0.4, 1e-12);
  EXPECT_NEAR(check.thinArea(0.8), 200.0, 1e-9) << "top and bottom, not the sides";
  const std::vector<std::string> faults = faultsOf(check, 0.8);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0],
    "Walls thinner than 0.8 mm: 200 mm² of the surface; the thinnest is 0.4 mm. Make them thicker, or the "
    "model "
    "larger.");
  EXPECT_TRUE(checkPrint(box(zero, { 10.0, 10.0, 0.4 })).isReady(0.4 - 1e-9));
}

TEST(PrintCheck, AWallOfAHollowIsBetweenBothShells)
{
  const Mesh hollow = joined(cube(10.0), turned(cube(9.2)), Vector3::Constant(0.4));
  const PrintCheck check = checkPrint(hollow);
  ASSERT_EQ(check.bodies.size(), 2u);
  EXPECT_TRUE(check.bodies[1].isHollow);
  EXPECT_FALSE(check.bodies[1].isInsideOut);
  EXPECT_NEAR(check.volume, 1000.0 - 9.2 * 9.2 * 9.2, 1e-9);
  for (const double wall : check.walls)
  {
    EXPECT_NEAR(wall, 0.4, 1e-9);
  }
  EXPECT_TRUE(check.isReady(0.39));
  // A body within the hollow is one; the same hollow beside the cube is inside out.
  const Mesh nested = joined(hollow, cube(2.0), Vector3::Constant(4.0));
  EXPECT_TRUE(checkPrint(nested).isReady(0.39));
  EXPECT_EQ(checkPrint(nested).hollows, 1);
  const PrintCheck beside = checkPrint(joined(cube(10.0), turned(cube(9.2)), { 20.0, 0.0, 0.0 }));
  EXPECT_EQ(beside.insideOut, 1);
  EXPECT_NEAR(beside.bodies[1].volume, -9.2 * 9.2 * 9.2, 1e-9);
  EXPECT_EQ(facesWith(beside, InsideOutFault), 12);
  EXPECT_EQ(faultsOf(beside), std::vector<std::string>{ "Bodies that are inside out: 1. Turn their faces." });
}

TEST(PrintCheck, AMissingFaceIsAHoleAtItsPlace)
{
  Mesh mesh = cube(10.0);
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2); // at z = 0
  mesh.triangles.erase(mesh.triangles.begin());                             // half of that at z = 10
  const PrintCheck check = checkPrint(mesh);
  EXPECT_EQ(check.openEdges, 4 + 3);
  EXPECT_EQ(check.holes, 2);
  EXPECT_NEAR(check.holeLength, 40.0, 1e-9);
  EXPECT_LT((check.holePlace - Vector3(5.0, 5.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(check.turnedEdges + check.crowdedEdges + check.crossings, 0);
  const std::vector<std::string> faults = faultsOf(check, 0.0, 2.0);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0],
    "Open edges: 7, round holes: 2. The largest, 80 mm round, is at (10, 10, 0) mm. Fill the holes.");
}

TEST(PrintCheck, AFaceThatIsTurnedOrThereTwiceIsNamed)
{
  Mesh mesh = cube(10.0);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  PrintCheck check = checkPrint(mesh);
  EXPECT_EQ(check.turnedEdges, 3);
  EXPECT_EQ(facesWith(check, TurnedFault), 4) << "the face and its neighbours";
  EXPECT_EQ(check.openEdges + check.crowdedEdges, 0);
  EXPECT_FALSE(check.isReady(0.0));
  mesh = cube(10.0);
  mesh.triangles.push_back(mesh.triangles[0]);
  check = checkPrint(mesh);
  EXPECT_EQ(check.crowdedEdges, 3);
  EXPECT_EQ(check.openEdges + check.turnedEdges, 0);
  EXPECT_FALSE(check.isReady(0.0));
}

TEST(PrintCheck, BodiesThatOverlapPassThroughEachOtherButKeepTheirWalls)
{
  const PrintCheck check = checkPrint(joined(cube(10.0), cube(10.0), { 5.0, 3.0, 2.0 }));
  EXPECT_EQ(check.bodies.size(), 2u);
  EXPECT_GT(check.crossings, 0);
  EXPECT_GT(facesWith(check, CrossingFault), 0);
  EXPECT_NEAR(check.leastWall, 10.0, 1e-9) << "a face of one within the other is none of its walls";
  EXPECT_EQ(faultsOf(check).size(), 1u);
  EXPECT_TRUE(checkPrint(joined(cube(10.0), cube(10.0), { 11.0, 0.0, 0.0 })).isReady(0.0));
}

TEST(PrintCheck, SeamsOfATextureAreNoHoles)
{
  const Mesh whole = cube(10.0);
  Mesh split;
  for (const Triangle& t : whole.triangles)
  {
    const int at = split.vertexCount();
    split.triangles.push_back({ at, at + 1, at + 2 });
    for (const int v : t)
    {
      split.points.push_back(whole.points[v]);
    }
  }
  split.triangles.push_back({ 0, 0, 1 }); // counts as none
  const PrintCheck check = checkPrint(split);
  EXPECT_TRUE(check.isReady(9.0));
  EXPECT_EQ(check.bodies.size(), 1u);
  EXPECT_EQ(check.walls.back(), -1.0);
}

TEST(PrintCheck, SheetsHaveNoWall)
{
  const Mesh sheet{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const PrintCheck open = checkPrint(sheet);
  EXPECT_EQ(open.leastWall, -1.0);
  EXPECT_EQ(open.holes, 1);
  Mesh both = sheet;
  both.triangles.push_back({ 0, 2, 1 });
  const PrintCheck closed = checkPrint(both);
  EXPECT_EQ(closed.openEdges, 0);
  EXPECT_EQ(closed.leastWall, 0.0) << "it has two sides, and nothing between them";
  EXPECT_FALSE(closed.isReady(0.0));
  EXPECT_TRUE(checkPrint(Mesh()).bodies.empty());
  EXPECT_FALSE(checkPrint(Mesh()).isReady(0.0));
}

TEST(PrintCheck, WallsOfASphereAreItsDiameterForAnyNumberOfThreads)
{
  const Mesh sphere = icosphere(4, 3.0);
  const PrintCheck serial = checkPrint(sphere), threaded = checkPrint(sphere, twoThreads());
  EXPECT_EQ(serial.walls, threaded.walls);
  EXPECT_EQ(serial.faults, threaded.faults);
  for (const double wall : serial.walls)
  {
    EXPECT_NEAR(wall, 6.0, 0.03);
  }
  EXPECT_TRUE(serial.isReady(5.9));
}
