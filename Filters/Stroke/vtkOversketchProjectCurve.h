/**
 * @class vtkOversketchProjectCurve
 * @brief a spline drawn over a mesh as curves on what is seen of it
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.1: the spline is
 * sampled every few pixels and each sample projected to the place of the mesh that is seen under it.
 *
 * Departures (see Kernels/Ray/curve_projection.h): where the surface ends, or leaps, the curve is cut into
 * runs, since samples would step through the air; and each run is sampled evenly along the surface, half a
 * mean edge apart but 4 to 10 px, since samples every few pixels mince coarse triangles (Spacing).
 *
 * Input 0 (Curves): stroke polydata, as vtkOversketchNurbsFit makes it: polylines in display coordinates with
 * points half a pixel apart, point array CurveT (else the share of the points before), and cell arrays
 * ViewTransform, ProjectionTransform and ViewportSize. A closed one repeats its first point id at the end.
 * Input 1 (Mesh): triangle mesh, vtkPolyData. Borders, non-manifold edges and any orientation are tolerated.
 *
 * Output 0 (Curves): one polyline per run in world space, double, in the order of strokes and along each; of
 * an open stroke the longest run alone, with a warning where there are others. A run that closes repeats its
 * first point id.
 * Point arrays:
 * - CurveT, double: the parameter, interpolated; a run through the start of a closed stroke goes on beyond 1,
 * - ArcLength, MeshCell, MeshVertices, MeshWeights, Normals and, where the curves have it, Pressure: as
 *   vtkOversketchSurfaceStroke has them.
 * Cell arrays:
 * - Closed, int: 1 where the run is of a closed stroke,
 * - CurveId, StrokeId, int, and the strokes' view arrays: as there.
 * Field data, the splines' arrays among them, is passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray; BadStroke, naming the
 * stroke, when there is no polyline or there are other cells, and for a stroke with fewer than two samples,
 * one that is not finite, over 1e5 px, a view that is none, or nothing of which lies on the mesh. Curves or a
 * mesh without points give an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: the first curve on a mesh builds
 * its ray scene, some 0.3 s and 50 MiB a million triangles; then a microsecond a point. The scene stays while
 * points and polygons of the mesh stand, the result, as the same arrays, while all that is read does.
 *
 * @sa vtkOversketchNurbsFit vtkOversketchInsertCurve vtkOversketchSurfaceStroke
 */
#ifndef vtkOversketchProjectCurve_h
#define vtkOversketchProjectCurve_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchProjectCurve : public vtkOversketchFilter
{
public:
  static vtkOversketchProjectCurve* New();
  vtkTypeMacro(vtkOversketchProjectCurve, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh that is drawn on, on port 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * Samples of a curve are so far apart in the picture [px, >= 0, default 0: evenly along the surface; 4 as
   * published].
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  /**
   * How many times curves have been projected: executions that the kept result did not answer.
   */
  vtkGetMacro(ProjectionCount, vtkIdType);

  /**
   * How many ray scenes it has taken: executions on another mesh than the one before.
   */
  vtkIdType GetSceneCount();

protected:
  vtkOversketchProjectCurve() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchProjectCurve() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Spacing = 0.0;
  vtkIdType ProjectionCount = 0;
};

#endif
