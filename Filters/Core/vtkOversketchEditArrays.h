/**
 * Arrays that the steps of an edit hand on: curves that run along the edges of a mesh, polylines with
 * point array VertexId, the vertex that each point is; and the region, point array EditRegion of a mesh, as
 * vtkOversketchEnclose writes it. Free functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchEditArrays_h
#define vtkOversketchEditArrays_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "vtkOversketchFilterTools.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * One curve; a closed one ends with the vertex that it begins with.
 */
struct Chain
{
  std::vector<int> Vertices;  // of the mesh
  std::vector<vtkIdType> Ids; // the curve's points
};

/**
 * All curves, number i from cell i. holder names the input in messages ("boundary curve"). Throws
 * Error(MissingArray) without VertexId, Error(BadStroke) when there is no polyline or there are other cells,
 * and, naming the point, for one that is not there or is no vertex in [0, vertexCount).
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<Chain> ReadChains(vtkPolyData* curves,
  int vertexCount,
  const std::string& holder);

/**
 * The one curve; Error(BadStroke) also where there are several.
 */
OVERSKETCHFILTERSCORE_EXPORT Chain ReadChain(vtkPolyData* curve, int vertexCount, const std::string& holder);

/**
 * The same on a mesh. Of a patch (vtkOversketchEnclose), which has point array VertexId itself, the vertices
 * with these values.
 */
OVERSKETCHFILTERSCORE_EXPORT Chain ReadChain(vtkPolyData* curve,
  vtkPolyData* mesh,
  const std::string& holder);

/**
 * The vertices, of a closed curve without the first one's repetition.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<int> VerticesOnce(Chain chain);

/**
 * Key of what ReadChains reads.
 */
OVERSKETCHFILTERSCORE_EXPORT MeshKey ChainsKey(vtkPolyData* curves);

/**
 * Values of EditRegion at a vertex.
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
