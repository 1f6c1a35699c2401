#include "Sparse/cholesky.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using Sparse = Cholesky::Sparse;

namespace
{

// A random symmetric positive definite matrix of 3x3 or 1x1 blocks on a grid graph with some far links, and
// its pattern.
struct Problem
{
  Sparse pattern, matrix;

  Problem(int side, int block)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    const int count = side * side;
    std::vector<Eigen::Triplet<double>> links, entries;
    const auto link = [&](int a, int b)
    {
      links.emplace_back(a, b, 1.0);
      links.emplace_back(b, a, 1.0);
      for (int r = 0; r < block; ++r)
      {
        for (int c = 0; c < block; ++c)
        {
          const double v = value(random);
          entries.emplace_back(a * block + r, b * block + c, v);
          entries.emplace_back(b * block + c, a * block + r, v);
        }
      }
    };
    for (int i = 0; i < count; ++i)
    {
      links.emplace_back(i, i, 1.0);
      for (int r = 0; r < block; ++r)
      {
        entries.emplace_back(i * block + r, i * block + r, 12.0 * block);
      }
      if (i % side + 1 < side)
        link(i, i + 1);
      if (i + side < count)
        link(i, i + side);
      if (i % 17 == 0 && i + 3 * side + 5 < count)
        link(i, i + 3 * side + 5);
    }
    this->pattern.resize(count, count);
    this->pattern.setFromTriplets(links.begin(), links.end());
    this->matrix.resize(count * block, count * block);
    this->matrix.setFromTriplets(entries.begin(), entries.end());
  }
};

} // namespace

TEST(Cholesky, SolvesGridsOfBlocks)
{
  for (const int block : { 1, 3 })
  {
    for (const int side : { 1, 2, 7, 30 })
    {
      const Problem problem(side, block);
      Cholesky factor(problem.pattern, block);
      ASSERT_TRUE(factor.factorise(problem.matrix, Context()));
      const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(problem.matrix.cols(), 3);
      Eigen::MatrixXd x = problem.matrix * expected;
      factor.solve(x);
      EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-11);
    }
  }
}

TEST(Cholesky, TakesANewMatrixOfTheSamePattern)
{
  const Problem problem(12, 3);
  Cholesky factor(problem.pattern, 3);
  ASSERT_TRUE(factor.factorise(problem.matrix, Context()));
  ASSERT_TRUE(factor.factorise(2.0 * problem.matrix, Context()));
  Eigen::MatrixXd x = problem.matrix * Eigen::VectorXd::Ones(problem.matrix.cols());
  factor.solve(x);
  EXPECT_LT((x.array() - 0.5).abs().maxCoeff(), 1e-12);
}

TEST(Cholesky, RefusesWhatIsNotPositiveDefinite)
{
  Problem problem(6, 1);
  problem.matrix.coeffRef(7, 7) = -1.0;
  EXPECT_FALSE(Cholesky(problem.pattern, 1).factorise(problem.matrix, Context()));
  // The graph Laplacian is singular: constants are in its null space.
  Sparse laplacian = -problem.pattern;
  for (int i = 0; i < laplacian.cols(); ++i)
  {
    laplacian.coeffRef(i, i) += problem.pattern.col(i).sum();
  }
  EXPECT_FALSE(Cholesky(problem.pattern, 1).factorise(laplacian, Context()));
}

TEST(Cholesky, CanBeCancelledHalfway)
{
  const Problem problem(40, 3);
  Cholesky factor(problem.pattern, 3);
  double reached = 0.0;
  Context context;
  context.progress = [&](double done) { reached = done; };
  context.cancelled = [&] { return reached > 0.5; };
  EXPECT_THROW(factor.factorise(problem.matrix, context), Error);
  EXPECT_LT(reached, 0.95);
  EXPECT_TRUE(factor.factorise(problem.matrix, Context()));
}
