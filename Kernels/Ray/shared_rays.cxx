#include "Ray/surface_rays.h"

#include <algorithm>
#include <mutex>

namespace oversketch
{

namespace
{

struct KnownRays
{
  std::mutex mutex;
  std::vector<std::weak_ptr<const SurfaceRays>> all; // the latest last

  // Those that somebody holds, the latest first.
  std::vector<std::shared_ptr<const SurfaceRays>> held()
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::vector<std::shared_ptr<const SurfaceRays>> found;
    for (auto one = this->all.rbegin(); one != this->all.rend(); ++one)
    {
      if (auto rays = one->lock())
      {
        found.push_back(std::move(rays));
      }
    }
    return found;
  }

  void add(const std::shared_ptr<const SurfaceRays>& rays)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->all.erase(
      std::remove_if(this->all.begin(), this->all.end(), [](const auto& one) { return one.expired(); }),
      this->all.end());
    this->all.push_back(rays);
  }
};

KnownRays& knownRays()
{
  static KnownRays known;
  return known;
}

} // namespace

std::shared_ptr<const SurfaceRays> sharedRays(const std::shared_ptr<const Mesh>& mesh, const Context& context)
{
  KnownRays& known = knownRays();
  const std::vector<std::shared_ptr<const SurfaceRays>> held = known.held();
  for (const auto& rays : held)
  {
    if (&rays->mesh() == mesh.get())
    {
      return rays;
    }
  }
  std::shared_ptr<const SurfaceRays> made;
  for (auto rays = held.begin(); rays != held.end() && !made; ++rays)
  {
    made = SurfaceRays::after(**rays, mesh, context);
  }
  if (!made)
  {
    made = std::make_shared<const SurfaceRays>(mesh, context);
  }
  known.add(made);
  return made;
}

} // namespace oversketch
