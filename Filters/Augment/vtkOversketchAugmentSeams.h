// Where the corners of a 4-8 mesh's cells lie on the mesh that it was made of, for Weld::Transfer; and the
// user's split points with the numbers of the 4-8 mesh. Not installed.
#ifndef vtkOversketchAugmentSeams_h
#define vtkOversketchAugmentSeams_h

#include "Mesh/context.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

// Gives the arrays of the 4-8 mesh to another one, cell and field arrays as they are: point i there is
// from[i] of `source`.
void CopyStellarArrays(vtkPolyData* source, const std::vector<vtkIdType>& from, vtkPolyData* to);

// Arrays that the steps carry from a welded mesh to what they make of it: point array Place, where a point
// lies on the welded mesh. OriginalCell and, where there are seams, Chart are there.
void AddPlaces(vtkPolyData* welded);

// Adds SourceCell and SourceWeights of vtkOversketchRemesh. A corner's source is of the chart of its cell, so
// a vertex that slid over a seam keeps to both sides of it.
void AddSources(vtkPolyData* welded, vtkPolyData* augmented, const Context& context);

// `split`, whose point i is vertex vertices[i] of augmented, as the output: points in the order of vertices,
// those that repeat one after all others; the positions and Stellar arrays of augmented. Returns the vertex
// of each point.
std::vector<vtkIdType> PutSplit(vtkPolyData* split,
  const std::vector<int>& vertices,
  vtkPolyData* augmented,
  vtkPolyData* output);

} // namespace oversketch
#endif
