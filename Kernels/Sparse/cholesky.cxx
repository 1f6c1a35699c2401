#include "Sparse/cholesky.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace oversketch
{

namespace
{

using Sparse = Cholesky::Sparse;

// Parent of each column in the elimination tree of the matrix with the given order (Liu's algorithm).
std::vector<int> eliminationTree(const Sparse& pattern,
  const std::vector<int>& order,
  const std::vector<int>& inverse)
{
  const int count = static_cast<int>(order.size());
  std::vector<int> parent(order.size(), -1), ancestor(order.size(), -1);
  for (int column = 0; column < count; ++column)
  {
    for (Sparse::InnerIterator it(pattern, inverse[column]); it; ++it)
    {
      for (int i = order[it.row()]; i >= 0 && i < column;)
      {
        const int next = ancestor[i];
        ancestor[i] = column;
        if (next < 0)
        {
          parent[i] = column;
        }
        i = next;
      }
    }
  }
  return parent;
}

// The columns such that children come right before their parents.
std::vector<int> postorder(const std::vector<int>& parent)
{
  const int count = static_cast<int>(parent.size());
  std::vector<int> firstChild(parent.size(), -1), sibling(parent.size(), -1), result, stack;
  for (int i = count - 1; i >= 0; --i)
  {
    if (parent[i] >= 0)
    {
      sibling[i] = firstChild[parent[i]];
      firstChild[parent[i]] = i;
    }
  }
  for (int root = 0; root < count; ++root)
  {
    if (parent[root] >= 0)
    {
      continue;
    }
    stack.push_back(root);
    while (!stack.empty())
    {
      const int i = stack.back();
      if (firstChild[i] >= 0)
      {
        stack.push_back(firstChild[i]);
        firstChild[i] = sibling[firstChild[i]];
      }
      else
      {
        stack.pop_back();
        result.push_back(i);
      }
    }
  }
  return result;
}

} // namespace

Cholesky::Cholesky(const Sparse& pattern, int block)
  : block_(block)
  , count_(static_cast<int>(pattern.cols()))
  , order_(pattern.cols())
  , inverse_(pattern.cols())
  , owner_(pattern.cols())
  , place_(pattern.cols())
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> amd;
  Eigen::AMDOrdering<int>()(pattern, amd);
  for (int i = 0; i < this->count_; ++i)
  {
    this->inverse_[i] = amd.indices()[i];
    this->order_[this->inverse_[i]] = i;
  }
  const std::vector<int> post = postorder(eliminationTree(pattern, this->order_, this->inverse_));
  std::vector<int> inverse(this->inverse_.size());
  std::transform(post.begin(), post.end(), inverse.begin(), [&](int i) { return this->inverse_[i]; });
  this->inverse_ = inverse;
  for (int i = 0; i < this->count_; ++i)
  {
    this->order_[this->inverse_[i]] = i;
  }
  this->buildSupernodes(pattern);
}

