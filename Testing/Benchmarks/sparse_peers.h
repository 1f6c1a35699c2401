// Whom our sparse factor is set beside: Eigen's matrices and CHOLMOD, and our own threads. Header-only.
#ifndef oversketch_testing_benchmarks_sparse_peers_h
#define oversketch_testing_benchmarks_sparse_peers_h

#include "Mesh/context.h"
#include "Sparse/elimination.h"

#include "vtkSMPTools.h"

#include <Eigen/SparseCore>

#ifdef OVERSKETCH_CHOLMOD
#include <cholmod.h>
#include <dlfcn.h>
#endif

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace oversketch_bench
{

using namespace oversketch;

using Sparse = Eigen::SparseMatrix<double>;

inline Context threads()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    vtkSMPTools::For(0,
      count,
      [&body](vtkIdType begin, vtkIdType end) { body(static_cast<int>(begin), static_cast<int>(end)); });
  };
  return context;
}

// Both triangles, in the order of the unknowns.
inline Sparse toEigen(const BlockMatrix& matrix)
{
  const int b = matrix.block;
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < matrix.nodeCount(); ++column)
  {
    for (int k = matrix.pattern.offsets[column]; k < matrix.pattern.offsets[column + 1]; ++k)
    {
      for (int e = 0; e < b * b; ++e)
      {
        entries.emplace_back(matrix.pattern.values[k] * b + e % b,
          column * b + e / b,
          matrix.values[static_cast<std::size_t>(k) * b * b + e]);
      }
    }
  }
  Sparse result(matrix.nodeCount() * b, matrix.nodeCount() * b);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

#ifdef OVERSKETCH_CHOLMOD
// CHOLMOD's supernodal factor and a solve that keeps its workspace.
class Cholmod
{
public:
  static constexpr std::array<int, 2> orderings = { CHOLMOD_AMD, CHOLMOD_METIS };

  Cholmod(const Sparse& matrix, int ordering)
    : Lower(matrix.triangularView<Eigen::Lower>())
  {
    cholmod_start(&this->Common);
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = ordering;
    this->Common.postorder = 1;
    this->Lower.makeCompressed();
    this->Matrix.nrow = this->Matrix.ncol = static_cast<std::size_t>(matrix.rows());
    this->Matrix.nzmax = static_cast<std::size_t>(this->Lower.nonZeros());
    this->Matrix.p = this->Lower.outerIndexPtr();
    this->Matrix.i = this->Lower.innerIndexPtr();
    this->Matrix.x = this->Lower.valuePtr();
    this->Matrix.stype = -1;
    this->Matrix.itype = CHOLMOD_INT;
    this->Matrix.xtype = CHOLMOD_REAL;
    this->Matrix.dtype = CHOLMOD_DOUBLE;
    this->Matrix.sorted = this->Matrix.packed = 1;
  }
  Cholmod(const Cholmod&) = delete;
  void operator=(const Cholmod&) = delete;
  ~Cholmod()
  {
    cholmod_free_dense(&this->Solution, &this->Common);
    cholmod_free_dense(&this->Scratch, &this->Common);
    cholmod_free_dense(&this->More, &this->Common);
    cholmod_free_factor(&this->Factor, &this->Common);
    cholmod_finish(&this->Common);
  }
  void analyse()
  {
    cholmod_free_factor(&this->Factor, &this->Common);
    this->Factor = cholmod_analyze(&this->Matrix, &this->Common);
    if (this->Factor == nullptr)
    {
      std::fprintf(stderr, "This CHOLMOD has no such order.\n");
      std::exit(1);
    }
  }
  double entries() const { return this->Common.lnz; }
  void factorise() { cholmod_factorize(&this->Matrix, this->Factor, &this->Common); }
  void solve(Eigen::MatrixXd& rightSide)
  {
    cholmod_dense given{};
    given.nrow = given.d = static_cast<std::size_t>(rightSide.rows());
    given.ncol = static_cast<std::size_t>(rightSide.cols());
    given.nzmax = given.nrow * given.ncol;
    given.x = rightSide.data();
    given.xtype = CHOLMOD_REAL;
    given.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A,
      this->Factor,
      &given,
      nullptr,
      &this->Solution,
      nullptr,
      &this->Scratch,
      &this->More,
      &this->Common);
    std::copy_n(static_cast<const double*>(this->Solution->x), given.nzmax, rightSide.data());
  }

  // "CHOLMOD", the order, and the BLAS that it runs on, which gets two threads if it can.
  static std::string name(int ordering)
  {
    const std::string order = ordering == CHOLMOD_METIS ? "CHOLMOD METIS" : "CHOLMOD AMD";
    Dl_info where{};
    void* product = dlsym(RTLD_DEFAULT, "dgemm_");
    if (product && dladdr(product, &where) &&
        std::string(realName(where.dli_fname)).find("openblas") != std::string::npos)
    {
      if (auto* set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
      {
        set(2);
      }
      return order + ", OpenBLAS";
    }
    return order + ", reference BLAS";
  }

private:
  static std::string realName(const char* path)
  {
    char* found = realpath(path, nullptr);
    std::string name = found ? found : path;
    std::free(found);
    return name;
  }

  Sparse Lower;
  cholmod_common Common{};
  cholmod_sparse Matrix{};
  cholmod_factor* Factor = nullptr;
  cholmod_dense *Solution = nullptr, *Scratch = nullptr, *More = nullptr;
};
#endif

} // namespace oversketch_bench
#endif
