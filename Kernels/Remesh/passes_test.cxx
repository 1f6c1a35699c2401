#include "Harness/shapes.h"
#include "Remesh/passes.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A closed surface with bumps, of which one side may change.
struct Bumpy
{
  Mesh mesh = icosphere(5);
  std::vector<char> active;
  std::vector<double> sizes;

  Bumpy()
    : sizes(mesh.points.size(), 0.05)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shake(-0.02, 0.02);
    for (Vector3& p : this->mesh.points)
    {
      p += Vector3(shake(random), shake(random), shake(random));
    }
    for (const Triangle& t : this->mesh.triangles)
    {
      this->active.push_back(this->mesh.points[t[0]][2] > -0.3);
    }
  }
  Patch patch(const Surface& surface) const { return { surface, this->active, this->sizes, {}, {}, false }; }
};

std::vector<Triangle> trianglesOf(const Patch& patch)
{
  std::vector<Triangle> all;
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    all.push_back(patch.triangle(t));
  }
  return all;
}

} // namespace

// By angle flips make valences uneven, which the others even out.
TEST(Passes, FlipsAreThoseOfOneLookAtEachEdgeInTurn)
{
  const Bumpy bumpy;
  const std::vector<int> charts;
  const Surface surface(bumpy.mesh, bumpy.active, charts);
  Patch plain = bumpy.patch(surface), quick = bumpy.patch(surface);
  const Context context;
  Steps steps{ context };
  for (const bool byAngle : { true, false, true, false })
  {
    int made = 0;
    for (int t = 0; t < plain.triangleCount(); ++t)
    {
      plain.eachEdge(t,
        [&](int h)
        {
          if (plain.flippable(h, byAngle))
          {
            plain.flip(h);
            ++made;
          }
        });
    }
    EXPECT_EQ(flipAll(quick, byAngle, steps), made);
    EXPECT_GT(made, 50);
    EXPECT_EQ(trianglesOf(quick), trianglesOf(plain));
  }
}
