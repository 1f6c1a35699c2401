// Facts of image-assisted.md, sections 11 and 12: the smoothings' solves.
#include "Raster/grid_smoothing.h"

#include "Harness/drawing_shapes.h"
#include "Harness/shapes.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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
  const double c = 0.5, small = 0.3;
  GridSmoothing grid(maps, 1, Context());
  const std::vector<float> smooth = grid.thickness(c, Context());
  std::vector<float> squares(frame.count(), 0.0f);
  for (std::size_t i = 0; i < frame.count(); ++i)
  {
    squares[i] = maps.distance[i] * (2.0f * maps.thickness[i] - maps.distance[i]);
  }
  const std::vector<float> ratio = grid.profileRatio(squares, small, Context());

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
  const auto count = static_cast<Eigen::Index>(inner.size());
  EXPECT_EQ(static_cast<int>(inner.size()), grid.cellCount());
  const std::array<int, 4> around{ -1, 1, -frame.width, frame.width };
  // own x - div(flow grad x) = side; at the rim no flux, or what leads to 0 there.
  const auto solved =
    [&](const Eigen::VectorXd& own, const Eigen::VectorXd& flow, bool fixed, const Eigen::VectorXd& side)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < count; ++i)
    {
      double sum = own[i];
      for (const int step : around)
      {
        const int j = numbers[inner[i] + step];
        const double weight = j < 0 ? (fixed ? flow[i] : 0.0) : 0.5 * (flow[i] + flow[j]);
        sum += weight;
        if (j >= 0)
        {
          entries.emplace_back(i, j, -weight);
        }
      }
      entries.emplace_back(i, i, sum);
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::VectorXd(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(side));
  };
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(count);
  Eigen::VectorXd thick(count), q(count), widths(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    thick[i] = maps.thickness[inner[i]];
    q[i] = squares[inner[i]];
  }
  const Eigen::VectorXd expected = solved(ones, c * c * thick.cwiseProduct(thick), false, thick);
  const Eigen::VectorXd membrane = solved(0.0 * ones, ones, true, 2.0 * ones);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    widths[i] = membrane[i];
    for (const int step : { 1, frame.width })
    {
      const int after = numbers[inner[i] + step], before = numbers[inner[i] - step];
      const int steps = (after >= 0) + (before >= 0);
      const double rise = membrane[after < 0 ? i : after] - membrane[before < 0 ? i : before];
      widths[i] += steps > 0 ? 0.25 * std::pow(rise / steps, 2) : 0.0;
    }
  }
  const Eigen::VectorXd factors =
    solved(membrane.cwiseQuotient(widths), small * small * widths, false, q.cwiseQuotient(widths));
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const double heights = factors[i] * membrane[i];
    EXPECT_NEAR(smooth[inner[i]], std::max<double>(expected[i], maps.distance[inner[i]]), 1e-4);
    EXPECT_NEAR(ratio[inner[i]] * maps.distance[inner[i]], heights, 1e-3 * (1.0 + heights));
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
