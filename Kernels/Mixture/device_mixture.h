// The greedy Gaussian mixture on the OpenCL device.
#ifndef oversketch_kernels_mixture_device_mixture_h
#define oversketch_kernels_mixture_device_mixture_h

#include "Mixture/mixture.h"
#include "OpenCL/device.h"

namespace oversketch
{

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
