// Parts that two meshes have in common, bit for bit: of one that has come of the other by changes here and
// there, or whatever the numbers of vertices and facets.
#ifndef oversketch_kernels_mesh_match_h
#define oversketch_kernels_mesh_match_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// numbers: per triangle of the mesh before, the triangle of the mesh now that has its corners at the same
// places, in the same order; -1: none. others: triangles of the mesh now that are in no number. Both ascend;
// what has stayed is to follow in the same order in both meshes. False, with neither told, where more than an
// eighth of either has no match.
bool matchTriangles(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others);

// Finds what vertexNormals has for the mesh now, bit for bit, from those of the mesh before: computed anew
// where triangles have changed alone. around: see trianglesAround. False where matchTriangles says so.
bool normalsAfter(const Mesh& before,
  const std::vector<Vector3>& normals,
  const Mesh& now,
  const Lists& around,
  std::vector<Vector3>& result);

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
