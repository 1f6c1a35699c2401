// Facts of image-assisted.md, sections 11 and 12: the smoothings' solves.
#include "Raster/grid_smoothing.h"

#include "Harness/shapes.h"
#include "Raster/drawing_shapes.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A body with a limb: D has two sizes.
DistanceMaps limbed(int size)
{
  const double s = size / 200.0;
  Polyline points;
  for (int i = 0; i <= 60; ++i)
  {
    const double angle = 0.2 + (turn - 0.4) * i / 60;
    points.emplace_back(s * (70.0 + 55.0 * std::cos(angle)), s * (100.0 + 55.0 * std::sin(angle)));
  }
  points.emplace_back(s * 190.0, s * 92.0);
  points.emplace_back(s * 190.0, s * 108.0);
  return distanceMaps(pixelFrame(size, size), { { points, 0 } }, ThicknessMode::Local, Context());
}

} // namespace

TEST(C11_5, ThicknessIsNowhereLessThanTheDistance)
{
  double rise = 0.0;
  for (const int step : { 1, 2, 3 })
  {
    const DistanceMaps maps = limbed(400);
    GridSmoothing grid(maps, step, Context());
    for (const double c : { 0.0, 0.2, 0.5, 1.0 })
    {
      const std::vector<float> smooth = grid.thickness(c, Context());
      int below = 0;
      for (std::size_t i = 0; i < smooth.size(); ++i)
      {
        below += maps.thickness[i] < maps.distance[i] || smooth[i] < maps.distance[i];
        rise = std::max<double>(rise, std::abs(smooth[i] - maps.thickness[i]));
      }
      EXPECT_EQ(below, 0);
      EXPECT_EQ(c == 0.0, smooth == maps.thickness);
    }
    // The same for two threads.
    GridSmoothing other(maps, step, twoThreads());
    EXPECT_EQ(grid.thickness(0.5, Context()), other.thickness(0.5, twoThreads()));
  }
  fact("C11_5",
    "a body with a limb, steps 1 to 3, c = 0 to 1: D and D' >= T at every sample, D' up to " + digits(rise) +
      " px off D");
}

TEST(C11_6, AConstantStaysAndNothingLeavesTheRange)
{
  double off = 0.0;
  for (const int step : { 1, 2 })
  {
    DistanceMaps maps = limbed(300);
    GridSmoothing grid(maps, step, Context());
    const std::vector<float> smooth = grid.thickness(0.5, Context());
    float least = 1e9f, most = 0.0f;
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      if (maps.distance[i] > 0.0f)
      {
        least = std::min(least, maps.thickness[i]);
        most = std::max(most, maps.thickness[i]);
      }
    }
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      if (maps.distance[i] > 0.0f)
      {
        EXPECT_GE(smooth[i], least);
        EXPECT_LE(smooth[i], most);
      }
    }
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      maps.thickness[i] = maps.distance[i] > 0.0f ? 100.0f : 0.0f;
    }
    const std::vector<float> same = grid.thickness(0.5, Context());
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      off = std::max<double>(off, std::abs(same[i] - maps.thickness[i]));
    }
  }
  EXPECT_LE(off, 1e-9);
  fact("C11_6", "constant D: D' off by " + digits(off) + "; elsewhere within the least and greatest D");
}

TEST(GridSmoothing, SolvesTheSystemsAsEigenDoes)
{
  const DistanceMaps maps = limbed(120);
  const Frame& frame = maps.frame;
  const double c = 0.5, small = 0.15;
  GridSmoothing grid(maps, 1, Context());
  const std::vector<float> smooth = grid.thickness(c, Context());
  std::vector<float> squares(frame.count(), 0.0f);
  for (std::size_t i = 0; i < frame.count(); ++i)
  {
    const float d = std::min(maps.distance[i], smooth[i]);
    squares[i] = d * (2.0f * smooth[i] - d);
  }
  const std::vector<float> ratio = grid.profileRatio(smooth, squares, small, Context());

  std::vector<int> numbers(frame.count(), -1);
  std::vector<std::size_t> inner;
  for (std::size_t i = 0; i < frame.count(); ++i)
  {
    if (maps.distance[i] > 0.0f)
    {
      numbers[i] = static_cast<int>(inner.size());
      inner.push_back(i);
    }
  }
  EXPECT_EQ(static_cast<int>(inner.size()), grid.cellCount());
  const auto solved =
    [&](const std::vector<float>& flow, double factor, bool fixed, const Eigen::VectorXd& side)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (const std::size_t p : inner)
    {
      double sum = 1.0;
      const auto square = [&](std::size_t i)
      { return factor * factor * flow[i] * static_cast<double>(flow[i]); };
      for (const std::size_t q : { p - 1, p + 1, p - frame.width, p + frame.width })
      {
        if (numbers[q] >= 0)
        {
          const double weight = 0.5 * (square(p) + square(q));
          entries.emplace_back(numbers[p], numbers[q], -weight);
          sum += weight;
        }
        else
        {
          sum += fixed ? square(p) : 0.0;
        }
      }
      entries.emplace_back(numbers[p], numbers[p], sum);
    }
    Eigen::SparseMatrix<double> matrix(inner.size(), inner.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::VectorXd(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(side));
  };
  Eigen::VectorXd own(inner.size()), q(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    own[i] = maps.thickness[inner[i]];
    q[i] = squares[inner[i]];
  }
  const Eigen::VectorXd expected = solved(maps.thickness, c, false, own);
  const Eigen::VectorXd s = solved(smooth, small, true, q);
  const Eigen::VectorXd heights = s + solved(smooth, small, true, q - s);
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    EXPECT_NEAR(smooth[inner[i]], std::max<double>(expected[i], maps.distance[inner[i]]), 1e-4);
    EXPECT_NEAR(ratio[inner[i]] * q[i], std::max(0.0, heights[i]), 1e-3 * (1.0 + q[i]));
  }
}

