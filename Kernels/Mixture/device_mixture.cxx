#include "Mixture/device_mixture.h"

#include "Mixture/mixture_cl.h"

#include <algorithm>

namespace oversketch
{

namespace
{

template <typename Real>
MixtureFit fitWith(Device& device,
  const std::vector<double>& samples,
  const MixtureOptions& options,
  std::size_t groupSize,
  std::size_t width,
  const char* definitions)
{
  MixtureFit fit;
  device.guard(
    [&]
    {
      const cl_int n = static_cast<cl_int>(samples.size());
      const MixtureCandidates candidates = mixtureCandidates(samples, options);
      const auto real = [](const std::vector<double>& values)
      { return std::vector<Real>(values.begin(), values.end()); };
      const std::size_t vectors = (samples.size() + width - 1) / width;
      std::vector<Real> padded = real(samples), inside(samples.size(), Real(1));
      padded.resize(vectors * width, padded.back());
      inside.resize(vectors * width, Real(0));
      const cl::Buffer x = toDevice(device, padded);
      const cl::Buffer one = toDevice(device, inside);
      const cl::Buffer means = toDevice(device, real(candidates.means));
      const cl::Buffer density = onDevice<Real>(device, vectors * width);
      const cl::Buffer shares = onDevice<Real>(device, vectors * width * maximumMixtureComponents);
      const cl::Buffer result = onDevice<Real>(device, 3 * maximumMixtureComponents + 1);
      const cl::Buffer counts = onDevice<cl_int>(device, 2);
      cl::Kernel kernel(device.program("mixture",
                          mixture_cl,
                          std::string(definitions) + " -D MAXIMUM=" +
                            std::to_string(maximumMixtureComponents) + " -D WIDTH=" + std::to_string(width)),
        "greedyMixture");
      cl_uint argument = 0;
      const auto set = [&](const auto& value) { kernel.setArg(argument++, value); };
      set(n);
      set(static_cast<cl_int>(vectors));
      set(x);
      set(one);
      set(static_cast<cl_int>(candidates.means.size()));
      set(means);
      set(static_cast<Real>(candidates.variance));
      set(static_cast<cl_int>(options.components));
      set(static_cast<Real>(options.varianceFloor));
      set(static_cast<cl_int>(options.maximumSteps));
      set(static_cast<Real>(options.tolerance * double(n)));
      set(density);
      set(shares);
      set(cl::Local(3 * groupSize * sizeof(Real)));
      set(result);
      set(counts);
      const cl::NDRange items(groupSize);
      device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, items, items);
      std::vector<Real> values(3 * maximumMixtureComponents + 1);
      cl_int sizes[2] = { 0, 0 };
      device.queue().enqueueReadBuffer(result, CL_TRUE, 0, values.size() * sizeof(Real), values.data());
      device.queue().enqueueReadBuffer(counts, CL_TRUE, 0, sizeof(sizes), sizes);
      for (cl_int k = 0; k < sizes[0]; ++k)
      {
        fit.mixture.push_back({ values[3 * k], values[3 * k + 1], values[3 * k + 2] });
      }
      fit.logLikelihood = values.back();
      fit.steps = sizes[1];
    });
  return fit;
}

} // namespace

MixtureFit fitMixtureOnDevice(Device& device,
  const std::vector<double>& samples,
  const MixtureOptions& options,
  std::size_t groupSize,
  bool singlePrecision)
{
  if (samples.empty())
  {
    throw Error(Failure::BadRegion, "There are no samples to fit a Gaussian mixture to.");
  }
  if (groupSize == 0)
  {
    groupSize = device.info().cpu ? 1 : std::min<std::size_t>(1024, device.info().maxWorkGroupSize);
  }
  const std::size_t width = groupSize == 1 ? 8 : 1;
  return device.info().fp64 && !singlePrecision
           ? fitWith<double>(
               device, samples, options, groupSize, width, "-D REAL=double -D USE_DOUBLE -D TINY=DBL_MIN")
           : fitWith<float>(device, samples, options, groupSize, width, "-D REAL=float -D TINY=FLT_MIN");
}

} // namespace oversketch
