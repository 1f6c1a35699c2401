// The OpenCL device that kernels run on, and the programs built for it. One device per process.
#ifndef oversketch_kernels_open_cl_device_h
#define oversketch_kernels_open_cl_device_h

#include "Mesh/context.h"

// Version 1.2 of the C++ binding, with exceptions.
#define CL_TARGET_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace oversketch
{

struct DeviceInfo
{
  std::string platform; // e.g. "Portable Computing Language"
  std::string device;
  std::string version; // of OpenCL, as the device tells it
  std::size_t maxWorkGroupSize = 0;
  std::size_t localMemory = 0; // bytes
  bool fp64 = false;           // double precision in kernels
  bool cpu = false;            // the device is the host's own processor
};

class Device
{
public:
  // The process's device: the first GPU of all platforms, else the first accelerator, else the first CPU;
  // null where OpenCL has none. Null as well while the environment variable OVERSKETCH_OPENCL is "off", which
  // is how a machine without a device is tried out; it is read at each call. Thread-safe.
  static std::shared_ptr<Device> instance();

  // The device for the wanted backend; null for Host. Null too where there is no device: then `warning` says
  // so.
  static std::shared_ptr<Device> choose(Backend wanted, Message& warning);

  const DeviceInfo& info() const { return this->Info; }
  const cl::Context& context() const { return this->Context; }
  // In order, safe to enqueue to from several threads; buffers and cl::Kernel objects are the caller's own.
  const cl::CommandQueue& queue() const { return this->Queue; }

  // The program built from OpenCL C 1.2 source, once per process and pair of name and options. The source is
  // what oversketch_embed_cl() made of a .cl file; options are of the kind "-D NAME=value". Correctly rounded
  // divisions and roots are asked for where the device has them; unsafe mathematics never is. Keeping them
  // for the next process is left to the driver. Thread-safe. Throws Error(NoDevice) with the compiler's log.
  cl::Program program(const std::string& name, const std::string& source, const std::string& options = "");

  // The largest work-group, `most` at most, that this device runs the kernel with: registers bound it beside
  // the device's own limit, and local memory, of which each work-item needs `each` bytes and the group
  // `beside` more. Whole rows of the processor's lanes where it is more than one. Throws cl::Error.
  std::size_t groupSize(const cl::Kernel& kernel,
    std::size_t most,
    std::size_t each = 0,
    std::size_t beside = 0) const;

  // Runs body and turns a cl::Error into Error(Failure::NoDevice), so that the caller can go on with the
  // host.
  template <typename Body>
  void guard(const Body& body) const
  {
    try
    {
      body();
    }
    catch (const cl::Error& error)
    {
      throw Error(Failure::NoDevice, this->describe(error.what(), error.err()));
    }
  }

private:
  explicit Device(const cl::Device& device);
  static std::shared_ptr<Device> find();
  std::string describe(const char* call, int code) const;

  cl::Device ClDevice;
  cl::Context Context;
  cl::CommandQueue Queue;
  DeviceInfo Info;
  std::string Options;
  std::mutex Mutex;
  std::map<std::string, cl::Program> Programs;
};

// A read-only buffer with a copy of the values. OpenCL has no empty buffers: an empty vector gives one unused
// element.
template <typename T>
cl::Buffer toDevice(const Device& device, const std::vector<T>& values)
{
  if (values.empty())
  {
    return cl::Buffer(device.context(), CL_MEM_READ_ONLY, sizeof(T));
  }
  // The flag promises that the host memory is copied, so the cast away from const writes nothing.
  return cl::Buffer(device.context(),
    CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
    values.size() * sizeof(T),
    const_cast<T*>(values.data()));
}

// A writable buffer of `count` elements, not initialised.
template <typename T>
cl::Buffer onDevice(const Device& device, std::size_t count)
{
  return cl::Buffer(device.context(), CL_MEM_READ_WRITE, (count == 0 ? 1 : count) * sizeof(T));
}

} // namespace oversketch
#endif
