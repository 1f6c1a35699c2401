#include "Mixture/mixture_sums.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#define OVERSKETCH_INLINE inline __attribute__((always_inline))

namespace oversketch
{

namespace
{

// W numbers, as many as a register holds.
template <int W>
struct Vector;
template <>
struct Vector<2>
{
  typedef double Lanes __attribute__((vector_size(16)));
  typedef std::uint64_t Bits __attribute__((vector_size(16)));
};
template <>
struct Vector<4>
{
  typedef double Lanes __attribute__((vector_size(32)));
  typedef std::uint64_t Bits __attribute__((vector_size(32)));
};
template <>
struct Vector<8>
{
  typedef double Lanes __attribute__((vector_size(64)));
  typedef std::uint64_t Bits __attribute__((vector_size(64)));
};

constexpr double log2E = 1.4426950408889634, ln2 = 0.6931471805599453;
constexpr double tiny = 1.5e-154; // its square is a normal number

template <int W>
OVERSKETCH_INLINE double total(const typename Vector<W>::Lanes& v)
{
  double sum = v[0];
  for (int lane = 1; lane < W; ++lane)
  {
    sum += v[lane];
  }
  return sum;
}

// 2^t for t <= 1000; below 2^-1000 everything is 2^-1000.
template <int W>
OVERSKETCH_INLINE void power2(typename Vector<W>::Lanes& t)
{
  using Lanes = typename Vector<W>::Lanes;
  using Bits = typename Vector<W>::Bits;
  constexpr double shift = 6755399441055744.0; // 1.5 * 2^52: the sum's last bits are the nearest whole number
  t = t < -1000.0 ? Lanes{} - 1000.0 : t;
  const Lanes whole = t + shift;
  const Lanes r = t - (whole - shift);
  // The polynomial of degree 10 that is nearest to 2^r on [-1/2, 1/2], off by at most 2.2e-16 of the value;
  // in pairs, for a short chain of operations.
  const Lanes r2 = r * r, r4 = r2 * r2;
  const Lanes a = (r * 0.6931471805599497 + 1.0) + (r * 0.05550410866445883 + 0.24022650695908768) * r2;
  const Lanes b = (r * 0.0013333558228561476 + 0.00961812910803459) +
                  (r * 1.5252658116561384e-05 + 0.00015403529961135955) * r2;
  const Lanes c = (r * 1.0208537904552164e-07 + 1.3215662831846104e-06) + r2 * 7.037279530582804e-09;
  const Lanes p = a + (b + c * r4) * r4;
  t = reinterpret_cast<Lanes>(reinterpret_cast<Bits>(p) + (reinterpret_cast<Bits>(whole) << 52));
}

// The logarithm of a product of positive numbers: factors between 1 and 2, exponents added, logarithms at the
// end.
template <int W>
struct Product
{
  using Lanes = typename Vector<W>::Lanes;
  using Bits = typename Vector<W>::Bits;
  Lanes mantissas = Lanes{} + 1.0;
  Bits exponents = {};
  int factors = 0;

