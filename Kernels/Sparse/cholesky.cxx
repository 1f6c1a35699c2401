#include "Sparse/cholesky.h"

#include "Sparse/dense.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr int stripRows = 24;    // of the strips that `pack` makes
constexpr int panelColumns = 96; // eliminated at a time, in whole strips: a strip of them stays in the caches
constexpr int solvedStrips = 8;  // that are solved together

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

// About the number of multiplications.
double workOf(const Supernode& node)
{
  const double height = node.columns + static_cast<double>(node.rows.size());
  return height * height * node.columns;
}

} // namespace

// The strips that a supernode's solved rows are packed in: first those of its own rows, then the others'.
struct Cholesky::Strips
{
  Strips(const PanelShape& panel, double* memory)
    : shape(panel)
    , own(roundedUp(panel.own, stripRows) / stripRows)
    , all(own + roundedUp(panel.others, stripRows) / stripRows)
    , packed(memory)
  {
  }
  std::size_t size() const { return static_cast<std::size_t>(this->all) * stripRows * this->shape.columns; }
  int first(int p) const
  {
    return p < this->own ? p * stripRows : this->shape.own + (p - this->own) * stripRows;
  }
  int last(int p) const
  {
    return std::min(this->first(p) + stripRows, p < this->own ? this->shape.own : this->shape.height);
  }
  // Columns done .. done + count - 1 of strip p.
  double* at(int p, int done, int count) const
  {
    return this->packed +
           (static_cast<std::size_t>(this->all) * done + static_cast<std::size_t>(p) * count) * stripRows;
  }

  // Takes strip p times strip q, transposed, over the columns done .. done + count - 1 from c, column
  // `column` of it at c + column ldc; above the diagonal nothing.
  void take(int p, int q, int done, int count, double* c, int ldc, int columns, bool fresh) const
  {
    const DenseKernels& dense = denseKernels();
    const int rows = this->last(p) - this->first(p);
    for (int column = 0; column < columns; column += 8)
    {
      const int row = p == q ? column : 0;
      dense.multiply(c + row + static_cast<std::size_t>(column) * ldc,
        ldc,
        this->at(p, done, count) + row,
        this->at(q, done, count) + column,
        count,
        rows - row,
        std::min(8, columns - column),
        fresh);
    }
  }

  const PanelShape shape;
  const int own, all; // number
  double* const packed;
};

Cholesky::Cholesky(std::shared_ptr<const Elimination> elimination, std::shared_ptr<FactorMemory> memory)
  : Symbolic(std::move(elimination))
  , Buffers(std::move(memory))
{
}

void Cholesky::placePanels()
{
  this->PanelPlaces.clear();
  this->VectorPlaces.clear();
  std::size_t panels = 0, vectors = 0;
  this->StripsSize = 0;
  for (const Supernode& node : this->Symbolic->supernodes)
  {
    const PanelShape shape(node, this->Block);
    this->PanelPlaces.push_back(panels);
    this->VectorPlaces.push_back(vectors);
    panels += shape.size();
    vectors += static_cast<std::size_t>(shape.others);
    this->StripsSize = std::max(this->StripsSize, Strips(shape, nullptr).size());
  }
  this->VectorPlaces.push_back(vectors);
  this->Buffers->panels.reserve(panels); // cleared panel by panel, on the thread that works on it
  this->Runs.resize(this->Symbolic->supernodes.size());
  this->Smallest.resize(static_cast<std::size_t>(this->Symbolic->nodeCount()) * this->Block);
}

// Where the matrix that each supernode hands on is kept until its parent takes it. Each subtree, and the rest
// of the tree, has two stacks, for even and odd depths: then the children of a supernode are on top of one,
// and it pushes on the other one. The stacks of the subtrees lie in the memory of the thread at work, all but
// what their roots hand on.
void Cholesky::placeUpdates()
{
  const Elimination& elimination = *this->Symbolic;
  this->UpdatePlaces.assign(elimination.supernodes.size(), 0);
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
        this->UpdatePlaces[s] = top[stack];
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
      this->UpdatePlaces[s] += node.subtree == subtree && node.depth % 2 ? most[0] : 0;
    }
    return most[0] + most[1];
  };
  std::size_t shared = place(-1, 0, static_cast<int>(elimination.supernodes.size()) - 1), stacks = 0;
  for (int subtree = 0; subtree < static_cast<int>(elimination.subtrees.size()); ++subtree)
  {
    const auto [first, root] = elimination.subtrees[subtree];
    stacks = std::max(stacks, place(subtree, first, root - 1));
    this->UpdatePlaces[root] = shared;
    shared += size(root);
  }
  this->Buffers->updates.reserve(shared);
  this->StackSize = stacks;
}

