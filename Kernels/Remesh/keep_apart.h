// Vertices that have come to lie at one place.
#ifndef oversketch_kernels_remesh_keep_apart_h
#define oversketch_kernels_remesh_keep_apart_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// Whoever welds a mesh would take two vertices at one place for one, and their edges for edges of more than
// two triangles. Moves each vertex that lies where another one does and may move towards the middle of its
// neighbours, by as little as tells them apart: as floats where the mesh will be stored in such. Of those at
// one place the one that is least movable stays: 0 may not move. Returns how many are left together, because
// none of them may move or their neighbours lie there as well.
int keepApart(Mesh& mesh, const std::vector<char>& movable, bool asFloats);

} // namespace oversketch
#endif
