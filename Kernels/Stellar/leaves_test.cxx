#include "Harness/forest_shapes.h"
#include "Stellar/leaves.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Leaves to split, by names that do not depend on what was split before: places in the tree.
struct Target
{
  int root;
  std::uint64_t path;
};

// Splits until the target is no longer a leaf or an ancestor of one alone.
void split(Forest& forest, const Target& target)
{
  for (bool found = true; found;)
  {
    found = false;
    for (int f = 0; f < static_cast<int>(forest.faces.size()) && !found; ++f)
    {
      const Forest::Face& face = forest.faces[f];
      std::uint64_t above = target.path;
      while (above > face.path)
      {
        above /= 2;
      }
      if (face.root == target.root && above == face.path)
      {
        forest.refine(f, {});
        found = true;
      }
    }
  }
}

Forest refinedAtRandom(const Mesh& mesh, unsigned seed, int refinements)
{
  std::mt19937 random(seed);
  Forest forest = baseOf(mesh);
  for (int i = 0; i < refinements; ++i)
  {
    const int f = anyFace(forest, random);
    if (forest.faces[f].gen < 30)
    {
      forest.refine(f, {});
    }
  }
  return forest;
}

// A leaf array set with everything in it.
Leaves fullLeaves()
{
  Forest forest = canonical(refinedAtRandom(subdivided(octahedron()), 11, 150), Context()).forest;
  needBaseNormals(forest, Context());
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  forest.displacement.resize(forest.vertices.size());
  forest.feature.resize(forest.vertices.size());
  for (std::size_t v = 0; v < forest.vertices.size(); ++v)
  {
    forest.displacement[v] = Vector3(unit(random), unit(random), unit(random));
    forest.feature[v] = unit(random);
    forest.vertices[v].moved = static_cast<std::uint8_t>(random() % 8);
    forest.vertices[v].curveId =
      forest.vertices[v].moved & Forest::Placed ? static_cast<int>(random() % 3) - 1 : -1;
    forest.vertices[v].curveParam = unit(random);
  }
  return emit(forest);
}

std::string refusal(const Leaves& leaves)
{
  try
  {
    rebuild(leaves, Context());
  }
  catch (const Error& e)
  {
    EXPECT_TRUE(e.failure() == Failure::BadMesh || e.failure() == Failure::MissingArray);
    EXPECT_NE(std::string(e.what()).find("a filter merged, split or reordered"), std::string::npos);
    return e.what();
  }
  return {};
}

} // namespace

TEST(D2_5, TheOrderOfSplitsDoesNotMatter)
{
  const Mesh mesh = subdivided(octahedron());
  PairingOptions greedy;
  greedy.improvePairs = false; // thirds too
  std::mt19937 random(21);
  Forest grown = baseOf(mesh, greedy);
  std::vector<Target> targets;
  for (int i = 0; i < 120; ++i)
  {
    const Forest::Face face = grown.faces[anyFace(grown, random)];
    targets.push_back({ face.root, face.path });
    split(grown, targets.back());
  }
  const Leaves expected = canonicalLeaves(grown);
  for (int shuffle = 0; shuffle < 10; ++shuffle)
  {
    std::shuffle(targets.begin(), targets.end(), random);
    Forest forest = baseOf(mesh, greedy);
    for (int i = 0; i < 120; ++i)
    {
      split(forest, targets[i]);
      if (i == 60) // written and read in the middle
      {
        const Forest packed = canonical(forest, twoThreads()).forest;
        forest = rebuild(emit(packed), twoThreads());
        ASSERT_TRUE(sameForest(forest, packed));
      }
    }
    EXPECT_TRUE(sameBytes(canonicalLeaves(forest), expected)) << shuffle;
  }
  fact("D2_5",
    "120 splits in ten orders, each written and read in the middle: the same bytes of " +
      std::to_string(grown.faceCount()) + " faces");
}

TEST(D2_5, RebuildIsExactAfterRandomRefinementsAndWelds)
{
  int faces = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const Mesh mesh = seed % 2 ? cylinder(1.0, 2.0, 7, 3) : subdivided(octahedron());
    Forest forest = refinedAtRandom(mesh, seed, 500);
    std::mt19937 random(seed);
    for (int i = 0; i < 60; ++i)
    {
      weldDown(forest, static_cast<int>(random() % forest.vertices.size()));
      forest.refine(anyFace(forest, random), {}); // takes unused slots
    }
    ASSERT_EQ(forest.broken(), "");
    const Canonical packed = canonical(forest, Context());
    EXPECT_EQ(packed.forest.broken(), "");
    EXPECT_EQ(packed.forest.faceCount(), forest.faceCount());
    EXPECT_TRUE(sameForest(rebuild(emit(packed.forest), Context()), packed.forest));
    EXPECT_TRUE(sameForest(canonical(packed.forest, twoThreads()).forest, packed.forest));
    for (std::size_t v = 0; v < packed.vertexFrom.size(); ++v)
    {
      EXPECT_EQ(packed.forest.vertices[v].position, forest.vertices[packed.vertexFrom[v]].position);
    }
    faces += packed.forest.faceCount();
  }
  fact("D2_5",
    "rebuilt from arrays to the bit after 500 random refinements and 60 welds, " + std::to_string(faces) +
      " faces");
}

