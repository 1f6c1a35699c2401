#include "Ray/embree.h"
#include "Ray/ray_caster.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace oversketch
{

namespace
{

// State that the filter reads and writes for the ray in flight. Embree hands the context back, so its part
// comes first.
struct Query
{
  embree::Context context;
  const RayFacet* facets = nullptr; // null: any hit will do
  std::array<float, 3> direction;
  int place;
  bool keepsOn; // hits do not shorten the ray
  bool tied;    // any hit: the last two were equally near
  RayHit best;
};

// Embree offers every hit not farther than the nearest one accepted so far, in an order that depends on its
// tree. Choosing among equals makes the answer independent of that.
void keepNearestExit(const RTCFilterFunctionNArguments* arguments)
{
  Query& query = *reinterpret_cast<Query*>(arguments->context);
  const float distance = RTCRayN_tfar(arguments->ray, arguments->N, 0);
  if (!query.facets)
  {
    query.tied = distance == query.best.distance;
    query.best.distance = distance;
    return;
  }
  const int triangle = static_cast<int>(RTCHitN_primID(arguments->hit, arguments->N, 0));
  if (!leavesThrough(query.facets[triangle], query.place, query.direction, distance))
  {
    arguments->valid[0] = 0;
    return;
  }
  if (query.keepsOn)
  {
    arguments->valid[0] = 0;
  }
  if (distance < query.best.distance ||
      (distance == query.best.distance &&
        comesBefore(query.facets[triangle], query.facets[query.best.triangle])))
  {
    query.best = { distance, triangle };
  }
}

// Within rounding of an edge, where a neighbour may be hit nearly at the same distance.
bool atEdge(const RTCHit& hit)
{
  return hit.u <= 1e-6f || hit.v <= 1e-6f || hit.u + hit.v >= 1.0f - 1e-6f;
}

class EmbreeCaster final : public RayCaster
{
public:
  explicit EmbreeCaster(const RayScene& scene)
    : Scene(scene)
    , Device(embree::startDevice())
    , Embree(rtcNewScene(this->Device.get()))
  {
    rtcSetSceneFlags(this->Embree.get(), RTC_SCENE_FLAG_ROBUST);
    const embree::Owned<RTCGeometry> geometry(rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    rtcSetSharedGeometryBuffer(geometry.get(),
      RTC_BUFFER_TYPE_VERTEX,
      0,
      RTC_FORMAT_FLOAT3,
      scene.points.data(),
      0,
      sizeof(scene.points[0]),
      scene.points.size());
    rtcSetSharedGeometryBuffer(geometry.get(),
      RTC_BUFFER_TYPE_INDEX,
      0,
      RTC_FORMAT_UINT3,
      scene.facets.data(),
      offsetof(RayFacet, places),
      sizeof(RayFacet),
      scene.facets.size());
    rtcSetGeometryIntersectFilterFunction(geometry.get(), keepNearestExit);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(this->Embree.get(), geometry.get());
    rtcCommitScene(this->Embree.get());
    embree::checkTaken(this->Device.get());
  }

  void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context& context) override
  {
    hits.resize(rays.directions.size());
    context.parallelFor(static_cast<int>(rays.vertices.size()),
      [&](int begin, int end)
      {
        std::vector<char> doubtful(rays.raysPerVertex);
        for (int i = begin; i < end && !context.cancelled(); ++i)
        {
          const std::size_t first = static_cast<std::size_t>(i) * rays.raysPerVertex;
          const std::array<float, 3>* directions = rays.directions.data() + first;
          RayHit* found = hits.data() + first;
          Query query;
          query.place = this->Scene.places[rays.vertices[i]];
          query.keepsOn = false;
          // Nearly always the first facet that is hit is the one.
          for (int k = 0; k < rays.raysPerVertex; ++k)
          {
            const RTCRayHit ray = this->trace(query, rays.vertices[i], directions[k]);
            doubtful[k] = query.tied || atEdge(ray.hit);
            found[k] = { std::numeric_limits<float>::max(), -1 };
            if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID)
            {
              found[k] = { ray.ray.tfar, static_cast<int>(ray.hit.primID) };
              __builtin_prefetch(&this->Scene.facets[found[k].triangle]);
            }
          }
          query.facets = this->Scene.facets.data();
          for (int k = 0; k < rays.raysPerVertex; ++k)
          {
            if (found[k].triangle >= 0 &&
                (doubtful[k] ||
                  !leavesThrough(
                    query.facets[found[k].triangle], query.place, directions[k], found[k].distance)))
            {
              query.direction = directions[k];
              this->trace(query, rays.vertices[i], directions[k]);
              found[k] = query.best;
              if (found[k].triangle >= 0)
              {
                // Once more without shortening: nodes whose bounds the rounded distances of two neighbours
                // lie apart from are then entered in any tree.
                query.keepsOn = true;
                this->trace(query, rays.vertices[i], directions[k], 1.0001f * found[k].distance);
                query.keepsOn = false;
                found[k] = query.best;
              }
            }
          }
        }
      });
  }

  bool onHost() const override { return true; }

private:
  RTCRayHit trace(Query& query,
    int vertex,
    const std::array<float, 3>& direction,
    float end = std::numeric_limits<float>::infinity()) const
  {
    query.best = { std::numeric_limits<float>::max(), -1 };
    query.tied = false;
    return embree::trace(this->Embree.get(),
      query.context,
      this->Scene.points[vertex].data(),
      direction.data(),
      nearestExit,
      end);
  }

  const RayScene& Scene;
  embree::Owned<RTCDevice> Device;
  embree::Owned<RTCScene> Embree;
};

} // namespace

std::unique_ptr<RayCaster> makeEmbreeCaster(const RayScene& scene)
{
  return std::make_unique<EmbreeCaster>(scene);
}

} // namespace oversketch
