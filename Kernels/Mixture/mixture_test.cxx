#include "Harness/shapes.h"
#include "Mixture/mixture.h"
#include "OpenCL/device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

using namespace oversketch;
using oversketch_test::fact;

namespace
{

std::vector<double> uniforms(int count)
{
  std::mt19937 generator(3);
  std::vector<double> values(count);
  for (double& x : values)
  {
    x = double(generator()) / 4294967296.0;
  }
  return values;
}

// Box-Muller, so that the draws are the same with every standard library.
std::vector<double> twoBumps()
{
  std::mt19937 generator(5);
  const auto uniform = [&] { return (double(generator()) + 0.5) / 4294967296.0; };
  std::vector<double> values;
  for (int i = 0; i < 2048; ++i)
  {
    const double z = std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * oversketch_test::pi * uniform());
    values.push_back(i < 1024 ? 0.2 + 0.03 * z : 0.7 + 0.05 * z);
  }
  return values;
}

std::string text(double value)
{
  std::ostringstream stream;
  stream.precision(3);
  stream << value;
  return stream.str();
}

double worstDifference(const Mixture& a, const Mixture& b)
{
  double worst = a.size() == b.size() ? 0.0 : 1.0;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k)
  {
    worst = std::max({ worst,
      std::abs(a[k].weight - b[k].weight),
      std::abs(a[k].mean - b[k].mean),
      std::abs(a[k].variance - b[k].variance) });
  }
  return worst;
}

} // namespace

TEST(A7_1, MomentsAfterAnyMStepAreTheSamples)
{
  const std::vector<double> samples = uniforms(777);
  double mean = 0.0, second = 0.0;
  for (double x : samples)
  {
    mean += x / double(samples.size());
    second += x * x / double(samples.size());
  }
  Mixture mixture{ { 0.5, 0.1, 0.02 }, { 0.3, 0.5, 0.01 }, { 0.2, 0.6, 0.3 } };
  double worst = 0.0;
  for (int step = 0; step < 20; ++step)
  {
    mixture = stepMixture(mixture, samples, 1e-4).mixture;
    double weight = 0.0, m = 0.0, s = 0.0;
    for (const Gaussian& g : mixture)
    {
      weight += g.weight;
      m += g.weight * g.mean;
      s += g.weight * (g.variance + g.mean * g.mean);
      EXPECT_GT(g.variance, 1e-4);
    }
    worst = std::max({ worst, std::abs(weight - 1.0), std::abs(m - mean), std::abs(s - second) });
  }
  EXPECT_LT(worst, 1e-12);
  fact("A7_1", "weights, mean and second moment off by at most " + text(worst) + " over 20 M-steps");
}

TEST(A7_2, LikelihoodNeverFallsInEMNorWithMoreComponents)
{
  const std::vector<double> samples = uniforms(2048);
  Mixture mixture{ { 0.5, 0.1, 0.02 }, { 0.3, 0.5, 0.01 }, { 0.2, 0.6, 0.3 } };
  double before = -1e300;
  for (int step = 0; step < 100; ++step)
  {
    const MixtureStep next = stepMixture(mixture, samples, 1e-4);
    EXPECT_GE(next.logLikelihood, before - 1e-9);
    before = next.logLikelihood;
    mixture = next.mixture;
  }
  std::string reached;
  before = -1e300;
  for (int components = 1; components <= 4; ++components)
  {
    MixtureOptions options;
    options.components = components;
    const MixtureFit fit = fitMixture(samples, options);
    EXPECT_EQ(int(fit.mixture.size()), components);
    EXPECT_GT(fit.logLikelihood, before);
    double direct = 0.0;
    for (double x : samples)
    {
      direct += LogDensity(fit.mixture)(x);
    }
    EXPECT_NEAR(fit.logLikelihood, direct, 1e-8);
    before = fit.logLikelihood;
    reached += (components > 1 ? ", " : "") + text(fit.logLikelihood);
  }
  fact("A7_2", "log-likelihood of 2048 uniforms for K = 1..4: " + reached);
}

