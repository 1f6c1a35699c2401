/**
 * Numbers of the parts of a mesh that are one body all the same: field array Joined, int, which
 * vtkOversketchJoin writes. For use in the .cxx of filters and applications; not wrapped.
 */
#ifndef vtkOversketchJoinedParts_h
#define vtkOversketchJoinedParts_h

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <set>

namespace oversketch
{

/**
 * Gives them as in cell array PartId; none where nothing is joined.
 */
inline std::set<int> JoinedParts(vtkPolyData* mesh)
{
  std::set<int> joined;
  vtkDataArray* numbers = mesh->GetFieldData()->GetArray("Joined");
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    joined.insert(static_cast<int>(numbers->GetComponent(i, 0)));
  }
  return joined;
}

} // namespace oversketch
#endif
