// The region of interest that a boundary drawn on the surface encloses.
#ifndef oversketch_kernels_region_enclose_h
#define oversketch_kernels_region_enclose_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Enclosed
{
  std::vector<char> faces;    // per triangle: 2 inside the boundary, 1 of the ring round it, 0 outside
  std::vector<char> vertices; // per vertex: 2 strictly inside, 1 on the boundary or of the ring, 0 outside
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.1: from the face
// under the reference curve's middle over neighbouring faces inside the boundary until none is left, and one
// ring of faces more; what is strictly inside can be deformed.
//
// The thesis does not say what inside is. Here growing goes over edges and never over one of the boundary, so
// that what lies behind the region in the picture stays out; a middle on an edge or a vertex starts from any
// face there; the ring is every face that shares a vertex with one inside. A vertex on a border of the mesh,
// or at which a face is not inside, is not strictly inside.
//
// Both curves are vertices, each joined to the next one by an edge; a closed one repeats its first at the
// end. Throws Error(Failure::BadStroke) for a reference curve of fewer than two vertices and a boundary that
// is open or not of edges; Error(Failure::BadRegion) when the reference curve is not strictly inside, when
// the faces inside are over 80 % of the connected part of the mesh or, see discBorder, no disc.
Enclosed enclose(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& reference,
  const std::vector<int>& boundary,
  const Context& context);

// The triangles with flags of at least `least`, and the vertices that they name, in their order.
struct Extract
{
  Mesh mesh;
  std::vector<int> vertices, triangles; // their ids in the whole mesh
};
Extract extractFaces(const Mesh& mesh, const std::vector<char>& flags, char least);

} // namespace oversketch
#endif
