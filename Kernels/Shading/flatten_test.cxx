// Facts of editors.md, section 13, flatten and texture: the disc.
#include "Shading/flatten.h"

#include "Harness/patches.h"
#include "Harness/threads.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

double discArea(const std::vector<Vector2>& disc, const Triangle& t)
{
  const Vector2 u = disc[t[1]] - disc[t[0]], v = disc[t[2]] - disc[t[0]];
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

int flips(const Mesh& mesh, const std::vector<Vector2>& disc)
{
  return static_cast<int>(std::count_if(mesh.triangles.begin(),
    mesh.triangles.end(),
    [&](const Triangle& t) { return !(discArea(disc, t) > 0.0); }));
}

// 95 of 100 triangles' area on the surface over that on the disc, over that of 5 of 100.
double areaSpread(const Mesh& mesh, const std::vector<Vector2>& disc)
{
  std::vector<double> ratios;
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 u = mesh.points[t[1]] - mesh.points[t[0]], v = mesh.points[t[2]] - mesh.points[t[0]];
    ratios.push_back(0.5 * u.cross(v).norm() / discArea(disc, t));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[ratios.size() * 95 / 100] / ratios[ratios.size() * 5 / 100];
}

Mesh bumpy(int side)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-0.3, 0.3);
  Mesh mesh = gridSurface(side, side, false, false, [](double u, double v) { return Vector3(u, v, 0.0); });
  for (Vector3& p : mesh.points)
  {
    p += Vector3(value(random), value(random), 3.0 * value(random)) / side;
  }
  return mesh;
}

void expectNoDisc(const Mesh& mesh, const std::string& what)
{
  try
  {
    flattened(mesh, {});
    ADD_FAILURE() << what;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadRegion);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

} // namespace

TEST(B6_1, TheDiscIsWholeAndFillsItsSquare)
{
  double least = 1.0, moved = 0.0;
  int triangles = 0;
  for (const Mesh& mesh : { cap(3),
         cap(4, -0.5),
         limb(4, 4.0),
         bumpy(30),
         gridSurface(20, 4, false, false, [](double u, double v) { return Vector3(20 * u, 2 * v, 0); }) })
  {
    const std::vector<Vector2> disc = flattened(mesh, {});
    EXPECT_EQ(flips(mesh, disc), 0);
    triangles += mesh.triangleCount();
    Eigen::AlignedBox2d box;
    for (const Vector2& p : disc)
    {
      box.extend(p);
    }
    EXPECT_LT((box.min() - Vector2(-1, -1)).norm() + (box.max() - Vector2(1, 1)).norm(), 1e-12);
    for (const Triangle& t : mesh.triangles)
    {
      least = std::min(least, discArea(disc, t));
    }
    Mesh shifted = mesh;
    for (Vector3& p : shifted.points)
    {
      p += Vector3(5, 5, 5);
    }
    const std::vector<Vector2> again = flattened(shifted, {}), two = flattened(mesh, twoThreads());
    EXPECT_EQ(two, disc);
    for (std::size_t v = 0; v < disc.size(); ++v)
    {
      moved = std::max(moved, (again[v] - disc[v]).norm());
    }
  }
  EXPECT_LT(moved, 1e-9);
  fact("B6_1",
    std::to_string(triangles) +
      " triangles of 5 patches, all of positive area; extremes 1 to 1e-12; shifted by 5: within " +
      std::to_string(moved * 1e12) + "e-12");
}

TEST(B6_6, BalancingOpensLimbs)
{
  std::string said;
  for (const double length : { 6.0, 12.0, 20.0 })
  {
    const Mesh mesh = limb(5, length);
    const std::vector<Vector2> plain = flattened(mesh, {}, 0), balanced = flattened(mesh, {});
    EXPECT_EQ(flips(mesh, plain), 0);
    EXPECT_EQ(flips(mesh, balanced), 0);
    const double before = areaSpread(mesh, plain), after = areaSpread(mesh, balanced);
    EXPECT_GT(before, 30.0);
    EXPECT_LT(after, before / 5.0);
    said += (said.empty() ? "" : ", ") + std::to_string(before) + " to " + std::to_string(after);
  }
  fact("B6_6", "limbs: no triangle turns over, p95/p5 of the area ratio from " + said);
}

TEST(Flatten, WhatIsNoDiscIsNamed)
{
  expectNoDisc(icosphere(1), "closed");
  expectNoDisc(cylinder(1.0, 2.0, 12, 4), "hole");
  expectNoDisc(joined(cap(2), cap(2), Vector3(5, 0, 0)), "several pieces");
  // A torus without one triangle has a handle.
  Mesh handle = torus(2.0, 0.5, 20, 10);
  handle.triangles.pop_back();
  expectNoDisc(handle, "handle");
  Mesh pinched{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } },
    { { 0, 1, 2 }, { 0, 3, 4 } } };
  expectNoDisc(pinched, "pinched");
  Mesh fin{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } } };
  expectNoDisc(fin, "three triangles");
  Mesh loose = cap(2);
  loose.points.emplace_back(0, 0, 0);
  expectNoDisc(loose, "without a triangle");
  Mesh turned{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 1, 2, 3 } } };
  expectNoDisc(turned, "pinched");
  Mesh flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }, { { 0, 1, 2 } } };
  expectNoDisc(flat, "area");
  expectNoDisc({}, "closed");
}

TEST(Flatten, OneTriangleAndCancel)
{
  const Mesh one{ { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  EXPECT_EQ(flips(one, flattened(one, {})), 0);
  Context stop;
  stop.cancelled = [] { return true; };
  EXPECT_THROW(flattened(cap(3), stop), Error);
}
