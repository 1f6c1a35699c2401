// Faces of a triangle mesh that pass through other faces of it.
#ifndef oversketch_kernels_intersection_crossing_faces_h
#define oversketch_kernels_intersection_crossing_faces_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

// Two faces, the lower one first.
using FacePair = std::array<int, 2>;

// The pairs of faces that meet elsewhere than in a corner of both, in ascending order; the answer is exact
// for the points as they are. `changed` has a byte per face: of each pair one at least is changed; empty: all
// are.
//
// Corners are the same where their positions are equal, so that points which a reader split for their texture
// coordinates tear nothing. Faces with two corners or three in common are no pair: whether those are folded
// over, or lie in each other, is a matter of their angle. Faces with one corner in common are a pair where
// they meet in more than that; others where they touch at all, be it in a point or lying in one plane. Faces
// without area and such with points that are not finite are in no pair.
//
// Pairs are the same for any number of threads. 30,000 triangles take some 30 ms on one thread. Throws
// Error(Cancelled).
std::vector<FacePair> crossingFaces(const Mesh& mesh,
  const std::vector<char>& changed,
  const Context& context = Context());

} // namespace oversketch
#endif
