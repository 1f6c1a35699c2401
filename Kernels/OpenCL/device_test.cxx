#include "OpenCL/device.h"
#include "OpenCL/device_test_cl.h"
#include "OpenCL/saxpy.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

using namespace oversketch;
using namespace oversketch_test;

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
  const Saxpy result = runSaxpy(*device);
  EXPECT_EQ(result.sums, (std::vector<float>{ 12, 24, 36, 48 }));
  EXPECT_EQ(result.groupSizes, std::vector<int>(4, 2));
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