TEST(Leaves, EverythingTravels)
{
  const Leaves leaves = fullLeaves();
  EXPECT_TRUE(sameBytes(emit(rebuild(leaves, twoThreads())), leaves));
  Leaves plain = leaves;
  plain.baseNormal.clear();
  plain.displacement.clear();
  plain.feature.clear();
  const Forest forest = rebuild(plain, Context());
  EXPECT_FALSE(forest.hasBaseNormals);
  EXPECT_TRUE(sameBytes(emit(forest), plain));
  EXPECT_EQ(rebuild(Leaves(), Context()).faceCount(), 0);
}

TEST(Leaves, ChangedArraysAreRefusedByName)
{
  const Leaves good = fullLeaves();
  ASSERT_EQ(refusal(good), "");
  const int cells = static_cast<int>(good.triangles.size()), points = static_cast<int>(good.points.size());
  const auto expect = [&](const std::string& name, const std::function<void(Leaves&)>& change)
  {
    Leaves bad = good;
    change(bad);
    const std::string said = refusal(bad);
    EXPECT_NE(said.find(name), std::string::npos) << name << ": " << said;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int cell : { 0, 1, cells / 2, cells - 1 })
  {
    expect("StellarRoot", [&](Leaves& l) { ++l.root[cell]; });
    expect("StellarRoot", [&](Leaves& l) { l.root[cell] = -5; });
    expect("StellarGen", [&](Leaves& l) { ++l.gen[cell]; });
    expect("StellarGen", [&](Leaves& l) { l.gen[cell] = 200; });
    expect("Stellar", [&](Leaves& l) { l.path[cell] ^= 1; });
    expect("Stellar", [&](Leaves& l) { l.path[cell] = 0; });
    expect("StellarPath", [&](Leaves& l) { l.path[cell] = ~std::uint64_t(0); });
    expect("not there", [&](Leaves& l) { l.triangles[cell][1] = points; });
    expect("not there", [&](Leaves& l) { l.triangles[cell][2] = -1; });
    expect("twice", [&](Leaves& l) { l.triangles[cell][2] = l.triangles[cell][0]; });
  }
  expect("StellarRoot", [](Leaves& l) { l.root.clear(); });
  expect("StellarPath", [](Leaves& l) { l.path.pop_back(); });
  expect("StellarGen", [](Leaves& l) { l.gen.clear(); });
  expect("StellarMoved", [](Leaves& l) { l.moved.clear(); });
  expect("StellarMoved", [](Leaves& l) { l.moved[7] = 8; });
  expect("CurveId", [](Leaves& l) { l.curveId[3] = -2; });
  expect("CurveId", [](Leaves& l) { l.curveId[3] = 1, l.moved[3] = Forest::Displaced; });
  expect("CurveParam", [&](Leaves& l) { l.curveParam[3] = nan; });
  expect("BaseNormal", [&](Leaves& l) { l.baseNormal[3].x() = nan; });
  expect("Displacement", [&](Leaves& l) { l.displacement[3].x() = nan; });
  expect("Feature", [&](Leaves& l) { l.feature.pop_back(); });
  expect("The place of point 3", [&](Leaves& l) { l.points[3].x() = nan; });
}