// Where the supernode's update is: the stacks are those of the thread that works on its subtree.
double* Cholesky::updateOf(int s, const Memory& stacks) const
{
  const int subtree = this->Symbolic->supernodes[s].subtree;
  const bool shared = subtree < 0 || this->Symbolic->subtrees[subtree][1] == s;
  return (shared ? this->Buffers->updates : stacks).data() + this->UpdatePlaces[s];
}

// Makes the panel: the matrix's entries and what the children handed on. place is scratch.
void Cholesky::assemble(int s,
  const BlockMatrix& matrix,
  const Memory& stacks,
  std::vector<int>& place,
  const Context& context)
{
  const Elimination& elimination = *this->Symbolic;
  const Supernode& node = elimination.supernodes[s];
  const int b = this->Block;
  const PanelShape shape = this->shapeOf(s);
  const std::size_t ld = static_cast<std::size_t>(shape.height);
  double* panel = this->Buffers->panels.data() + this->PanelPlaces[s];
  for (int i = 0; i < node.columns; ++i)
  {
    place[node.first + i] = i * b;
  }
  for (int i = 0; i < static_cast<int>(node.rows.size()); ++i)
  {
    place[node.rows[i]] = shape.own + i * b;
  }
  for (const int child : node.children)
  {
    if (child >= 0)
    {
      this->Runs[child] = runsOf(elimination.supernodes[child], node, b);
    }
  }
  double* smallest = this->Smallest.data() + static_cast<std::size_t>(node.first) * b;
  context.parallelFor(node.columns,
    [&](int begin, int end)
    {
      std::fill_n(panel + ld * begin * b, ld * (end - begin) * b, 0.0);
      for (int i = begin; i < end; ++i)
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
      this->gather(s, begin, end, panel, shape.height, stacks);
    });
}

// Adds what the children handed on for the columns begin .. end - 1 of the supernode, in nodes, its own and
// the others' after them, to `into`: it has the leading dimension ld and begins at the first of its own
// nodes, or for the others at the first of these.
void Cholesky::gather(int s, int begin, int end, double* into, int ld, const Memory& stacks) const
{
  const Supernode& node = this->Symbolic->supernodes[s];
  const int b = this->Block;
  const bool own = begin < node.columns;
  const int skipped = own ? 0 : this->shapeOf(s).own;
  for (const int child : node.children)
  {
    if (child < 0)
    {
      continue;
    }
    const Supernode& from = this->Symbolic->supernodes[child];
    const std::vector<Run>& runs = this->Runs[child];
    const int height = this->shapeOf(child).others;
    const double* values = this->updateOf(child, stacks);
    const auto position = [&](int place)
    {
      return static_cast<int>(
        std::lower_bound(from.toParent.begin(), from.toParent.end(), place) - from.toParent.begin());
    };
    const int last = position(end) * b;
    auto run = runs.begin();
    for (int column = position(begin) * b; column < last; ++column)
    {
      while (run->from + run->count <= column)
      {
        ++run;
      }
      const int to = run->to + (column - run->from) - skipped;
      denseKernels().add(&*run,
        &*runs.begin() + runs.size(),
        column - run->from,
        values + static_cast<std::size_t>(column) * height,
        into + static_cast<std::size_t>(to) * ld - skipped);
    }
  }
}

