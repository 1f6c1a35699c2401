// The order in which a sparse symmetric matrix is eliminated, and the shape of its Cholesky factor: what
// depends on the pattern alone and serves any number of matrices.
#ifndef oversketch_kernels_sparse_elimination_h
#define oversketch_kernels_sparse_elimination_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <functional>
#include <vector>

namespace oversketch
{

// A sparse symmetric matrix of small dense blocks, one block row and column for each node of a graph.
struct BlockMatrix
{
  int block = 1;              // rows and columns of a block
  Lists pattern;              // of each node, itself and the nodes that it is coupled with, in any order
  std::vector<double> values; // block k, column-major, belongs to row pattern.values[k] of its list's column
  int nodeCount() const { return static_cast<int>(this->pattern.offsets.size()) - 1; }
};

// A part of the nested dissection, eliminated together: its panel of the factor has a column for each of its
// nodes and rows for these and for those they touch later.
struct Supernode
{
  int first = 0, columns = 0; // its nodes are first .. first + columns - 1 in the new order
  int parent = -1, depth = 0; // depth 0 has no parent
  int subtree = -1;           // that it is in, -1 above all of them
  std::array<int, 2> children{ -1, -1 };
  std::vector<int> rows;     // places of the other nodes that its panel has rows of, ascending
  std::vector<int> toParent; // of each row: its number among the parent's own nodes and, after them, its rows
};

// Entries of a supernode's panel for blocks of some size. Its own rows are padded to a multiple of 8, and the
// others as well.
struct PanelShape
{
  PanelShape(const Supernode& node, int block);
  std::size_t size() const
  {
    return static_cast<std::size_t>(this->height) * static_cast<std::size_t>(this->columns);
  }
  int columns, own, rows, others, height;
};

class Elimination
{
public:
  // The pattern lists each node's neighbours and the node itself, symmetrically; positions are those of the
  // nodes, near for neighbours. The result does not depend on the number of threads.
  Elimination(const Lists& pattern, const std::vector<Vector3>& positions, const Context& context);

  int nodeCount() const { return static_cast<int>(this->order.size()); }

  // Entries that the factor of a matrix of such blocks takes, zeros in panels included.
  std::size_t storedCount(int block) const;

  // Calls body(subtree) for each subtree, in parallel. Returns early when cancelled; to be asked for
  // afterwards.
  void forSubtrees(const Context& context, const std::function<void(int)>& body) const;

  std::vector<int> order, inverse;          // new place of a node, node at a new place
  std::vector<Supernode> supernodes;        // children before parents
  std::vector<std::array<int, 2>> subtrees; // first and last supernode of each; they do not touch each other
  std::vector<std::vector<int>> levels;     // the supernodes above the subtrees by depth, deepest first

private:
  void findSubtrees();
  void findRows(int s, const Lists& pattern, std::vector<int>& place);
};

} // namespace oversketch
#endif
