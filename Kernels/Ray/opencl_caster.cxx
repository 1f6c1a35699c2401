#include "OpenCL/device.h"
#include "Ray/bvh.h"
#include "Ray/cast_rays_cl.h"
#include "Ray/ray_caster.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// A read-only buffer of values that outlive it: on the host's own processor the values themselves, else a
// copy.
template <typename T>
cl::Buffer shared(const Device& device, const std::vector<T>& values)
{
  if (!device.info().cpu || values.empty())
  {
    return toDevice(device, values);
  }
  // The device only reads, so the cast away from const writes nothing.
  return cl::Buffer(device.context(),
    CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR,
    values.size() * sizeof(T),
    const_cast<T*>(values.data()));
}

class OpenCLCaster : public RayCaster
{
public:
  OpenCLCaster(const RayScene& scene, const std::shared_ptr<Device>& device, const Context& context)
    : device_(device)
    , bvh_(buildBvh(scene, context))
  {
    static_assert(sizeof(Bvh::Node) == 9 * 8 * sizeof(float) && sizeof(Bvh::Pack) == 10 * 8 * sizeof(float) &&
                    offsetof(Bvh::Node, child) == 48 * sizeof(float) &&
                    offsetof(Bvh::Node, normalLower) == 28 * 8 && sizeof(RayFacet) == 4 * 4 * sizeof(float) &&
                    offsetof(RayFacet, plane) == 3 * sizeof(double) &&
                    offsetof(RayFacet, offset) == 6 * sizeof(double) && sizeof(RayHit) == 2 * sizeof(float),
      "the sizes that cast_rays.cl counts in");
    // Few different programs: depths are rounded up. A node's children are written all at once.
    const int stackSize = (this->bvh_.stackSize + Bvh::width + 31) / 32 * 32;
    device->guard(
      [&]
      {
        this->kernel_ =
          cl::Kernel(device->program("cast_rays", cast_rays_cl, "-D STACK_SIZE=" + std::to_string(stackSize)),
            "cast_rays");
        this->nodes_ = shared(*device, this->bvh_.nodes);
        this->packs_ = shared(*device, this->bvh_.packs);
        this->facets_ = shared(*device, scene.facets);
        this->points_ = shared(*device, scene.points);
        this->places_ = shared(*device, scene.places);
      });
  }

  void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context&) override
  {
    const std::size_t count = rays.directions.size();
    hits.resize(count);
    if (count == 0)
    {
      return;
    }
    this->device_->guard(
      [&]
      {
        const cl::Buffer vertices = shared(*this->device_, rays.vertices);
        const cl::Buffer directions = shared(*this->device_, rays.directions);
        const cl::Buffer found(this->device_->context(),
          CL_MEM_WRITE_ONLY | (this->device_->info().cpu ? CL_MEM_USE_HOST_PTR : 0),
          count * sizeof(RayHit),
          this->device_->info().cpu ? hits.data() : nullptr);
        int argument = 0;
        for (const cl::Buffer& buffer :
          { this->nodes_, this->packs_, this->facets_, this->points_, this->places_, vertices, directions })
        {
          this->kernel_.setArg(argument++, buffer);
        }
        this->kernel_.setArg(argument++, rays.raysPerVertex);
        this->kernel_.setArg(argument++, static_cast<int>(count));
        this->kernel_.setArg(argument++, found);
        const std::size_t group = std::min<std::size_t>(64, this->device_->info().maxWorkGroupSize);
        const cl::CommandQueue& queue = this->device_->queue();
        queue.enqueueNDRangeKernel(
          this->kernel_, cl::NullRange, cl::NDRange((count + group - 1) / group * group), cl::NDRange(group));
        // Where the buffer is the vector itself this only waits.
        queue.enqueueReadBuffer(found, CL_TRUE, 0, count * sizeof(RayHit), hits.data());
      });
  }

  bool onHost() const override { return false; }

private:
  std::shared_ptr<Device> device_;
  Bvh bvh_;
  cl::Kernel kernel_;
  cl::Buffer nodes_, packs_, facets_, points_, places_;
};

} // namespace

std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context)
{
  return std::make_unique<OpenCLCaster>(scene, device, context);
}

} // namespace oversketch
