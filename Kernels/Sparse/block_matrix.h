// A sparse symmetric matrix of small dense blocks, one block row and column for each node of a graph.
#ifndef oversketch_kernels_sparse_block_matrix_h
#define oversketch_kernels_sparse_block_matrix_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct BlockMatrix
{
  int block = 1;              // rows and columns of a block
  Lists pattern;              // of each node, itself and the nodes that it is coupled with, in any order
  std::vector<double> values; // block k, column-major, belongs to row pattern.values[k] of its list's column
  int nodeCount() const { return static_cast<int>(this->pattern.offsets.size()) - 1; }
};

} // namespace oversketch
#endif
