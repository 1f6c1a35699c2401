// Defects that keep a triangle mesh from being the base of a 4-8 mesh.
#ifndef oversketch_kernels_stellar_defects_h
#define oversketch_kernels_stellar_defects_h

#include "Mesh/mesh.h"

namespace oversketch
{

// Throws Error(BadMesh) unless the mesh is a simplicial manifold with one orientation, with boundary or
// without, in one piece or several. The message counts each kind of defect and names the first five:
// points that are not finite, triangles that name no point, name one twice, have no area or repeat another,
// edges of more than two triangles or of two that run the same way, points where pieces meet at nothing else.
// Loose points are no defect.
void checkManifold(const Mesh& mesh);
// Checks where the adjacency is there already; what names no point is not looked for.
void checkManifold(const Mesh& mesh, const Adjacency& adjacency);
// Checks only that triangles name points of the mesh, which adjacency needs.
void checkPointIds(const Mesh& mesh);

} // namespace oversketch
#endif
