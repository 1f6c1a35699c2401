// A coarse mesh that stands in for a large one while a hand draws on it.
#ifndef oversketch_kernels_remesh_proxy_h
#define oversketch_kernels_remesh_proxy_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Proxy
{
  Mesh mesh;
  std::vector<int> pointFrom; // per point of the mesh its point in the original
};

// Clusters of vertices that share a cell of a uniform grid and hang together by edges inside it, so that the
// two sides of a thin part stay apart; a triangle with its corners in three clusters stays. A cluster stands
// where its vertex nearest to the mean of all of them is. Cells are such that some targetFaces triangles
// stay.
//
// What is no manifold then, though the mesh is one there, is made anew of smaller cells: clusters with a hole
// or a handle, edges of more than two triangles, triangles there twice or turned by over 60 degrees, points
// whose triangles are no single fan. At the finest each vertex stands alone; where that leaves too many
// triangles all begins anew with larger cells. So a closed manifold gives a closed manifold of the same kind;
// pieces that lie within one cell are lost, and holes of two. Where the mesh is no manifold the proxy need be
// none. At last edges of needles are flipped, which light would show.
//
// Throws Error(BadMesh) where nothing has an area or pieces lie too far apart, Error(Cancelled). Linear in
// the mesh; the same for any number of threads.
Proxy makeProxy(const Mesh& mesh, int targetFaces, const Context& context = Context());

} // namespace oversketch
#endif
