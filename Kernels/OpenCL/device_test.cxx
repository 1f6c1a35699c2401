#include "OpenCL/device.h"
#include "OpenCL/device_test_cl.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

using namespace oversketch;
TEST(Device, RunsAnEmbeddedProgram)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  EXPECT_FALSE(device->info().platform.empty());
  EXPECT_FALSE(device->info().device.empty());
  EXPECT_GE(device->info().maxWorkGroupSize, 1u);
  std::vector<float> sums{ 10, 20, 30, 40 };
  std::vector<int> groupSizes(4); // as each work-item saw it
  device->guard(
    [&]
    {
      const cl::Buffer xs = toDevice(*device, std::vector<float>{ 1, 2, 3, 4 });
      const cl::Buffer sizes = onDevice<int>(*device, 4);
      const cl::Buffer ys(
        device->context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, 4 * sizeof(float), sums.data());
      cl::Kernel kernel(device->program("device_test", device_test_cl), "saxpy");
      kernel.setArg(0, 2.0f);
      kernel.setArg(1, xs);
      kernel.setArg(2, ys);
      kernel.setArg(3, sizes);
      device->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(4), cl::NDRange(2));
      device->queue().enqueueReadBuffer(ys, CL_TRUE, 0, 4 * sizeof(float), sums.data());
      device->queue().enqueueReadBuffer(sizes, CL_TRUE, 0, 4 * sizeof(int), groupSizes.data());
    });
  EXPECT_EQ(sums, (std::vector<float>{ 12, 24, 36, 48 }));
  EXPECT_EQ(groupSizes, std::vector<int>(4, 2));
}

// A group that fills a device's local memory to the last byte, or its registers, is refused by it: error -5.
TEST(Device, GroupsKeepWithinWhatTheDeviceHas)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  const cl::Kernel kernel(device->program("device_test", device_test_cl), "saxpy");
  const std::size_t memory = device->info().localMemory;
  EXPECT_EQ(device->groupSize(kernel, 1), 1u);
  EXPECT_LE(device->groupSize(kernel, 1u << 20), device->info().maxWorkGroupSize);
  EXPECT_LE(device->groupSize(kernel, 64, memory / 4), 4u);
  EXPECT_LE(device->groupSize(kernel, 64, memory / 4, 1), 3u);
  EXPECT_EQ(device->groupSize(kernel, 64, memory, memory), 1u);
}

TEST(Device, BuildsAProgramOnceAlsoFromSeveralThreads)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  std::vector<cl_program> built(4);
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back([&, i] { built[i] = device->program("device_test", device_test_cl)(); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(built, std::vector<cl_program>(4, built[0]));
  EXPECT_NE(device->program("device_test", device_test_cl, "-D OTHER=1")(), built[0]);
}

TEST(Device, ABrokenProgramIsOneErrorWithTheLog)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  for (int attempt = 0; attempt < 2; ++attempt) // and it is not remembered as built
  {
    try
    {
      device->program("broken", "kernel void f() { no_such_function_here(1); }");
      FAIL() << "a broken program was built";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), Failure::NoDevice);
      EXPECT_NE(std::string(error.what()).find("broken"), std::string::npos);
    }
  }
}

TEST(Device, AFailedCallIsAnError)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  EXPECT_THROW(
    device->guard([&] { cl::Kernel(device->program("device_test", device_test_cl), "no_such_kernel"); }),
    Error);
}

TEST(Device, CanBeSwitchedOff)
{
  Message warning;
  EXPECT_EQ(Device::choose(Backend::Host, warning), nullptr);
  EXPECT_TRUE(warning.empty());
  setenv("OVERSKETCH_OPENCL", "off", 1);
  EXPECT_EQ(Device::instance(), nullptr);
  for (const Backend wanted : { Backend::Auto, Backend::OpenCL })
  {
    EXPECT_EQ(Device::choose(wanted, warning), nullptr);
    EXPECT_EQ(warning.text(), "There is no OpenCL device; the host computes instead.");
  }
  unsetenv("OVERSKETCH_OPENCL");
  EXPECT_EQ(Device::choose(Backend::Auto, warning), Device::instance());
}
