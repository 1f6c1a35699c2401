// Triangles that would make the doubled mesh no surface are divided.
#ifndef oversketch_kernels_planar_terminal_h
#define oversketch_kernels_planar_terminal_h

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

} // namespace oversketch
#endif
