#include "Ray/ray_caster.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstring>
#include <limits>

namespace oversketch
{

namespace
{

#if RTC_VERSION_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

// What the filter reads and writes for the ray in flight. Embree hands the context back, so its part comes
// first.
struct Query
{
  QueryContext context;
  const RayScene* scene;
  std::array<float, 3> direction;
  int place;
  RayHit best;
};

// Embree offers every hit not farther than the nearest one accepted so far, in an order that depends on its
// tree. Keeping the lowest id among equals makes the answer independent of that.
void keepNearestExit(const RTCFilterFunctionNArguments* arguments)
{
  Query& query = *reinterpret_cast<Query*>(arguments->context);
  const int triangle = static_cast<int>(RTCHitN_primID(arguments->hit, arguments->N, 0));
  const float distance = RTCRayN_tfar(arguments->ray, arguments->N, 0);
  if (!leavesThrough(*query.scene, triangle, query.place, query.direction, distance))
  {
    arguments->valid[0] = 0;
    return;
  }
  if (distance < query.best.distance || (distance == query.best.distance && triangle < query.best.triangle))
  {
    query.best = { distance, triangle };
  }
}

class EmbreeCaster : public RayCaster
{
public:
  explicit EmbreeCaster(const RayScene& scene)
    : scene_(scene)
    , device_(rtcNewDevice(nullptr))
  {
    if (!this->device_)
    {
      throw Error(Failure::Unexpected, "Embree could not be started on this processor.");
    }
    this->embree_ = rtcNewScene(this->device_);
    rtcSetSceneFlags(this->embree_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    static_assert(
      sizeof(Triangle) == 3 * sizeof(unsigned), "Embree reads triangles as three 32-bit integers");
    const auto fill =
      [&](RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count, const void* data)
    {
      void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count);
      if (!buffer)
      {
        rtcReleaseGeometry(geometry);
        this->release();
        throw std::bad_alloc();
      }
      std::memcpy(buffer, data, stride * count);
    };
    fill(
      RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 4 * sizeof(float), scene.points.size(), scene.points.data());
    fill(RTC_BUFFER_TYPE_INDEX,
      RTC_FORMAT_UINT3,
      sizeof(Triangle),
      scene.triangles.size(),
      scene.triangles.data());
    rtcSetGeometryIntersectFilterFunction(geometry, keepNearestExit);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->embree_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->embree_);
    const RTCError error = rtcGetDeviceError(this->device_);
    if (error != RTC_ERROR_NONE)
    {
      this->release();
      throw Error(Failure::Unexpected,
        "Embree could not take the mesh (error " + std::to_string(static_cast<int>(error)) + ").");
    }
  }

  ~EmbreeCaster() override { this->release(); }
  EmbreeCaster(const EmbreeCaster&) = delete;
  EmbreeCaster& operator=(const EmbreeCaster&) = delete;

  void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context& context) override
  {
    hits.resize(rays.directions.size());
    context.parallelFor(static_cast<int>(rays.vertices.size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end && !context.cancelled(); ++i)
        {
          const std::size_t first = static_cast<std::size_t>(i) * rays.raysPerVertex;
          for (std::size_t ray = first; ray < first + rays.raysPerVertex; ++ray)
          {
            hits[ray] = this->castOne(rays.vertices[i], rays.directions[ray]);
          }
        }
      });
  }

private:
  RayHit castOne(int origin, const std::array<float, 3>& direction) const
  {
    Query query;
    query.scene = &this->scene_;
    query.direction = direction;
    query.place = this->scene_.places[origin];
    query.best = { std::numeric_limits<float>::max(), -1 };
    RTCRayHit ray;
    const std::array<float, 4>& o = this->scene_.points[origin];
    ray.ray.org_x = o[0];
    ray.ray.org_y = o[1];
    ray.ray.org_z = o[2];
    ray.ray.tnear = nearestExit;
    ray.ray.dir_x = direction[0];
    ray.ray.dir_y = direction[1];
    ray.ray.dir_z = direction[2];
    ray.ray.time = 0.0f;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = static_cast<unsigned>(-1);
    ray.ray.id = 0;
    ray.ray.flags = 0;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.primID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcInitRayQueryContext(&query.context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &query.context;
    rtcIntersect1(this->embree_, &ray, &arguments);
#else
    rtcInitIntersectContext(&query.context);
    rtcIntersect1(this->embree_, &query.context, &ray);
#endif
    return query.best;
  }

  void release()
  {
    rtcReleaseScene(this->embree_);
    rtcReleaseDevice(this->device_);
  }

  const RayScene& scene_;
  RTCDevice device_;
  RTCScene embree_ = nullptr;
};

} // namespace

std::unique_ptr<RayCaster> makeEmbreeCaster(const RayScene& scene)
{
  return std::make_unique<EmbreeCaster>(scene);
}

} // namespace oversketch
