// Parts that the two users of Embree share: its header of either version, handles that let go, a ray. Not
// installed.
#ifndef oversketch_kernels_ray_embree_h
#define oversketch_kernels_ray_embree_h

#include "Mesh/context.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace oversketch::embree
{

#if RTC_VERSION_MAJOR >= 4
using Context = RTCRayQueryContext;
#else
using Context = RTCIntersectContext;
#endif

struct Release
{
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

inline Owned<RTCDevice> startDevice()
{
  Owned<RTCDevice> device(rtcNewDevice(nullptr));
  if (!device)
  {
    throw Error(Failure::Unexpected, "Embree could not be started on this processor.");
  }
  return device;
}

// After a scene was committed.
inline void checkTaken(RTCDevice device)
{
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
  {
    throw Error(Failure::Unexpected, "Embree could not take the mesh (error %1).", static_cast<int>(error));
  }
}

// The first hit from `start` to `end` along a ray; geomID is RTC_INVALID_GEOMETRY_ID where there is none.
// Filter and geometry functions are handed the context.
inline RTCRayHit trace(RTCScene scene,
  Context& context,
  const float* origin,
  const float* direction,
  float start,
  float end)
{
  RTCRayHit ray;
  ray.ray.org_x = origin[0];
  ray.ray.org_y = origin[1];
  ray.ray.org_z = origin[2];
  ray.ray.tnear = start;
  ray.ray.dir_x = direction[0];
  ray.ray.dir_y = direction[1];
  ray.ray.dir_z = direction[2];
  ray.ray.time = 0.0f;
  ray.ray.tfar = end;
  ray.ray.mask = static_cast<unsigned>(-1);
  ray.ray.id = 0;
  ray.ray.flags = 0;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.primID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &ray, &arguments);
#else
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
#endif
  return ray;
}

} // namespace oversketch::embree
#endif
