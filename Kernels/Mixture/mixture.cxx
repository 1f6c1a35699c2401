#include "Mixture/mixture.h"

#include "Mixture/mixture_sums.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace oversketch
{

namespace
{

constexpr double logTwoPi = 1.8378770664093453;

// Mixture and candidate in equal shares is where the log-likelihood is expanded; the true weight is the
// expansion's maximum, kept inside (0, 1).
struct Insertion
{
  double weight = 0.5;
  double logLikelihood = -std::numeric_limits<double>::infinity();
};

Insertion scoreCandidate(const std::vector<double>& samples,
  const std::vector<double>& density,
  double mean,
  double variance)
{
  ScoreSums sums{};
  mixtureKernels().score(samples, density, mean, variance, sums);
  if (!(sums.squares > 0.0))
  {
    return {};
  }
  Insertion insertion;
  insertion.weight = std::clamp(0.5 - 0.5 * sums.sum / sums.squares, 0.01, 0.99);
  const double step = insertion.weight - 0.5;
  insertion.logLikelihood = sums.logs - std::log(2.0) * double(samples.size()) - 2.0 * step * sums.sum -
                            2.0 * step * step * sums.squares;
  return insertion;
}

// Into equal intervals first, then each: of spread samples, which an interval has few of, sooner than by
// comparisons alone.
std::vector<double> sortedSamples(const std::vector<double>& samples)
{
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double origin = *low, scale = (double(samples.size()) - 1.0) / (*high - origin);
  if (!std::isfinite(scale))
  {
    return samples; // all alike
  }
  std::vector<int> intervals(samples.size());
  std::vector<int> ends(intervals.size() + 1, 0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    intervals[i] = static_cast<int>((samples[i] - origin) * scale);
    ++ends[intervals[i] + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<int> next = ends;
  std::vector<double> sorted(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    sorted[next[intervals[i]]++] = samples[i];
  }
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
  {
    if (ends[k + 1] - ends[k] > 1)
    {
      std::sort(sorted.begin() + ends[k], sorted.begin() + ends[k + 1]);
    }
  }
  return sorted;
}

} // namespace

LogDensity::LogDensity(const Mixture& mixture)
{
  for (const Gaussian& g : mixture)
  {
    this->Terms.push_back({ g.mean, g.variance, std::log(g.weight), logTwoPi + std::log(g.variance) });
  }
}

double LogDensity::operator()(double x) const
{
  double logs[maximumMixtureComponents];
  double largest = -std::numeric_limits<double>::infinity();
  const std::size_t count = this->Terms.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    // ln(weight N(x; mean, variance))
    const Term& term = this->Terms[k];
    const double d = x - term.mean;
    logs[k] = term.logWeight - 0.5 * (term.logScale + d * d / term.variance);
    largest = std::max(largest, logs[k]);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    sum += std::exp(logs[k] - largest);
  }
  return largest + std::log(sum);
}

MixtureStep stepMixture(const Mixture& mixture, const std::vector<double>& samples, double varianceFloor)
{
  StepSums sums{};
  mixtureKernels().step(mixture, samples, sums);
  MixtureStep step{ mixture, sums.logLikelihood };
  for (std::size_t k = 0; k < mixture.size(); ++k)
  {
    // A component that lost its samples keeps its place with no weight to speak of.
    const double mass = sums.mass[k];
    const double away = mass > 0.0 ? sums.first[k] / mass : 0.0;
    const double spread = mass > 0.0 ? sums.second[k] / mass - away * away : 0.0;
    step.mixture[k] = {
      std::max(mass / double(samples.size()), 1e-12), mixture[k].mean + away, std::max(spread, varianceFloor)
    };
  }
  return step;
}

MixtureCandidates mixtureCandidates(const std::vector<double>& samples, const MixtureOptions& options)
{
  const std::vector<double> sorted = sortedSamples(samples);
  const double n = double(sorted.size());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / n;
  double variance = 0.0;
  for (double x : sorted)
  {
    variance += (x - mean) * (x - mean) / n;
  }
  MixtureCandidates candidates;
  // The rule of thumb for the width of a one-dimensional kernel density estimate, squared.
  candidates.variance = std::max(variance * std::pow(4.0 / (3.0 * n), 0.4), options.varianceFloor);
  for (int c = 0; c < options.candidates; ++c)
  {
    candidates.means.push_back(sorted[std::size_t((c + 0.5) / options.candidates * n)]);
  }
  return candidates;
}

MixtureFit fitMixture(const std::vector<double>& samples,
  const MixtureOptions& options,
  const Context& context)
{
  if (samples.empty())
  {
    throw Error(Failure::BadRegion, "There are no samples to fit a Gaussian mixture to.");
  }
  // From any single component, one step lands on the samples' own mean and variance.
  MixtureFit fit;
  fit.mixture = stepMixture({ { 1.0, samples[0], 1.0 } }, samples, options.varianceFloor).mixture;
  fit.logLikelihood = stepMixture(fit.mixture, samples, options.varianceFloor).logLikelihood;
  fit.steps = 1;
  const MixtureCandidates candidates = mixtureCandidates(samples, options);
  const double gain = options.tolerance * double(samples.size());
  std::vector<double> density;
  std::vector<Insertion> insertions(candidates.means.size());
  while (int(fit.mixture.size()) < options.components)
  {
    context.checkpoint(double(fit.mixture.size()) / options.components);
    mixtureKernels().density(fit.mixture, samples, density);
    context.each(int(insertions.size()),
      [&](int c)
      { insertions[c] = scoreCandidate(samples, density, candidates.means[c], candidates.variance); });
    const auto best = std::max_element(insertions.begin(),
      insertions.end(),
      [](const Insertion& a, const Insertion& b) { return a.logLikelihood < b.logLikelihood; });
    Mixture trial = fit.mixture;
    for (Gaussian& g : trial)
    {
      g.weight *= 1.0 - best->weight;
    }
    trial.push_back({ best->weight, candidates.means[best - insertions.begin()], candidates.variance });

    Mixture converged = trial;
    double reached = -std::numeric_limits<double>::infinity();
    for (int s = 0; s < options.maximumSteps; ++s)
    {
      const MixtureStep step = stepMixture(trial, samples, options.varianceFloor);
      ++fit.steps;
      // Only a variance at its floor can make the likelihood fall; then the mixture before stands.
      const bool rises = step.logLikelihood > reached + gain;
      if (step.logLikelihood > reached)
      {
        reached = step.logLikelihood;
        converged = trial;
      }
      if (!rises)
      {
        break;
      }
      trial = step.mixture;
    }
    if (!(reached > fit.logLikelihood + gain))
    {
      break;
    }
    fit.mixture = converged;
    fit.logLikelihood = reached;
  }
  return fit;
}

std::vector<int> drawWithoutReplacement(int population, int maximum, int seed)
{
  std::vector<int> indices(population);
  std::iota(indices.begin(), indices.end(), 0);
  if (population <= maximum)
  {
    return indices;
  }
  // Not std::shuffle or std::sample: their results differ between standard libraries.
  std::mt19937 generator(static_cast<std::uint32_t>(seed));
  for (int i = 0; i < maximum; ++i)
  {
    const std::uint64_t range = std::uint64_t(population - i);
    std::swap(indices[i], indices[i + int(std::uint64_t(generator()) * range >> 32)]);
  }
  indices.resize(maximum);
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::vector<int> evenItems(const std::vector<double>& weights, int maximum)
{
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  const bool alike = !(all > 0.0);
  const std::size_t count = std::min(weights.size(), static_cast<std::size_t>(maximum));
  const double step = (alike ? static_cast<double>(weights.size()) : all) / static_cast<double>(count);
  std::vector<int> items;
  items.reserve(count);
  double passed = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    passed += alike ? 1.0 : weights[i];
    while (items.size() < count && (static_cast<double>(items.size()) + 0.5) * step <= passed)
    {
      items.push_back(static_cast<int>(i));
    }
  }
  items.resize(count, static_cast<int>(weights.size()) - 1); // rounding may leave the last one
  return items;
}

std::vector<double> evenSamples(std::vector<double> values, int maximum)
{
  std::sort(values.begin(), values.end());
  std::vector<double> samples;
  for (const int i : evenItems(std::vector<double>(values.size(), 1.0), maximum))
  {
    samples.push_back(values[i]);
  }
  return samples;
}

} // namespace oversketch
