// Extrusion: a drawing's mesh twice, in front of its plane and behind it, and walls between.
#ifndef oversketch_kernels_inflate_extrude_h
#define oversketch_kernels_inflate_extrude_h

#include "Inflate/solid.h"
#include "Planar/planar_mesh.h"

namespace oversketch
{

enum class WallRows
{
  Refined, // 2^k rows after k refinements: 2 4^k triangles, 4^k quads for each border edge of the coarse mesh
  One
};

// Source: image-assisted modelling, section 13: all points at +depth and -depth, not shared, joined by walls
// at all rims. The printed count of the walls' faces, "2k triangles (k quads)", is 0 for k = 0: exponents
// were lost in print; what refinement makes of 2 triangles (1 quad) is meant here. One is the other reading
// of it, 2 2^k. Points: the front's, the back's, the walls'. Throws Error(Failure::BadStroke) for a depth
// that is not above 0, Error(Failure::BadMesh) as borderOf and edgesBetweenBasePoints do.
Solid extrude(const PlanarMesh& mesh, double depth, WallRows rows);

} // namespace oversketch
#endif
