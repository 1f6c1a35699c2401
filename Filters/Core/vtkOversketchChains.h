/**
 * Curves that run along the edges of a mesh: polylines with point array VertexId, the vertex that each point
 * is. Free functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchChains_h
#define vtkOversketchChains_h

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
 * What ReadChains reads.
 */
OVERSKETCHFILTERSCORE_EXPORT MeshKey ChainsKey(vtkPolyData* curves);

} // namespace oversketch
#endif
