// Cuts holes out of a drawing's mesh.
#ifndef oversketch_kernels_planar_trim_h
#define oversketch_kernels_planar_trim_h

#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

namespace oversketch
{

// Source: image-assisted modelling, section 14: the mesh without the faces of the regions that are `gone`, by
// the region that they inherited; points and edges of strokes that no face has then are left out, the others
// keep their order. Points between what is left and what is gone are of kind Hole. Throws
// Error(Failure::BadMesh), naming it, for a face of a region that there is not.
PlanarMesh withoutRegions(const PlanarMesh& mesh, const std::vector<char>& gone);

// Leaves out points that no face has, and edges of strokes that are not kept; numbers them anew.
void compact(PlanarMesh& mesh, const std::vector<char>& keptEdges);

} // namespace oversketch
#endif
