// Smoothing of the region's border (SEED, Sec. 4.4, Fig. 10).
#ifndef oversketch_kernels_region_border_h
#define oversketch_kernels_region_border_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// On region vertices: convex, at most two neighbours in the region: deselect. Concave, exactly one neighbour
// outside it: select that one. Convex before concave, then by vertex id; when both hold, convex wins. A
// vertex changes sides at most twice, which ends the rules' disputes on open meshes; vertices on the mesh's
// own border are never deselected, nor are seeds. rings > 0 confines changes to that many rings of vertices
// on either side of the border as given, 0 does not. At the end pieces of the region without a seed are
// dropped, if there are seeds at all.
std::vector<char> smoothBorder(const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  int rings);

} // namespace oversketch
#endif