// The rows of a column are those of the matrix and those of its children in the tree. A column joins the
// supernode of the one before if that is its child and the panel gains few zeros.
void Cholesky::buildSupernodes(const Sparse& pattern)
{
  const std::vector<int> parent = eliminationTree(pattern, this->order_, this->inverse_);
  std::vector<std::vector<int>> rows(this->count_); // below the diagonal; freed once passed on
  std::vector<std::vector<int>> children(this->count_);
  std::vector<int> seen(this->count_, -1);
  double zeros = 0.0; // in the panel of the last supernode
  for (int column = 0; column < this->count_; ++column)
  {
    std::vector<int>& own = rows[column];
    const auto add = [&](int row)
    {
      if (row > column && seen[row] != column)
      {
        seen[row] = column;
        own.push_back(row);
      }
    };
    for (Sparse::InnerIterator it(pattern, this->inverse_[column]); it; ++it)
    {
      add(this->order_[it.row()]);
    }
    const std::size_t before = column > 0 ? rows[column - 1].size() : 0;
    for (const int child : children[column])
    {
      std::for_each(rows[child].begin(), rows[child].end(), add);
      rows[child] = std::vector<int>();
    }
    std::sort(own.begin(), own.end());
    if (parent[column] >= 0)
    {
      children[parent[column]].push_back(column);
    }
    if (column > 0 && parent[column - 1] == column)
    {
      Supernode& last = this->supernodes_.back();
      const double gained =
        last.columns * (static_cast<double>(own.size()) + 1.0 - static_cast<double>(before));
      const double entries = (last.columns + 1.0) * (static_cast<double>(own.size()) + last.columns + 1.0);
      if (zeros + gained <= (last.columns < 8 ? 0.4 : 0.1) * entries)
      {
        zeros += gained;
        ++last.columns;
        last.rows = own; // the rows of its own nodes are put before them below
        this->owner_[column] = static_cast<int>(this->supernodes_.size()) - 1;
        continue;
      }
    }
    zeros = 0.0;
    this->owner_[column] = static_cast<int>(this->supernodes_.size());
    this->supernodes_.push_back({ column, 1, own, {} });
  }
  for (Supernode& node : this->supernodes_)
  {
    node.rows.insert(node.rows.begin(), node.columns, 0);
    std::iota(node.rows.begin(), node.rows.begin() + node.columns, node.first);
  }
}

// The panel of the supernode, from the lower triangle of the reordered matrix.
void Cholesky::assemble(Supernode& node, const Sparse& matrix)
{
  const int b = this->block_;
  for (int i = 0; i < static_cast<int>(node.rows.size()); ++i)
  {
    this->place_[node.rows[i]] = i;
  }
  node.panel.setZero(
    static_cast<Eigen::Index>(node.rows.size()) * b, static_cast<Eigen::Index>(node.columns) * b);
  for (int column = 0; column < node.columns * b; ++column)
  {
    const int newColumn = node.first * b + column;
    for (Sparse::InnerIterator it(matrix, this->inverse_[newColumn / b] * b + newColumn % b); it; ++it)
    {
      const int row = static_cast<int>(it.row());
      const int newNode = this->order_[row / b];
      if (newNode * b + row % b >= newColumn)
      {
        node.panel(this->place_[newNode] * b + row % b, column) = it.value();
      }
    }
  }
}

// Takes from the node's panel what the rows begin .. end of a descendant, which are columns of the node, add
// to it.
void Cholesky::subtract(Supernode& node, const Supernode& descendant, int begin, int end)
{
  const int b = this->block_;
  const int height = (static_cast<int>(descendant.rows.size()) - begin) * b;
  const int width = (end - begin) * b;
  const auto left = descendant.panel.middleRows(begin * b, height);
  this->update_.resize(height, width);
  this->update_.noalias() = left * left.topRows(width).transpose();
  for (int j = 0; j < width; ++j)
  {
    const int column = (descendant.rows[begin + j / b] - node.first) * b + j % b;
    double* panel = &node.panel(0, column);
    const double* update = &this->update_(0, j);
    for (int i = j / b * b; i < height; i += b)
    {
      double* rows = panel + this->place_[descendant.rows[begin + i / b]] * b;
      for (int k = 0; k < b; ++k)
      {
        rows[k] -= update[i + k];
      }
    }
  }
}

bool Cholesky::eliminate(Supernode& node, const std::vector<double>& diagonal) const
{
  const Eigen::Index width = node.panel.cols();
  auto top = node.panel.topRows(width);
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(top);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  for (Eigen::Index i = 0; i < width; ++i)
  {
    const double pivot = top(i, i) * top(i, i);
    if (!(pivot >
          1e-12 *
            diagonal[static_cast<std::size_t>(node.first) * this->block_ + static_cast<std::size_t>(i)]) ||
        !std::isfinite(pivot))
    {
      return false;
    }
  }
  if (node.panel.rows() > width)
  {
    auto bottom = node.panel.bottomRows(node.panel.rows() - width);
    top.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(bottom);
  }
  return true;
}

