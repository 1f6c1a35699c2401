// Triangles from a line to the ring round it, bisected to the scale of what lies between.
#include "Remesh/refine_between.h"

#include "Harness/shapes.h"
#include "Mesh/nearest.h"
#include "Mesh/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double halfLength = 1.0, reach = 0.6;

// A flat square of (2 n)^2 triangles, 8 wide.
Mesh square(int n)
{
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.points.emplace_back(8.0 * i / n - 4.0, 8.0 * j / n - 4.0, 0.0);
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({ a, b, d });
      mesh.triangles.push_back({ a, d, c });
    }
  }
  return mesh;
}

int triangleAt(const Mesh& mesh, const Vector3& p)
{
  int nearest = 0;
  double least = HUGE_VAL;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    const double away = squaredDistance(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], p);
    if (away < least)
    {
      least = away;
      nearest = t;
    }
  }
  return nearest;
}

// Circle of radius 2, wide about a short line in the middle.
RunOnMesh wideRing(const Mesh& mesh)
{
  RunOnMesh ring;
  for (int i = 0; i <= 80; ++i)
  {
    const double angle = 2.0 * pi * i / 80.0;
    ring.points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    ring.triangles.push_back(triangleAt(mesh, ring.points.back()));
  }
  return ring;
}

// A straight line along x, and the rim of what lies within `reach` of it.
RefineInput inputOn(const Mesh& mesh, double edges = 6.0)
{
  RefineInput input{ mesh, { {} }, { {} }, edges, 1e9 };
  const auto add = [&](RunOnMesh& run, double x, double y)
  {
    run.points.emplace_back(x, y, 0.0);
    run.triangles.push_back(triangleAt(mesh, run.points.back()));
  };
  for (int i = 0; i <= 20; ++i)
  {
    add(input.line[0], halfLength * (i / 10.0 - 1.0), 0.0);
  }
  for (int i = 0; i <= 80; ++i)
  {
    const double angle = 2.0 * pi * i / 80.0;
    add(input.ring[0],
      std::copysign(halfLength, std::cos(angle)) * (std::abs(std::cos(angle)) > 1e-9) +
        reach * std::cos(angle),
      reach * std::sin(angle));
  }
  return input;
}

double wayFromLine(const Vector3& p)
{
  return std::hypot(std::max(0.0, std::abs(p[0]) - halfLength), p[1]);
}

double longestEdge(const Mesh& mesh, const Triangle& t)
{
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    longest = std::max(longest, (mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).norm());
  }
  return longest;
}

} // namespace

TEST(B11_5, ACoarseSquareGetsSixEdgesFromLineToRing)
{
  const Mesh mesh = square(8); // edges of 1: less than one from line to ring
  const auto made = refineBetween(inputOn(mesh), Context());
  ASSERT_TRUE(made);
  int inside = 0;
  double longest = 0.0, farthest = 0.0, smallest = 60.0;
  for (std::size_t t = 0; t < made->mesh.triangles.size(); ++t)
  {
    const Triangle& c = made->mesh.triangles[t];
    const bool isInside =
      std::all_of(c.begin(), c.end(), [&](int v) { return wayFromLine(made->mesh.points[v]) < reach; });
    inside += isInside;
    longest = isInside ? std::max(longest, longestEdge(made->mesh, c)) : longest;
    const Triangle& whole = mesh.triangles[made->triangleSources[t]];
    if (longestEdge(made->mesh, c) < 0.99 * longestEdge(mesh, whole)) // bisected
    {
      double nearest = HUGE_VAL;
      for (const int v : whole)
      {
        nearest = std::min(nearest, wayFromLine(mesh.points[v]) - reach);
      }
      farthest = std::max(farthest, nearest);
    }
    smallest = isInside ? std::min(smallest, smallestAngle(made->mesh, c)) : smallest;
    // On the old triangle, wound alike.
    const Vector3 normal = (made->mesh.points[c[1]] - made->mesh.points[c[0]])
                             .cross(made->mesh.points[c[2]] - made->mesh.points[c[0]]);
    EXPECT_GT(normal[2], 0.0);
  }
  EXPECT_LE(longest, 4.0 / 3.0 * reach / 6.0 * (1.0 + 1e-9));
  EXPECT_GT(inside, 200);
  EXPECT_LT(farthest, 1.0); // in edges of the square
  // Bisected at longest edges: angles of 45 and 90 degrees alone; beyond the ring somewhere across.
  EXPECT_GE(smallest, 45.0 - 1e-6);
  EXPECT_GE(smallestAngle(made->mesh), 18.0);
  // No vertex on an edge of another triangle.
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& c : made->mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++edges[std::minmax(c[k], c[(k + 1) % 3])];
    }
  }
  for (const auto& [edge, count] : edges)
  {
    const Vector3 &a = made->mesh.points[edge.first], &b = made->mesh.points[edge.second];
    const bool border = (std::abs(a[0]) == 4.0 && a[0] == b[0]) || (std::abs(a[1]) == 4.0 && a[1] == b[1]);
    EXPECT_EQ(count, border ? 1 : 2);
  }
  for (std::size_t v = 0; v < made->mesh.points.size(); ++v)
  {
    if (made->pointSources[v] >= 0)
    {
      EXPECT_EQ(made->mesh.points[v], mesh.points[made->pointSources[v]]);
      continue;
    }
    Vector3 mean = Vector3::Zero();
    for (const auto& [source, weight] : made->origins[v])
    {
      mean += weight * mesh.points[source];
    }
    EXPECT_LT((mean - made->mesh.points[v]).norm(), 1e-12);
  }
  fact("B11_5",
    "half a way of " + std::to_string(reach) + " edges: longest edge inside " +
      std::to_string(longest * 6.0 / reach) + " sixths of the way, " + std::to_string(inside) +
      " triangles, changes up to " + std::to_string(farthest) + " edges beyond the ring");
}

