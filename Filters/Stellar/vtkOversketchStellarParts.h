// The charts of a 4-8 mesh, for the filters of this module. Not installed.
#ifndef vtkOversketchStellarParts_h
#define vtkOversketchStellarParts_h

#include "vtkOversketchFilterTools.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

class Forest;

// The chart of each root by cell array Chart, one whole number per triangle (see vtkOversketchRemesh); empty
// where the mesh has none. A root that lies in several, as over a simplified base, has that of its first
// cell. Throws Error(BadMesh) naming a number that is none.
std::vector<int> PartsOf(vtkPolyData* mesh, const Forest& forest);

// What PartsOf reads of a mesh beside its 4-8 arrays.
MeshKey PartsKey(vtkPolyData* mesh);

} // namespace oversketch
#endif
