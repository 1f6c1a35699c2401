// Inner points of the coarse mesh move to where the triangles round them are of better shape.
#ifndef oversketch_kernels_planar_relax_h
#define oversketch_kernels_planar_relax_h

#include "Planar/planar_mesh.h"

namespace oversketch
{

// Darts, and what was put into terminal triangles, stand where no angle was thought of: of a drawing's coarse
// mesh, and so of what is refined from it, the narrowest twentieth of the triangles has half the angle that
// it can have. One after the other, eight times, each point in no stroke moves to the place, of some near its
// own and towards the middle of its neighbours, where the sum of the reciprocals of the triangles' least
// angles is the least. Which points are joined stays, and no triangle is turned over that was not. Of
// triangles alone.
PlanarMesh relaxed(const PlanarMesh& mesh);

} // namespace oversketch
#endif
