#include "OpenCL/device.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace oversketch
{

Device::Device(const cl::Device& device)
  : ClDevice(device)
  , Context(device)
  , Queue(this->Context, device)
{
  const auto text = [](std::string value)
  {
    value.resize(std::strlen(value.c_str())); // some drivers count the terminating zero
    return value;
  };
  this->Info.platform = text(cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>());
  this->Info.device = text(device.getInfo<CL_DEVICE_NAME>());
  this->Info.version = text(device.getInfo<CL_DEVICE_VERSION>());
  this->Info.maxWorkGroupSize = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
  this->Info.localMemory = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
  this->Info.fp64 = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
  this->Info.cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
  this->Options = "-cl-std=CL1.2";
  if (device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT)
  {
    this->Options += " -cl-fp32-correctly-rounded-divide-sqrt";
  }
}

std::shared_ptr<Device> Device::find()
{
  try
  {
    std::vector<cl::Platform> platforms;
    cl::Platform::get(&platforms);
    for (const cl_device_type type : { CL_DEVICE_TYPE_GPU, CL_DEVICE_TYPE_ACCELERATOR, CL_DEVICE_TYPE_CPU })
    {
      for (const cl::Platform& platform : platforms)
      {
        std::vector<cl::Device> devices;
        try
        {
          platform.getDevices(type, &devices);
        }
        catch (const cl::Error&)
        {
          // A platform without a device of this type; another one may have it.
        }
        for (const cl::Device& device : devices)
        {
          if (device.getInfo<CL_DEVICE_AVAILABLE>() && device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>() &&
              device.getInfo<CL_DEVICE_ENDIAN_LITTLE>())
          {
            return std::shared_ptr<Device>(new Device(device));
          }
        }
      }
    }
  }
  catch (const cl::Error&)
  {
    // No platform at all, or one that cannot make a context: as good as no device.
  }
  return nullptr;
}

std::shared_ptr<Device> Device::instance()
{
  const char* off = std::getenv("OVERSKETCH_OPENCL");
  if (off && std::strcmp(off, "off") == 0)
  {
    return nullptr;
  }
  // Never released: drivers unload before static objects are destroyed, and would then be called.
  static const auto* device = new std::shared_ptr<Device>(Device::find());
  return *device;
}

std::shared_ptr<Device> Device::choose(Backend wanted, Message& warning)
{
  warning = {};
  if (wanted == Backend::Host)
  {
    return nullptr;
  }
  std::shared_ptr<Device> device = Device::instance();
  if (!device)
  {
    warning = noDeviceText;
  }
  return device;
}

cl::Program Device::program(const std::string& name, const std::string& source, const std::string& options)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const std::string key = name + ' ' + options;
  const auto known = this->Programs.find(key);
  if (known != this->Programs.end())
  {
    return known->second;
  }
  cl::Program program;
  try
  {
    program = cl::Program(this->Context, source);
    program.build({ this->ClDevice }, (this->Options + ' ' + options).c_str());
  }
  catch (const cl::BuildError& error)
  {
    std::string log;
    for (const auto& entry : error.getBuildLog())
    {
      log += entry.second;
    }
    throw Error(
      Failure::NoDevice, this->describe(("building program " + name).c_str(), error.err()) + '\n' + log);
  }
  catch (const cl::Error& error)
  {
    throw Error(Failure::NoDevice, this->describe(error.what(), error.err()));
  }
  this->Programs.emplace(key, program);
  return program;
}

std::size_t Device::groupSize(const cl::Kernel& kernel,
  std::size_t most,
  std::size_t each,
  std::size_t beside) const
{
  std::size_t size = std::min({ most,
    this->Info.maxWorkGroupSize,
    kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(this->ClDevice) });
  if (each > 0)
  {
    beside += kernel.getWorkGroupInfo<CL_KERNEL_LOCAL_MEM_SIZE>(this->ClDevice);
    size = std::min(size, (this->Info.localMemory - std::min(beside, this->Info.localMemory)) / each);
  }
  const std::size_t lanes =
    kernel.getWorkGroupInfo<CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE>(this->ClDevice);
  return std::max<std::size_t>(size > lanes ? size - size % lanes : size, 1);
}

std::string Device::describe(const char* call, int code) const
{
  return "OpenCL device " + this->Info.device + " failed: " + call + " gave error " + std::to_string(code) +
         '.';
}

} // namespace oversketch
