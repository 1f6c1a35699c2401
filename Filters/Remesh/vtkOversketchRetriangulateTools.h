/**
 * What a retriangulation makes of a mesh, its arrays and its curves. Free functions, for use in the .cxx of
 * filters; not wrapped.
 */
#ifndef vtkOversketchRetriangulateTools_h
#define vtkOversketchRetriangulateTools_h

#include "OversketchFiltersRemeshModule.h" // For export macro

#include "Remesh/retriangulate.h"
#include "vtkOversketchChains.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkPolyData;

namespace oversketch
{

/**
 * Field array MeanEdge of a mesh, its mean edge length when it was loaded. Throws Error(MissingArray) where
 * it is not one positive value.
 */
OVERSKETCHFILTERSREMESH_EXPORT double MeanEdgeOf(vtkPolyData* mesh);

/**
 * Point array EditRegion of a mesh. Throws Error(MissingArray) without it, Error(BadRegion) naming the vertex
 * for a value that is not 0, 1 or 2.
 */
OVERSKETCHFILTERSREMESH_EXPORT std::vector<char> EditRegionLabels(vtkPolyData* mesh);

/**
 * The new triangles with the arrays of the mesh as it was: floating point arrays mixed (active normals
 * normalised), others from the vertex of largest weight, EditRegion 2 where a vertex that it is mixed of has
 * that; cell arrays from the triangle below. Field data is passed, global ids and the arrays of a 4-8 mesh
 * are dropped.
 */
OVERSKETCHFILTERSREMESH_EXPORT void WriteRetriangulated(const Retriangulated& result,
  vtkPolyData* mesh,
  vtkPolyData* output);

/**
 * Curves with their vertices' new ids and places; `first` is the number of the first one in the result.
 * Floating arrays of new points lie between their neighbours', others are the nearer one's; cell and field
 * data is passed.
 */
OVERSKETCHFILTERSREMESH_EXPORT void WriteChains(const Retriangulated& result,
  std::size_t first,
  const std::vector<Chain>& chains,
  vtkPolyData* curves,
  vtkPolyData* output);

/**
 * An array without values of the same kind, name and components, of some tuples.
 */
OVERSKETCHFILTERSREMESH_EXPORT vtkSmartPointer<vtkAbstractArray> LikeArray(vtkAbstractArray* array,
  std::size_t tuples);

/**
 * Whether an array's numbers are mixed between elements: those of floating kinds.
 */
OVERSKETCHFILTERSREMESH_EXPORT bool IsReal(vtkAbstractArray* array);

/**
 * Makes a tuple of three a unit vector, but for a zero one.
 */
OVERSKETCHFILTERSREMESH_EXPORT void NormaliseTuple(vtkDataArray* values, vtkIdType tuple);

} // namespace oversketch
#endif
