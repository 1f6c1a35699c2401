// A 4-8 mesh's arrays, and the user's split points with its numbers. Not installed.
#ifndef vtkOversketchAugmentSeams_h
#define vtkOversketchAugmentSeams_h

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

// Gives the arrays of the 4-8 mesh to another one, cell and field arrays as they are: point i there is
// from[i] of `source`.
void CopyStellarArrays(vtkPolyData* source, const std::vector<vtkIdType>& from, vtkPolyData* to);

// `split`, whose point i is vertex vertices[i] of augmented, as the output: points in the order of vertices,
// those that repeat one after all others; the positions and Stellar arrays of augmented. Returns the vertex
// of each point.
std::vector<vtkIdType> PutSplit(vtkPolyData* split,
  const std::vector<int>& vertices,
  vtkPolyData* augmented,
  vtkPolyData* output);

} // namespace oversketch
#endif
