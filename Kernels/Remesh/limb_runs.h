// Runs of a ring that lie on what its line lies on, and the share of a region outside the ring.
#ifndef oversketch_kernels_remesh_limb_runs_h
#define oversketch_kernels_remesh_limb_runs_h

#include "Mesh/mesh.h"
#include "Mesh/view.h"
#include "Remesh/refine_between.h"

#include <vector>

namespace oversketch
{

// A ring often passes over another limb beside or behind the one it is meant for: a closed curve with both on
// it would go round neither. Of the runs of a ring on a mesh those are told (1) that touch what the line
// reaches over edges without leaving the ring in the picture, seen or hidden; and of these, where the line
// reaches them over the far side of the model alone, those to and from which the leaps are at most half as
// long again as they are, as on what lies behind a ridge. All are, where that leaves none. normals: of
// vertices, outward or inward. ring: in display coordinates, closed. seeds: triangles that the line lies in.
std::vector<char> runsOnLimb(const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const Lists& vertexVertices,
  const View& view,
  const std::vector<Vector2>& ring,
  const std::vector<int>& seeds,
  const std::vector<RunOnMesh>& runs);

// The share of a region's area that lies outside the ring in the picture, seen or hidden. inside: of
// vertices; a triangle with such a one is in the region.
double shareOutside(const Mesh& mesh,
  const std::vector<char>& inside,
  const View& view,
  const std::vector<Vector2>& ring);

} // namespace oversketch
#endif
