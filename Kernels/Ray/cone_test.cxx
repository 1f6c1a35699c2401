// Cones of rays: their directions, frames, and what is made of their lengths.
#include "Harness/shapes.h"
#include "Ray/ray_caster.h"
#include "Ray/shape_diameter.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

TEST(Ray, ConeDirectionsFillTheConeEvenly)
{
  for (const double angle : { 60.0, 120.0 })
  {
    const double beta = angle * pi / 360.0;
    const auto cone = coneDirections(1000, angle);
    Vector3 mean = Vector3::Zero();
    for (const Vector3& d : cone)
    {
      EXPECT_NEAR(d.norm(), 1.0, 1e-14);
      EXPECT_GT(d[2], std::cos(beta));
      mean += d / 1000.0;
    }
    EXPECT_NEAR(mean[2], 0.5 * (1.0 + std::cos(beta)), 1e-12); // of the cap of half-angle beta
    EXPECT_NEAR(mean.head<2>().norm(), 0.0, 1e-3);
  }
}

TEST(Ray, FramesTurnSmoothly)
{
  const Mesh sphere = icosphere(5);
  for (const MeshEdge& e : buildAdjacency(sphere).edges)
  {
    const Vector3 a = sphere.points[e.v0], b = sphere.points[e.v1];
    const double toPole = 1.0 - std::abs(a.dot(Vector3(0.4169, 0.5411, 0.7303).normalized()));
    if (toPole > 0.05)
    {
      EXPECT_LT((frameAround(a) - frameAround(b)).norm(), 6.0 * (a - b).norm());
    }
  }
  for (const double sign : { -1.0, 1.0 }) // and at the poles it is a frame all the same
  {
    const Vector3 axis = sign * Vector3(0.4169, 0.5411, 0.7303).normalized();
    EXPECT_LT(
      (frameAround(axis).transpose() * frameAround(axis) - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
}

TEST(Ray, SummaryDropsOutliersAndWeighs)
{
  const auto hits = [](const std::vector<double>& lengths)
  {
    std::vector<ConeHit> list;
    list.reserve(lengths.size());
    for (const double length : lengths)
    {
      list.push_back({ length, length < 0.0 ? -1 : 0 });
    }
    return list;
  };
  const std::vector<double> even(6, 1.0);
  EXPECT_DOUBLE_EQ(summarise(hits({ 1, 1.2, -1, 1.1, 0.9, 50 }).data(), even), 1.05);
  EXPECT_DOUBLE_EQ(summarise(hits({ -1, -1, -1, 3, -1, -1 }).data(), even), 3.0);
  EXPECT_DOUBLE_EQ(
    summarise(hits({ 0.1, 0.7, -1, -1, -1, -1 }).data(), even), 0.4); // both exactly one deviation off
  EXPECT_EQ(summarise(hits({ -1, -1, -1, -1, -1, -1 }).data(), even), -1.0);
  EXPECT_DOUBLE_EQ(summarise(hits({ 1, 2, -1, -1, -1, -1 }).data(), { 3, 1, 9, 9, 9, 9 }), 1.25);
}
