// What refinement hands back of the strokes, gathered over several rounds of making a mesh.
#ifndef oversketch_kernels_planar_splits_h
#define oversketch_kernels_planar_splits_h

#include "Planar/planar_mesh.h"

namespace oversketch
{

// Adds what was handed back to what was before: a part that meets one of those is to be halved once more than
// it was. The order is that of the rounds.
void addSplits(std::vector<StrokeSplit>& splits, const std::vector<StrokeSplit>& more);

} // namespace oversketch
#endif
