// One-dimensional Gaussian mixtures by greedy expectation maximisation (SEED, Sec. 4.2, Table 2): start from
// one component; insert the best of the candidates, judged by a second-order expansion of the log-likelihood
// in the new weight; run EM to convergence; repeat. Ours because no library among the dependencies has greedy
// insertion, and the general ones (OpenCV's ml::EM) start from random centres.
#ifndef oversketch_kernels_mixture_mixture_h
#define oversketch_kernels_mixture_mixture_h

#include "Mesh/context.h"

#include <vector>

namespace oversketch
{

class Device;

struct Gaussian
{
  double weight, mean, variance;
};
using Mixture = std::vector<Gaussian>;

constexpr int maximumMixtureComponents = 8;

struct MixtureOptions
{
  int components = 4;          // at most; 1 .. maximumMixtureComponents
  int candidates = 64;         // places tried for a new component: quantiles of the samples
  double varianceFloor = 1e-4; // of every component; keeps constant samples from collapsing
  int maximumSteps = 300;      // EM steps per insertion
  double tolerance = 1e-5;     // EM has converged when the mean log-likelihood gains no more than this
};

struct MixtureFit
{
  Mixture mixture;
  double logLikelihood = 0.0; // sum over the samples
  int steps = 0;              // EM steps in all
};

// ln of a mixture's density; finite for every finite x. The logarithms of weights and variances are taken
// once, not for every x.
class LogDensity
{
public:
  explicit LogDensity(const Mixture& mixture);
  double operator()(double x) const;

private:
  struct Term
  {
    double mean, variance, logWeight, logScale;
  };
  std::vector<Term> Terms;
};

// One EM step: responsibilities of the components, then weights, means and variances from them.
// logLikelihood is that of the mixture given, not of the one returned.
struct MixtureStep
{
  Mixture mixture;
  double logLikelihood;
};
MixtureStep stepMixture(const Mixture& mixture, const std::vector<double>& samples, double varianceFloor);

// Means and common variance of the components that an insertion tries.
struct MixtureCandidates
{
  std::vector<double> means;
  double variance;
};
MixtureCandidates mixtureCandidates(const std::vector<double>& samples, const MixtureOptions& options);

// Throws Error(BadRegion) without samples. Stops early when a further component raises the likelihood no
// more.
MixtureFit fitMixture(const std::vector<double>& samples,
  const MixtureOptions& options,
  const Context& context = {});

// `maximum` ascending indices below `population`, without replacement, all where there are no more than that.
// Draws the same for the same seed on every platform.
std::vector<int> drawWithoutReplacement(int population, int maximum, int seed);

// At most `maximum` of the items 0 .. weights.size() - 1 at equal steps of their weights, ascending: as many
// of each as its weight's share of all. Weights that are all zero stand for equal ones.
std::vector<int> evenItems(const std::vector<double>& weights, int maximum);

// At most `maximum` of the values at equal steps of their number, ascending.
std::vector<double> evenSamples(std::vector<double> values, int maximum);

// fitMixture on the device, in one launch: a single work-group runs every EM step and insertion, so the host
// need not synchronise; one buffer goes there, one comes back. Double precision where the device has it (then
// equal to the host's fit to 1e-5 and better), else single. groupSize 0: as many work-items as the
// device's registers and local memory serve, 256 at most (more only lengthen the sums over the group: 0.66 ms
// for 256, 0.81 for 480 on an NVIDIA H100, whose host took 0.60), and 1 on a processor, where a group is one
// thread anyway: there the one work-item computes on vectors of 8 samples, with which the compiler fills the
// processor's widest registers. So the device is the right choice (Backend::Auto) on a processor too: it
// takes less than a tenth of the host's time, which the launch, some 0.05 ms, does not change. Throws
// Error(NoDevice) when the device fails.
MixtureFit fitMixtureOnDevice(Device& device,
  const std::vector<double>& samples,
  const MixtureOptions& options,
  std::size_t groupSize = 0,
  bool singlePrecision = false);

} // namespace oversketch
#endif
