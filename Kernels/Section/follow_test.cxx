#include "Section/follow.h"

#include "Harness/section_shapes.h"
#include "Harness/threads.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Polyline bumped(const FlatProfile& profile)
{
  Polyline drawn = profile.points;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    drawn[i] += 0.1 * std::sin(pi * profile.t[i]) * Vector2(0.5, 1.0);
  }
  return drawn;
}

} // namespace

TEST(Follow, HandlesLimitWhatMovesWithThePlane)
{
  const PlaneReach alone(0.5, {}), between(0.5, { 0.9, 0.2, 0.0, 0.5 }), last(0.6, { 0.3 });
  EXPECT_EQ(alone.at(0.0), 1.0);
  EXPECT_EQ(alone.at(1.0), 1.0);
  EXPECT_EQ(between.at(0.5), 1.0);
  EXPECT_NEAR(between.at(0.35), 0.5, 1e-15);
  EXPECT_EQ(between.at(0.2), 0.0);
  EXPECT_EQ(between.at(0.1), 0.0);
  EXPECT_NEAR(between.at(0.7), 0.5, 1e-15);
  EXPECT_EQ(between.at(1.0), 0.0);
  EXPECT_NEAR(last.at(0.45), 0.5, 1e-15);
  EXPECT_EQ(last.at(0.6), 1.0);
  EXPECT_EQ(last.at(1.0), 1.0);
}

TEST(Follow, RoundAnEndTheSidesAreMixed)
{
  // Past the end of the arc on the sphere, in y = 0: half of each side; beside it one alone.
  const Profiled p(sphereScene(24, 96));
  const RegionPlaces region = p.region();
  const std::vector<double> shares = sideShares(p.scene.mesh.points, region, p.curve, p.frames, {});
  int past = 0;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const Vector3& q = p.scene.mesh.points[region.vertices[i]];
    EXPECT_GE(shares[i], 0.0);
    EXPECT_LE(shares[i], 1.0);
    // On mirrored vertices they are mirrored.
    if (std::abs(q[0]) < 0.5)
    {
      EXPECT_EQ(shares[i], q[1] >= 0.0 ? 1.0 : 0.0) << q.transpose();
    }
    else if (q[1] == 0.0 && std::abs(q[0]) > 0.72)
    {
      EXPECT_NEAR(shares[i], 0.5, 1e-9);
      ++past;
    }
  }
  EXPECT_GT(past, 4);
}

// The end itself is as near by the last segment as by its point, but for rounding.
TEST(Follow, PastAnEndAllSidesAreMixed)
{
  std::vector<Vector3> curve, points;
  for (int i = 0; i < 10; ++i)
  {
    curve.push_back(Vector3(-0.94, -1.87, -1.88) + pi / 30.0 * i * Vector3(1.0, 2.0, 2.0));
  }
  const CurveFrames frames(curve, std::vector<Vector3>(curve.size(), Vector3(2.0, 1.0, -2.0) / 3.0));
  const CurveFrame end = frames.at(1.0);
  RegionPlaces region;
  for (int i = 0; i < 500; ++i)
  {
    const double angle = pi * (i + 0.5) / 500.0;
    points.push_back(
      curve.back() + 0.1 * (1.0 + i % 7) * (std::cos(angle) * end.side + std::sin(angle) * end.along));
    region.vertices.push_back(i);
    region.side.push_back(std::cos(angle) > 0.0 ? 1.0 : -1.0);
  }
  const std::vector<double> shares = sideShares(points, region, curve, frames, {});
  for (int i = 0; i < 500; ++i)
  {
    EXPECT_NEAR(shares[i], 0.5 * (1.0 + std::cos(pi * (i + 0.5) / 500.0)), 1e-9);
  }
}

// Also where the place of the curve that a vertex lies beside is another one: the section would not be what
// was drawn.
TEST(Follow, WhatThePlaneCutsStaysInIt)
{
  Profiled p(sphereScene(24, 96, 0.3));
  for (double& t : p.scene.parameter)
  {
    t = std::min(1.0, t + 0.12);
  }
  const FlatProfile profile = p.flat(p.section());
  const std::vector<Vector3> moves = p.moves(profile, p.change(profile, bumped(profile)));
  int cut = 0;
  double length = 0.0, worst = 0.0;
  for (std::size_t i = 1; i < p.curve.size(); ++i)
  {
    length += (p.curve[i] - p.curve[i - 1]).norm();
  }
  for (int v = 0; v < p.scene.mesh.vertexCount(); ++v)
  {
    const double off = (p.scene.mesh.points[v] - p.frame.origin).dot(p.frame.along) / length;
    if (std::abs(off) < 0.02 && moves[v] != Vector3::Zero())
    {
      worst = std::max(worst, std::abs(moves[v].normalized().dot(p.frame.along)));
      ++cut;
    }
  }
  EXPECT_GT(cut, 20);
  EXPECT_LT(worst, 0.04); // 0.12 of the place beside
}

TEST(Follow, ThreadsChangeNoBitAndHandlesStop)
{
  const Profiled p(sphereScene(24, 96, 0.3));
  const FlatProfile profile = p.flat(p.section());
  const ProfileChange change = p.change(profile, bumped(profile));
  const std::vector<Vector3> one = p.moves(profile, change), two = p.moves(profile, change, {}, twoThreads());
  EXPECT_EQ(std::memcmp(one.data(), two.data(), one.size() * sizeof(Vector3)), 0);
  const std::vector<Vector3> limited = p.moves(profile, change, { 0.3, 0.7 });
  int moved = 0;
  for (int v = 0; v < p.scene.mesh.vertexCount(); ++v)
  {
    const double t = p.scene.parameter[v];
    if (t <= 0.3 || t >= 0.7)
    {
      EXPECT_EQ(limited[v], Vector3::Zero());
    }
    EXPECT_LE(limited[v].norm(), one[v].norm() + 1e-15);
    moved += limited[v] != Vector3::Zero() ? 1 : 0;
  }
  EXPECT_GT(moved, 50);
  Context stop;
  stop.cancelled = [] { return true; };
  EXPECT_THROW(p.moves(profile, change, {}, stop), Error);
}
