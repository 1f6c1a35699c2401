// One process that needs one program: prints how many it compiled, then what the program computed. For the
// tests.
#include "OpenCL/device.h"
#include "OpenCL/device_test_cl.h"

#include <cstdio>
#include <exception>

using namespace oversketch;

int main()
try
{
  const auto device = Device::instance();
  if (!device)
  {
    return 1;
  }
  std::vector<float> y{ 10, 20, 30, 40 };
  device->guard(
    [&]
    {
      const cl::Buffer xs = toDevice(*device, std::vector<float>{ 1, 2, 3, 4 });
      const cl::Buffer sizes = onDevice<int>(*device, y.size());
      const cl::Buffer ys(
        device->context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, y.size() * sizeof(float), y.data());
      cl::Kernel kernel(device->program("device_test", device_test_cl), "saxpy");
      kernel.setArg(0, 2.0f);
      kernel.setArg(1, xs);
      kernel.setArg(2, ys);
      kernel.setArg(3, sizes);
      device->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(4), cl::NDRange(2));
      device->queue().enqueueReadBuffer(ys, CL_TRUE, 0, y.size() * sizeof(float), y.data());
    });
  std::printf("%d: %g %g %g %g\n", device->compilations(), y[0], y[1], y[2], y[3]);
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
