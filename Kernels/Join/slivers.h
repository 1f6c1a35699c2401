// Slivers that rounding and points that all but coincide leave where two bodies meet, taken out.
#ifndef oversketch_kernels_join_slivers_h
#define oversketch_kernels_join_slivers_h

#include "Join/unite.h"

namespace oversketch
{

// Merges points nearer to each other than `least` [model length] along edges at new points, the new one into
// the other; and flips the longest edge of triangles that are lower than that, as long as either helps
// (M. Botsch, L. Kobbelt, "A Robust Procedure to Eliminate Degenerate Faces from Triangle Meshes", 2001).
// Then leaves out points that no triangle has.
void removeSlivers(United& united, double least);

// Merges points of the edges between triangles of different parts along these where they are
// nearer to each other than half the length of the vertex, and no triangle turns by it.
void coarsenCrease(United& united, const std::vector<double>& lengths);

} // namespace oversketch
#endif
