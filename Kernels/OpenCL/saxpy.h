// Sums that the tests compute on a device: (10, 20, 30, 40) + 2 (1, 2, 3, 4), in two groups of two.
// Header-only.
#ifndef oversketch_kernels_open_cl_saxpy_h
#define oversketch_kernels_open_cl_saxpy_h

#include "OpenCL/device.h"
#include "OpenCL/device_test_cl.h"

#include <vector>

namespace oversketch_test
{

struct Saxpy
{
  std::vector<float> sums{ 10, 20, 30, 40 };
  std::vector<int> groupSizes{ 0, 0, 0, 0 }; // as each work-item saw it
};

inline Saxpy runSaxpy(oversketch::Device& device)
{
  Saxpy result;
  device.guard(
    [&]
    {
      std::vector<float>& y = result.sums;
      const cl::Buffer xs = oversketch::toDevice(device, std::vector<float>{ 1, 2, 3, 4 });
      const cl::Buffer sizes = oversketch::onDevice<int>(device, y.size());
      const cl::Buffer ys(
        device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, y.size() * sizeof(float), y.data());
      cl::Kernel kernel(device.program("device_test", oversketch::device_test_cl), "saxpy");
      kernel.setArg(0, 2.0f);
      kernel.setArg(1, xs);
      kernel.setArg(2, ys);
      kernel.setArg(3, sizes);
      device.queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(4), cl::NDRange(2));
      device.queue().enqueueReadBuffer(ys, CL_TRUE, 0, y.size() * sizeof(float), y.data());
      device.queue().enqueueReadBuffer(
        sizes, CL_TRUE, 0, result.groupSizes.size() * sizeof(int), result.groupSizes.data());
    });
  return result;
}

} // namespace oversketch_test
#endif
