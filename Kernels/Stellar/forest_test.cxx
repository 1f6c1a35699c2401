#include "Harness/shapes.h"
#include "Stellar/forest.h"

#include <gtest/gtest.h>

using namespace oversketch;
using oversketch_test::fact;

namespace
{

// The unit square as one pair, diagonal from (0, 0) to (1, 1).
Forest quad()
{
  Forest forest;
  forest.vertices.resize(4);
  const Vector3 corners[] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    forest.vertices[i].position = corners[i];
  }
  forest.faces.resize(2);
  forest.faces[0] = { 1, { 1, 2, 0 }, { -1, -1, -1 }, 0, 0 };
  forest.faces[1] = { 1, { 3, 0, 2 }, { -1, -1, -1 }, 1, 0 };
  forest.rootCount = 2;
  forest.connect();
  return forest;
}

void refineAll(Forest& forest, int generations)
{
  for (int g = 0; g < generations; ++g)
  {
    const int count = static_cast<int>(forest.faces.size());
    for (int f = 0; f < count; ++f)
    {
      if (forest.faces[f].gen == g)
      {
        forest.refine(f, {});
      }
    }
  }
}

} // namespace

TEST(D2_1, UniformRefinementsOfAQuad)
{
  const int points[] = { 4, 5, 9, 13, 25, 41, 81 };
  std::string reached;
  for (int g = 0; g <= 6; ++g)
  {
    Forest forest = quad();
    refineAll(forest, g);
    EXPECT_EQ(forest.broken(), "");
    EXPECT_EQ(forest.faceCount(), 2 << g);
    EXPECT_EQ(forest.vertexCount(), points[g]);
    reached +=
      (g ? ", " : "") + std::to_string(forest.faceCount()) + " / " + std::to_string(forest.vertexCount());
  }
  fact("D2_1", "faces / points after 0 to 6 refinements: " + reached);
}

TEST(D2_3, RefiningAtACornerStaysLocal)
{
  for (int generation : { 1, 2, 5, 10, 20, 40 })
  {
    Forest forest = quad();
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
