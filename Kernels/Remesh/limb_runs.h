// Which parts of a ring, drawn round a line, lie on what the line lies on.
#ifndef oversketch_kernels_remesh_limb_runs_h
#define oversketch_kernels_remesh_limb_runs_h

#include "Mesh/mesh.h"
#include "Mesh/view.h"
#include "Remesh/refine_between.h"

#include <vector>

namespace oversketch
{

// A ring round the tip of a limb often passes over another one beside or behind it, whose way to the first
// leads over the body: a closed curve with both on it would not go round the limb. Of the runs of a ring on a
// mesh those are told (1) that touch what the line reaches over edges without leaving the ring in the
// picture; all, where that is none. ring: in display coordinates, closed. seeds: triangles that the line lies
// in.
std::vector<char> runsOnLimb(const Mesh& mesh,
  const Lists& vertexVertices,
  const View& view,
  const std::vector<Vector2>& ring,
  const std::vector<int>& seeds,
  const std::vector<RunOnMesh>& runs);

} // namespace oversketch
#endif
