/**
 * @class vtkOversketchSilhouetteSketch
 * @brief a stroke as the new shape of a stretch of the silhouette
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-A.2: the stroke begins
 * and ends on the surface; the silhouette points nearest to both ends, p0 and pn, and the mean of their
 * normals span a plane, on which the stroke, projected along the lines of sight, is the sketch. The curve is
 * what of the surface is to go there. The paper leaves open, and here is chosen: points of visible silhouette
 * curves are preferred; the sketch is shifted, linearly in arc length, to end on p0 and pn; each
 * sample of the sketch is paired with a point of its own on the surface, found along the mean normal.
 * Departures, undone by the projection Ray: the first hit against that normal often is on the far side of the
 * model (Projection); and p0 and pn are nearest in the picture where that is within 20 px, since a pen that
 * presses a pixel beside a limb lies on what is behind it. An end beside the model is always taken so.
 *
 * Input 0 (Stroke): stroke polydata: one polyline in display coordinates with cell arrays ViewTransform,
 * ProjectionTransform and ViewportSize.
 * Input 1 (Mesh): triangle mesh, vtkPolyData; its point normals are used where it has them, else
 * angle-weighted ones are computed.
 * Input 2 (Silhouette): silhouette curves of that mesh in the stroke's view, of vtkOversketchSilhouette or
 * vtkOversketchVisibility: point array Normals, cell array Visible where it is there.
 *
 * Output 0 (Curve): the curve on the mesh, one polyline in world space with the arrays that
 * vtkOversketchSurfaceStroke documents; CurveId and StrokeId are 0. Samples that fall on one place in
 * succession are one point. Field array Hidden, double: of a dent, how far from the curve the surface hides
 * it along the lines of sight, and has to move with it [model length]; 0 of a bump. Output 1 (Sketch): the
 * sketch; points and cell are those of output 0 one to one. Point array ArcLength, double: along the sketch
 * [model length]; cell arrays CurveId, StrokeId.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray; BadStroke when there is not
 * one polyline, it has fewer than two samples, one that is not finite or a length over 1e5 px, it leads
 * round the end of a limb (the normals at both ends are over 120 degrees apart, or the sketch is over six
 * times as long as the way between them; with Line), an end lies beside the model and its silhouette, there
 * is no silhouette, its ends and normals span no plane or one that is seen within 5 degrees of edge-on, a
 * step is longer than MaximumStep, or the projection Path finds no one curve between the ends. A stroke or a
 * mesh without points gives empty outputs silently.
 *
 * Deterministic. Cost: as vtkOversketchSurfaceStroke, and one line or closest point a sample. The ray scene
 * stays while points and polygons of the mesh stand, the result, as the same arrays, while all that is read
 * does.
 *
 * @sa vtkOversketchSilhouette vtkOversketchVisibility vtkOversketchSurfaceStroke
 */
#ifndef vtkOversketchSilhouetteSketch_h
#define vtkOversketchSilhouetteSketch_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchSilhouetteSketch : public vtkOversketchFilter
{
public:
  static vtkOversketchSilhouetteSketch* New();
  vtkTypeMacro(vtkOversketchSilhouetteSketch, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh, on port 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  /**
   * The silhouette curves, on port 2.
   */
  void SetSilhouetteConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(2, curves); }
  void SetSilhouetteData(vtkPolyData* curves) { this->SetInputData(2, curves); }

  enum ProjectionType
  {
    Ray = 0,
    Line = 1,
    Path = 2
  };
  ///@{
  /**
   * How a sample of the sketch finds its point of the surface. Ray, as published: the first hit against the
   * mean normal, else along it, else the nearest place. Line (default): the hit of the whole line along it
   * that is nearest to the point before; where that is farther than four steps of the chord from p0 to pn,
   * the place nearest to the point of the chord at the sample's share of the sketch. Path: the silhouette
   * curve between p0 and pn at that share of its length.
   */
  vtkSetClampMacro(Projection, int, Ray, Path);
  vtkGetMacro(Projection, int);
  void SetProjectionToRay() { this->SetProjection(Ray); }
  void SetProjectionToLine() { this->SetProjection(Line); }
  void SetProjectionToPath() { this->SetProjection(Path); }
  ///@}

  ///@{
  /**
   * With the projection Line a longer step of the curve is refused: it bridges empty space [model length,
   * default -1: 0.03 of the mesh's diagonal; 0: no limit].
   */
  vtkSetMacro(MaximumStep, double);
  vtkGetMacro(MaximumStep, double);
  ///@}

  /**
   * The sketch, on port 1.
   */
  vtkPolyData* GetSketchOutput() { return this->GetOutput(1); }

  /**
   * How many times a stroke has been projected: executions that the kept result did not answer.
   */
  vtkGetMacro(ProjectionCount, vtkIdType);

  /**
   * How many ray scenes it has taken: executions on another mesh than the one before.
   */
  vtkIdType GetSceneCount();

protected:
  vtkOversketchSilhouetteSketch();
  ~vtkOversketchSilhouetteSketch() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Projection = Line;
  double MaximumStep = -1.0;
  vtkIdType ProjectionCount = 0;
};

#endif
