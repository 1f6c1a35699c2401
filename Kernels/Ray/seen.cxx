#include "Ray/seen.h"

namespace oversketch
{

std::vector<char> seenVertices(const SurfaceRays& surface,
  const View& view,
  const std::vector<int>& vertices,
  const Context& context)
{
  constexpr double apart = 1e-6; // of the diagonal: what is nearer is the surface at the vertex itself
  const double before = 4.0 * surface.diagonal();
  std::vector<char> seen(vertices.size(), 0);
  context.eachUntilCancelled(static_cast<int>(vertices.size()),
    [&](int i)
    {
      const Vector3& place = surface.mesh().points[vertices[i]];
      const Vector3 origin = view.perspective() ? view.eye() : Vector3(place + before * view.normal());
      const Vector3 way = place - origin;
      const SurfaceHit hit = surface.nearest({ origin, way });
      seen[i] =
        view.inFront(place) && !(hit.found() && hit.distance < way.norm() - apart * surface.diagonal());
    });
  context.checkpoint(1.0);
  return seen;
}

} // namespace oversketch
