// A plain Embree scene, as its manual shows one, to measure it.
#ifndef oversketch_testing_benchmarks_embree_scene_h
#define oversketch_testing_benchmarks_embree_scene_h

#include "Ray/ray_caster.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cstddef>
#include <limits>

namespace oversketch_bench
{

class EmbreeScene
{
public:
  EmbreeScene(const oversketch::RayScene& scene, RTCBuildQuality quality)
  {
    static RTCDevice device = rtcNewDevice("threads=2");
    this->Scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(this->Scene, quality);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_VERTEX,
      0,
      RTC_FORMAT_FLOAT3,
      scene.points.data(),
      0,
      sizeof(scene.points[0]),
      scene.points.size());
    rtcSetSharedGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_INDEX,
      0,
      RTC_FORMAT_UINT3,
      scene.facets.data(),
      offsetof(oversketch::RayFacet, places),
      sizeof(oversketch::RayFacet),
      scene.facets.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }
  ~EmbreeScene() { rtcReleaseScene(this->Scene); }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // To the first facet of any kind; infinite where there is none.
  float length(const std::array<float, 4>& origin, const std::array<float, 3>& direction) const
  {
    RTCRayHit ray;
    ray.ray.org_x = origin[0];
    ray.ray.org_y = origin[1];
    ray.ray.org_z = origin[2];
    ray.ray.tnear = oversketch::nearestExit;
    ray.ray.dir_x = direction[0];
    ray.ray.dir_y = direction[1];
    ray.ray.dir_z = direction[2];
    ray.ray.time = 0.0f;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = static_cast<unsigned>(-1);
    ray.ray.id = 0;
    ray.ray.flags = 0;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(this->Scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(this->Scene, &context, &ray);
#endif
    return ray.ray.tfar;
  }

private:
  RTCScene Scene;
};

} // namespace oversketch_bench
#endif