TEST(A7_3, TwoBumpsAreRecovered)
{
  MixtureOptions options;
  options.components = 2;
  MixtureFit fit = fitMixture(twoBumps(), options);
  ASSERT_EQ(fit.mixture.size(), 2u);
  std::sort(fit.mixture.begin(),
    fit.mixture.end(),
    [](const Gaussian& a, const Gaussian& b) { return a.mean < b.mean; });
  EXPECT_NEAR(fit.mixture[0].mean, 0.2, 0.01);
  EXPECT_NEAR(fit.mixture[1].mean, 0.7, 0.01);
  EXPECT_NEAR(fit.mixture[0].weight, 0.5, 0.02);
  EXPECT_NEAR(fit.mixture[1].weight, 0.5, 0.02);
  EXPECT_NEAR(std::sqrt(fit.mixture[0].variance), 0.03, 0.005);
  EXPECT_NEAR(std::sqrt(fit.mixture[1].variance), 0.05, 0.005);
  fact("A7_3",
    "means " + text(fit.mixture[0].mean) + ", " + text(fit.mixture[1].mean) + ", weights " +
      text(fit.mixture[0].weight) + ", " + text(fit.mixture[1].weight));
}

TEST(A7_4, DeviceFitEqualsHostFit)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  double worst = 0.0;
  for (const std::vector<double>& samples : { uniforms(2048), twoBumps(), uniforms(1000), uniforms(5) })
  {
    for (int components : { 1, 2, 4 })
    {
      MixtureOptions options;
      options.components = components;
      const MixtureFit host = fitMixture(samples, options);
      const MixtureFit other = fitMixtureOnDevice(*device, samples, options);
      EXPECT_EQ(other.steps, host.steps);
      EXPECT_NEAR(other.logLikelihood, host.logLikelihood, 1e-5 * std::abs(host.logLikelihood));
      worst = std::max(worst, worstDifference(host.mixture, other.mixture));
    }
  }
  EXPECT_LT(worst, device->info().fp64 ? 1e-5 : 1e-3);
  fact("A7_4", "device and host mixtures differ by at most " + text(worst));
}

TEST(A7_4, DeviceReductionEqualsHostReductionForAnyGroupAndPrecision)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  // One component is one reduction and nothing else: counts, sums, squares, logs.
  MixtureOptions options;
  options.components = 1;
  const std::vector<double> samples = uniforms(2048);
  const MixtureFit host = fitMixture(samples, options);
  for (bool single : { true, false })
  {
    for (std::size_t group : { 1, 7, 64 })
    {
      const MixtureFit other = fitMixtureOnDevice(*device, samples, options, group, single);
      EXPECT_LT(worstDifference(host.mixture, other.mixture), 1e-5) << group << single;
      EXPECT_NEAR(other.logLikelihood, host.logLikelihood, 1e-5 * std::abs(host.logLikelihood));
    }
  }
}

TEST(Mixture, DeviceFitEqualsHostFitForAnyGroup)
{
  const auto device = Device::instance();
  if (!device || !device->info().fp64)
  {
    GTEST_SKIP() << "no OpenCL device with double precision";
  }
  // 130 samples fill neither vectors nor groups.
  const std::vector<double> samples = uniforms(130);
  MixtureOptions options;
  options.components = 3;
  const MixtureFit host = fitMixture(samples, options);
  EXPECT_EQ(host.mixture.size(), 3u);
  std::vector<std::size_t> groups{ 1 };
  if (device->info().platform != "Portable Computing Language")
  {
    groups.push_back(7); // PoCL runs it as well, after compiling barriers within loops for minutes
  }
  for (std::size_t group : groups)
  {
    const MixtureFit other = fitMixtureOnDevice(*device, samples, options, group);
    EXPECT_LT(worstDifference(host.mixture, other.mixture), 1e-5) << group;
    EXPECT_EQ(other.steps, host.steps) << group;
  }
}

