#include "Sparse/cholesky.h"

#include "Sparse/dense.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr int panelColumns = 96; // columns eliminated at a time: their strips of 24 rows stay in the caches
constexpr int panelRows = 192;   // rows that a thread takes, a multiple of 24

// Rows of a child that stay together in its parent's panel, in entries of the padded panels.
struct Run
{
  int from, to, count;
};

std::vector<Run> runsOf(const Supernode& child, const Supernode& parent, int block)
{
  const int own = PanelShape(parent, block).own;
  std::vector<Run> runs;
  int last = -1;
  for (int i = 0; i < static_cast<int>(child.toParent.size()); ++i)
  {
    const int to = child.toParent[i];
    if (i == 0 || to != last + 1 || to == parent.columns)
    {
      const int entry = to < parent.columns ? to * block : own + (to - parent.columns) * block;
      runs.push_back({ i * block, entry, 0 });
    }
    runs.back().count += block;
    last = to;
  }
  return runs;
}

// About the number of multiplications.
double workOf(const Supernode& node)
{
  const double height = node.columns + static_cast<double>(node.rows.size());
  return height * height * node.columns;
}

} // namespace

Cholesky::Cholesky(std::shared_ptr<const Elimination> elimination)
  : elimination_(std::move(elimination))
{
}

void Cholesky::placePanels()
{
  this->panelPlaces_.clear();
  this->vectorPlaces_.clear();
  std::size_t panels = 0, vectors = 0;
  for (const Supernode& node : this->elimination_->supernodes)
  {
    const PanelShape shape(node, this->block_);
    this->panelPlaces_.push_back(panels);
    this->vectorPlaces_.push_back(vectors);
    panels += shape.size();
    vectors += static_cast<std::size_t>(shape.others);
  }
  this->vectorPlaces_.push_back(vectors);
  this->panels_.reset();
  this->panels_.reset(new double[panels]); // cleared panel by panel, on the thread that works on it
  this->smallest_.resize(static_cast<std::size_t>(this->elimination_->nodeCount()) * this->block_);
}

// Where the matrix that each supernode hands on is kept until its parent takes it. Each subtree, and the rest
// of the tree, has two stacks, for even and odd depths: then the children of a supernode are on top of one,
// and it pushes on the other one. Returns the size of all.
std::size_t Cholesky::placeUpdates()
{
  const Elimination& elimination = *this->elimination_;
  this->updatePlaces_.resize(elimination.supernodes.size());
  const auto size = [this](int s)
  {
    const PanelShape shape = this->shapeOf(s);
    return static_cast<std::size_t>(shape.others) * static_cast<std::size_t>(shape.rows);
  };
  std::size_t base = 0;
  for (int subtree = -1; subtree < static_cast<int>(elimination.subtrees.size()); ++subtree)
  {
    const int first = subtree < 0 ? 0 : elimination.subtrees[subtree][0];
    const int last =
      subtree < 0 ? static_cast<int>(elimination.supernodes.size()) - 1 : elimination.subtrees[subtree][1];
    std::array<std::size_t, 2> top{}, most{};
    for (int s = first; s <= last; ++s)
    {
      const Supernode& node = elimination.supernodes[s];
      if (node.subtree == subtree)
      {
        const int stack = node.depth % 2;
        this->updatePlaces_[s] = top[stack];
        top[stack] += size(s);
        most[stack] = std::max(most[stack], top[stack]);
        for (const int child : node.children)
        {
          if (child >= 0 && elimination.supernodes[child].subtree == subtree)
          {
            top[1 - stack] -= size(child);
          }
        }
      }
    }
    for (int s = first; s <= last; ++s)
    {
      const Supernode& node = elimination.supernodes[s];
      if (node.subtree == subtree)
      {
        this->updatePlaces_[s] += base + (node.depth % 2 ? most[0] : 0);
      }
    }
    base += most[0] + most[1];
  }
  return base;
}

