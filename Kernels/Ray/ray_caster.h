// First exits of rays from a triangle mesh, on the host (Embree) or on an OpenCL device.
#ifndef oversketch_ray_caster_h
#define oversketch_ray_caster_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <memory>
#include <vector>

namespace oversketch
{

class Device;

// What is asked of a facet that a ray has met. One line of the processor's cache.
struct alignas(64) RayFacet
{
  std::array<float, 3> normal; // unit; zero for a degenerate triangle, which no ray can hit
  std::array<int, 3> places;   // of the corners
  Vector3 plane;               // normal . x = offset holds for the facet's points, before they were rounded
  double offset;
};

// The mesh as rays see it: single precision, moved and scaled so that it fills [-1, 1]. Precision then
// neither depends on the unit of length nor suffers far from the origin.
struct RayScene
{
  explicit RayScene(const Mesh& mesh, const Context& context = Context());

  // A point of the model in the scene, not rounded.
  Vector3 inScene(const Vector3& point) const { return (point - this->centre) / this->scale; }

  std::vector<std::array<float, 4>> points; // x y z and padding
  std::vector<int> order;                   // the vertices along a space-filling curve
  std::vector<int> places; // per vertex the lowest vertex at the same place: seams are no gaps
  std::vector<RayFacet> facets;
  Vector3 centre = Vector3::Zero();
  double scale = 1.0; // model length of one unit of the scene

private:
  void findPlaces();
};

// Rays in groups of equal size, each group with its own origin, a vertex of the mesh.
struct RayBatch
{
  int raysPerVertex = 0;
  std::vector<int> vertices;
  // Per vertex: its rays leave through no facet nearer than this [unit of the scene]. A caster need not use
  // it.
  std::vector<float> starts;
  std::vector<std::array<float, 3>> directions; // raysPerVertex per vertex
};

struct RayHit
{
  float distance; // in the unit of the scene, times the length of the direction
  int triangle;   // -1: none
};

// Hits nearer than this [unit of the scene] are where the ray starts on a facet that it only touches.
constexpr float nearestExit = 1e-6f;

// The predicate that both casters share: a ray may leave through this facet, and does not start at its
// corners. Decided in single precision with one order of operations, so that both decide alike.
inline bool leavesThrough(const RayFacet& facet, int place, const std::array<float, 3>& d, float distance)
{
  const std::array<float, 3>& n = facet.normal;
  return n[0] * d[0] + n[1] * d[1] + n[2] * d[2] > 0.0f && distance > nearestExit &&
         facet.places[0] != place && facet.places[1] != place && facet.places[2] != place;
}

class RayCaster
{
public:
  virtual ~RayCaster() = default;

  // The nearest facet through which each ray leaves: direction . facet normal > 0, and the facet does not
  // touch the origin. All other facets are passed through. Where rays meet an edge, the lowest id of
  // its facets wins; of facets that overlap in one plane Embree's tree may choose another than the device.
  // Hits come in the order of the rays. On a cancelled context the hits are incomplete.
  virtual void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context& context) = 0;

  // Whether several threads may call cast() at a time, and starts save time.
  virtual bool onHost() const = 0;
};

// The scene must live as long as the caster.
std::unique_ptr<RayCaster> makeEmbreeCaster(const RayScene& scene);
// Throws Error(Failure::NoDevice) when the device cannot do it; so does its cast().
std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context);

} // namespace oversketch
#endif
