// Of a ring over two limbs, the part that is on the one that the line lies on.
#include "Remesh/limb_runs.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A torus seen from its side, so that its halves stand side by side like two legs; joined far above and
// below.
struct TwoLegs
{
  Mesh mesh = torus(2.0, 0.5, 96, 32); // about z
  Adjacency links = buildAdjacency(this->mesh);
  View view = orthographicView(Vector3(0.0, 0.0, 1.0), Vector3(0.0, 1.0, 0.0), 60.0);

  int triangleAt(const Vector3& p) const
  {
    int nearest = 0;
    double least = HUGE_VAL;
    for (int t = 0; t < this->mesh.triangleCount(); ++t)
    {
      const Triangle& c = this->mesh.triangles[t];
      const Vector3 middle =
        (this->mesh.points[c[0]] + this->mesh.points[c[1]] + this->mesh.points[c[2]]) / 3.0;
      if ((middle - p).squaredNorm() < least)
      {
        least = (middle - p).squaredNorm();
        nearest = t;
      }
    }
    return nearest;
  }
  RunOnMesh runAt(double x, double y) const
  {
    const Vector3 place(x, y, 0.5);
    return { { place }, { this->triangleAt(place) } };
  }
  // A rectangle in the picture.
  std::vector<Vector2> box(double left, double right, double low, double high) const
  {
    std::vector<Vector2> corners;
    for (const auto& [x, y] : { std::pair(left, low), { right, low }, { right, high }, { left, high } })
    {
      corners.emplace_back(this->view.toDisplay(Vector3(x, y, 0.0)).head<2>());
    }
    return corners;
  }
};

} // namespace

TEST(LimbRuns, WhatIsReachedOutsideTheRingAloneIsAnotherLimb)
{
  const TwoLegs legs;
  const std::vector<Vector3> normals = vertexNormals(legs.mesh);
  const std::vector<int> line{ legs.triangleAt(Vector3(-2.0, 0.0, 0.5)) };
  const std::vector<RunOnMesh> runs{ legs.runAt(-2.0, 0.7), legs.runAt(2.0, 0.7), legs.runAt(-2.0, -0.7) };
  const auto over = [&](const std::vector<Vector2>& ring)
  { return runsOnLimb(legs.mesh, normals, legs.links.vertexVertices, legs.view, ring, line, runs); };
  EXPECT_EQ(over(legs.box(-3.0, 3.0, -0.8, 0.8)), (std::vector<char>{ 1, 0, 1 }));
  // A ring that holds the bow between them holds both.
  EXPECT_EQ(over(legs.box(-3.0, 3.0, -0.8, 3.0)), (std::vector<char>{ 1, 1, 1 }));
  // A leg behind the other: joined to it inside the ring, but over sides that face away.
  const View along = orthographicView(Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), 60.0);
  std::vector<Vector2> round;
  for (int i = 0; i < 60; ++i)
  {
    const double angle = 2.0 * pi * i / 60.0;
    round.emplace_back(400.0 + 350.0 * std::cos(angle), 300.0 + 350.0 * std::sin(angle));
  }
  const auto toAndFro = [&](double x, int times) // over 0.4
  {
    RunOnMesh run;
    for (int i = 0; i <= times; ++i)
    {
      run.points.emplace_back(x, i % 2 ? 0.9 : 0.5, 0.0);
      run.triangles.push_back(legs.triangleAt(run.points.back()));
    }
    return run;
  };
  const auto ofLegs = [&](int times)
  {
    return runsOnLimb(legs.mesh,
      normals,
      legs.links.vertexVertices,
      along,
      round,
      { legs.triangleAt(Vector3(-1.5, 0.0, 0.0)) },
      { toAndFro(-1.4, 1), toAndFro(2.4, times) });
  };
  EXPECT_EQ(ofLegs(11), (std::vector<char>{ 1, 0 }));
  // Leaps of 3.8 there and back: less than half as long again.
  EXPECT_EQ(ofLegs(15), (std::vector<char>{ 1, 1 }));
  // A line that lies beside its ring tells nothing.
  EXPECT_EQ(over(legs.box(5.0, 6.0, 5.0, 6.0)), (std::vector<char>{ 1, 1, 1 }));
}

TEST(LimbRuns, OfARegionWhatLiesOutsideTheRingIsMeasured)
{
  const TwoLegs legs;
  const auto outside = [&](const std::vector<Vector2>& ring, const auto& isInside)
  {
    std::vector<char> inside;
    for (const Vector3& p : legs.mesh.points)
    {
      inside.push_back(isInside(p) ? 1 : 0);
    }
    return shareOutside(legs.mesh, inside, legs.view, ring);
  };
  const auto isLeft = [](const Vector3& p) { return p[0] < 0.0; };
  const auto isAny = [](const Vector3&) { return true; };
  const std::vector<Vector2> left = legs.box(-3.0, 0.0, -3.0, 3.0);
  EXPECT_NEAR(outside(left, isLeft), 0.0, 0.03); // triangles over x = 0
  EXPECT_NEAR(outside(left, isAny), 0.5, 0.03);
  EXPECT_EQ(outside(legs.box(-3.0, 3.0, -3.0, 3.0), isAny), 0.0);
  EXPECT_EQ(outside(legs.box(5.0, 6.0, 5.0, 6.0), isAny), 1.0);
  EXPECT_EQ(outside(left, [](const Vector3&) { return false; }), 0.0);
}
