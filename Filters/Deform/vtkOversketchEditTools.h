/**
 * Readers of the editors' filters: curves along a mesh's edges, a region's arrays, handles, frames. Free
 * functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchEditTools_h
#define vtkOversketchEditTools_h

#include "OversketchFiltersDeformModule.h" // For export macro

#include "Matrix/frames.h"
#include "Matrix/logarithm.h"
#include "Mesh/place.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchSharedMesh.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace oversketch
{

/**
 * The reference curve on its mesh.
 */
struct CurveOnMesh
{
  std::vector<int> Vertices;
  std::vector<Vector3> Points;
  std::vector<double> Lengths; // from the first point to each
  CurveFrames Frames;

  CurveOnMesh(vtkPolyData* curve, const MeshData& mesh);
  Binding PlaceAt(double t) const; // t: share of its length
};

/**
 * A value of some vertices of a mesh's point array of one component, which must lie within `least` and 1.
 * Throws Error(MissingArray), Error(BadRegion) naming the vertex.
 */
std::vector<double> ReadValues(vtkPolyData* mesh,
  const char* name,
  const std::vector<int>& vertices,
  double least = 0.0);

/**
 * A matrix as 16 numbers, row by row. ReadMatrix throws Error(MissingArray), Error(BadStroke) where one is
 * not finite.
 */
void WriteMatrix(vtkFieldData* data, const char* name, const Matrix4& matrix);
OVERSKETCHFILTERSDEFORM_EXPORT Matrix4 ReadMatrix(vtkFieldData* data,
  const char* name,
  const std::string& holder,
  const std::string& remedy);

/**
 * A frame by its matrix (matrixOf) and back.
 */
CurveFrame FrameOf(const Matrix4& matrix);

/**
 * Point array CurveT of handles: shares of the reference curve's length. Throws Error(MissingArray),
 * Error(BadStroke) naming the handle, of one outside 0 and 1.
 */
std::vector<double> ReadHandlePlaces(vtkPolyData* handles);

/**
 * Point array Matrix, affine. Throws Error(MissingArray), Error(BadStroke) naming the handle.
 */
std::vector<Matrix4> ReadHandleMatrices(vtkPolyData* handles);

} // namespace oversketch
#endif
