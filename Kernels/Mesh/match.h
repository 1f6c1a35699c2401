// Parts that two meshes have in common, bit for bit, where one has come of the other by changes here and
// there.
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

} // namespace oversketch
#endif
