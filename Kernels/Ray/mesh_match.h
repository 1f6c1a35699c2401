// Vertices and facets that two meshes have in common, bit for bit and whatever the numbers of vertices and
// facets.
#ifndef oversketch_kernels_ray_mesh_match_h
#define oversketch_kernels_ray_mesh_match_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct MeshMatch
{
  std::vector<int> vertices; // per vertex now: one before with the same point and normal, or -1
  std::vector<int> added;    // facets now that were not there before, or fewer times, ascending
  std::vector<int> removed;  // facets before that are there no more, ascending, equal ones once
};

// Facets are the same when their three points are, in the same order.
MeshMatch matchMeshes(const Mesh& before,
  const std::vector<Vector3>& normalsBefore,
  const Mesh& now,
  const std::vector<Vector3>& normalsNow,
  const Context& context);

} // namespace oversketch
#endif
