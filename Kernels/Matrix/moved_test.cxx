// Facts of editors.md, section 13, operators and handles; Eigen's exponential as the oracle.
#include "Matrix/moved.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Harness/transformations.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Points, a handful of logarithms, weights.
struct RegionScene
{
  std::vector<Vector3> points;
  std::vector<Matrix4> logs;
  std::vector<double> weights;

  explicit RegionScene(int count, double size = 1.0)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (int k = 0; k < 3; ++k)
    {
      Matrix4 log = Matrix4::Zero();
      for (int i = 0; i < 12; ++i)
      {
        log(i / 4, i % 4) = size * value(random);
      }
      this->logs.push_back(log);
    }
    for (int v = 0; v < count; ++v)
    {
      this->points.emplace_back(value(random), value(random), value(random));
      const bool still = v % 5 == 0;
      for (int k = 0; k < 3; ++k)
      {
        this->weights.push_back(still ? 0.0 : 0.5 * (1.0 + value(random)));
      }
    }
    for (int v = 0; v < count; v += 5)
    {
      this->points[v][0] = -0.0;
    }
  }
  Matrix4 sum(int v) const
  {
    Matrix4 x = Matrix4::Zero();
    for (int k = 0; k < 3; ++k)
    {
      x += this->weights[3 * v + k] * this->logs[k];
    }
    return x;
  }
  std::vector<Vector3> run(const Context& context = {}) const
  {
    return moved(this->points, this->logs, this->weights, context);
  }
};

bool sameBits(const Vector3& a, const Vector3& b)
{
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): its bits are meant
  return std::memcmp(a.data(), b.data(), sizeof(double) * 3) == 0;
}

} // namespace

TEST(B10_3, HalfATurnStaysOnItsCircle)
{
  const Matrix4 about = shift(1, 0, 0) * turn(Vector3::UnitZ(), 120.0) * shift(-1, 0, 0);
  const Vector3 there = moved({ { 2, 0, 0 } }, { logarithm(about) }, { 0.5 }, {})[0];
  EXPECT_LT((there - Vector3(1.5, std::sqrt(0.75), 0.0)).norm(), 1e-14);
  EXPECT_NEAR((there - Vector3(1, 0, 0)).norm(), 1.0, 1e-14);
  // A blend of the points goes straight.
  const Vector3 linear = 0.5 * Vector3(2, 0, 0) + 0.5 * (about * Eigen::Vector4d(2, 0, 0, 1)).head<3>();
  EXPECT_NEAR((linear - Vector3(1, 0, 0)).norm(), 0.5, 1e-14);
  fact("B10_3",
    "half of 120 degrees about z through (1, 0, 0): (2, 0, 0) goes to (" + std::to_string(there[0]) + ", " +
      std::to_string(there[1]) + ", 0), 1 off the axis; blended linearly 0.5");
}

TEST(B10_5, AHandleActsBetweenItsNeighbours)
{
  const std::vector<double> handles{ 0.25, 0.5, 0.75 }, without{ 0.5, 0.75 };
  const Matrix4 up = logarithm(shift(0, 0, 1)), none = Matrix4::Zero();
  const auto height = [&](const std::vector<double>& at, std::size_t k, double t)
  {
    std::vector<Matrix4> logs(at.size(), none);
    logs[k] = up;
    return moved({ { 0.3, 0.2, 0.0 } }, logs, tents(at, t), {})[0][2];
  };
  EXPECT_EQ(height(handles, 1, 0.5), 1.0);
  EXPECT_EQ(height(handles, 1, 0.375), 0.5);
  EXPECT_EQ(height(handles, 1, 0.625), 0.5);
  for (const double t : { 0.0, 0.1, 0.25, 0.75, 0.8, 1.0 })
  {
    EXPECT_EQ(height(handles, 1, t), 0.0);
  }
  for (const double t : { 0.0, 0.1, 0.3, 0.499 })
  {
    EXPECT_EQ(height(without, 0, t), 1.0);
  }
  for (const double t : { -1.0, 0.0, 0.1, 0.3, 0.6, 0.75, 2.0 })
  {
    const std::vector<double> shares = tents(handles, t);
    EXPECT_EQ(shares[0] + shares[1] + shares[2], 1.0);
  }
  EXPECT_TRUE(tents({}, 0.5).empty());
  fact("B10_5",
    "the middle of three handles: 1 at its place, 0.5 half way, 0 outside; without the left one 1 before it");
}

TEST(B10_3, AsEigenOnTenThousandMatrices)
{
  double largest = 0.0;
  for (const double size : { 0.1, 1.0, 3.0 })
  {
    const RegionScene scene(10000, size);
    const std::vector<Vector3> result = scene.run();
    double worst = 0.0;
    for (int v = 0; v < 10000; ++v)
    {
      const Matrix4 exact = scene.sum(v).exp();
      const Eigen::Vector4d there = exact * scene.points[v].homogeneous();
      worst = std::max(worst, (result[v] - there.head<3>()).norm() / exact.norm());
    }
    EXPECT_LT(worst, 1e-13) << size;
    largest = std::max(largest, worst);
  }
  fact("B10_3",
    "of 30,000 sums of logarithms within " + std::to_string(1e15 * largest) + "e-15 of Eigen's exponential");
}

TEST(Moved, WhatHasNoWeightKeepsItsBits)
{
  const RegionScene scene(1003);
  const std::vector<Vector3> result = scene.run();
  for (int v = 0; v < 1003; ++v)
  {
    EXPECT_EQ(sameBits(result[v], scene.points[v]), v % 5 == 0) << v;
  }
  EXPECT_TRUE(moved({}, scene.logs, {}, {}).empty());
  EXPECT_EQ(moved(scene.points, {}, {}, {}), scene.points);
}

TEST(Moved, ThreadsAndNeighboursChangeNoBit)
{
  const RegionScene scene(5000, 2.0);
  const std::vector<Vector3> one = scene.run(), two = scene.run(twoThreads());
  for (int v = 0; v < 5000; ++v)
  {
    ASSERT_TRUE(sameBits(one[v], two[v]));
  }
  for (int v = 1; v < 200; ++v)
  {
    const std::vector<double> weights(scene.weights.begin() + 3 * v, scene.weights.begin() + 3 * v + 3);
    ASSERT_TRUE(sameBits(moved({ scene.points[v] }, scene.logs, weights, {})[0], one[v])) << v;
  }
}

TEST(Moved, WhatCannotBeDoneIsSaid)
{
  const auto expect = [](const RegionScene& scene, Failure failure, const std::string& what)
  {
    try
    {
      scene.run();
      ADD_FAILURE() << what;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), failure);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  RegionScene perspective(40), far(40), lost(40), nowhere(40), few(40);
  perspective.logs[1](3, 0) = 1e-3;
  expect(perspective, Failure::SolveFailed, "perspective");
  far.weights[3 * 21] = 1e9;
  far.weights[3 * 33] = 1e9;
  expect(far, Failure::SolveFailed, "point 21 ");
  lost.weights[3 * 13] = std::nan("");
  expect(lost, Failure::SolveFailed, "point 13 ");
  nowhere.points[7][2] = std::numeric_limits<double>::infinity();
  expect(nowhere, Failure::BadMesh, "Point 7 ");
  few.weights.pop_back();
  expect(few, Failure::MissingArray, "119 weights");
  Context stop;
  stop.cancelled = [] { return true; };
  EXPECT_THROW(RegionScene(40).run(stop), Error);
}
