// Pairs of the coarse mesh's triangles become quads.
#ifndef oversketch_kernels_planar_merge_quads_h
#define oversketch_kernels_planar_merge_quads_h

#include "Planar/planar_mesh.h"

namespace oversketch
{

// Source: image-assisted modelling, section 10. Edges on no stroke are visited by decreasing quality of the
// quad that their two triangles make, 1 - (2 / pi) max |pi / 2 - angle| over its corners, equal ones by their
// points' numbers; where both triangles are still free and the quad is strictly convex and of a quality above
// 0.1 they become it. Edges of strokes stay. Triangles may remain. Two edges of the border that meet are left
// to two faces: in one, each level of refinement has a quad there with opposite corners on the border, and
// what triangulates the doubled surface would cut front and back along the same diagonal.
//
// Points and edges stay as they are; faces start at their least corner, ascend, and are each its own base.
PlanarMesh mergeQuads(const PlanarMesh& mesh);

// The quality of a quad by its corners in order; 0 for one with an angle of 0 or a straight one, and beyond.
double quadQuality(const std::array<Vector2, 4>& corners);

} // namespace oversketch
#endif
