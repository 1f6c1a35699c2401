// Triangles from a line to the ring round it are made as small as what lies between the two asks for.
#ifndef oversketch_kernels_remesh_refine_between_h
#define oversketch_kernels_remesh_refine_between_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include <optional>
#include <vector>

namespace oversketch
{

// A run of a curve on a mesh: places, and the triangle that each lies in. A closed one ends where it begins.
struct RunOnMesh
{
  std::vector<Vector3> points;
  std::vector<int> triangles;
};

struct RefineInput
{
  const Mesh& mesh;
  std::vector<RunOnMesh> line, ring;
  double edges = 6.0;   // that are to lie between line and ring, above 0
  double longest = 0.0; // edges that are asked for are no longer than this, a mesh's mean edge [model length]
};

struct Refined
{
  Mesh mesh;                     // input vertices in their order, then new ones; triangles alike
  std::vector<int> pointSources; // the input vertex, or -1
  std::vector<Mix> origins;      // of each vertex that is new, input vertices and weights
  std::vector<int> triangleSources;
  std::vector<double> sizes; // the edge length that is asked for at each vertex, `longest` at most
};

// Wanted at a place from line to ring is an edge of 1/edges of the way over it, its distances from both; of
// 0.7 of that at the line, where two slopes meet, rising evenly to halfway. Beyond the ring, which goes
// straight on from run to run, one that grows by twice as much as the place is off. A triangle whose longest
// edge is over 4/3 of what is wanted somewhere in it is bisected there, after those beyond that edge whose
// own longest edge is another one (Rivara): no angle is less than half of the one that was there, and new
// vertices lie on the old triangles. One beyond the ring that is fine enough is cut across where its
// neighbour is bisected, wherever it is longest, but not once it is flatter than 0.03, and no edge is
// bisected both ends of which are over `longest` beyond it, or off the way from line to ring, so that nothing
// runs on over the model. Looked at are triangles that a curve passes through, and from there on the
// neighbours of what was bisected. A mesh that is fine enough for nine in ten of those along either curve is
// left as it is: nothing is returned. Where line and ring all but meet, a quarter of the usual length is
// small enough. Deterministic. Throws Error(Failure::Cancelled).
std::optional<Refined> refineBetween(const RefineInput& input, const Context& context);

} // namespace oversketch
#endif
