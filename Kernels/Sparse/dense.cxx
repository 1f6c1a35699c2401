#include "Sparse/dense.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#define OVERSKETCH_INLINE inline __attribute__((always_inline))

namespace oversketch
{

namespace
{

// W doubles. The second type may lie anywhere.
template <int W>
struct Vector;
template <>
struct Vector<2>
{
  typedef double Type __attribute__((vector_size(16)));
  typedef double Memory __attribute__((vector_size(16), aligned(8), may_alias));
};
template <>
struct Vector<4>
{
  typedef double Type __attribute__((vector_size(32)));
  typedef double Memory __attribute__((vector_size(32), aligned(8), may_alias));
};
template <>
struct Vector<8>
{
  typedef double Type __attribute__((vector_size(64)));
  typedef double Memory __attribute__((vector_size(64), aligned(8), may_alias));
};

template <int W>
OVERSKETCH_INLINE void load(typename Vector<W>::Type& v, const double* from)
{
  v = *reinterpret_cast<const typename Vector<W>::Memory*>(from);
}
template <int W>
OVERSKETCH_INLINE void store(double* to, const typename Vector<W>::Type& v)
{
  *reinterpret_cast<typename Vector<W>::Memory*>(to) = v;
}

// Sum of a vector's entries, by halves.
template <int W>
OVERSKETCH_INLINE double total(const typename Vector<W>::Type& v)
{
  if constexpr (W == 2)
  {
    return v[0] + v[1];
  }
  else
  {
    double entries[W];
    store<W>(entries, v);
    typename Vector<W / 2>::Type low, high;
    load<W / 2>(low, entries);
    load<W / 2>(high, entries + W / 2);
    return total<W / 2>(low + high);
  }
}

// c (0 if fresh) -= a b^T for V vectors of W rows and at most C columns, the sums in registers.
template <int W, int V, int C>
OVERSKETCH_INLINE void tile(double* c,
  int ldc,
  const double* a,
  int stepA,
  const double* b,
  int stepB,
  int depth,
  int columns,
  bool fresh)
{
  typename Vector<W>::Type sum[C][V] = {};
  for (int k = 0; k < depth; ++k)
  {
    typename Vector<W>::Type left[V];
    for (int v = 0; v < V; ++v)
    {
      load<W>(left[v], a + v * W);
    }
#pragma GCC unroll 8
    for (int j = 0; j < C; ++j)
    {
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v)
      {
        sum[j][v] += left[v] * b[j];
      }
    }
    a += stepA;
    b += stepB;
  }
#pragma GCC unroll 8
  for (int j = 0; j < C; ++j)
  {
    if (j < columns)
    {
#pragma GCC unroll 4
      for (int v = 0; v < V; ++v)
      {
        typename Vector<W>::Type old{};
        if (!fresh)
        {
          load<W>(old, c + static_cast<long>(j) * ldc + v * W);
        }
        store<W>(c + static_cast<long>(j) * ldc + v * W, old - sum[j][v]);
      }
    }
  }
}

// Columns that the registers hold beside three vectors of rows.
template <int W>
constexpr int tileColumns = W == 8 ? 8 : 4;

template <int W>
OVERSKETCH_INLINE void tiles(double* c,
  int ldc,
  const double* a,
  int stepA,
  const double* b,
  int stepB,
  int depth,
  int rows,
  int columns,
  bool fresh)
{
  constexpr int C = tileColumns<W>;
  for (int j = 0; j < columns; j += C)
  {
    double* out = c + static_cast<long>(j) * ldc;
    int i = 0;
    for (; i + 3 * W <= rows; i += 3 * W)
    {
      tile<W, 3, C>(out + i, ldc, a + i, stepA, b + j, stepB, depth, columns - j, fresh);
    }
    if (i + 2 * W <= rows)
    {
      tile<W, 2, C>(out + i, ldc, a + i, stepA, b + j, stepB, depth, columns - j, fresh);
      i += 2 * W;
    }
    if (i + W <= rows)
    {
      tile<W, 1, C>(out + i, ldc, a + i, stepA, b + j, stepB, depth, columns - j, fresh);
    }
  }
}

// x L^T = x for `rows` of x and at most 8 columns.
template <int W>
OVERSKETCH_INLINE void solveStrip(const double* l, double* x, int ld, int rows, int columns)
{
  double inverse[8];
  for (int j = 0; j < columns; ++j)
  {
    inverse[j] = 1.0 / l[j + static_cast<long>(j) * ld];
  }
  for (int i = 0; i < rows; i += W)
  {
    typename Vector<W>::Type solved[8];
#pragma GCC unroll 8
    for (int j = 0; j < 8; ++j)
    {
      if (j < columns)
      {
        load<W>(solved[j], x + i + static_cast<long>(j) * ld);
#pragma GCC unroll 8
        for (int k = 0; k < j; ++k)
        {
          solved[j] -= solved[k] * l[j + static_cast<long>(k) * ld];
        }
        solved[j] *= inverse[j];
        store<W>(x + i + static_cast<long>(j) * ld, solved[j]);
      }
    }
  }
}

template <int W>
OVERSKETCH_INLINE void solveRowsAny(const double* l, double* x, int ld, int rows, int count)
{
  for (int j = 0; j < count; j += 8)
  {
    const int columns = std::min(8, count - j);
    double* strip = x + static_cast<long>(j) * ld;
    for (int i = 0; i < rows; i += 24)
    {
      tiles<W>(strip + i, ld, x + i, ld, l + j, ld, j, std::min(24, rows - i), columns, false);
    }
    solveStrip<W>(l + j + static_cast<long>(j) * ld, strip, ld, rows, columns);
  }
}

template <int W>
OVERSKETCH_INLINE bool factorAny(double* a, int ld, int count, const double* smallest)
{
  const int height = roundedUp(count, 8);
  for (int j = 0; j < count; j += 8)
  {
    const int columns = std::min(8, count - j);
    double* strip = a + static_cast<long>(j) * ld;
    for (int i = j; i < height; i += 24)
    {
      tiles<W>(strip + i, ld, a + i, ld, a + j, ld, j, std::min(24, height - i), columns, false);
    }
    double* corner = strip + j;
    for (int k = 0; k < columns; ++k)
    {
      double* own = corner + static_cast<long>(k) * ld;
      const double pivot = own[k];
      if (!(pivot > smallest[j + k]) || !std::isfinite(pivot))
      {
        return false;
      }
      const double root = std::sqrt(pivot);
      own[k] = root;
      for (int i = k + 1; i < columns; ++i)
      {
        own[i] /= root;
      }
      for (int other = k + 1; other < columns; ++other)
      {
        for (int i = other; i < columns; ++i)
        {
          corner[i + static_cast<long>(other) * ld] -= own[i] * own[other];
        }
      }
    }
    solveStrip<W>(corner, corner + 8, ld, height - j - 8, columns);
  }
  return true;
}

template <int W>
OVERSKETCH_INLINE void addAny(const Run* first, const Run* last, int skipped, const double* from, double* to)
{
  for (const Run* run = first; run != last; ++run, skipped = 0)
  {
    const double* in = from + run->from;
    double* out = to + run->to;
    int i = skipped;
    for (; i + W <= run->count; i += W)
    {
      typename Vector<W>::Type sum, more;
      load<W>(sum, out + i);
      load<W>(more, in + i);
      store<W>(out + i, sum + more);
    }
    for (; i < run->count; ++i)
    {
      out[i] += in[i];
    }
  }
}

// x L^T and L x for the square at the corner of a strip of columns.
template <int S>
OVERSKETCH_INLINE void forwardCorner(const double* l, int ld, int columns, double* x)
{
  for (int j = 0; j < columns; ++j)
  {
    const double inverse = 1.0 / l[j + static_cast<long>(j) * ld];
    for (int s = 0; s < S; ++s)
    {
      x[j + s * ld] *= inverse;
    }
    for (int i = j + 1; i < columns; ++i)
    {
      for (int s = 0; s < S; ++s)
      {
        x[i + s * ld] -= l[i + static_cast<long>(j) * ld] * x[j + s * ld];
      }
    }
  }
}

template <int S>
OVERSKETCH_INLINE void backwardCorner(const double* l, int ld, int columns, double* x)
{
  for (int j = columns - 1; j >= 0; --j)
  {
    const double inverse = 1.0 / l[j + static_cast<long>(j) * ld];
    for (int s = 0; s < S; ++s)
    {
      double sum = x[j + s * ld];
      for (int i = j + 1; i < columns; ++i)
      {
        sum -= l[i + static_cast<long>(j) * ld] * x[i + s * ld];
      }
      x[j + s * ld] = sum * inverse;
    }
  }
}

// x[rows] -= L x for C columns.
template <int W, int S, int C>
OVERSKETCH_INLINE void forwardColumns(const double* l, int ld, int first, const double* own, double* x)
{
  for (int i = first; i < ld; i += W)
  {
    typename Vector<W>::Type sum[S];
    for (int s = 0; s < S; ++s)
    {
      load<W>(sum[s], x + i + s * ld);
    }
#pragma GCC unroll 8
    for (int j = 0; j < C; ++j)
    {
      typename Vector<W>::Type column;
      load<W>(column, l + i + static_cast<long>(j) * ld);
      for (int s = 0; s < S; ++s)
      {
        sum[s] -= column * own[j + s * ld];
      }
    }
    for (int s = 0; s < S; ++s)
    {
      store<W>(x + i + s * ld, sum[s]);
    }
  }
}

// own -= L^T x[rows] for C columns.
template <int W, int S, int C>
OVERSKETCH_INLINE void backwardColumns(const double* l, int ld, int first, double* own, const double* x)
{
  typename Vector<W>::Type sum[C][S] = {};
  for (int i = first; i < ld; i += W)
  {
    typename Vector<W>::Type side[S];
    for (int s = 0; s < S; ++s)
    {
      load<W>(side[s], x + i + s * ld);
    }
#pragma GCC unroll 8
    for (int j = 0; j < C; ++j)
    {
      typename Vector<W>::Type column;
      load<W>(column, l + i + static_cast<long>(j) * ld);
      for (int s = 0; s < S; ++s)
      {
        sum[j][s] += column * side[s];
      }
    }
  }
#pragma GCC unroll 8
  for (int j = 0; j < C; ++j)
  {
    for (int s = 0; s < S; ++s)
    {
      own[j + s * ld] -= total<W>(sum[j][s]);
    }
  }
}

// Calls take(C, k) for C columns from column k on: as many as the registers hold at a time, then 4, 2 and 1.
template <int W, typename Take>
OVERSKETCH_INLINE void forColumns(int columns, const Take& take)
{
  constexpr int C = tileColumns<W>;
  int k = 0;
  for (; k + C <= columns; k += C)
  {
    take(std::integral_constant<int, C>(), k);
  }
  if (C > 4 && k + 4 <= columns)
  {
    take(std::integral_constant<int, 4>(), k);
    k += 4;
  }
  if (k + 2 <= columns)
  {
    take(std::integral_constant<int, 2>(), k);
    k += 2;
  }
  if (k < columns)
  {
    take(std::integral_constant<int, 1>(), k);
  }
}

template <int W, int S>
OVERSKETCH_INLINE void forwardAny(const double* l, int height, int count, double* x)
{
  for (int j = 0; j < count; j += 8)
  {
    const int columns = std::min(8, count - j);
    const double* strip = l + static_cast<long>(j) * height;
    forwardCorner<S>(strip + j, height, columns, x + j);
    forColumns<W>(
      columns, [&](auto C, int k) __attribute__((always_inline)) {
        forwardColumns<W, S, C.value>(strip + static_cast<long>(k) * height, height, j + 8, x + j + k, x);
      });
  }
}

template <int W, int S>
OVERSKETCH_INLINE void backwardAny(const double* l, int height, int count, double* x)
{
  for (int j = roundedUp(count, 8) - 8; j >= 0; j -= 8)
  {
    const int columns = std::min(8, count - j);
    const double* strip = l + static_cast<long>(j) * height;
    forColumns<W>(
      columns, [&](auto C, int k) __attribute__((always_inline)) {
        backwardColumns<W, S, C.value>(strip + static_cast<long>(k) * height, height, j + 8, x + j + k, x);
      });
    backwardCorner<S>(strip + j, height, columns, x + j);
  }
}

// The kernels compiled for one kind of processor; target is its attribute.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define OVERSKETCH_DENSE_KERNELS(name, target, W)                                                            \
  struct name                                                                                                \
  {                                                                                                          \
    target static bool factor(double* a, int ld, int count, const double* smallest)                          \
    {                                                                                                        \
      return factorAny<W>(a, ld, count, smallest);                                                           \
    }                                                                                                        \
    target static void solveRows(const double* l, double* x, int ld, int rows, int count)                    \
    {                                                                                                        \
      solveRowsAny<W>(l, x, ld, rows, count);                                                                \
    }                                                                                                        \
    target static void multiply(double* c,                                                                   \
      int ldc,                                                                                               \
      const double* a,                                                                                       \
      const double* b,                                                                                       \
      int depth,                                                                                             \
      int rows,                                                                                              \
      int columns,                                                                                           \
      bool fresh)                                                                                            \
    {                                                                                                        \
      tiles<W>(c, ldc, a, 24, b, 24, depth, rows, columns, fresh);                                           \
    }                                                                                                        \
    target static void add(const Run* first, const Run* last, int skipped, const double* from, double* to)   \
    {                                                                                                        \
      addAny<W>(first, last, skipped, from, to);                                                             \
    }                                                                                                        \
    target static void forward(const double* l, int height, int count, double* x, int sides)                 \
    {                                                                                                        \
      sides == 3 ? forwardAny<W, 3>(l, height, count, x) : forwardAny<W, 1>(l, height, count, x);            \
    }                                                                                                        \
    target static void backward(const double* l, int height, int count, double* x, int sides)                \
    {                                                                                                        \
      sides == 3 ? backwardAny<W, 3>(l, height, count, x) : backwardAny<W, 1>(l, height, count, x);          \
    }                                                                                                        \
    static constexpr DenseKernels all{ factor, solveRows, multiply, add, forward, backward };                \
  };
// NOLINTEND(bugprone-macro-parentheses)

OVERSKETCH_DENSE_KERNELS(Baseline, , 2)
#if defined(__x86_64__)
OVERSKETCH_DENSE_KERNELS(Avx2, __attribute__((target("avx2,fma"))), 4)
OVERSKETCH_DENSE_KERNELS(Avx512, __attribute__((target("avx512f,avx2,fma"))), 8)
#endif

const DenseKernels& chooseKernels()
{
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f"))
  {
    return Avx512::all;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return Avx2::all;
  }
#endif
  return Baseline::all;
}

} // namespace

const DenseKernels& denseKernels()
{
  static const DenseKernels& kernels = chooseKernels();
  return kernels;
}

void pack(const double* a, int ld, int rows, int depth, double* out)
{
  for (int i = 0; i < rows; i += 24)
  {
    const int height = std::min(24, rows - i);
    const double* from = a + i;
    for (int k = 0; k < depth; ++k, from += ld, out += 24)
    {
      if (height == 24)
      {
        std::copy_n(from, 24, out); // by vectors, without a call
      }
      else
      {
        std::copy_n(from, 8, out);
        std::copy_n(from + height - 8, 8, out + height - 8);
      }
    }
  }
}

} // namespace oversketch
