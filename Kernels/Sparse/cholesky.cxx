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

// Copies one column of a block. For the usual sizes without a call.
inline void copyColumn(const double* from, int block, double* to)
{
  switch (block)
  {
    case 1:
      to[0] = from[0];
      break;
    case 3:
      to[0] = from[0];
      to[1] = from[1];
      to[2] = from[2];
      break;
    default:
      std::copy_n(from, block, to);
  }
}

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

// About the number of multiplications.
double workOf(const Supernode& node)
{
  const double height = node.columns + static_cast<double>(node.rows.size());
  return height * height * node.columns;
}

} // namespace

Cholesky::Cholesky(std::shared_ptr<const Elimination> elimination, std::shared_ptr<FactorMemory> memory)
  : elimination_(std::move(elimination))
  , memory_(std::move(memory))
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
  this->memory_->panels.reserve(panels); // cleared panel by panel, on the thread that works on it
  this->smallest_.resize(static_cast<std::size_t>(this->elimination_->nodeCount()) * this->block_);
}

// Where the matrix that each supernode hands on is kept until its parent takes it. Each subtree, and the rest
// of the tree, has two stacks, for even and odd depths: then the children of a supernode are on top of one,
// and it pushes on the other one. The stacks of the subtrees lie in the memory of the thread at work, all but
// what their roots hand on.
void Cholesky::placeUpdates()
{
  const Elimination& elimination = *this->elimination_;
  this->updatePlaces_.assign(elimination.supernodes.size(), 0);
  const auto size = [this](int s)
  {
    const PanelShape shape = this->shapeOf(s);
    return static_cast<std::size_t>(shape.others) * static_cast<std::size_t>(shape.rows);
  };
  // Places the supernodes first .. last of one subtree, or those of none, and returns the size of the stacks.
  const auto place = [&](int subtree, int first, int last)
  {
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
      this->updatePlaces_[s] += node.subtree == subtree && node.depth % 2 ? most[0] : 0;
    }
    return most[0] + most[1];
  };
  std::size_t shared = place(-1, 0, static_cast<int>(elimination.supernodes.size()) - 1), stacks = 0;
  for (int subtree = 0; subtree < static_cast<int>(elimination.subtrees.size()); ++subtree)
  {
    const auto [first, root] = elimination.subtrees[subtree];
    stacks = std::max(stacks, place(subtree, first, root - 1));
    this->updatePlaces_[root] = shared;
    shared += size(root);
  }
  this->memory_->updates.reserve(shared);
  this->stackSize_ = stacks;
}

// Where the supernode's update is: the stacks are those of the thread that works on its subtree.
double* Cholesky::updateOf(int s, const Memory& stacks) const
{
  const int subtree = this->elimination_->supernodes[s].subtree;
  const bool shared = subtree < 0 || this->elimination_->subtrees[subtree][1] == s;
  return (shared ? this->memory_->updates : stacks).data() + this->updatePlaces_[s];
}

// Clears the panel and puts the matrix's entries there. place is scratch.
void Cholesky::assemble(int s, const BlockMatrix& matrix, std::vector<int>& place)
{
  const Elimination& elimination = *this->elimination_;
  const Supernode& node = elimination.supernodes[s];
  const int b = this->block_;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t ld = static_cast<std::size_t>(shape.height);
  double* panel = this->memory_->panels.data() + this->panelPlaces_[s];
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
          copyColumn(value + c * b, b, columns + ld * c + place[row]);
        }
      }
    }
    for (int c = 0; c < b; ++c)
    {
      smallest[i * b + c] = 1e-12 * columns[ld * c + i * b + c];
    }
  }
}

// Adds what the children handed on to the panel, or to what the supernode hands on itself.
void Cholesky::gather(int s, bool toPanel, const Memory& stacks, const Context& context)
{
  const Supernode& node = this->elimination_->supernodes[s];
  const PanelShape shape = this->shapeOf(s);
  double* into = toPanel ? this->memory_->panels.data() + this->panelPlaces_[s] : this->updateOf(s, stacks);
  const int step = toPanel ? shape.height : shape.others;
  const int skipped = toPanel ? 0 : shape.own; // rows of the panel's numbering above the first of `into`
  for (const int child : node.children)
  {
    if (child < 0)
    {
      continue;
    }
    const std::vector<Run> runs = runsOf(this->elimination_->supernodes[child], node, this->block_);
    const std::size_t height = static_cast<std::size_t>(this->shapeOf(child).others);
    const double* values = this->updateOf(child, stacks);
    const auto second =
      std::find_if(runs.begin(), runs.end(), [&](const Run& run) { return run.to >= shape.own; });
    const auto first = toPanel ? runs.begin() : second, last = toPanel ? second : runs.end();
    context.parallelFor(static_cast<int>(last - first),
      [&](int begin, int end)
      {
        for (auto columns = first + begin; columns != first + end; ++columns)
        {
          double* to = into + static_cast<std::size_t>(columns->to - skipped) * step;
          const double* from = values + static_cast<std::size_t>(columns->from) * height;
          for (int j = 0; j < columns->count; ++j, to += step, from += height)
          {
            for (int i = j; i < columns->count; ++i)
            {
              to[columns->to - skipped + i] += from[columns->from + i];
            }
            for (auto run = columns + 1; run != runs.end(); ++run)
            {
              for (int i = 0; i < run->count; ++i)
              {
                to[run->to - skipped + i] += from[run->from + i];
              }
            }
          }
        }
      });
  }
}

