// Facts of editors.md, section 13, profile: the frames along a curve.
#include "Matrix/frames.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A curve on the unit sphere over the pole, with the mean face normals of a mesh's nearest vertices.
struct SphereCurve
{
  std::vector<Vector3> points, normals;

  explicit SphereCurve(const std::function<Vector2(double)>& seen, int count = 120)
  {
    static const Mesh sphere = icosphere(4);
    static const std::vector<Vector3> around = vertexNormals(sphere);
    for (int i = 0; i <= count; ++i)
    {
      const Vector2 p = seen(static_cast<double>(i) / count);
      const Vector3 at(p[0], p[1], std::sqrt(1.0 - p.squaredNorm()));
      int nearest = 0;
      for (int v = 1; v < sphere.vertexCount(); ++v)
      {
        nearest = sphere.points[v].dot(at) > sphere.points[nearest].dot(at) ? v : nearest;
      }
      this->points.push_back(at);
      this->normals.push_back(around[nearest]);
    }
  }
};

SphereCurve arc()
{
  return SphereCurve([](double t) { return Vector2(std::sin((t - 0.5) * pi / 2.0), 0.0); });
}

SphereCurve letterS()
{
  return SphereCurve([](double t) { return Vector2(1.2 * (t - 0.5), 0.3 * std::sin(2.0 * pi * t)); });
}

double degrees(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / pi;
}

void expectRightHanded(const CurveFrame& f)
{
  EXPECT_LT(std::abs(f.along.dot(f.side)), 1e-12);
  EXPECT_LT(std::abs(f.side.dot(f.outward)), 1e-12);
  EXPECT_LT(std::abs(f.outward.dot(f.along)), 1e-12);
  EXPECT_NEAR(f.side.dot(f.outward.cross(f.along)), 1.0, 1e-12);
}

} // namespace

TEST(B8_1, PlanesAndFramesOfACurveOverThePole)
{
  const SphereCurve scene = arc();
  const CurveFrames frames(scene.points, scene.normals);
  const CurveFrame middle = frames.planesAt(0.5), quarter = frames.planesAt(0.25);
  EXPECT_LT((middle.outward - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_LT((middle.along - Vector3::UnitX()).norm(), 1e-12);
  EXPECT_LT((middle.origin - Vector3::UnitZ()).norm(), 1e-12);
  // At a quarter the curve is at -22.5 degrees from the pole.
  EXPECT_LT((quarter.origin - Vector3(-std::sin(pi / 8), 0, std::cos(pi / 8))).norm(), 1e-12);
  EXPECT_LT(degrees(quarter.along, Vector3(std::cos(pi / 8), 0, std::sin(pi / 8))), 0.01);
  EXPECT_EQ(quarter.outward, middle.outward);

  const SphereCurve bent = letterS();
  const CurveFrames bends(bent.points, bent.normals);
  double worst = 0.0, planes = 0.0;
  for (int i = 0; i <= 200; ++i)
  {
    const double t = i / 200.0;
    for (const CurveFrames* one : { &frames, &bends })
    {
      const CurveFrame f = one->at(t);
      expectRightHanded(f);
      expectRightHanded(one->planesAt(t));
      worst = std::max(worst, degrees(f.outward, f.origin));
    }
    planes = std::max(planes, degrees(bends.planesAt(t).outward, bends.at(t).origin));
  }
  EXPECT_LT(worst, 3.0);
  EXPECT_GT(planes, 20.0);
  fact("B8_1",
    "an arc over the pole: N = y, T = x to 1e-12; n within " + std::to_string(worst) +
      " degrees of the radius, of an S too, where the fitted plane's is up to " + std::to_string(planes) +
      " off");
}

TEST(Frames, AStraightCurveHasPlanesToo)
{
  // Straight on a plane: the fitted plane is any; the surface says which.
  std::vector<Vector3> points, normals;
  for (int i = 0; i <= 10; ++i)
  {
    points.emplace_back(0.1 * i, 0.0, 0.0);
    normals.emplace_back(0.0, 0.0, 1.0);
  }
  const CurveFrames frames(points, normals);
  EXPECT_LT((frames.planesAt(0.3).outward - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_LT((frames.at(0.3).outward - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((frames.at(0.3).side - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(frames.at(-1.0).origin, points.front());
  EXPECT_EQ(frames.at(2.0).origin, points.back());
  EXPECT_LT((frames.at(0.37).origin - Vector3(0.37, 0, 0)).norm(), 1e-15);
}

TEST(Frames, WhatHasNoneIsRefused)
{
  const Vector3 a(0, 0, 0), b(1, 0, 0), up(0, 0, 1);
  EXPECT_THROW(CurveFrames({}, {}), Error);
  EXPECT_THROW(CurveFrames({ a }, { up }), Error);
  EXPECT_THROW(CurveFrames({ a, a }, { up, up }), Error);
  EXPECT_THROW(CurveFrames({ a, b }, { up }), Error);
  EXPECT_THROW(CurveFrames({ a, Vector3(std::nan(""), 0, 0) }, { up, up }), Error);
  EXPECT_THROW(CurveFrames({ a, b }, { b, b }).at(0.5), Error); // along the normal
}