// Factors the panel, some columns at a time, and makes what is handed on. Each column takes what the ones
// before it leave for it when its turn comes, so that it is read and written once.
bool Cholesky::eliminate(int s, const Memory& stacks, double* packed, const Context& context)
{
  const DenseKernels& dense = denseKernels();
  const PanelShape shape = this->shapeOf(s);
  const Strips strips(shape, packed);
  double* panel = this->Buffers->panels.data() + this->PanelPlaces[s];
  const double* smallest =
    this->Smallest.data() + static_cast<std::size_t>(this->Symbolic->supernodes[s].first) * this->Block;
  const std::size_t ld = static_cast<std::size_t>(shape.height);
  for (int done = 0; done < shape.columns; done += panelColumns)
  {
    const int count = std::min(panelColumns, shape.columns - done);
    const int top = done / stripRows;
    context.parallelFor(done > 0 ? strips.all - top : 0,
      [&](int begin, int end)
      {
        for (int p = top + begin; p < top + end; ++p)
        {
          for (int before = 0; before < done; before += panelColumns)
          {
            for (int q = top; q <= p && q * stripRows < done + count; ++q)
            {
              strips.take(p,
                q,
                before,
                panelColumns,
                panel + strips.first(p) + q * stripRows * ld,
                shape.height,
                std::min(stripRows, done + count - q * stripRows),
                false);
            }
          }
        }
      });
    double* corner = panel + done + done * ld;
    if (context.cancelled() || !dense.factor(corner, shape.height, count, smallest + done))
    {
      return false;
    }
    const int start = done + count < shape.columns ? top + count / stripRows : strips.own;
    context.parallelFor(strips.all - start,
      [&](int begin, int end)
      {
        for (int p = start + begin; p < start + end;)
        {
          const int next =
            std::min({ p + solvedStrips, start + end, p < strips.own ? strips.own : strips.all });
          const int rows = strips.last(next - 1) - strips.first(p);
          double* x = panel + strips.first(p) + done * ld;
          dense.solveRows(corner, x, shape.height, rows, count);
          pack(x, shape.height, rows, count, strips.at(p, done, count));
          p = next;
        }
      });
  }
  this->handOn(s, strips, stacks, context);
  const Supernode& node = this->Symbolic->supernodes[s];
  context.parallelFor(static_cast<int>(node.rows.size()),
    [&](int begin, int end)
    {
      this->gather(
        s, node.columns + begin, node.columns + end, this->updateOf(s, stacks), shape.others, stacks);
    });
  return true;
}

// Makes what the supernode itself leaves of the matrix for the others, by square blocks that fit the caches.
void Cholesky::handOn(int s, const Strips& strips, const Memory& stacks, const Context& context)
{
  const PanelShape& shape = strips.shape;
  double* update = this->updateOf(s, stacks);
  if (shape.columns == 0)
  {
    std::fill_n(update, static_cast<std::size_t>(shape.others) * shape.rows, 0.0);
    return;
  }
  const int count = strips.all - strips.own;
  const int side = count < 32 ? 4 : 8; // strips of a block
  const int blocks = (count + side - 1) / side;
  context.eachUntilCancelled(blocks * (blocks + 1) / 2,
    [&](int task)
    {
      int row = 0, column = task; // of the block
      while (column > row)
      {
        column -= ++row;
      }
      for (int done = 0; done < shape.columns; done += panelColumns)
      {
        for (int p = row * side; p < std::min(row * side + side, count); ++p)
        {
          for (int q = column * side; q <= std::min(column * side + side - 1, p); ++q)
          {
            strips.take(strips.own + p,
              strips.own + q,
              done,
              std::min(panelColumns, shape.columns - done),
              update + p * stripRows + static_cast<std::size_t>(q) * stripRows * shape.others,
              shape.others,
              std::min(stripRows, shape.rows - q * stripRows),
              done == 0);
          }
        }
      }
    });
}

bool Cholesky::factorise(const BlockMatrix& matrix, const Context& context)
{
  const Elimination& elimination = *this->Symbolic;
  if (this->Block != matrix.block)
  {
    this->Block = matrix.block;
    this->placePanels();
    this->placeUpdates();
  }
  std::atomic<bool> good(true);
  const Context serial;
  context.checkpoint(0.0);
  elimination.forSubtrees(context,
    [&](int subtree)
    {
      const auto stacks = this->Buffers->stacks.take(this->StackSize);
      std::vector<int> place(elimination.order.size());
      const auto strips = this->Buffers->strips.take(this->StripsSize);
      const auto [first, last] = elimination.subtrees[subtree];
      for (int s = first; s <= last && good && !context.cancelled(); ++s)
      {
        this->assemble(s, matrix, *stacks, place, serial);
        if (!this->eliminate(s, *stacks, strips->data(), serial))
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
  const auto strips = this->Buffers->strips.take(this->StripsSize);
  for (int s = 0; s < static_cast<int>(elimination.supernodes.size()) && good; ++s)
  {
    if (elimination.supernodes[s].subtree < 0)
    {
      context.checkpoint(done / total);
      done += workOf(elimination.supernodes[s]);
      // What is done sooner than another thread is woken stays on this one.
      const Context& worth =
        workOf(elimination.supernodes[s]) * std::pow(this->Block, 3) > 4e6 ? context : serial;
      this->assemble(s, matrix, this->Buffers->updates, place, worth);
      good = this->eliminate(s, this->Buffers->updates, strips->data(), worth);
    }
  }
  context.checkpoint(good ? 1.0 : done / total);
  return good;
}

} // namespace oversketch
