/**
 * Points bound to a mesh, as curves, sections and handles carry them: point array MeshVertices
 * (vtkIdType[3]), the vertices a point hangs on, and MeshWeights (double[3]), their weights, sum 1; unused
 * vertices repeat the first. A point that hangs on nothing names vertex -1 three times. Free functions, for
 * use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchBindings_h
#define vtkOversketchBindings_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/place.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

enum class Unbound
{
  Refused,
  Allowed
};

/**
 * Bindings of the points of `points`; nothing is asked of a polydata without points. holder names the input
 * in messages ("handles"), remedy says what makes it. Throws Error(MissingArray) for an array that is absent
 * or has the wrong shape, Error(BadMesh) naming the first point that hangs on a vertex outside
 * [0, vertexCount) or has weights that are not finite or do not sum to 1.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<Binding> ReadBindings(vtkPolyData* points,
  int vertexCount,
  const std::string& holder,
  const std::string& remedy,
  Unbound unbound = Unbound::Refused);

/**
 * Adds both arrays to the points' data, one binding per point, in the place of those that were there.
 */
OVERSKETCHFILTERSCORE_EXPORT void WriteBindings(const std::vector<Binding>& bindings, vtkPolyData* points);

} // namespace oversketch
#endif