// Factors the panel, some columns at a time, and makes what is handed on.
bool Cholesky::eliminate(int s, const Memory& stacks, std::vector<double>& packed, const Context& context)
{
  const DenseKernels& dense = denseKernels();
  const PanelShape shape = this->shapeOf(s);
  this->gather(s, true, stacks, context);
  double* panel = this->memory_->panels.data() + this->panelPlaces_[s];
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
    this->eliminateFrom(s, done, count, stacks, packed, context);
  }
  if (shape.columns == 0)
  {
    std::fill_n(this->updateOf(s, stacks), static_cast<std::size_t>(shape.others) * shape.rows, 0.0);
  }
  this->gather(s, false, stacks, context);
  return true;
}

// Takes the square of `count` columns, packed from row `start` on, from the columns from `start` on and from
// what is handed on.
void Cholesky::eliminateFrom(int s,
  int done,
  int count,
  const Memory& stacks,
  const std::vector<double>& packed,
  const Context& context)
{
  const DenseKernels& dense = denseKernels();
  const PanelShape shape = this->shapeOf(s);
  double* panel = this->memory_->panels.data() + this->panelPlaces_[s];
  double* update = this->updateOf(s, stacks);
  const int start = done + count < shape.columns ? done + count : shape.own;
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
          const bool fresh = column >= own && done == 0;
          dense.multiply(c,
            column < own ? shape.height : shape.others,
            a,
            b,
            count,
            last - row,
            std::min(8, columns),
            fresh);
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
    this->placeUpdates();
  }
  std::atomic<bool> good(true);
  const Context serial;
  context.checkpoint(0.0);
  elimination.forSubtrees(context,
    [&](int subtree)
    {
      const auto stacks = this->memory_->stacks.take(this->stackSize_);
      std::vector<int> place(elimination.order.size());
      std::vector<double> packed;
      const auto [first, last] = elimination.subtrees[subtree];
      for (int s = first; s <= last && good && !context.cancelled(); ++s)
      {
        this->assemble(s, matrix, place);
        if (!this->eliminate(s, *stacks, packed, serial))
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
      good = this->eliminate(s, this->memory_->updates, packed, context);
    }
  }
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
  const std::size_t height = static_cast<std::size_t>(shape.height);
  local.assign(height * sides, 0.0);
  double* own = this->solution_.data() + static_cast<std::size_t>(node.first) * b * sides;
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
    const double* from = this->vectors_.data() + this->vectorPlaces_[child] * sides;
    for (const Run& run : runsOf(elimination.supernodes[child], node, b))
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
    this->memory_->panels.data() + this->panelPlaces_[s], shape.height, shape.columns, local.data(), sides);
  for (int i = 0; i < shape.columns; ++i)
  {
    collect(local.data() + i, height, sides, own + i * sides);
  }
  double* handed = this->vectors_.data() + this->vectorPlaces_[s] * sides;
  for (int side = 0; side < sides; ++side)
  {
    std::copy_n(local.data() + side * height + shape.own, shape.others, handed + side * shape.others);
  }
}

// Solves for the supernode's own unknowns from those after them.
void Cholesky::backward(int s, int sides, std::vector<double>& local)
{
  const Supernode& node = this->elimination_->supernodes[s];
  const int b = this->block_;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t height = static_cast<std::size_t>(shape.height);
  local.assign(height * sides, 0.0);
  double* own = this->solution_.data() + static_cast<std::size_t>(node.first) * b * sides;
  for (int i = 0; i < shape.columns; ++i)
  {
    scatter(own + i * sides, local.data() + i, height, sides);
  }
  double* to = local.data() + shape.own;
  for (const int row : node.rows)
  {
    const double* from = this->solution_.data() + static_cast<std::size_t>(row) * b * sides;
    for (int k = 0; k < b; ++k, ++to)
    {
      scatter(from + k * sides, to, height, sides);
    }
  }
  denseKernels().backward(
    this->memory_->panels.data() + this->panelPlaces_[s], shape.height, shape.columns, local.data(), sides);
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
  const Elimination& elimination = *this->elimination_;
  const int b = this->block_;
  const std::size_t all = this->smallest_.size();
  for (Eigen::Index solved = 0; solved < rightSide.cols();)
  {
    const int sides = rightSide.cols() - solved >= 3 ? 3 : 1;
    this->solution_.resize(all * sides);
    this->vectors_.resize(this->vectorPlaces_.back() * sides);
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
              this->solution_.data() + static_cast<std::size_t>(row) * sides);
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
