// The region stays on the near side of a fork: an amendment of ours to the region of interest.
#ifndef oversketch_kernels_region_fork_h
#define oversketch_kernels_region_fork_h

#include "Mesh/mesh.h"
#include "Region/grow.h"

#include <vector>

namespace oversketch
{

// On a mesh with handles a limb may fork and both branches lead back to the body: a leg that another one
// touches. They are as thick, so the region takes both, and a stroke over the foot moves the other leg too.
// Such a region has several closed borders though what is left is in one piece. It is confined to what lies
// within the farthest edge path from the seeds whose border is a single loop, no longer than one and a half
// times the longest that the region has; islands of it are filled. A region with one border, one that reaches
// an open border of the mesh, and one round which no such loop lies, as a cup's handle that is meant as a
// whole, are returned as they were.
std::vector<char> cutAtFork(const Mesh& mesh,
  const Adjacency& adjacency,
  const MeshParts& parts,
  const std::vector<int>& seeds,
  const std::vector<char>& region);

} // namespace oversketch
#endif
