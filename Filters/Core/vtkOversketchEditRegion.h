/**
 * The region of an edit as vtkOversketchEnclose writes it: point array EditRegion of a mesh. Free functions,
 * for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchEditRegion_h
#define vtkOversketchEditRegion_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * What EditRegion says of a vertex.
 */
struct EditLabel
{
  static constexpr char Outside = 0;
  static constexpr char Rim = 1;    // on the boundary, or of the ring of triangles round it
  static constexpr char Inside = 2; // strictly within the boundary
};

/**
 * The label of each vertex. Throws Error(MissingArray) without the array, Error(BadRegion) naming the vertex
 * for a value that is not one of these.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<char> ReadEditRegion(vtkPolyData* mesh);

/**
 * The vertices strictly inside, ascending. Throws what ReadEditRegion does, and Error(BadRegion) where there
 * is none.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<int> ReadInside(vtkPolyData* mesh);

} // namespace oversketch
#endif
