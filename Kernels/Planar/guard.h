// Keeps the faces of a refined planar mesh from turning over.
#ifndef oversketch_kernels_planar_guard_h
#define oversketch_kernels_planar_guard_h

#include "Planar/subdivide.h"

#include <set>

namespace oversketch
{

// The faces of which a triangle, or one of those that a quad's diagonals cut off it, covers no more than
// `least` with its sign, ascending.
std::vector<int> invertedFaces(const PlanarMesh& mesh, double least, const Context& context);

// Source: image-assisted modelling, section 9, its amendment. Points go to w W + (1 - w) W', W where masks
// and snap have them (`smooth`), W' where they lie in the middle (the places in `level.mesh`, which are
// replaced). w is 1 first; those of the free points of inverted faces are halved until none is left, below
// 0.1 they are 0, and after 6 passes those of the faces round them too. Points of strokes do not move.
//
// Returns the faces that stay inverted with all their w at 0, ascending: the strokes leave them no room.
// Parts of the bases that are `given` up are not looked at. Where no face is inverted with all w at 1, every
// place is W to the bit.
std::vector<int> keepUpright(SubdividedMesh& level,
  double least,
  const std::set<int>& given,
  const Context& context);

} // namespace oversketch
#endif