TEST(RefineBetween, AMeshThatIsFineEnoughStays)
{
  const Mesh mesh = square(128); // diagonals of 0.088 where 0.093 is asked for at the line
  EXPECT_FALSE(refineBetween(inputOn(mesh), Context()));
  EXPECT_TRUE(refineBetween(inputOn(mesh, 8.0), Context()));
}

// The weight 1 - 3 s^2 + 2 s^3 is level at the line, and across edges of h its slope leaps there by 6 h, from
// both sides together.
TEST(RefineBetween, AtTheLineEdgesAreFinerThanHalfwayToTheRing)
{
  const Mesh mesh = square(96); // diagonals of 0.118 where 0.133 is asked for halfway, 0.093 at the line
  const auto made = refineBetween(inputOn(mesh), Context());
  ASSERT_TRUE(made);
  for (std::size_t t = 0; t < made->mesh.triangles.size(); ++t)
  {
    const Triangle& c = made->mesh.triangles[t];
    const Vector3 middle =
      (made->mesh.points[c[0]] + made->mesh.points[c[1]] + made->mesh.points[c[2]]) / 3.0;
    if (wayFromLine(middle) < 0.01)
    {
      EXPECT_LE(longestEdge(made->mesh, c), 4.0 / 3.0 * (0.7 * reach / 6.0 + 0.01));
    }
    else if (wayFromLine(middle) > 0.6 * reach)
    {
      EXPECT_EQ(c, mesh.triangles[made->triangleSources[t]]);
    }
  }
}

// Triangles at the line are fewer than one in ten of those along both curves.
TEST(RefineBetween, AShortLineThatAsksIsHeardBesideALongRing)
{
  const Mesh mesh = square(28); // diagonals of 0.404
  RefineInput input = inputOn(mesh);
  for (Vector3& p : input.line[0].points)
  {
    p = { 0.1 * p[0], 0.1, 0.0 };
  }
  input.ring[0] = wideRing(mesh);
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  EXPECT_LT(made->mesh.triangleCount(), mesh.triangleCount() + 400);
}

TEST(RefineBetween, SizesAreOfTheWayAndNeverAboveTheLongest)
{
  const Mesh mesh = square(8);
  RefineInput input = inputOn(mesh);
  input.longest = 0.5;
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  for (std::size_t v = 0; v < made->sizes.size(); ++v)
  {
    const double way = wayFromLine(made->mesh.points[v]);
    EXPECT_LE(made->sizes[v], 0.5);
    if (way <= 0.95 * reach)
    {
      EXPECT_NEAR(made->sizes[v], std::min(1.0, 0.7 + 0.6 * way / reach) * reach / 6.0, 0.02 * reach);
    }
    else if (way > reach + 0.25)
    {
      EXPECT_EQ(made->sizes[v], 0.5);
    }
  }
}

TEST(RefineBetween, WithoutARingOrRoomForOneThereIsNothingToDo)
{
  const Mesh mesh = square(8);
  RefineInput input = inputOn(mesh);
  input.ring.clear();
  EXPECT_FALSE(refineBetween(input, Context()));
  input.ring = input.line; // of no way at all there is no sixth
  EXPECT_FALSE(refineBetween(input, Context()));
}

