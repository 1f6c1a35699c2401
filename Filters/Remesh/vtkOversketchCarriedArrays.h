// The arrays of a mesh on what remeshing made of it, for the filters of this module. Not installed.
#ifndef vtkOversketchCarriedArrays_h
#define vtkOversketchCarriedArrays_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <vector>

class vtkAbstractArray;
class vtkIdList;

namespace oversketch
{

// The points of the input that a new point is a mean of, and their weights.
using PointMix = std::function<void(vtkIdType point, vtkIdList* ids, std::vector<double>& weights)>;

// An array of points. sources: the input's point that each point is, or -1; those are mixed where the array
// is of floating type, and take what the point of largest weight has where it is not, or is named Region;
// active normals keep length 1.
vtkSmartPointer<vtkAbstractArray> CarriedPointArray(vtkAbstractArray* array,
  bool normals,
  const std::vector<int>& sources,
  const PointMix& mix);

// An array of cells; sources: the input's cell that each cell comes from.
vtkSmartPointer<vtkAbstractArray> CarriedCellArray(vtkAbstractArray* array, const std::vector<int>& sources);

} // namespace oversketch
#endif
