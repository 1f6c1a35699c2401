/**
 * A mesh with some points at other places: what the filters of this folder put out. Free functions, for use
 * in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchMovedPoints_h
#define vtkOversketchMovedPoints_h

#include "Mesh/mesh.h"

#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

namespace oversketch
{

/**
 * The points with the listed ones moved, double where they were double, else float; the others to the bit.
 */
vtkSmartPointer<vtkPoints> WithPlaces(vtkPoints* points, const std::vector<std::pair<int, Vector3>>& moved);

/**
 * Whether an array can be the normals of so many points or cells.
 */
bool UsableNormals(vtkDataArray* normals, vtkIdType count);

/**
 * A copy of normals with the listed ones overwritten; one without length is left as it was.
 */
vtkSmartPointer<vtkDataArray> WithNormals(vtkDataArray* normals,
  const std::vector<std::pair<int, Vector3>>& changed);

class MovingPatch;
struct Context;

/**
 * The output: the input with the patch's vertices at the places, and active point and cell normals anew where
 * a triangle changed. `folds`, `moved`: edges folded by it, points that are not where they were.
 */
struct MoveReport
{
  int Folds = 0, Moved = 0;
};
MoveReport WriteMoved(vtkPolyData* input,
  MovingPatch& patch,
  const std::vector<Vector3>& places,
  vtkPolyData* output,
  const Context& context);

} // namespace oversketch
#endif
