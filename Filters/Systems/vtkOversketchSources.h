// Where the corners of what steps made of a welded mesh lie on it, for Weld::Transfer.
#ifndef vtkOversketchSources_h
#define vtkOversketchSources_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "Mesh/context.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"

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

// The two arrays of a changed mesh, read. Throws Error(MissingArray) where one is not there.
class OVERSKETCHFILTERSSYSTEMS_EXPORT Sources
{
public:
  explicit Sources(vtkPolyData* changed);
  // Of a triangle's corner: the triangle it lies on, and the weights of that one's corners.
  vtkIdType Cell(vtkIdType triangle, int corner) const
  {
    return this->Cells->GetPointer(0)[3 * triangle + corner];
  }
  const double* WeightsAt(vtkIdType triangle, int corner) const
  {
    return this->Weights->GetPointer(0) + 9 * triangle + 3 * corner;
  }

private:
  vtkSmartPointer<vtkIdTypeArray> Cells;
  vtkSmartPointer<vtkDoubleArray> Weights;
};

} // namespace oversketch
#endif
