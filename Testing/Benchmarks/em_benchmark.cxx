// Gaussian mixtures of 2048 samples by expectation maximisation. Ours is the whole greedy fit to four
// components, one launch, copies and insertions in the time. The others run as many EM iterations of four
// components as do the same work: one for every four of our component steps (131, which peers.py has as a
// number). CGAL's starts by its own k-means.
#include "benchmark_frame.h"

#include "Mixture/mixture.h"
#include "OpenCL/device.h"

#include <CGAL/Surface_mesh_segmentation/internal/Expectation_maximization.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>

namespace oversketch_bench
{

namespace
{

constexpr int sampleCount = 2048;
constexpr int components = 4;

// Four bumps, Box-Muller: the same with every standard library.
std::vector<double> makeSamples()
{
  constexpr double means[components] = { 0.1, 0.3, 0.55, 0.8 };
  constexpr double deviations[components] = { 0.05, 0.08, 0.06, 0.05 };
  std::mt19937 generator(7);
  const auto uniform = [&] { return (double(generator()) + 0.5) / 4294967296.0; };
  std::vector<double> samples;
  for (int i = 0; i < sampleCount; ++i)
  {
    const double z = std::sqrt(-2.0 * std::log(uniform())) * std::cos(6.283185307179586 * uniform());
    samples.push_back(means[i % components] + deviations[i % components] * z);
  }
  return samples;
}

struct Fits
{
  std::vector<double> samples = makeSamples();
  std::vector<float> floats{ samples.begin(), samples.end() };
  MixtureFit fit;
  int iterations = 0; // of four components, the work of our fit

  Fits()
  {
    int work = 0, steps = 0;
    for (int k = 1; k <= components; ++k)
    {
      MixtureOptions options;
      options.components = k;
      this->fit = fitMixture(this->samples, options);
      work += k * (this->fit.steps - steps);
      steps = this->fit.steps;
    }
    this->iterations = work / components;
  }
};

const Fits& fits()
{
  static const Fits all;
  return all;
}

#if defined(__x86_64__) && !defined(__clang__) // whose pragma has no target
// The limit: EM in single precision, 16 numbers to an operation, a polynomial for the exponential, nothing
// guarded.
#pragma GCC push_options
#pragma GCC target("avx512f,fma")
using Floats = float __attribute__((vector_size(64)));
using Ints = int __attribute__((vector_size(64)));

inline __attribute__((always_inline)) void exponential(Floats& x)
{
  constexpr float shift = 12582912.0f;   // 1.5 * 2^23: the sum's last bits are the nearest whole number
  x = x < -80.0f ? Floats{} - 80.0f : x; // what is made of it stays clear of slow subnormal numbers
  const Floats whole = x * 1.44269504f + shift;
  const Floats r = x - (whole - shift) * 0.693147182f;
  Floats p = r * (1.0f / 720.0f) + 1.0f / 120.0f;
  p = p * r + 1.0f / 24.0f;
  p = p * r + 1.0f / 6.0f;
  p = p * r + 0.5f;
  p = p * r + 1.0f;
  p = p * r + 1.0f;
  x = reinterpret_cast<Floats>(reinterpret_cast<Ints>(p) + (reinterpret_cast<Ints>(whole) << 23));
}

void limit(const std::vector<float>& samples, int iterations, Mixture& mixture)
{
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    Floats mass[components] = {}, first[components] = {}, second[components] = {};
    float height[components], steepness[components], mean[components];
    for (int k = 0; k < components; ++k)
    {
      height[k] = static_cast<float>(mixture[k].weight / std::sqrt(6.283185307179586 * mixture[k].variance));
      steepness[k] = static_cast<float>(-0.5 / mixture[k].variance);
      mean[k] = static_cast<float>(mixture[k].mean);
    }
    for (std::size_t i = 0; i < samples.size(); i += 16)
    {
      Floats x, terms[components], off[components], sum = Floats{} + 1e-37f;
      std::memcpy(&x, &samples[i], sizeof(x));
      for (int k = 0; k < components; ++k)
      {
        off[k] = x - mean[k];
        terms[k] = steepness[k] * off[k] * off[k];
        exponential(terms[k]);
        terms[k] *= height[k];
        sum += terms[k];
      }
      const Floats inverse = 1.0f / sum;
      for (int k = 0; k < components; ++k)
      {
        Floats share = terms[k] * inverse;
        mass[k] += share;
        share *= off[k];
        first[k] += share;
        second[k] += share * off[k];
      }
    }
    for (int k = 0; k < components; ++k)
    {
      double m = 0.0, f = 0.0, s = 0.0;
      for (int lane = 0; lane < 16; ++lane)
      {
        m += mass[k][lane];
        f += first[k][lane];
        s += second[k][lane];
      }
      mixture[k] = {
        m / double(samples.size()), mixture[k].mean + f / m, std::max(s / m - (f / m) * (f / m), 1e-9)
      };
    }
  }
}
#pragma GCC pop_options
#endif

Job side(const char* who, std::function<void()> run)
{
  Job job;
  job.job = "greedy EM";
  job.size = "2048";
  job.who = who;
  job.threads = 1;
  job.prepare = [] { fits(); };
  job.run = std::move(run);
  job.figures = []
  {
    const int iterations = fits().iterations;
    return std::map<std::string, double>{ { "iterations", iterations }, { "em_steps", fits().fit.steps } };
  };
  return job;
}

} // namespace

void jobs()
{
  if (const auto device = Device::instance())
  {
    add(side("ours", [device] { fitMixtureOnDevice(*device, fits().samples, {}); }));
  }
  else
  {
    std::fprintf(stderr, "No OpenCL device: our fit on the device is left out.\n");
  }
  add(side("ours, host", [] { fitMixture(fits().samples, {}); }));
  add(side("CGAL",
    []
    {
      // A threshold that no progress is below: all iterations.
      CGAL::internal::Expectation_maximization(components,
        fits().samples,
        CGAL::internal::Expectation_maximization::K_MEANS_INITIALIZATION,
        1,
        -1e300,
        static_cast<std::size_t>(fits().iterations));
    }));
#if defined(__x86_64__) && !defined(__clang__) // whose pragma has no target
  if (__builtin_cpu_supports("avx512f"))
  {
    add(side("limit",
      []
      {
        Mixture mixture;
        for (int k = 0; k < components; ++k)
        {
          mixture.push_back({ 0.25, (k + 0.5) / components, 0.01 });
        }
        limit(fits().floats, fits().iterations, mixture);
        if (!(mixture[0].variance > 0.0))
        {
          std::fprintf(stderr, "The limit went astray.\n");
        }
      }));
  }
#endif
}

} // namespace oversketch_bench