// Clears the panel and puts the matrix's entries there. place is scratch.
void Cholesky::assemble(int s, const BlockMatrix& matrix, std::vector<int>& place)
{
  const Elimination& elimination = *this->elimination_;
  const Supernode& node = elimination.supernodes[s];
  const int b = this->block_;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t ld = static_cast<std::size_t>(shape.height);
  double* panel = this->panels_.get() + this->panelPlaces_[s];
  std::fill_n(panel, shape.size(), 0.0);
  for (int i = 0; i < node.columns; ++i)
  {
    place[node.first + i] = i * b;
  }
  for (int i = 0; i < static_cast<int>(node.rows.size()); ++i)
  {
    place[node.rows[i]] = shape.own + i * b;
  }
  double* smallest = this->smallest_.data() + static_cast<std::size_t>(node.first) * b;
  for (int i = 0; i < node.columns; ++i)
  {
    const int v = elimination.inverse[node.first + i];
    double* columns = panel + ld * i * b;
    for (int k = matrix.pattern.offsets[v]; k < matrix.pattern.offsets[v + 1]; ++k)
    {
      const int row = elimination.order[matrix.pattern.values[k]];
      if (row >= node.first + i)
      {
        const double* value = matrix.values.data() + static_cast<std::size_t>(k) * b * b;
        for (int c = 0; c < b; ++c)
        {
          std::copy_n(value + c * b, b, columns + ld * c + place[row]);
        }
      }
    }
    for (int c = 0; c < b; ++c)
    {
      smallest[i * b + c] = 1e-12 * columns[ld * c + i * b + c];
    }
  }
}

// Adds what the children handed on, after clearing what the node will.
void Cholesky::gather(int s, const Context& context)
{
  const Supernode& node = this->elimination_->supernodes[s];
  const PanelShape shape = this->shapeOf(s);
  double* panel = this->panels_.get() + this->panelPlaces_[s];
  double* update = this->updates_.get() + this->updatePlaces_[s];
  context.parallelFor(shape.rows,
    [&](int begin, int end)
    {
      for (int j = begin; j < end; ++j)
      {
        const int first = j / 8 * 8; // tiles reach this far above the diagonal
        std::fill_n(update + static_cast<std::size_t>(j) * shape.others + first, shape.others - first, 0.0);
      }
    });
  for (const int child : node.children)
  {
    if (child < 0)
    {
      continue;
    }
    const std::vector<Run> runs = runsOf(this->elimination_->supernodes[child], node, this->block_);
    const std::size_t height = static_cast<std::size_t>(this->shapeOf(child).others);
    const double* values = this->updates_.get() + this->updatePlaces_[child];
    context.parallelFor(static_cast<int>(runs.size()),
      [&](int begin, int end)
      {
        for (int r = begin; r < end; ++r)
        {
          const Run columns = runs[r];
          double* to =
            columns.to < shape.own
              ? panel + static_cast<std::size_t>(columns.to) * shape.height
              : update + static_cast<std::size_t>(columns.to - shape.own) * shape.others - shape.own;
          const int step = columns.to < shape.own ? shape.height : shape.others;
          const double* from = values + static_cast<std::size_t>(columns.from) * height;
          for (int j = 0; j < columns.count; ++j, to += step, from += height)
          {
            for (int i = j; i < columns.count; ++i)
            {
              to[columns.to + i] += from[columns.from + i];
            }
            for (auto run = runs.begin() + r + 1; run != runs.end(); ++run)
            {
              for (int i = 0; i < run->count; ++i)
              {
                to[run->to + i] += from[run->from + i];
              }
            }
          }
        }
      });
  }
}

// Factors the panel and takes its square from what is handed on, some columns at a time.
bool Cholesky::eliminate(int s, std::vector<double>& packed, const Context& context)
{
  const DenseKernels& dense = denseKernels();
  const PanelShape shape = this->shapeOf(s);
  double* panel = this->panels_.get() + this->panelPlaces_[s];
  const double* smallest =
    this->smallest_.data() + static_cast<std::size_t>(this->elimination_->supernodes[s].first) * this->block_;
  const std::size_t ld = static_cast<std::size_t>(shape.height);
  for (int done = 0; done < shape.columns; done += panelColumns)
  {
    const int count = std::min(panelColumns, shape.columns - done);
    double* corner = panel + done + done * ld;
    if (context.cancelled() || !dense.factor(corner, shape.height, count, smallest + done))
    {
      return false;
    }
    const int start = done + count < shape.columns ? done + count : shape.own;
    const int below = shape.height - start;
    packed.resize(std::max(packed.size(), static_cast<std::size_t>(roundedUp(below, 24)) * count));
    context.parallelFor(roundedUp(below, panelRows) / panelRows,
      [&](int begin, int end)
      {
        for (int first = begin * panelRows; first < std::min(end * panelRows, below); first += panelRows)
        {
          const int rows = std::min(panelRows, below - first);
          double* x = panel + start + first + done * ld;
          dense.solveRows(corner, x, shape.height, rows, count);
          pack(x, shape.height, rows, count, packed.data() + static_cast<std::size_t>(first) * count);
        }
      });
    this->eliminateFrom(s, start, count, packed, context);
  }
  return true;
}

