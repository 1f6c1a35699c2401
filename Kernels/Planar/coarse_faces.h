// The faces of a coarse mesh made better: terminal triangles are divided, inner points move, pairs become
// quads.
#ifndef oversketch_kernels_planar_coarse_faces_h
#define oversketch_kernels_planar_coarse_faces_h

#include "Planar/planar_mesh.h"

namespace oversketch
{

enum class TerminalRule
{
  TwoBoundaryEdges,
  ThreeBoundaryVertices
};

// Source: image-assisted modelling, section 7. A triangle and its copy, joined along two edges of the rim,
// share all three points; on the third edge four faces meet. The paper calls triangles terminal that have
// "three boundary vertices", which are all of a drawing without features, though its figure 11 shows such
// triangles untouched: here those with at least two edges on the mesh's border are, the literal reading is a
// rule of its own.
//
// A terminal triangle is merged with its neighbour across its other edge (by the literal rule the longest of
// several) and the two become a fan of four round the mean of their corners or, where that does not see them
// all, round the middle of the edge between them. Where the other edges are of strokes or of the border, a
// fan of three round its own mean. None is terminal afterwards by the first rule, nor, of triangles that
// were, by the other.
//
// The mesh's own points keep their numbers, new ones are of the base and in no stroke; faces start at their
// least corner, ascend, and are each its own base. Of triangles alone. Throws Error(Failure::BadStroke),
// naming the place, where a triangle is so thin that no point lies in it.
PlanarMesh repairTerminals(const PlanarMesh& mesh, TerminalRule rule);

// Darts, and what was put into terminal triangles, stand where no angle was thought of: of a drawing's coarse
// mesh, and so of what is refined from it, the narrowest twentieth of the triangles has half the angle that
// it can have. One after the other, eight times, each point in no stroke moves to the place, of some near its
// own and towards the middle of its neighbours, where the sum of the reciprocals of the triangles' least
// angles is the least. Which points are joined stays, and no triangle is turned over that was not. Of
// triangles alone.
PlanarMesh relaxed(const PlanarMesh& mesh);

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
