/**
 * What a retriangulation makes of a mesh, its arrays and its curves. Free functions, for use in the .cxx of
 * filters; not wrapped.
 */
#ifndef vtkOversketchRetriangulateTools_h
#define vtkOversketchRetriangulateTools_h

#include "OversketchFiltersRemeshModule.h" // For export macro

#include "Remesh/retriangulate.h"
#include "vtkOversketchChains.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace oversketch
{

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

} // namespace oversketch
#endif
