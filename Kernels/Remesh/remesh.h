// Incremental remeshing of a region to target edge lengths, with where every corner came from.
#ifndef oversketch_remesh_h
#define oversketch_remesh_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include <array>
#include <vector>

namespace oversketch
{

struct RemeshInput
{
  const Mesh& mesh;
  std::vector<char> region;     // per vertex
  std::vector<double> targets;  // target edge length per vertex, see targetLengths()
  std::vector<int> charts;      // per triangle, or empty
  std::vector<Binding> handles; // rebound to the result
  bool protectHandles = true;   // what carries handles stays where it is, and is only split
  int iterations = 5;
};

struct RemeshResult
{
  Mesh mesh;
  // Points outside the region come first, in their order; then those of the region that stayed; then new
  // ones.
  std::vector<int> pointSource;     // the input point it is, or -1 for one that moved or is new
  std::vector<SurfacePoint> places; // where on the input each point is
  // Triangles outside the region come first, in their order.
  std::vector<int> triangleSource; // the input triangle under its middle
  std::vector<std::array<SurfacePoint, 3>>
    corners; // where on the input each corner is, in the triangle's own chart
  std::vector<Binding> handles;
};

// Botsch and Kobbelt's loop: split edges over 4/3 of the target, collapse those under 4/5, flip towards
// valence 6, relax within the tangent plane and go back to the input surface. Only triangles with three
// region vertices change; see Patch for what stays. Throws Error(Cancelled).
RemeshResult remesh(const RemeshInput& input, const Context& context);

} // namespace oversketch
#endif
