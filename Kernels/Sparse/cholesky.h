// Sparse Cholesky factor of a symmetric positive definite matrix of small equal blocks.
//
// Why not a library: Eigen's simplicial factors work entry by entry, five times slower here on the adjusted
// form, and cannot be cancelled; CHOLMOD's supernodal one is under the GPL. The ordering, the dense
// arithmetic and the sparse type are Eigen's.
#ifndef oversketch_cholesky_h
#define oversketch_cholesky_h

#include "Mesh/context.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace oversketch
{

// L L^T = P A P^T, by groups of neighbouring columns with (nearly) the same rows ("supernodes"), each a dense
// panel.
class Cholesky
{
public:
  using Sparse = Eigen::SparseMatrix<double>;

  // Orders the nodes of the symmetric pattern (both triangles stored; values mean nothing) by minimum degree
  // and finds the shape of the factor. The matrix to come has `block` rows and columns for each node.
  Cholesky(const Sparse& pattern, int block);

  // Factors the matrix (both triangles stored, nothing outside the pattern); what it held before is lost.
  // False when a pivot falls below 1e-12 of its diagonal entry: the matrix is not positive definite in
  // floating point. Calls context.checkpoint with progress in [0, 1]. The result does not depend on the
  // number of threads: there is one.
  bool factorise(const Sparse& matrix, const Context& context);

  // Solves for all columns of the right-hand side, in place.
  void solve(Eigen::MatrixXd& rightSide) const;

private:
  struct Supernode
  {
    int first, columns;    // its nodes are first .. first + columns - 1 in the new order
    std::vector<int> rows; // nodes of its rows, ascending; the first are its own
    Eigen::MatrixXd panel; // (rows x columns) blocks, column-major; the top is lower triangular
  };

  void buildSupernodes(const Sparse& pattern);
  void assemble(Supernode& node, const Sparse& matrix);
  void subtract(Supernode& node, const Supernode& descendant, int begin, int end);
  bool eliminate(Supernode& node, const std::vector<double>& diagonal) const;

  int block_, count_;
  std::vector<int> order_, inverse_; // new place of a node, node at a new place
  std::vector<int> owner_;           // supernode of a new place
  std::vector<int> place_;           // scratch: row of a node in the panel at work
  std::vector<Supernode> supernodes_;
  Eigen::MatrixXd update_; // scratch
};

} // namespace oversketch
#endif