// Takes the square of `count` columns, packed from row `start` on, from the columns from `start` on and from
// what is handed on.
void Cholesky::eliminateFrom(int s,
  int start,
  int count,
  const std::vector<double>& packed,
  const Context& context)
{
  const DenseKernels& dense = denseKernels();
  const PanelShape shape = this->shapeOf(s);
  double* panel = this->panels_.get() + this->panelPlaces_[s];
  double* update = this->updates_.get() + this->updatePlaces_[s];
  const int below = shape.height - start;
  const int own = shape.own - start; // rows, and padded columns, that the panel has from there on
  const std::size_t strip = static_cast<std::size_t>(24) * count;
  context.parallelFor(roundedUp(below, 24) / 24,
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        const int last = std::min(24 * p + 24, below);
        for (int column = 0; column < last; column += 8)
        {
          const int row = std::max(24 * p, column);
          const double* a = packed.data() + p * strip + (row - 24 * p);
          const double* b = packed.data() + column / 24 * strip + column % 24;
          double* c = column < own
                        ? panel + (start + row) + static_cast<std::size_t>(start + column) * shape.height
                        : update + (row - own) + static_cast<std::size_t>(column - own) * shape.others;
          const int columns = column < own ? shape.columns - start - column : shape.rows - (column - own);
          dense.multiply(
            c, column < own ? shape.height : shape.others, a, b, count, last - row, std::min(8, columns));
        }
      }
    });
}

bool Cholesky::factorise(const BlockMatrix& matrix, const Context& context)
{
  const Elimination& elimination = *this->elimination_;
  if (this->block_ != matrix.block)
  {
    this->block_ = matrix.block;
    this->placePanels();
  }
  this->updates_.reset(new double[this->placeUpdates()]);
  std::atomic<bool> good(true);
  const Context serial;
  context.checkpoint(0.0);
  elimination.forSubtrees(context,
    [&](int subtree)
    {
      std::vector<int> place(elimination.order.size());
      std::vector<double> packed;
      const auto [first, last] = elimination.subtrees[subtree];
      for (int s = first; s <= last && good && !context.cancelled(); ++s)
      {
        this->assemble(s, matrix, place);
        this->gather(s, serial);
        if (!this->eliminate(s, packed, serial))
        {
          good = false;
        }
      }
    });
  double total = 0.0, done = 0.0;
  for (const Supernode& node : elimination.supernodes)
  {
    total += workOf(node);
    done += node.subtree < 0 ? 0.0 : workOf(node);
  }
  std::vector<int> place(elimination.order.size());
  std::vector<double> packed;
  for (int s = 0; s < static_cast<int>(elimination.supernodes.size()) && good; ++s)
  {
    if (elimination.supernodes[s].subtree < 0)
    {
      context.checkpoint(done / total);
      done += workOf(elimination.supernodes[s]);
      this->assemble(s, matrix, place);
      this->gather(s, context);
      good = this->eliminate(s, packed, context);
    }
  }
  this->updates_.reset();
  context.checkpoint(good ? 1.0 : done / total);
  return good;
}