bool Cholesky::factorise(const Sparse& matrix, const Context& context)
{
  std::vector<double> diagonal(matrix.cols());
  for (int i = 0; i < this->count_ * this->block_; ++i)
  {
    diagonal[i] = matrix.coeff(this->inverse_[i / this->block_] * this->block_ + i % this->block_,
      this->inverse_[i / this->block_] * this->block_ + i % this->block_);
  }
  // A supernode waits in the list of the next one that it has a row in.
  const int count = static_cast<int>(this->supernodes_.size());
  std::vector<int> head(this->supernodes_.size(), -1), next(this->supernodes_.size(), -1),
    done(this->supernodes_.size(), 0);
  const auto enlist = [&](int s, int row)
  {
    const Supernode& node = this->supernodes_[s];
    done[s] = row;
    if (row < static_cast<int>(node.rows.size()))
    {
      int& list = head[this->owner_[node.rows[row]]];
      next[s] = list;
      list = s;
    }
  };
  double total = 0.0, passed = 0.0;
  const auto work = [](const Supernode& node)
  { return static_cast<double>(node.rows.size()) * static_cast<double>(node.rows.size()) * node.columns; };
  for (const Supernode& node : this->supernodes_)
  {
    total += work(node);
  }
  double reported = 0.0;
  for (int s = 0; s < count; ++s)
  {
    Supernode& node = this->supernodes_[s];
    this->assemble(node, matrix);
    for (int d = head[s]; d >= 0;)
    {
      const int following = next[d];
      const std::vector<int>& rows = this->supernodes_[d].rows;
      int end = done[d];
      while (end < static_cast<int>(rows.size()) && rows[end] < node.first + node.columns)
      {
        ++end;
      }
      this->subtract(node, this->supernodes_[d], done[d], end);
      enlist(d, end);
      d = following;
    }
    if (!this->eliminate(node, diagonal))
    {
      return false;
    }
    enlist(s, node.columns);
    passed += work(node);
    if (passed > reported + 0.01 * total)
    {
      reported = passed;
      context.checkpoint(passed / total);
    }
  }
  return true;
}

void Cholesky::solve(Eigen::MatrixXd& rightSide) const
{
  const int b = this->block_;
  Eigen::MatrixXd x(rightSide.rows(), rightSide.cols());
  for (int i = 0; i < this->count_; ++i)
  {
    x.middleRows(i * b, b) = rightSide.middleRows(this->inverse_[i] * b, b);
  }
  Eigen::MatrixXd below;
  for (const Supernode& node : this->supernodes_)
  {
    const Eigen::Index width = node.panel.cols(), height = node.panel.rows() - width;
    auto own = x.middleRows(node.first * b, width);
    node.panel.topRows(width).triangularView<Eigen::Lower>().solveInPlace(own);
    below.noalias() = node.panel.bottomRows(height) * own;
    for (Eigen::Index i = 0; i < height; i += b)
    {
      x.middleRows(node.rows[static_cast<std::size_t>((width + i) / b)] * b, b) -= below.middleRows(i, b);
    }
  }
  for (auto node = this->supernodes_.rbegin(); node != this->supernodes_.rend(); ++node)
  {
    const Eigen::Index width = node->panel.cols(), height = node->panel.rows() - width;
    below.resize(height, x.cols());
    for (Eigen::Index i = 0; i < height; i += b)
    {
      below.middleRows(i, b) = x.middleRows(node->rows[static_cast<std::size_t>((width + i) / b)] * b, b);
    }
    auto own = x.middleRows(node->first * b, width);
    own.noalias() -= node->panel.bottomRows(height).transpose() * below;
    node->panel.topRows(width).transpose().triangularView<Eigen::Upper>().solveInPlace(own);
  }
  for (int i = 0; i < this->count_; ++i)
  {
    rightSide.middleRows(this->inverse_[i] * b, b) = x.middleRows(i * b, b);
  }
}

} // namespace oversketch