// Long thin triangles: what is bisected is so at its longest edge, and nothing runs on for ever.
TEST(RefineBetween, NoAngleIsLessThanHalfOfWhatWasThere)
{
  Mesh mesh = square(8);
  for (Vector3& p : mesh.points)
  {
    p[0] += 0.3 * std::sin(3.0 * p[1]) + 2.5 * p[1];
  }
  const double before = smallestAngle(mesh);
  const auto made = refineBetween(inputOn(mesh), Context());
  ASSERT_TRUE(made);
  double after = 60.0; // inside the ring
  for (const Triangle& c : made->mesh.triangles)
  {
    if (std::all_of(c.begin(), c.end(), [&](int v) { return wayFromLine(made->mesh.points[v]) < reach; }))
    {
      after = std::min(after, smallestAngle(made->mesh, c));
    }
  }
  EXPECT_GE(after, 0.5 * before);
  EXPECT_LT(made->mesh.triangleCount(), 20000);
}

// An edge passes beside the ring whose ends are far beyond it, so that it is not halved: a triangle at it is
// cut across, and its parts would come to lie upon that edge, as long as before, and be cut for ever.
TEST(RefineBetween, ATriangleAtALongEdgeIsNotCutForEver)
{
  const Mesh mesh{ { { -5, 0.7, 0 }, { 5, 0.7, 0 }, { 0, -0.9, 0 }, { 0, 0.5, 0 } },
    { { 0, 3, 1 }, { 0, 2, 3 }, { 3, 2, 1 } } };
  RefineInput input = inputOn(mesh);
  input.longest = 0.5;
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  EXPECT_GT(made->mesh.triangleCount(), mesh.triangleCount());
  EXPECT_LT(made->mesh.triangleCount(), 5000);
  EXPECT_TRUE(weldPoints(made->mesh.points).empty());
  for (const Triangle& c : made->mesh.triangles)
  {
    EXPECT_GT(smallestAngle(made->mesh, c), 0.01);
  }
}

// A ring that is hidden over a third of its turn: its ends are farther from the line than much that lies
// beyond the straight way between them.
TEST(RefineBetween, BeyondAGapOfTheRingIsBeyondTheRing)
{
  const Mesh mesh = square(16);
  RefineInput input = inputOn(mesh);
  for (Vector3& p : input.line[0].points)
  {
    p *= 0.5;
  }
  input.ring[0] = {};
  for (int i = 0; i <= 80; ++i)
  {
    const double angle = (-30.0 + 3.0 * i) * pi / 180.0;
    input.ring[0].points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    input.ring[0].triangles.push_back(triangleAt(mesh, input.ring[0].points.back()));
  }
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  int beyond = 0;
  for (std::size_t v = 0; v < made->sizes.size(); ++v)
  {
    const Vector3& p = made->mesh.points[v];
    if (std::abs(p[0]) < 0.4 && p[1] < -1.0 && p[1] > -2.0)
    {
      EXPECT_NEAR(made->sizes[v], 1.0 / 6.0 + 2.0 * (-1.0 - p[1]), 0.02);
      ++beyond;
    }
  }
  EXPECT_GT(beyond, 2);
}

// A sheet that is folded just beyond the ring: its lower half is nearer to the line than the ring is, in
// space, but not over the surface.
TEST(RefineBetween, TheOtherSideOfAThinPartIsBeyondTheRing)
{
  Mesh mesh = square(40);
  const std::vector<Vector3> flat = mesh.points;
  for (Vector3& p : mesh.points)
  {
    p = p[0] > 1.7 ? Vector3(3.4 - p[0], p[1], -0.2) : p;
  }
  RefineInput input = inputOn(mesh);
  input.longest = 0.25;
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  for (std::size_t t = 0; t < made->mesh.triangles.size(); ++t)
  {
    const Triangle& whole = mesh.triangles[made->triangleSources[t]];
    if (std::all_of(whole.begin(), whole.end(), [&](int v) { return flat[v][0] > 2.3; }))
    {
      EXPECT_EQ(made->mesh.triangles[t], whole);
    }
  }
}

// A sheet that is bent down beside the line: its wall is nearer to the line than the ring is, but a way over
// it to the ring is much longer than from line to ring.
TEST(RefineBetween, WhatLiesOffTheWayFromLineToRingStays)
{
  Mesh mesh = square(6);
  const std::vector<Vector3> flat = mesh.points;
  for (Vector3& p : mesh.points)
  {
    p = p[1] > 0.3 ? Vector3(p[0], 0.3, 0.3 - p[1]) : p;
  }
  RefineInput input = inputOn(mesh);
  input.longest = 0.5;
  for (Vector3& p : input.line[0].points)
  {
    p *= 0.1;
  }
  input.ring[0] = wideRing(mesh);
  const auto made = refineBetween(input, Context());
  ASSERT_TRUE(made);
  for (std::size_t t = 0; t < made->mesh.triangles.size(); ++t)
  {
    const Triangle& whole = mesh.triangles[made->triangleSources[t]];
    if (std::all_of(whole.begin(), whole.end(), [&](int v) { return flat[v][1] > 1.3; }))
    {
      EXPECT_EQ(made->mesh.triangles[t], whole);
    }
  }
}
