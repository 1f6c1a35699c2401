// Solving with a factor: down the tree of supernodes and up again.
#include "Sparse/cholesky.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// One row of the right-hand sides, from side by side to one after the other (`step` apart), and back.
inline void scatter(const double* from, double* to, std::size_t step, int sides)
{
  to[0] = from[0];
  if (sides == 3)
  {
    to[step] = from[1];
    to[2 * step] = from[2];
  }
}
inline void collect(const double* from, std::size_t step, int sides, double* to)
{
  to[0] = from[0];
  if (sides == 3)
  {
    to[1] = from[step];
    to[2] = from[2 * step];
  }
}

} // namespace

// Solves for the supernode's own unknowns and hands on what the others get from them.
void Cholesky::forward(int s, int sides, std::vector<double>& local)
{
  const Elimination& elimination = *this->Symbolic;
  const Supernode& node = elimination.supernodes[s];
  const int b = this->Block;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t height = static_cast<std::size_t>(shape.height);
  local.resize(height * sides);
  for (int side = 0; side < sides; ++side)
  {
    std::fill(local.data() + side * height + shape.columns, local.data() + (side + 1) * height, 0.0);
  }
  double* own = this->Solution.data() + static_cast<std::size_t>(node.first) * b * sides;
  for (int i = 0; i < shape.columns; ++i)
  {
    scatter(own + i * sides, local.data() + i, height, sides);
  }
  for (const int child : node.children)
  {
    if (child < 0)
    {
      continue;
    }
    const int rows = this->shapeOf(child).others;
    const double* from = this->Vectors.data() + this->VectorPlaces[child] * sides;
    for (const Run& run : this->Runs[child])
    {
      for (int side = 0; side < sides; ++side)
      {
        const double* in = from + side * rows + run.from;
        double* out = local.data() + side * height + run.to;
        for (int i = 0; i < run.count; ++i)
        {
          out[i] += in[i];
        }
      }
    }
  }
  denseKernels().forward(
    this->Buffers->panels.data() + this->PanelPlaces[s], shape.height, shape.columns, local.data(), sides);
  for (int i = 0; i < shape.columns; ++i)
  {
    collect(local.data() + i, height, sides, own + i * sides);
  }
  double* handed = this->Vectors.data() + this->VectorPlaces[s] * sides;
  for (int side = 0; side < sides; ++side)
  {
    std::copy_n(local.data() + side * height + shape.own, shape.others, handed + side * shape.others);
  }
}

// Solves for the supernode's own unknowns from those after them.
void Cholesky::backward(int s, int sides, std::vector<double>& local)
{
  const Supernode& node = this->Symbolic->supernodes[s];
  const int b = this->Block;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t height = static_cast<std::size_t>(shape.height);
  local.resize(height * sides);
  for (int side = 0; side < sides; ++side) // the padding
  {
    double* first = local.data() + side * height;
    std::fill(first + shape.columns, first + shape.own, 0.0);
    std::fill(first + shape.own + shape.rows, first + shape.height, 0.0);
  }
  double* own = this->Solution.data() + static_cast<std::size_t>(node.first) * b * sides;
  for (int i = 0; i < shape.columns; ++i)
  {
    scatter(own + i * sides, local.data() + i, height, sides);
  }
  double* to = local.data() + shape.own;
  for (const int row : node.rows)
  {
    const double* from = this->Solution.data() + static_cast<std::size_t>(row) * b * sides;
    for (int k = 0; k < b; ++k, ++to)
    {
      scatter(from + k * sides, to, height, sides);
    }
  }
  denseKernels().backward(
    this->Buffers->panels.data() + this->PanelPlaces[s], shape.height, shape.columns, local.data(), sides);
  for (int i = 0; i < shape.columns; ++i)
  {
    collect(local.data() + i, height, sides, own + i * sides);
  }
}

void Cholesky::sweep(const std::vector<int>& level, Step step, int sides, const Context& context)
{
  context.parallelFor(static_cast<int>(level.size()),
    [&](int begin, int end)
    {
      std::vector<double> local;
      for (int i = begin; i < end; ++i)
      {
        (this->*step)(level[i], sides, local);
      }
    });
}

void Cholesky::solve(Eigen::MatrixXd& rightSide, const Context& context)
{
  const Elimination& elimination = *this->Symbolic;
  const int b = this->Block;
  const std::size_t all = this->Smallest.size();
  for (Eigen::Index solved = 0; solved < rightSide.cols();)
  {
    const int sides = rightSide.cols() - solved >= 3 ? 3 : 1;
    this->Solution.resize(all * sides);
    this->Vectors.resize(this->VectorPlaces.back() * sides);
    double* outer = rightSide.data() + solved * rightSide.rows();
    // Calls move(entry outside, row inside) for each row; the sides of a row stand together inside.
    const auto permute = [&](const auto& move)
    {
      context.parallelFor(elimination.nodeCount(),
        [&](int begin, int end)
        {
          for (int row = begin * b; row < end * b; ++row)
          {
            move(outer + static_cast<std::size_t>(elimination.inverse[row / b]) * b + row % b,
              this->Solution.data() + static_cast<std::size_t>(row) * sides);
          }
        });
    };
    permute([=](double* given, double* row) { collect(given, all, sides, row); });
    elimination.forSubtrees(context,
      [&](int subtree)
      {
        std::vector<double> local;
        for (int s = elimination.subtrees[subtree][0]; s <= elimination.subtrees[subtree][1]; ++s)
        {
          this->forward(s, sides, local);
        }
      });
    for (const auto& level : elimination.levels)
    {
      this->sweep(level, &Cholesky::forward, sides, context);
    }
    for (auto level = elimination.levels.rbegin(); level != elimination.levels.rend(); ++level)
    {
      this->sweep(*level, &Cholesky::backward, sides, context);
    }
    elimination.forSubtrees(context,
      [&](int subtree)
      {
        std::vector<double> local;
        for (int s = elimination.subtrees[subtree][1]; s >= elimination.subtrees[subtree][0]; --s)
        {
          this->backward(s, sides, local);
        }
      });
    context.checkpoint(static_cast<double>(solved + sides) / static_cast<double>(rightSide.cols()));
    permute([=](double* given, double* row) { scatter(row, given, all, sides); });
    solved += sides;
  }
}

} // namespace oversketch
