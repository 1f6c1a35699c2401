// Strokes from polydata and back, and the surface that they are drawn on, for the filters of this module. Not
// installed.
#ifndef vtkOversketchStrokeTools_h
#define vtkOversketchStrokeTools_h

#include "Mesh/view.h"
#include "Ray/projection.h"
#include "Stroke/polyline.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// Throws Error(BadStroke) naming the stroke when it is longer than `longestStroke`.
void RefuseEndless(const std::vector<StrokeLine>& strokes);

// The view of one stroke, see ViewOf; strokes of one polydata may carry different ones.
View ViewOfStroke(vtkPolyData* strokes, int stroke);

// A stroke for each of the input's: places[i] on the samples of stroke i. Point arrays are interpolated, cell
// and field data passed, z is 0.
void WriteStrokes(vtkPolyData* input,
  const std::vector<StrokeLine>& strokes,
  const std::vector<std::vector<Blend>>& places,
  const std::vector<char>& closed,
  vtkPolyData* output);

// All that the steps on a surface read of strokes.
MeshKey StrokesKey(vtkPolyData* strokes);

// A curve on the mesh and the stroke that it comes from.
struct StrokeCurve
{
  SurfaceCurve Curve;
  int Stroke;
};

// Writes polylines with the arrays that vtkOversketchSurfaceStroke documents.
void WriteSurfaceCurves(const std::vector<StrokeCurve>& curves,
  const MeshData& mesh,
  vtkPolyData* strokes,
  const std::vector<StrokeLine>& lines,
  vtkPolyData* output);

// A mesh and its ray scene, held for the next stroke.
class KeptSurface
{
public:
  // The scene of the mesh, made where the last one asked for had other points or triangles.
  const SurfaceRays& Provide(vtkPolyData* mesh, const Context& context);
  const MeshData& Mesh() const { return *this->Data; }
  vtkIdType Builds() const { return this->BuildCount; }

private:
  std::shared_ptr<const MeshData> Data;
  std::shared_ptr<const oversketch::Mesh> Shape; // that the scene is of
  std::unique_ptr<const SurfaceRays> Rays;
  vtkIdType BuildCount = 0;
};

} // namespace oversketch
#endif