TEST(Mixture, ALoneSampleFarFromTheRestKeepsTheLikelihoodFinite)
{
  std::vector<double> samples(3000, 0.1);
  samples[1234] = 0.9;
  for (int components : { 1, 2 })
  {
    MixtureOptions options;
    options.components = components;
    const MixtureFit host = fitMixture(samples, options);
    double direct = 0.0;
    for (double x : samples)
    {
      direct += LogDensity(host.mixture)(x);
    }
    EXPECT_NEAR(host.logLikelihood, direct, 1e-8 * std::abs(direct));
    if (const auto device = Device::instance(); device && device->info().fp64)
    {
      const MixtureFit other = fitMixtureOnDevice(*device, samples, options);
      EXPECT_EQ(other.steps, host.steps);
      EXPECT_LT(worstDifference(host.mixture, other.mixture), 1e-5);
      EXPECT_NEAR(other.logLikelihood, host.logLikelihood, 1e-8 * std::abs(host.logLikelihood));
    }
  }
}

TEST(Mixture, ConstantSamplesKeepTheVarianceFloor)
{
  const MixtureFit fit = fitMixture(std::vector<double>(50, 0.25), {});
  ASSERT_EQ(fit.mixture.size(), 1u);
  EXPECT_DOUBLE_EQ(fit.mixture[0].mean, 0.25);
  EXPECT_DOUBLE_EQ(fit.mixture[0].variance, 1e-4);
  EXPECT_TRUE(std::isfinite(LogDensity(fit.mixture)(1.0)));
}

TEST(Mixture, NoSamplesIsAnError)
{
  EXPECT_THROW(fitMixture({}, {}), Error);
}

TEST(Mixture, DrawsAreDistinctFixedAndComplete)
{
  const std::vector<int> drawn = drawWithoutReplacement(10000, 2048, 1);
  EXPECT_EQ(drawn.size(), 2048u);
  EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
  EXPECT_EQ(std::set<int>(drawn.begin(), drawn.end()).size(), drawn.size());
  EXPECT_EQ(drawn, drawWithoutReplacement(10000, 2048, 1));
  EXPECT_NE(drawn, drawWithoutReplacement(10000, 2048, 2));
  EXPECT_NEAR(std::accumulate(drawn.begin(), drawn.end(), 0.0) / 2048.0, 4999.5, 250.0);
  EXPECT_EQ(drawWithoutReplacement(5, 2048, 1), (std::vector<int>{ 0, 1, 2, 3, 4 }));
}

TEST(Mixture, EvenItemsFollowTheWeights)
{
  // A tenth of the weight on the first of four, the others three tenths each.
  std::vector<double> weights;
  for (int k = 0; k < 1000; ++k)
  {
    weights.push_back(k % 4 == 0 ? 0.1 : 0.3);
  }
  const std::vector<int> items = evenItems(weights, 100);
  EXPECT_EQ(items.size(), 100u);
  EXPECT_TRUE(std::is_sorted(items.begin(), items.end()));
  // Each stands for a hundredth: of every ten items in their order, two and a half groups of four.
  for (int k = 0; k < 100; ++k)
  {
    EXPECT_NEAR(items[k], 10 * k + 5, 2);
  }
  EXPECT_EQ(evenItems({ 0.0, 1.0, 0.0, 3.0 }, 4), (std::vector<int>{ 1, 3, 3, 3 }));
  EXPECT_EQ(evenItems({ 0.0, 0.0, 0.0, 0.0 }, 2), (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(evenItems({ 2.0, 2.0 }, 2048), (std::vector<int>{ 0, 1 }));
  EXPECT_TRUE(evenItems({}, 10).empty());
}

TEST(Mixture, EvenSamplesDoNotDependOnTheOrder)
{
  EXPECT_EQ(evenSamples({ 3.0, 1.0, 2.0, 3.0 }, 2048), (std::vector<double>{ 1.0, 2.0, 3.0, 3.0 }));
  EXPECT_EQ(evenSamples({ 4.0, 1.0, 3.0, 2.0 }, 2), evenSamples({ 1.0, 2.0, 3.0, 4.0 }, 2));
  EXPECT_EQ(evenSamples({ 1.0, 2.0, 3.0, 4.0 }, 2), (std::vector<double>{ 1.0, 3.0 }));
  EXPECT_TRUE(evenSamples({}, 10).empty());
}
