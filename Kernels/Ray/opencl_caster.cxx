#include "OpenCL/device.h"
#include "Ray/bvh.h"
#include "Ray/cast_rays_cl.h"
#include "Ray/ray_caster.h"

#include <algorithm>

namespace oversketch
{

namespace
{

class OpenCLCaster : public RayCaster
{
public:
  OpenCLCaster(const RayScene& scene, const std::shared_ptr<Device>& device, const Context& context)
    : device_(device)
  {
    const Bvh bvh = buildBvh(scene, context);
    static_assert(sizeof(Bvh::Node) == 8 * 4 * sizeof(float) && sizeof(Bvh::Pack) == 10 * 4 * sizeof(float),
      "the sizes that cast_rays.cl counts in");
    // Few different programs: depths are rounded up.
    const int stackSize = (bvh.stackSize + 31) / 32 * 32;
    device->guard(
      [&]
      {
        this->kernel_ =
          cl::Kernel(device->program("cast_rays", cast_rays_cl, "-D STACK_SIZE=" + std::to_string(stackSize)),
            "cast_rays");
        this->nodes_ = toDevice(*device, bvh.nodes);
        this->packs_ = toDevice(*device, bvh.packs);
        this->facets_ = toDevice(*device, scene.facets);
        this->points_ = toDevice(*device, scene.points);
        this->places_ = toDevice(*device, scene.places);
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
    this->distances_.resize(count);
    this->found_.resize(count);
    this->device_->guard(
      [&]
      {
        const cl::Buffer vertices = toDevice(*this->device_, rays.vertices);
        const cl::Buffer starts = toDevice(*this->device_, rays.starts);
        const cl::Buffer directions = toDevice(*this->device_, rays.directions);
        const cl::Buffer distances = onDevice<float>(*this->device_, count);
        const cl::Buffer found = onDevice<int>(*this->device_, count);
        int argument = 0;
        for (const cl::Buffer& buffer : { this->nodes_,
               this->packs_,
               this->facets_,
               this->points_,
               this->places_,
               vertices,
               starts,
               directions })
        {
          this->kernel_.setArg(argument++, buffer);
        }
        this->kernel_.setArg(argument++, rays.raysPerVertex);
        this->kernel_.setArg(argument++, static_cast<int>(count));
        this->kernel_.setArg(argument++, distances);
        this->kernel_.setArg(argument++, found);
        const std::size_t group = std::min<std::size_t>(64, this->device_->info().maxWorkGroupSize);
        const cl::CommandQueue& queue = this->device_->queue();
        queue.enqueueNDRangeKernel(
          this->kernel_, cl::NullRange, cl::NDRange((count + group - 1) / group * group), cl::NDRange(group));
        queue.enqueueReadBuffer(distances, CL_FALSE, 0, count * sizeof(float), this->distances_.data());
        queue.enqueueReadBuffer(found, CL_TRUE, 0, count * sizeof(int), this->found_.data());
      });
    for (std::size_t ray = 0; ray < count; ++ray)
    {
      hits[ray] = { this->distances_[ray], this->found_[ray] };
    }
  }

  bool threadSafe() const override { return false; }

private:
  std::shared_ptr<Device> device_;
  cl::Kernel kernel_;
  cl::Buffer nodes_, packs_, facets_, points_, places_;
  std::vector<float> distances_;
  std::vector<int> found_;
};

} // namespace

std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context)
{
  return std::make_unique<OpenCLCaster>(scene, device, context);
}

} // namespace oversketch
