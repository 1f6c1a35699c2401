#include "Mixture/mixture.h"

#include "Mixture/mixture_cl.h"
#include "OpenCL/device.h"

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
  const std::string& definitions)
{
  const std::size_t components = std::size_t(std::clamp(options.components, 1, maximumMixtureComponents));
  const std::size_t rows = std::max<std::size_t>(3 * components + 1, 12); // values to one reduction
  cl::Kernel kernel;
  device.guard(
    [&]
    {
      kernel = cl::Kernel(
        device.program("mixture",
          mixture_cl,
          definitions + " -D MAXIMUM=" + std::to_string(components) + " -D WIDTH=" + std::to_string(width)),
        "greedyMixture");
      if (groupSize == 0)
      {
        groupSize = device.groupSize(kernel, 256, rows * sizeof(Real), sizeof(Real));
      }
    });
  const MixtureCandidates candidates = mixtureCandidates(samples, options);
  const std::size_t vectors = (samples.size() + width - 1) / width;
  std::vector<Real> input(samples.begin(), samples.end());
  input.resize(vectors * width, Real(samples.back()));
  for (std::size_t i = 0; i < width; ++i)
  {
    input.push_back(Real((vectors - 1) * width + i < samples.size() ? 1 : 0));
  }
  input.insert(input.end(), candidates.means.begin(), candidates.means.end());
  // A work-item alone has the local memory for itself: of a processor it is as large as its cache.
  const std::size_t shape = vectors * width * sizeof(Real), local = rows * groupSize * sizeof(Real);
  const std::size_t kept =
    groupSize == 1 ? std::min((device.info().localMemory - local) / shape, candidates.means.size()) : 0;
  std::vector<Real> result(3 * components + 3);
  device.guard(
    [&]
    {
      const cl::Buffer in = toDevice(device, input);
      const cl::Buffer density = onDevice<Real>(device, vectors * width);
      const cl::Buffer out = onDevice<Real>(device, result.size());
      cl_uint argument = 0;
      const auto set = [&](const auto& value) { kernel.setArg(argument++, value); };
      set(static_cast<cl_int>(samples.size()));
      set(static_cast<cl_int>(vectors));
      set(static_cast<cl_int>(candidates.means.size()));
      set(static_cast<cl_int>(kept));
      set(in);
      set(static_cast<Real>(candidates.variance));
      set(static_cast<Real>(options.varianceFloor));
      set(static_cast<cl_int>(options.maximumSteps));
      set(static_cast<Real>(options.tolerance * double(samples.size())));
      set(density);
      set(cl::Local(local));
      set(cl::Local(std::max(kept * shape, sizeof(Real)))); // of no bytes it would be refused
      set(out);
      const cl::NDRange items(groupSize);
      device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, items, items);
      device.queue().enqueueReadBuffer(out, CL_TRUE, 0, result.size() * sizeof(Real), result.data());
    });
  MixtureFit fit;
  const std::size_t used = std::size_t(result[3 * components + 1]);
  for (std::size_t k = 0; k < used; ++k)
  {
    fit.mixture.push_back({ result[3 * k], result[3 * k + 1], result[3 * k + 2] });
  }
  fit.logLikelihood = result[3 * components];
  fit.steps = int(result[3 * components + 2]);
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
  if (groupSize == 0 && device.info().cpu)
  {
    groupSize = 1;
  }
  const std::size_t width = groupSize == 1 ? 8 : 1;
  return device.info().fp64 && !singlePrecision
           ? fitWith<double>(
               device, samples, options, groupSize, width, "-D REAL=double -D USE_DOUBLE -D TINY=1.5e-154")
           : fitWith<float>(device, samples, options, groupSize, width, "-D REAL=float -D TINY=1.1e-19f");
}

} // namespace oversketch
