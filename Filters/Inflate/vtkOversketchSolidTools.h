// Surfaces made of a drawing's mesh, to polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchSolidTools_h
#define vtkOversketchSolidTools_h

#include "Inflate/solid.h"

class vtkPolyData;

namespace oversketch
{

// Writes the surface: points and polygons, the input's point and cell arrays by the points' and faces'
// sources, its field arrays. Of walls BaseFaceId is -1. Adds
// - point array Displacement, double: distance from the drawing's plane [world],
// - point and cell array Side, int: 1 front, -1 back, 0 on a seam or wall,
// - point array PlanarId, int: the point of the drawing's mesh.
// Normals are not passed: the input's are not the surface's.
void WriteSolid(const Solid& solid, vtkPolyData* input, vtkPolyData* output);

// Back from there; sources are the polydata's own points and faces. Throws Error(MissingArray) naming an
// absent array, Error(BadMesh) for a point that is not finite and for cells other than triangles and quads.
Solid SolidOf(vtkPolyData* surface);

} // namespace oversketch
#endif
