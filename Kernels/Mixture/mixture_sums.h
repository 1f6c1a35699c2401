// The sums over all samples that fitting a mixture takes its time for, as many samples at a time as a
// register holds.
//
// Why not a library: vectors of exponentials at the processor's own width, chosen when the program starts,
// are in none of the dependencies: Eigen takes its width when it is compiled.
#ifndef oversketch_kernels_mixture_mixture_sums_h
#define oversketch_kernels_mixture_mixture_sums_h

#include "Mixture/mixture.h"

#include <vector>

namespace oversketch
{

// Sums of r, r d and r d^2 for each component, r its share of a sample and d the sample's distance from its
// mean. And the mixture's log-likelihood.
struct StepSums
{
  double mass[maximumMixtureComponents], first[maximumMixtureComponents], second[maximumMixtureComponents];
  double logLikelihood;
};

// For a candidate of density phi where the mixture has the density f, delta = (f - phi) / (f + phi): the sums
// of ln(f + phi), delta and delta^2.
struct ScoreSums
{
  double logs, sum, squares;
};

// Each is compiled for AVX-512, AVX2 with fused multiply-add, and the baseline, like the kernels of
// Sparse/dense.h: the results are the same from run to run on one machine, and differ between machines by
// rounding.
struct MixtureKernels
{
  void (*step)(const Mixture& mixture, const std::vector<double>& samples, StepSums& sums);
  // The mixture's density at each sample.
  void (*density)(const Mixture& mixture, const std::vector<double>& samples, std::vector<double>& density);
  void (*score)(const std::vector<double>& samples,
    const std::vector<double>& density,
    double mean,
    double variance,
    ScoreSums& sums);
};

// The kernels for this processor.
const MixtureKernels& mixtureKernels();

} // namespace oversketch
#endif
