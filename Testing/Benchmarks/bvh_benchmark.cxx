// The tree that the device's rays walk, beside the one that Embree builds at its default, medium, quality.
#include "Ray/bvh.h"
#include "benchmark_frame.h"
#include "embree_scene.h"

#include "vtkSMPTools.h"

#include <memory>

namespace oversketch_bench
{

namespace
{

void add(const std::string& size, const std::string& who, const std::function<void(const RayScene&)>& build)
{
  auto scene = std::make_shared<std::unique_ptr<RayScene>>();
  Job job;
  job.job = "BVH build";
  job.size = size;
  job.who = who;
  job.prepare = [=]
  {
    if (!*scene)
    {
      *scene = std::make_unique<RayScene>(model(size).mesh);
    }
  };
  job.run = [=] { build(**scene); };
  oversketch_bench::add(job);
}

} // namespace

void jobs()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    vtkSMPTools::For(0,
      count,
      [&body](vtkIdType begin, vtkIdType end) { body(static_cast<int>(begin), static_cast<int>(end)); });
  };
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    add(size, "ours", [=](const RayScene& scene) { buildBvh(scene, context); });
    add(size, "Embree", [](const RayScene& scene) { EmbreeScene(scene, RTC_BUILD_QUALITY_MEDIUM); });
  }
}

} // namespace oversketch_bench
