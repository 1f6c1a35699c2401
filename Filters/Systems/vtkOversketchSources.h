// Where the corners of what steps made of a welded mesh lie on it, for Weld::Transfer.
#ifndef vtkOversketchSources_h
#define vtkOversketchSources_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "Mesh/context.h"

class vtkPolyData;

namespace oversketch
{

// Arrays that the steps carry from a welded mesh to what they make of it: point array Place, where a point
// lies on the welded mesh. OriginalCell and, where there are seams, Chart are there.
OVERSKETCHFILTERSSYSTEMS_EXPORT void AddPlaces(vtkPolyData* welded);

// Adds SourceCell and SourceWeights of vtkOversketchRemesh. A corner's source is of the chart of its cell, so
// a vertex that slid over a seam keeps to both sides of it.
OVERSKETCHFILTERSSYSTEMS_EXPORT void AddSources(vtkPolyData* welded,
  vtkPolyData* changed,
  const Context& context);

} // namespace oversketch
#endif