  OVERSKETCH_INLINE void multiply(const Lanes& factor)
  {
    const Bits bits = reinterpret_cast<Bits>(this->mantissas * factor);
    this->exponents += bits >> 52;
    this->mantissas =
      reinterpret_cast<Lanes>((bits & ((std::uint64_t(1) << 52) - 1)) | (std::uint64_t(1023) << 52));
    ++this->factors;
  }
  OVERSKETCH_INLINE double log() const
  {
    double logs = 0.0;
    for (int lane = 0; lane < W; ++lane)
    {
      logs += std::log(this->mantissas[lane]) +
              ln2 * (static_cast<double>(this->exponents[lane]) - 1023.0 * this->factors);
    }
    return logs;
  }
};

// log2(weight N(x; mean, variance)) is height - steepness (x - mean)^2.
struct Bell
{
  double height, steepness, mean;
  Bell() = default;
  explicit Bell(const Gaussian& g)
    : height(std::log2(g.weight) - 0.5 * std::log2(6.283185307179586 * g.variance))
    , steepness(0.5 * log2E / g.variance)
    , mean(g.mean)
  {
  }
};

// Calls body(first, in, count) for each W numbers from `first` on; at the end only `count` of them are
// there, and `in` is 0 for the others, else 1.
template <int W, typename Body>
OVERSKETCH_INLINE void forLanes(std::size_t size, const Body& body)
{
  using Lanes = typename Vector<W>::Lanes;
  const Lanes all = Lanes{} + 1.0;
  std::size_t i = 0;
  for (; i + W <= size; i += W)
  {
    body(i, all, W);
  }
  if (i < size)
  {
    Lanes in{};
    for (std::size_t lane = 0; lane < size - i; ++lane)
    {
      in[lane] = 1.0;
    }
    body(i, in, static_cast<int>(size - i));
  }
}

// W numbers from a vector, the last of it again where there are fewer.
template <int W>
OVERSKETCH_INLINE void load(typename Vector<W>::Lanes& v,
  const std::vector<double>& from,
  std::size_t first,
  int count)
{
  if (count == W)
  {
    std::memcpy(&v, from.data() + first, sizeof(v));
  }
  else
  {
    for (int lane = 0; lane < W; ++lane)
    {
      v[lane] = from[first + std::min(lane, count - 1)];
    }
  }
}

template <int W, int K>
OVERSKETCH_INLINE void stepOf(const Mixture& mixture, const std::vector<double>& samples, StepSums& sums)
{
  using Lanes = typename Vector<W>::Lanes;
  Bell bells[K];
  std::transform(mixture.begin(), mixture.end(), bells, [](const Gaussian& g) { return Bell(g); });
  Lanes mass[K] = {}, first[K] = {}, second[K] = {}, heights{};
  Product<W> product;
  forLanes<W>(
    samples.size(), [&](std::size_t i, const Lanes& in, int count) __attribute__((always_inline)) {
      Lanes x, terms[K], off[K], sum{};
      load<W>(x, samples, i, count);
      Lanes largest = Lanes{} - INFINITY; // taken out: far from all means, densities underflow
#pragma GCC unroll 8
      for (int k = 0; k < K; ++k)
      {
        off[k] = x - bells[k].mean;
        terms[k] = bells[k].height - off[k] * off[k] * bells[k].steepness;
        largest = terms[k] > largest ? terms[k] : largest;
      }
#pragma GCC unroll 8
      for (int k = 0; k < K; ++k)
      {
        terms[k] -= largest;
        power2<W>(terms[k]);
        sum += terms[k];
      }
      heights += in * largest;
      product.multiply(in > 0.0 ? sum : Lanes{} + 1.0);
      const Lanes inverse = in / sum;
#pragma GCC unroll 8
      for (int k = 0; k < K; ++k)
      {
        const Lanes share = terms[k] * inverse, moment = share * off[k];
        mass[k] += share;
        first[k] += moment;
        second[k] += moment * off[k];
      }
    });
  for (int k = 0; k < K; ++k)
  {
    sums.mass[k] = total<W>(mass[k]);
    sums.first[k] = total<W>(first[k]);
    sums.second[k] = total<W>(second[k]);
  }
  sums.logLikelihood = ln2 * total<W>(heights) + product.log();
}

template <int W>
OVERSKETCH_INLINE void stepAny(const Mixture& mixture, const std::vector<double>& samples, StepSums& sums)
{
  // With the number of components known, sums stay in registers.
  switch (mixture.size())
  {
    case 1:
      return stepOf<W, 1>(mixture, samples, sums);
    case 2:
      return stepOf<W, 2>(mixture, samples, sums);
    case 3:
      return stepOf<W, 3>(mixture, samples, sums);
    case 4:
      return stepOf<W, 4>(mixture, samples, sums);
    case 5:
      return stepOf<W, 5>(mixture, samples, sums);
    case 6:
      return stepOf<W, 6>(mixture, samples, sums);
    case 7:
      return stepOf<W, 7>(mixture, samples, sums);
    default:
      return stepOf<W, maximumMixtureComponents>(mixture, samples, sums);
  }
}

template <int W>
OVERSKETCH_INLINE void densityAny(const Mixture& mixture,
  const std::vector<double>& samples,
  std::vector<double>& density)
{
  using Lanes = typename Vector<W>::Lanes;
  Bell bells[maximumMixtureComponents];
  std::transform(mixture.begin(), mixture.end(), bells, [](const Gaussian& g) { return Bell(g); });
  density.resize(samples.size());
  forLanes<W>(
    samples.size(), [&](std::size_t i, const Lanes&, int count) __attribute__((always_inline)) {
      Lanes x, sum{};
      load<W>(x, samples, i, count);
      for (std::size_t k = 0; k < mixture.size(); ++k)
      {
        const Lanes off = x - bells[k].mean;
        Lanes term = bells[k].height - off * off * bells[k].steepness;
        power2<W>(term);
        sum += term;
      }
      std::memcpy(density.data() + i, &sum, count * sizeof(double));
    });
}

template <int W>
OVERSKETCH_INLINE void scoreAny(const std::vector<double>& samples,
  const std::vector<double>& density,
  double mean,
  double variance,
  ScoreSums& sums)
{
  using Lanes = typename Vector<W>::Lanes;
  const Bell bell({ 1.0, mean, variance });
  Lanes sum{}, squares{};
  Product<W> product;
  forLanes<W>(
    samples.size(), [&](std::size_t i, const Lanes& in, int count) __attribute__((always_inline)) {
      Lanes x, f;
      load<W>(x, samples, i, count);
      load<W>(f, density, i, count);
      const Lanes off = x - bell.mean;
      Lanes phi = bell.height - off * off * bell.steepness;
      power2<W>(phi);
      Lanes both = f + phi;
      both = both > tiny ? both : Lanes{} + tiny; // both may underflow
      product.multiply(in > 0.0 ? both : Lanes{} + 1.0);
      const Lanes delta = in * (f - phi) / both;
      sum += delta;
      squares += delta * delta;
    });
  sums = { product.log(), total<W>(sum), total<W>(squares) };
}

// The kernels compiled for one kind of processor; target is its attribute.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define OVERSKETCH_MIXTURE_KERNELS(name, target, W)                                                          \
  struct name                                                                                                \
  {                                                                                                          \
    target static void step(const Mixture& mixture, const std::vector<double>& samples, StepSums& sums)      \
    {                                                                                                        \
      stepAny<W>(mixture, samples, sums);                                                                    \
    }                                                                                                        \
    target static void density(const Mixture& mixture,                                                       \
      const std::vector<double>& samples,                                                                    \
      std::vector<double>& density)                                                                          \
    {                                                                                                        \
      densityAny<W>(mixture, samples, density);                                                              \
    }                                                                                                        \
    target static void score(const std::vector<double>& samples,                                             \
      const std::vector<double>& density,                                                                    \
      double mean,                                                                                           \
      double variance,                                                                                       \
      ScoreSums& sums)                                                                                       \
    {                                                                                                        \
      scoreAny<W>(samples, density, mean, variance, sums);                                                   \
    }                                                                                                        \
    static constexpr MixtureKernels all{ step, density, score };                                             \
  };
// NOLINTEND(bugprone-macro-parentheses)

OVERSKETCH_MIXTURE_KERNELS(Baseline, , 2)
#if defined(__x86_64__)
OVERSKETCH_MIXTURE_KERNELS(Avx2, __attribute__((target("avx2,fma"))), 4)
OVERSKETCH_MIXTURE_KERNELS(Avx512, __attribute__((target("avx512f,avx512dq,avx2,fma"))), 8)
#endif

const MixtureKernels& chooseKernels()
{
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
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

const MixtureKernels& mixtureKernels()
{
  static const MixtureKernels& kernels = chooseKernels();
  return kernels;
}

} // namespace oversketch
