/**
 * @class vtkOversketchSurfaceStroke
 * @brief strokes as curves on the surface that they are drawn over
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-A.1: each sample is
 * unprojected to the place of the surface that is seen under it, which with its triangle is a point of the
 * feature curve. Here a ray from the eye finds it, the first triangle, from either side; near and far planes
 * mean nothing. Departure (Tolerance): plain samples step through the air wherever one part of the model
 * hides another, so between two samples the stroke is halved in the picture until the curve follows the
 * surface, and cut where that leaps.
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates with cell arrays ViewTransform,
 * ProjectionTransform and ViewportSize. Any number of strokes, each with its own view; one that repeats its
 * first point id at the end is closed. Jitter is not dropped: see vtkOversketchStrokeThinning.
 * Input 1 (Mesh): triangle mesh, vtkPolyData; its point normals are used where it has them, else
 * angle-weighted ones are computed. Borders, non-manifold edges and any orientation are tolerated.
 *
 * Output 0 (Curves): one polyline per curve in world space, double, in the order of strokes and along each; a
 * closed curve repeats its first point id at the end. A stroke is several curves where it is cut.
 * Point arrays:
 * - ArcLength, double: from the curve's first point [model length],
 * - MeshCell, vtkIdType: the triangle that the point lies in,
 * - MeshVertices, vtkIdType[3]: its corners, and MeshWeights, double[3]: their weights, sum 1,
 * - Normals, double[3]: of the surface, unit length,
 * - Room, double[2]: against the normal and along it, how far it is to where the line leaves the model, and
 *   to where it enters another part [model length]; -1: nowhere,
 * - Pressure, of the stroke's type: where the strokes have it.
 * Cell arrays:
 * - CurveId, int: 0, 1, ...
 * - StrokeId, int: the stroke's cell,
 * - Radius, Height, Sharpness, and the three of the view: of the stroke, where the strokes have them.
 * Nothing else is passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray; BadStroke, naming the
 * stroke, when there is no polyline or there are other cells, and for a stroke with fewer than two samples,
 * one that is not finite, a length over 1e5 px, a view that is none, or of which no two samples in succession
 * meet the mesh. Strokes or a mesh without points give an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: the first stroke on a mesh builds
 * its ray scene, some 0.3 s and 50 MiB a million triangles; then a microsecond a ray, one to five rays a
 * sample. The scene stays while points and polygons of the mesh stand, the result, as the same arrays, while
 * all that is read does.
 *
 * @sa vtkOversketchChaikin vtkOversketchSilhouetteSketch
 */
#ifndef vtkOversketchSurfaceStroke_h
#define vtkOversketchSurfaceStroke_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchSurfaceStroke : public vtkOversketchFilter
{
public:
  static vtkOversketchSurfaceStroke* New();
  vtkTypeMacro(vtkOversketchSurfaceStroke, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh that is drawn on, on port 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  /**
   * Makes the ray scene of the mesh on port 1, so that the first stroke need not. Errors as of an update.
   */
  void Prepare();

  ///@{
  /**
   * The stroke is halved between two samples, at most nine times, until the surface under the middle is this
   * near to the middle of the chord and the chord no longer than 25 times this (but 2 to 20 pixels' size,
   * which counts first); what then is longer is cut [model length, default -1: 6e-4 of the mesh's diagonal;
   * 0: never, as published].
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * How many times strokes have been projected: executions that the kept result did not answer.
   */
  vtkGetMacro(ProjectionCount, vtkIdType);

  /**
   * How many ray scenes it has taken: executions on another mesh than the one before.
   */
  vtkIdType GetSceneCount();

protected:
  vtkOversketchSurfaceStroke() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchSurfaceStroke() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Tolerance = -1.0;
  vtkIdType ProjectionCount = 0;
};

#endif