TEST(GridSmoothing, BlowsUpAsEigenDoes)
{
  const DistanceMaps maps = limbed(120);
  const Frame& frame = maps.frame;
  const std::vector<float> ratio = GridSmoothing(maps, 1, Context()).poissonRatio(Context());
  std::vector<int> numbers(frame.count(), -1);
  int count = 0;
  for (std::size_t i = 0; i < frame.count(); ++i)
  {
    numbers[i] = maps.distance[i] > 0.0f ? count++ : -1;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t p = 0; p < frame.count(); ++p)
  {
    for (const std::size_t q : { p - 1, p + 1, p - frame.width, p + frame.width })
    {
      if (numbers[p] >= 0 && numbers[q] >= 0)
      {
        entries.emplace_back(numbers[p], numbers[q], -1.0);
      }
    }
    if (numbers[p] >= 0)
    {
      entries.emplace_back(numbers[p], numbers[p], 4.0);
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(
    Eigen::VectorXd(Eigen::VectorXd::Constant(count, 4.0)));
  for (std::size_t i = 0; i < frame.count(); ++i)
  {
    const double expected = numbers[i] < 0 ? 1.0 : u[numbers[i]] / maps.distance[i];
    EXPECT_NEAR(ratio[i], expected, 1e-4 * expected);
  }
  // A coarse grid knows where in its cells the rim is.
  const DistanceMaps large = limbed(400);
  const std::vector<float> fine = GridSmoothing(large, 1, Context()).poissonRatio(Context());
  const std::vector<float> coarse = GridSmoothing(large, 2, twoThreads()).poissonRatio(twoThreads());
  EXPECT_EQ(coarse, GridSmoothing(large, 2, Context()).poissonRatio(Context()));
  double off = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i)
  {
    const double t = large.distance[i] < 4.0f ? 0.0 : large.distance[i]; // beside the rim it is steep
    off = std::max(off, std::abs(std::sqrt(coarse[i] * t) - std::sqrt(fine[i] * t)));
  }
  EXPECT_LT(off, 1.0);
}

TEST(GridSmoothing, ACoarseGridIsNearTheFineOne)
{
  const DistanceMaps maps = limbed(800);
  const std::vector<float> fine = GridSmoothing(maps, 1, Context()).thickness(0.5, Context());
  const std::vector<float> coarse = GridSmoothing(maps, 2, Context()).thickness(0.5, Context());
  std::vector<float> off;
  for (std::size_t i = 0; i < fine.size(); ++i)
  {
    if (maps.distance[i] > 0.0f)
    {
      off.push_back(std::abs(fine[i] - coarse[i]));
    }
  }
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() * 99 / 100], 1.7f);
  EXPECT_LT(off.back(), 10.0f); // beside the rim where the limb begins: D jumps by 140 px there
  EXPECT_THROW(GridSmoothing(maps, 0, Context()), Error);
  const DistanceMaps half = distanceTo(maps.frame, { { ringAt(400, 400, 99), 0 } }, Context());
  EXPECT_THROW(GridSmoothing(half, 2, Context()), Error) << "findThickness was not called";
  const DistanceMaps none = distanceMaps(pixelFrame(40, 40), {}, ThicknessMode::Local, Context());
  GridSmoothing empty(none, 2, Context());
  EXPECT_EQ(empty.thickness(0.5, Context()), none.thickness);
  EXPECT_EQ(empty.poissonRatio(Context()), std::vector<float>(none.frame.count(), 1.0f));
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(GridSmoothing(maps, 2, cancelled), Error);
}
