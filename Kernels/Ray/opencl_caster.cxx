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
    : ClDevice(device)
    , Tree(buildBvh(scene, context))
  {
    static_assert(sizeof(Bvh::Node) == 9 * 8 * sizeof(float) && sizeof(Bvh::Pack) == 10 * 8 * sizeof(float) &&
                    offsetof(Bvh::Node, child) == 48 * sizeof(float) &&
                    offsetof(Bvh::Node, normalLower) == 28 * 8 && sizeof(RayFacet) == 4 * 4 * sizeof(float) &&
                    offsetof(RayFacet, plane) == 3 * sizeof(double) &&
                    offsetof(RayFacet, offset) == 6 * sizeof(double) && sizeof(RayHit) == 2 * sizeof(float),
      "the sizes that cast_rays.cl counts in");
    // Few different programs: depths are rounded up. A node's children are written all at once.
    const int stackSize = (this->Tree.stackSize + Bvh::width + 31) / 32 * 32;
    device->guard(
      [&]
      {
        this->Kernel =
          cl::Kernel(device->program("cast_rays", cast_rays_cl, "-D STACK_SIZE=" + std::to_string(stackSize)),
            "cast_rays");
        this->Nodes = shared(*device, this->Tree.nodes);
        this->Packs = shared(*device, this->Tree.packs);
        this->Facets = shared(*device, scene.facets);
        this->Points = shared(*device, scene.points);
        this->Places = shared(*device, scene.places);
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
    this->ClDevice->guard(
      [&]
      {
        const cl::Buffer vertices = shared(*this->ClDevice, rays.vertices);
        const cl::Buffer directions = shared(*this->ClDevice, rays.directions);
        const cl::Buffer found(this->ClDevice->context(),
          CL_MEM_WRITE_ONLY | (this->ClDevice->info().cpu ? CL_MEM_USE_HOST_PTR : 0),
          count * sizeof(RayHit),
          this->ClDevice->info().cpu ? hits.data() : nullptr);
        int argument = 0;
        for (const cl::Buffer& buffer :
          { this->Nodes, this->Packs, this->Facets, this->Points, this->Places, vertices, directions })
        {
          this->Kernel.setArg(argument++, buffer);
        }
        this->Kernel.setArg(argument++, rays.raysPerVertex);
        this->Kernel.setArg(argument++, static_cast<int>(count));
        this->Kernel.setArg(argument++, found);
        const std::size_t group = this->ClDevice->groupSize(this->Kernel, 64);
        const cl::CommandQueue& queue = this->ClDevice->queue();
        queue.enqueueNDRangeKernel(
          this->Kernel, cl::NullRange, cl::NDRange((count + group - 1) / group * group), cl::NDRange(group));
        // Where the buffer is the vector itself this only waits.
        queue.enqueueReadBuffer(found, CL_TRUE, 0, count * sizeof(RayHit), hits.data());
      });
  }

  bool onHost() const override { return false; }

private:
  std::shared_ptr<Device> ClDevice;
  Bvh Tree;
  cl::Kernel Kernel;
  cl::Buffer Nodes, Packs, Facets, Points, Places;
};

} // namespace

std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context)
{
  return std::make_unique<OpenCLCaster>(scene, device, context);
}

} // namespace oversketch
