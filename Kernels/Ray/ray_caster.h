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

// The mesh as rays see it: single precision, moved and scaled so that it fills [-1, 1]. Precision then
// neither depends on the unit of length nor suffers far from the origin.
struct RayScene
{
  explicit RayScene(const Mesh& mesh);

  std::vector<std::array<float, 4>> points; // x y z and padding
  std::vector<std::array<float, 4>>
    normals;                       // of facets; zero for a degenerate triangle, which no ray can hit
  std::vector<int> places;         // per vertex the lowest vertex at the same place: seams are no gaps
  std::vector<Triangle> triangles; // of places
  double scale = 1.0;              // model length of one unit of the scene
};

// Rays in groups of equal size, each group with its own origin, a vertex of the mesh.
struct RayBatch
{
  int raysPerVertex = 0;
  std::vector<int> vertices;
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
inline bool leavesThrough(const RayScene& scene,
  int triangle,
  int place,
  const std::array<float, 3>& d,
  float distance)
{
  const std::array<float, 4>& n = scene.normals[triangle];
  const Triangle& t = scene.triangles[triangle];
  return n[0] * d[0] + n[1] * d[1] + n[2] * d[2] > 0.0f && distance > nearestExit && t[0] != place &&
         t[1] != place && t[2] != place;
}

class RayCaster
{
public:
  virtual ~RayCaster() = default;

  // The nearest facet through which each ray leaves: direction . facet normal > 0, and the facet does not
  // touch the origin. All other facets are passed through. Among facets at one distance the lowest id wins.
  // Hits come in the order of the rays. On a cancelled context the hits are incomplete.
  virtual void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context& context) = 0;
};

// The scene must live as long as the caster.
std::unique_ptr<RayCaster> makeEmbreeCaster(const RayScene& scene);
// Throws Error(Failure::NoDevice) when the device cannot do it; so does its cast().
std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context);

} // namespace oversketch
#endif
