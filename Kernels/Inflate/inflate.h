// Inflation: a drawing's mesh pushed out to both sides and sealed at its rim.
#ifndef oversketch_kernels_inflate_inflate_h
#define oversketch_kernels_inflate_inflate_h

#include "Inflate/solid.h"
#include "Planar/planar_mesh.h"

namespace oversketch
{

// Source: image-assisted modelling, section 12: M_front = M_p + heights and M_back = M_p - heights with its
// faces turned, no faces between them; points of a rim are shared. Points come in M_p's order, front and rim
// first, then the back; faces likewise. Points without a face are left out. heights: of heightsOf.
//
// Throws Error(Failure::BadMesh), naming points, for a mesh whose borders are not its rims (a hole that is
// not trimmed, a border of another kind), for an edge or face inside it whose corners all lie on rims and for
// a quad with two opposite corners on rims: front and back would coincide there, of the quad when it is cut
// into triangles; one more refinement removes the former, mergeQuads after repairTerminals makes none.
Solid inflate(const PlanarMesh& mesh, const std::vector<double>& heights);

} // namespace oversketch
#endif
