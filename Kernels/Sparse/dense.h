// The dense arithmetic of the sparse Cholesky factor: small column-major panels whose rows and leading
// dimensions are multiples of 8, so that no loop needs a tail.
//
// Why not a library: Eigen's dense kernels take their vector width when the program is compiled, which is
// SSE2 here; OpenBLAS brings its own threads, whose number would then decide the result.
//
// Each kernel is compiled for AVX-512, AVX2 with fused multiply-add, and the baseline, and chosen when the
// program starts. Results are the same from run to run and for any number of threads on one machine; between
// machines they differ by rounding, as fused multiply-add rounds once: it saves half the time of a
// factorisation.
#ifndef oversketch_kernels_sparse_dense_h
#define oversketch_kernels_sparse_dense_h

namespace oversketch
{

inline int roundedUp(int count, int step)
{
  return (count + step - 1) / step * step;
}

// Numbers that stay together when they go from one column to another.
struct Run
{
  int from, to, count;
};

struct DenseKernels
{
  // Lower Cholesky factor of the count x count block at a, in place (rows up to the next multiple of 8 are
  // touched). False when a pivot is not above smallest[i].
  bool (*factor)(double* a, int ld, int count, const double* smallest);

  // x L^T = x for rows (a multiple of 8) of x: L is the factor that `factor` left at l; both have the same
  // ld.
  void (*solveRows)(const double* l, double* x, int ld, int rows, int count);

  // c -= a b^T, or c = -a b^T if fresh, for `rows` (a multiple of 8, at most 24) by `columns` (at most 8) of
  // c. Column k of a starts at a + 24 k, that of b at b + 24 k, as `pack` puts them.
  void (*multiply)(double* c,
    int ldc,
    const double* a,
    const double* b,
    int depth,
    int rows,
    int columns,
    bool fresh);

  // to[run.to ..] += from[run.from ..] for each run but the first `skipped` numbers of the first one.
  void (*add)(const Run* first, const Run* last, int skipped, const double* from, double* to);

  // Solves L x = x for the first `count` rows of x and takes from the `height` - roundedUp(count, 8) others
  // what they get from it. x holds 1 or 3 right-hand sides, each `height` (= ld) long.
  void (*forward)(const double* l, int height, int count, double* x, int sides);

  // Solves L^T x = x for the first `count` rows of x, from the others.
  void (*backward)(const double* l, int height, int count, double* x, int sides);
};

// The kernels for this processor.
const DenseKernels& denseKernels();

// Copies `rows` (a multiple of 8) of `depth` columns into strips of 24 rows, each column by column.
void pack(const double* a, int ld, int rows, int depth, double* out);

} // namespace oversketch
#endif