TEST(Leaves, CellsAndPointsThatAFilterTouchedAreRefused)
{
  const Leaves good = fullLeaves();
  std::mt19937 random(31);
  const int cells = static_cast<int>(good.triangles.size()), points = static_cast<int>(good.points.size());
  int refused = 0;
  for (int i = 0; i < 400; ++i)
  {
    Leaves bad = good;
    const int a = static_cast<int>(random() % cells), b = static_cast<int>(random() % cells);
    const int p = static_cast<int>(random() % points), q = static_cast<int>(random() % points);
    switch (i % 5)
    {
      case 0: // two cells change places
        std::swap(bad.triangles[a], bad.triangles[b]);
        std::swap(bad.root[a], bad.root[b]);
        std::swap(bad.path[a], bad.path[b]);
        std::swap(bad.gen[a], bad.gen[b]);
        if (a == b)
          continue;
        break;
      case 1: // two points are merged
        for (Triangle& t : bad.triangles)
          std::replace(t.begin(), t.end(), p, q);
        if (p == q)
          continue;
        break;
      case 2: // a cell has a point of its own
        for (auto* v : { &bad.points, &bad.baseNormal, &bad.displacement })
          v->push_back(v->at(good.triangles[a][i % 3]));
        bad.moved.push_back(0);
        bad.curveId.push_back(-1);
        bad.curveParam.push_back(0);
        bad.feature.push_back(0);
        bad.triangles[a][i % 3] = points;
        break;
      case 3: // a cell is gone
        bad.triangles.erase(bad.triangles.begin() + a);
        bad.root.erase(bad.root.begin() + a);
        bad.path.erase(bad.path.begin() + a);
        bad.gen.erase(bad.gen.begin() + a);
        break;
      default: // a cell begins with another corner
        std::rotate(bad.triangles[a].begin(), bad.triangles[a].begin() + 1, bad.triangles[a].end());
    }
    EXPECT_NE(refusal(bad), "") << i;
    ++refused;
  }
  EXPECT_GT(refused, 380);
}

TEST(Leaves, NothingThatIsReadIsUnsound)
{
  // Whatever is changed: refused, or a forest whose structure holds.
  std::mt19937 random(41);
  const Leaves good = fullLeaves();
  for (int i = 0; i < 3000; ++i)
  {
    Leaves bad = good;
    for (int change = 1 + static_cast<int>(random() % 3); change > 0; --change)
    {
      const std::size_t c = random() % bad.triangles.size(), d = random() % bad.triangles.size();
      const int v = static_cast<int>(random() % bad.points.size());
      switch (random() % 6)
      {
        case 0:
          bad.triangles[c][random() % 3] = v;
          break;
        case 1:
          bad.path[c] = bad.path[d];
          break;
        case 2:
          bad.gen[c] = bad.gen[d];
          break;
        case 3:
          bad.root[c] = bad.root[d];
          break;
        case 4:
          std::swap(bad.triangles[c], bad.triangles[d]);
          break;
        default:
          std::swap(bad.triangles[c][0], bad.triangles[c][random() % 3]);
      }
    }
    try
    {
      EXPECT_EQ(rebuild(bad, Context()).broken(), "");
    }
    catch (const Error&)
    {
    }
  }
}

TEST(Leaves, ASeamThatIsCutOnOneSideOnlyIsRefused)
{
  // Two quads side by side, their common edge split on the left; the right one knows nothing of it.
  Forest whole = quadForest(2, 1);
  const int m = whole.refineEdge(1, 4, {});
  ASSERT_GE(m, 0);
  const Leaves leaves = canonicalLeaves(whole);
  Leaves torn;
  torn.points = leaves.points;
  torn.moved = leaves.moved;
  torn.curveId = leaves.curveId;
  torn.curveParam = leaves.curveParam;
  const Leaves coarse = emit(quadForest(2, 1));
  for (const Leaves* from : { &leaves, &coarse })
  {
    for (std::size_t c = 0; c < from->triangles.size(); ++c)
    {
      if ((from->root[c] < 2) == (from == &leaves))
      {
        torn.triangles.push_back(from->triangles[c]);
        torn.root.push_back(from->root[c]);
        torn.path.push_back(from->path[c]);
        torn.gen.push_back(from->gen[c]);
      }
    }
  }
  EXPECT_NE(refusal(torn), "");
}

TEST(Leaves, FacesUnderAreAncestorsOrTheFirstOfThoseWithin)
{
  const Forest before = canonical(refinedAtRandom(subdivided(octahedron()), 51, 60), Context()).forest;
  Forest grown = before;
  std::mt19937 random(52);
  for (int i = 0; i < 300; ++i)
  {
    grown.refine(anyFace(grown, random), {});
  }
  const Forest after = canonical(grown, Context()).forest;
  const std::vector<int> up = facesUnder(before, after), down = facesUnder(after, before);
  for (int f = 0; f < after.faceCount(); ++f)
  {
    std::uint64_t path = after.faces[f].path;
    while (path > before.faces[up[f]].path)
    {
      path /= 2;
    }
    EXPECT_EQ(after.faces[f].root, before.faces[up[f]].root);
    EXPECT_EQ(path, before.faces[up[f]].path);
  }
  for (int f = 0; f < before.faceCount(); ++f)
  {
    std::uint64_t path = after.faces[down[f]].path;
    while (path > before.faces[f].path)
    {
      EXPECT_EQ(path % 2, 0u);
      path /= 2;
    }
    EXPECT_EQ(path, before.faces[f].path);
    EXPECT_EQ(after.faces[down[f]].root, before.faces[f].root);
  }
}
