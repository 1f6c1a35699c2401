// First exits of rays from a triangle mesh, on the host (Embree) or on an OpenCL device.
#ifndef oversketch_kernels_ray_ray_caster_h
#define oversketch_kernels_ray_ray_caster_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace oversketch
{

class Device;

// A facet as it is asked when a ray has met it. One line of the processor's cache.
struct alignas(64) RayFacet
{
  std::array<float, 3> normal; // unit; zero for a degenerate triangle, which no ray can hit
  std::array<int, 3> places;   // of the corners
  Vector3 plane;               // normal . x = offset holds for the facet's points, before they were rounded
  double offset;

  // Nothing is written; see Bvh::Pack.
  RayFacet() {} // "= default" would fill in zeros
};

// How a mesh is moved and scaled so that it lies within [-1, 1] and is at least 0.88 long. Precision then
// neither depends on the unit of length nor suffers far from the origin. The scale is a power of two and the
// centre the roundest place that will do, mostly the origin: a mesh that changes a little keeps its frame,
// and what did not change is then rounded as before.
struct RayFrame
{
  explicit RayFrame(const Mesh& mesh);
  bool operator==(const RayFrame& other) const
  {
    return this->centre == other.centre && this->scale == other.scale;
  }

  // A point of the model in the scene, not rounded.
  Vector3 inScene(const Vector3& point) const { return (point - this->centre) / this->scale; }

  Vector3 centre = Vector3::Zero();
  double scale = 1.0; // model length of one unit of the scene
};

// The mesh as rays see it, in single precision.
struct RayScene
{
  explicit RayScene(const Mesh& mesh, const Context& context = Context())
    : RayScene(mesh, RayFrame(mesh), context)
  {
  }
  RayScene(const Mesh& mesh, const RayFrame& within, const Context& context);

  std::vector<std::array<float, 4>> points; // x y z and padding
  std::vector<int> order;                   // the vertices along a space-filling curve
  std::vector<int> places; // per vertex the lowest vertex at the same place: seams are no gaps
  std::vector<RayFacet> facets;
  RayFrame frame;

private:
  void findPlaces(const std::vector<std::uint32_t>& cells);
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
inline bool leavesThrough(const RayFacet& facet, int place, const std::array<float, 3>& d, float distance)
{
  const std::array<float, 3>& n = facet.normal;
  return n[0] * d[0] + n[1] * d[1] + n[2] * d[2] > 0.0f && distance > nearestExit &&
         facet.places[0] != place && facet.places[1] != place && facet.places[2] != place;
}

// Tells which of two facets that a ray meets at the same distance is hit. The order depends on the
// facets alone, not on their numbers or on a caster's tree. Facets of one plane that are equal in it lead to
// the same length. Shared by both casters.
inline bool comesBefore(const RayFacet& a, const RayFacet& b)
{
  std::uint64_t bits[2][4];
  const RayFacet* facets[2] = { &a, &b };
  for (int i = 0; i < 2; ++i)
  {
    std::memcpy(bits[i], facets[i]->plane.data(), 3 * sizeof(double));
    std::memcpy(bits[i] + 3, &facets[i]->offset, sizeof(double));
  }
  for (int k = 0; k < 4; ++k)
  {
    if (bits[0][k] != bits[1][k])
    {
      return bits[0][k] < bits[1][k];
    }
  }
  return &a < &b;
}

class RayCaster
{
public:
  virtual ~RayCaster() = default;

  // The nearest facet through which each ray leaves: direction . facet normal > 0, and the facet does not
  // touch the origin. All other facets are passed through; of several at one distance comesBefore() decides.
  // Hits come in the order of the rays. On a cancelled context the hits are incomplete.
  virtual void cast(const RayBatch& rays, std::vector<RayHit>& hits, const Context& context) = 0;

  // Whether several threads may call cast() at a time.
  virtual bool onHost() const = 0;
};

// The scene must live as long as the caster.
std::unique_ptr<RayCaster> makeEmbreeCaster(const RayScene& scene);
// Throws Error(Failure::NoDevice) when the device cannot do it; so does its cast().
std::unique_ptr<RayCaster> makeOpenCLCaster(const RayScene& scene,
  const std::shared_ptr<Device>& device,
  const Context& context);

// Points within [-1, 1] along a Hilbert curve through 1024^3 cells.
struct CurveOrder
{
  std::vector<int> indices;         // ascending within a cell
  std::vector<std::uint32_t> cells; // of each of them where the curve reaches its cell: the same in one cell
};
CurveOrder curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context);

} // namespace oversketch
#endif
