// Sparse Cholesky factor of a symmetric positive definite matrix of small equal blocks.
//
// Why not a library: Eigen's simplicial factors work entry by entry, on one thread, and cannot be cancelled;
// CHOLMOD's supernodal one is under the GPL and is only as fast as the BLAS that the system has.
#ifndef oversketch_kernels_sparse_cholesky_h
#define oversketch_kernels_sparse_cholesky_h

#include "Mesh/context.h"
#include "Sparse/dense.h"
#include "Sparse/elimination.h"
#include "Sparse/memory.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace oversketch
{

// L L^T = P A P^T by the multifrontal method: each supernode is eliminated in a dense panel and hands what it
// leaves of the matrix for the others on to its parent. Subtrees are independent, so they are worked on in
// parallel; the large panels above them are, tile by tile. Every sum has a fixed order: the result does not
// depend on the number of threads.
class Cholesky
{
public:
  // memory: that of a factor which is not used any more, to save the time of taking new memory.
  explicit Cholesky(std::shared_ptr<const Elimination> elimination,
    std::shared_ptr<FactorMemory> memory = std::make_shared<FactorMemory>());

  // Factors a matrix of the pattern that the elimination was made for, with blocks of any size; what was held
  // before is lost. False when a pivot falls below 1e-12 of its diagonal entry: the matrix is not positive
  // definite in floating point. Calls context.checkpoint with progress in [0, 1].
  bool factorise(const BlockMatrix& matrix, const Context& context);

  // Solves for all columns of the right-hand side, in place. Not for two threads at once.
  void solve(Eigen::MatrixXd& rightSide, const Context& context);

private:
  struct Strips;
  using Step = void (Cholesky::*)(int s, int sides, std::vector<double>& local);

  PanelShape shapeOf(int s) const { return PanelShape(this->Symbolic->supernodes[s], this->Block); }
  void placePanels();
  void placeUpdates();
  double* updateOf(int s, const Memory& stacks) const;
  void assemble(int s,
    const BlockMatrix& matrix,
    const Memory& stacks,
    std::vector<int>& place,
    const Context& context);
  void gather(int s, int begin, int end, double* into, int ld, const Memory& stacks) const;
  bool eliminate(int s, const Memory& stacks, double* packed, const Context& context);
  void handOn(int s, const Strips& strips, const Memory& stacks, const Context& context);
  void forward(int s, int sides, std::vector<double>& local);
  void backward(int s, int sides, std::vector<double>& local);
  void sweep(const std::vector<int>& level, Step step, int sides, const Context& context);

  std::shared_ptr<const Elimination> Symbolic;
  int Block = 0;
  // Places for each supernode: where its panel begins, what it hands on in the factorisation, and what in a
  // solve with one right-hand side.
  std::vector<std::size_t> PanelPlaces, UpdatePlaces, VectorPlaces;
  std::vector<std::vector<Run>> Runs; // of each supernode: how its rows lie in its parent's panel
  std::size_t StackSize = 0;          // of the subtrees' updates, see placeUpdates
  std::size_t StripsSize = 0;         // of the largest supernode's strips
  std::shared_ptr<FactorMemory> Buffers;
  std::vector<double> Smallest; // pivots
  std::vector<double> Solution; // in the new order, the right-hand sides side by side
  std::vector<double> Vectors;
};

} // namespace oversketch
#endif
