#include "Sparse/elimination.h"

#include "Sparse/dense.h"
#include "Sparse/dissection.h"

#include <algorithm>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int smallestPiece = 24; // nodes that dissection leaves together
constexpr int subtreeShare = 16;  // a subtree has at most this part of the nodes
constexpr int smallestSubtree = 256;

} // namespace

PanelShape::PanelShape(const Supernode& node, int block)
  : columns(node.columns * block)
  , own(roundedUp(columns, 8))
  , rows(static_cast<int>(node.rows.size()) * block)
  , others(roundedUp(rows, 8))
  , height(own + others)
{
}

Elimination::Elimination(const Lists& pattern, const std::vector<Vector3>& positions, const Context& context)
  : order(positions.size())
{
  Dissection dissection = dissect(pattern, positions, smallestPiece, context);
  this->inverse.swap(dissection.inverse);
  for (int i = 0; i < static_cast<int>(this->inverse.size()); ++i)
  {
    this->order[this->inverse[i]] = i;
  }
  this->supernodes.resize(dissection.parts.size());
  for (int s = 0; s < static_cast<int>(dissection.parts.size()); ++s)
  {
    const Dissection::Part& part = dissection.parts[s];
    this->supernodes[s].first = part.first;
    this->supernodes[s].columns = part.count;
    this->supernodes[s].parent = part.parent;
    if (part.parent >= 0)
    {
      std::array<int, 2>& children = this->supernodes[part.parent].children;
      children[children[0] >= 0] = s;
    }
  }
  this->findSubtrees();
  this->forSubtrees(context,
    [&](int subtree)
    {
      std::vector<int> place(this->order.size(), -1);
      for (int s = this->subtrees[subtree][0]; s <= this->subtrees[subtree][1]; ++s)
      {
        this->findRows(s, pattern, place);
      }
    });
  context.checkpoint(1.0);
  std::vector<int> place(this->order.size(), -1);
  for (const std::vector<int>& level : this->levels)
  {
    std::for_each(level.begin(), level.end(), [&](int s) { this->findRows(s, pattern, place); });
  }
}

void Elimination::findSubtrees()
{
  const int count = static_cast<int>(this->supernodes.size());
  std::vector<int> nodes(this->supernodes.size()); // of each and all below it
  for (int s = 0; s < count; ++s)
  {
    nodes[s] += this->supernodes[s].columns;
    if (this->supernodes[s].parent >= 0)
    {
      nodes[this->supernodes[s].parent] += nodes[s];
    }
  }
  const int most = std::max(smallestSubtree, this->nodeCount() / subtreeShare);
  for (int s = count - 1; s >= 0; --s)
  {
    Supernode& node = this->supernodes[s];
    node.depth = node.parent >= 0 ? this->supernodes[node.parent].depth + 1 : 0;
    if (nodes[s] > most)
    {
      this->levels.resize(std::max(this->levels.size(), static_cast<std::size_t>(node.depth) + 1));
      this->levels[node.depth].push_back(s);
      continue;
    }
    node.subtree = node.parent >= 0 ? this->supernodes[node.parent].subtree : -1;
    if (node.subtree < 0)
    {
      node.subtree = static_cast<int>(this->subtrees.size());
      this->subtrees.push_back({ s, s });
    }
    this->subtrees[node.subtree][0] = s;
  }
  std::reverse(this->levels.begin(), this->levels.end());
}

// The rows are those of the matrix and those of the children. Numbers the rows of the children in the node.
// place is -1 everywhere, before and after.
void Elimination::findRows(int s, const Lists& pattern, std::vector<int>& place)
{
  Supernode& node = this->supernodes[s];
  const int end = node.first + node.columns;
  const auto add = [&](int row)
  {
    if (row >= end && place[row] < 0)
    {
      place[row] = 0;
      node.rows.push_back(row);
    }
  };
  for (int i = node.first; i < end; ++i)
  {
    const int v = this->inverse[i];
    std::for_each(pattern.begin(v), pattern.end(v), [&](int n) { add(this->order[n]); });
  }
  for (const int child : node.children)
  {
    if (child >= 0)
    {
      const std::vector<int>& rows = this->supernodes[child].rows;
      std::for_each(rows.begin(), rows.end(), add);
    }
  }
  std::sort(node.rows.begin(), node.rows.end());
  for (std::size_t i = 0; i < node.rows.size(); ++i)
  {
    place[node.rows[i]] = node.columns + static_cast<int>(i);
  }
  for (const int child : node.children)
  {
    if (child >= 0)
    {
      const std::vector<int>& rows = this->supernodes[child].rows;
      std::vector<int>& toParent = this->supernodes[child].toParent;
      toParent.resize(rows.size());
      std::transform(rows.begin(),
        rows.end(),
        toParent.begin(),
        [&](int row) { return row < end ? row - node.first : place[row]; });
    }
  }
  for (const int row : node.rows)
  {
    place[row] = -1;
  }
}

std::size_t Elimination::storedCount(int block) const
{
  return std::accumulate(this->supernodes.begin(),
    this->supernodes.end(),
    std::size_t(0),
    [block](std::size_t sum, const Supernode& node) { return sum + PanelShape(node, block).size(); });
}

void Elimination::forSubtrees(const Context& context, const std::function<void(int)>& body) const
{
  context.eachUntilCancelled(static_cast<int>(this->subtrees.size()), body);
}

} // namespace oversketch
