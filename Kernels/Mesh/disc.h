// Whether a patch of a surface is a disc.
#ifndef oversketch_kernels_mesh_disc_h
#define oversketch_kernels_mesh_disc_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// A patch without its holes: its one border, counter-clockwise seen from outside, from its lowest vertex on.
// Throws Error(Failure::BadRegion) that says what the patch is instead of a disc: several pieces, a hole or a
// handle, a pinch, three triangles at an edge.
std::vector<int> discBorder(const Mesh& patch, const Adjacency& adjacency);

} // namespace oversketch
#endif
