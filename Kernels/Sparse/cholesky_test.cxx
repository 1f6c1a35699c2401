#include "Sparse/cholesky.h"

#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <thread>

using namespace oversketch;
using Sparse = Eigen::SparseMatrix<double>;

namespace
{

// A random symmetric positive definite matrix of 3x3 or 1x1 blocks on a grid graph with some far links.
struct Problem
{
  std::vector<Vector3> positions;
  Sparse matrix;
  BlockMatrix blocks;

  Problem(int side, int block)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    const int count = side * side;
    std::vector<Eigen::Triplet<double>> entries;
    const auto link = [&](int a, int b)
    {
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
      this->positions.emplace_back(i % side, i / side, 0.0);
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
    this->matrix.resize(count * block, count * block);
    this->matrix.setFromTriplets(entries.begin(), entries.end());
    this->fillBlocks(block);
  }

  void fillBlocks(int block)
  {
    this->blocks = BlockMatrix();
    this->blocks.block = block;
    Lists& pattern = this->blocks.pattern;
    pattern.offsets.push_back(0);
    for (int column = 0; column < this->matrix.cols() / block; ++column)
    {
      std::set<int> rows{ column };
      for (int c = 0; c < block; ++c)
      {
        for (Sparse::InnerIterator it(this->matrix, column * block + c); it; ++it)
        {
          rows.insert(static_cast<int>(it.row()) / block);
        }
      }
      for (const int row : rows)
      {
        pattern.values.push_back(row);
        for (int c = 0; c < block; ++c)
        {
          for (int r = 0; r < block; ++r)
          {
            this->blocks.values.push_back(this->matrix.coeff(row * block + r, column * block + c));
          }
        }
      }
      pattern.offsets.push_back(static_cast<int>(pattern.values.size()));
    }
  }

  std::shared_ptr<const Elimination> eliminated(const Context& context = Context()) const
  {
    return std::make_shared<Elimination>(this->blocks.pattern, this->positions, context);
  }

  Cholesky analysed(const Context& context = Context()) const { return Cholesky(this->eliminated(context)); }
};

// Two threads, whatever the machine has.
Context twoThreads()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    std::thread other([&] { body(0, count / 2); });
    body(count / 2, count);
    other.join();
  };
  return context;
}

} // namespace

TEST(Cholesky, SolvesGridsOfBlocks)
{
  for (const int block : { 1, 2, 3 })
  {
    for (const int side : { 1, 2, 7, 30, 61 })
    {
      const Problem problem(side, block);
      Cholesky factor = problem.analysed();
      ASSERT_TRUE(factor.factorise(problem.blocks, Context()));
      for (const int sides : { 1, 2, 3, 5 })
      {
        const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(problem.matrix.cols(), sides);
        Eigen::MatrixXd x = problem.matrix * expected;
        factor.solve(x, Context());
        EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-11);
      }
    }
  }
}

TEST(Cholesky, OrdersByTheGraphWherePositionsSayNothing)
{
  Problem problem(60, 1);
  const std::size_t expected = problem.eliminated()->storedCount(1);
  std::mt19937 random(3);
  std::vector<Vector3> shuffled = problem.positions;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  // One half so thin that the other is further off than buckets of it can be counted.
  std::vector<Vector3> thin = problem.positions;
  for (Vector3& p : thin)
  {
    p[0] *= p[0] < 0.5 * thin.back()[0] ? 1e-10 : 1.0;
  }
  for (const std::vector<Vector3>& positions :
    { shuffled, std::vector<Vector3>(problem.positions.size(), Vector3(1.0, 2.0, 3.0)), thin })
  {
    problem.positions = positions;
    Cholesky factor = problem.analysed();
    EXPECT_LT(problem.eliminated()->storedCount(1), 5 * expected); // a dense one takes 70 times as many
    ASSERT_TRUE(factor.factorise(problem.blocks, Context()));
    Eigen::MatrixXd x = problem.matrix * Eigen::VectorXd::Ones(problem.matrix.cols());
    factor.solve(x, Context());
    EXPECT_LT((x.array() - 1.0).abs().maxCoeff(), 1e-11);
  }
}

TEST(Cholesky, IsTheSameOnOneAndOnTwoThreads)
{
  for (const int block : { 1, 3 })
  {
    const Problem problem(70, block);
    const Eigen::MatrixXd given = Eigen::MatrixXd::Random(problem.matrix.cols(), 3);
    Eigen::MatrixXd one = given, two = given;
    Cholesky serial = problem.analysed(), parallel = problem.analysed(twoThreads());
    ASSERT_TRUE(serial.factorise(problem.blocks, Context()));
    ASSERT_TRUE(parallel.factorise(problem.blocks, twoThreads()));
    serial.solve(one, Context());
    parallel.solve(two, twoThreads());
    EXPECT_EQ(one, two);
  }
}

TEST(Cholesky, TakesANewMatrixOfTheSamePattern)
{
  Problem problem(12, 3);
  Cholesky factor = problem.analysed();
  ASSERT_TRUE(factor.factorise(problem.blocks, Context()));
  problem.matrix *= 2.0;
  problem.fillBlocks(3);
  ASSERT_TRUE(factor.factorise(problem.blocks, Context()));
  Eigen::MatrixXd x = problem.matrix * Eigen::VectorXd::Ones(problem.matrix.cols());
  factor.solve(x, Context());
  EXPECT_LT((x.array() - 1.0).abs().maxCoeff(), 1e-12);
}

TEST(Cholesky, RefusesWhatIsNotPositiveDefinite)
{
  Problem problem(6, 1);
  const Sparse good = problem.matrix;
  problem.matrix.coeffRef(7, 7) = -1.0;
  problem.fillBlocks(1);
  EXPECT_FALSE(problem.analysed().factorise(problem.blocks, Context()));
  // The graph Laplacian is singular: constants are in its null space.
  problem.matrix = good;
  for (int i = 0; i < good.cols(); ++i)
  {
    for (Sparse::InnerIterator it(problem.matrix, i); it; ++it)
    {
      it.valueRef() = it.row() == i ? static_cast<double>(good.col(i).nonZeros() - 1) : -1.0;
    }
  }
  problem.fillBlocks(1);
  EXPECT_FALSE(problem.analysed().factorise(problem.blocks, Context()));
}

TEST(Cholesky, CanBeCancelledHalfway)
{
  const Problem problem(70, 3);
  Cholesky factor = problem.analysed();
  double reached = 0.0;
  Context context;
  context.progress = [&](double done) { reached = done; };
  context.cancelled = [&] { return reached > 0.5; };
  EXPECT_THROW(factor.factorise(problem.blocks, context), Error);
  EXPECT_LT(reached, 0.95);
  EXPECT_TRUE(factor.factorise(problem.blocks, Context()));
}
