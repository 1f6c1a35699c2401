// A mesh that is asked where a ray meets it first, where a line meets it at all, and which of its places is
// nearest to a point.
//
// Embree's tree, over boxes of the facets, finds the candidates in single precision; each is decided in
// double precision, on the facet's own plane. Departure: Embree's own triangle test is not used, since the
// facet that it takes near an edge may be the neighbour of the one that the ray meets, and recomputing the
// hit there would leave the ray or the facet.
#ifndef oversketch_kernels_ray_surface_rays_h
#define oversketch_kernels_ray_surface_rays_h

#include "Mesh/context.h"
#include "Mesh/place.h"

#include <limits>
#include <memory>
#include <vector>

namespace oversketch
{

// A half-line, or the line that it lies on.
struct Ray
{
  Vector3 origin;
  Vector3 direction; // of any length but zero
};

struct SurfaceHit
{
  SurfacePoint at;                    // triangle -1: none
  Vector3 position = Vector3::Zero(); // of `at`: weights times corners
  // Along the ray, less than zero behind its origin, or from the point that was asked about [model length].
  double distance = std::numeric_limits<double>::infinity();

  bool found() const { return this->at.triangle >= 0; }
};

class SurfaceRays
{
public:
  // Takes some 0.3 s and 50 MiB a million triangles. A facet with a point that is not finite is not seen.
  // Throws Error(Failure::Cancelled), and Error(Failure::Unexpected) where Embree cannot take the mesh.
  explicit SurfaceRays(std::shared_ptr<const Mesh> mesh, const Context& context = Context());
  // Gives the same answers, bit for bit, by the tree of other rays and one of what their mesh has not: for a
  // mesh that comes of theirs by changes here and there; no tree of all of it is built. Null where too much
  // is different.
  static std::unique_ptr<const SurfaceRays> after(const SurfaceRays& before,
    std::shared_ptr<const Mesh> mesh,
    const Context& context = Context());
  ~SurfaceRays();

  const Mesh& mesh() const;
  double diagonal() const; // of the mesh's bounding box
  Vector3 centre() const;  // roughly the middle of it

  // All three may be called from several threads. Facets are met from either side and with their edges and
  // corners; nothing slips through between two. Of equal answers the one of the lowest triangle counts, so
  // they depend on the mesh alone. Degenerate triangles are met by no ray.

  // The first place on the ray, none where ray or direction is not finite.
  SurfaceHit nearest(const Ray& ray) const;
  // Every triangle that the whole line meets, by distance, then by triangle; on an edge that is two.
  std::vector<SurfaceHit> all(const Ray& line) const;
  // The place nearest to the point, none where that is not finite.
  SurfaceHit closest(const Vector3& point) const;

private:
  struct Trees;
  explicit SurfaceRays(std::unique_ptr<const Trees> trees);

  std::unique_ptr<const Trees> Internals;
};

// Rays of the mesh that somebody holds already, else made after those of another mesh that somebody holds,
// else anew. Held weakly: they go with the last who holds them. Callable from any thread.
std::shared_ptr<const SurfaceRays> sharedRays(const std::shared_ptr<const Mesh>& mesh,
  const Context& context = Context());

// Lengths from a place of the surface along its normal; infinite where nothing is met.
struct Room
{
  double inward;  // to where the line leaves the solid: how thick that is
  double outward; // to where it enters a solid: how wide the gap is
};

// Facets that the line meets from their other side do not count: folds of the surface round the place.
Room roomAt(const SurfaceRays& surface, const Vector3& place, const Vector3& normal);

// Along a line of sight, from a place within the solid to the farther of both places where the line leaves
// it; 0 outside. An outline that is drawn through the place has to carry that much away to either side of it.
double depthAt(const SurfaceRays& surface, const Vector3& place, const Vector3& sight);

} // namespace oversketch
#endif
