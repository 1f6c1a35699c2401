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

#include <functional>
#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

namespace oversketch
{

// Throws Error(BadStroke) naming the stroke when it is longer than `longestStroke`.
void RefuseEndless(const std::vector<DrawnLine>& strokes);

// A stroke as it lies on a canvas, each sample seen in the stroke's view, and which samples those are. It is
// closed where it repeats its first id, or its cell array Closed is 1; where that is neither 0 nor 1, or
// there is none, where its ends come near each other. Throws Error(BadStroke) naming the stroke (what:
// "Stroke", "Correction") when none of its samples meets the canvas, and what ViewOf does.
struct StrokeOnCanvas
{
  CanvasStroke Curve;
  std::vector<Blend> Places;
};
StrokeOnCanvas OntoCanvas(vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  int stroke,
  const Canvas& canvas,
  const char* what);

// A stroke for each of the input's: places[i] on the samples of stroke i. Point arrays are interpolated, cell
// and field data passed, z is 0.
void WriteStrokes(vtkPolyData* input,
  const std::vector<DrawnLine>& strokes,
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

// Curves of all strokes, by what `project` makes of one: the second half of a filter's progress. Throws
// Error(BadStroke) with `missed` for a stroke that no curve comes of.
using ProjectStroke = std::function<
  std::vector<SurfaceCurve>(const View& view, const DrawnLine& line, int stroke, const Context& context)>;
std::vector<StrokeCurve> ProjectStrokes(vtkAlgorithm* filter,
  vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  const char* missed,
  const ProjectStroke& project);

// A mesh and its ray scene, held for the next stroke.
class KeptSurface
{
public:
  // The scene of the mesh, made where the last one asked for had other points or triangles.
  const SurfaceRays& Provide(vtkPolyData* mesh, const Context& context);
  const MeshData& Mesh() const { return *this->Data; }
  const SurfaceRays& Scene() const { return *this->Rays; } // of the last Provide
  // Normals of some vertices as Mesh().Normals() has them, bit for bit: where the mesh brings none along,
  // neither the others' nor the adjacency are made for it.
  std::vector<Vector3> NormalsOf(const std::vector<int>& vertices) const;
  vtkIdType Builds() const { return this->BuildCount; }

private:
  std::shared_ptr<const MeshData> Data;
  std::shared_ptr<const oversketch::Mesh> Shape; // that the scene is of
  std::shared_ptr<const SurfaceRays> Rays;
  bool BringsNormals = false;
  vtkIdType BuildCount = 0;
};

// Writes polylines with the arrays that vtkOversketchSurfaceStroke documents.
void WriteSurfaceCurves(const std::vector<StrokeCurve>& curves,
  const KeptSurface& surface,
  vtkPolyData* strokes,
  const std::vector<DrawnLine>& lines,
  vtkPolyData* output);

} // namespace oversketch
#endif
