// The last pass of remeshing: folds that the deformation made are taken out.
#ifndef oversketch_kernels_remesh_unfold_h
#define oversketch_kernels_remesh_unfold_h

#include "Mesh/context.h"
#include "Remesh/patch.h"

namespace oversketch
{

// Moves vertices at folded edges (normals over 100 degrees apart) towards the mean of their neighbours where
// less is folded round them then and no triangle becomes a needle; one after the other, in rounds, until none
// helps. A vertex on the border of the patch or of a chart stays; places on the surface stay, too. Where
// nothing is folded nothing moves.
void unfold(Patch& patch, const Context& context);

} // namespace oversketch
#endif