// Solves for the supernode's own unknowns and hands on what the others get from them.
void Cholesky::forward(int s, int sides, std::vector<double>& local)
{
  const Elimination& elimination = *this->elimination_;
  const Supernode& node = elimination.supernodes[s];
  const int b = this->block_;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t all = this->smallest_.size();
  local.assign(static_cast<std::size_t>(shape.height) * sides, 0.0);
  for (int side = 0; side < sides; ++side)
  {
    std::copy_n(this->solution_.data() + side * all + static_cast<std::size_t>(node.first) * b,
      shape.columns,
      local.data() + static_cast<std::size_t>(side) * shape.height);
  }
  for (const int child : node.children)
  {
    if (child < 0)
    {
      continue;
    }
    const std::vector<int>& toParent = elimination.supernodes[child].toParent;
    const int height = this->shapeOf(child).others;
    const double* from = this->vectors_.data() + this->vectorPlaces_[child] * sides;
    for (int side = 0; side < sides; ++side, from += height)
    {
      double* to = local.data() + static_cast<std::size_t>(side) * shape.height;
      for (std::size_t i = 0; i < toParent.size(); ++i)
      {
        const int row = toParent[i];
        double* out = to + (row < node.columns ? row * b : shape.own + (row - node.columns) * b);
        for (int k = 0; k < b; ++k)
        {
          out[k] += from[i * b + k];
        }
      }
    }
  }
  denseKernels().forward(
    this->panels_.get() + this->panelPlaces_[s], shape.height, shape.columns, local.data(), sides);
  double* handed = this->vectors_.data() + this->vectorPlaces_[s] * sides;
  for (int side = 0; side < sides; ++side)
  {
    const double* from = local.data() + static_cast<std::size_t>(side) * shape.height;
    std::copy_n(
      from, shape.columns, this->solution_.data() + side * all + static_cast<std::size_t>(node.first) * b);
    std::copy_n(from + shape.own, shape.others, handed + static_cast<std::size_t>(side) * shape.others);
  }
}

// Solves for the supernode's own unknowns from those after them.
void Cholesky::backward(int s, int sides, std::vector<double>& local)
{
  const Supernode& node = this->elimination_->supernodes[s];
  const int b = this->block_;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t all = this->smallest_.size();
  local.assign(static_cast<std::size_t>(shape.height) * sides, 0.0);
  for (int side = 0; side < sides; ++side)
  {
    const double* from = this->solution_.data() + side * all;
    double* to = local.data() + static_cast<std::size_t>(side) * shape.height;
    std::copy_n(from + static_cast<std::size_t>(node.first) * b, shape.columns, to);
    to += shape.own;
    for (const int row : node.rows)
    {
      to = std::copy_n(from + static_cast<std::size_t>(row) * b, b, to);
    }
  }
  denseKernels().backward(
    this->panels_.get() + this->panelPlaces_[s], shape.height, shape.columns, local.data(), sides);
  for (int side = 0; side < sides; ++side)
  {
    std::copy_n(local.data() + static_cast<std::size_t>(side) * shape.height,
      shape.columns,
      this->solution_.data() + side * all + static_cast<std::size_t>(node.first) * b);
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
  const Elimination& elimination = *this->elimination_;
  const int b = this->block_;
  const std::size_t all = this->smallest_.size();
  for (Eigen::Index solved = 0; solved < rightSide.cols();)
  {
    const int sides = rightSide.cols() - solved >= 3 ? 3 : 1;
    this->solution_.resize(all * sides);
    this->vectors_.resize(this->vectorPlaces_.back() * sides);
    double* outer = rightSide.data() + solved * rightSide.rows();
    // Calls move(place outside, place inside) for each node and side.
    const auto permute = [&](const auto& move)
    {
      context.parallelFor(elimination.nodeCount(),
        [&](int begin, int end)
        {
          for (int side = 0; side < sides; ++side)
          {
            for (int i = begin; i < end; ++i)
            {
              move(outer + side * all + static_cast<std::size_t>(elimination.inverse[i]) * b,
                this->solution_.data() + side * all + static_cast<std::size_t>(i) * b);
            }
          }
        });
    };
    permute([b](double* from, double* to) { std::copy_n(from, b, to); });
    elimination.forSubtrees(context,
      [&](int subtree)
      {
        std::vector<double> local;
        for (int s = elimination.subtrees[subtree][0]; s <= elimination.subtrees[subtree][1]; ++s)
        {
          this->forward(s, sides, local);
        }
      });
    for (auto level = elimination.levels.begin(); level != elimination.levels.end(); ++level)
    {
      this->sweep(*level, &Cholesky::forward, sides, context);
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
    permute([b](double* to, const double* from) { std::copy_n(from, b, to); });
    solved += sides;
  }
}

} // namespace oversketch
