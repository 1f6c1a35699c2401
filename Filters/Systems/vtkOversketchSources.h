// Where the corners of what steps made of a welded mesh lie on it, for Weld::Transfer.
#ifndef vtkOversketchSources_h
#define vtkOversketchSources_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "Mesh/context.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
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

// The two arrays of a changed mesh, read, of all its triangles or (vtkOversketchRemesh::SourcesOfAll) of
// those that could change. Throws Error(MissingArray) where one is not there.
class OVERSKETCHFILTERSSYSTEMS_EXPORT Sources
{
public:
  explicit Sources(vtkPolyData* changed);
  // Triangle that a triangle's corner lies on, and the weights of that one's corners.
  vtkIdType Cell(vtkIdType triangle, int corner) const
  {
    return triangle < this->UnchangedCount
             ? this->Unchanged->GetValue(triangle)
             : this->Cells->GetPointer(0)[3 * (triangle - this->UnchangedCount) + corner];
  }
  const double* WeightsAt(vtkIdType triangle, int corner) const
  {
    return triangle < this->UnchangedCount
             ? OfCorner[corner]
             : this->Weights->GetPointer(0) + 9 * (triangle - this->UnchangedCount) + 3 * corner;
  }

private:
  static constexpr double OfCorner[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };

  vtkSmartPointer<vtkIntArray> Unchanged; // null where the others have sources of all triangles
  vtkIdType UnchangedCount = 0;
  vtkSmartPointer<vtkIdTypeArray> Cells;
  vtkSmartPointer<vtkDoubleArray> Weights;
};

} // namespace oversketch
#endif
