/**
 * @class vtkOversketchOutline
 * @brief outline of a mesh's picture, with the visible silhouette attached to it
 *
 * Source: an amendment to Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.3
 * (specification 13.1): toes, fingers, cusps and T-junctions cut the silhouette, and no single piece of it
 * can carry a stroke round a limb's tip. So the boundary loops (outer ones and holes) of the pixels that the
 * mesh covers are candidates for matching too; visible silhouette points within 3 px of a loop are
 * inserted in their order along it. A curve that leaves the loop sideways or runs back along it is not
 * attached there. The loop's points lie exactly on the boundary of the covered area, where it crosses the
 * lines between pixel centres, and are smoothed by five taps. Departure: every mesh edge that the loop is the
 * picture of is bound too, and silhouette points are attached no farther than half an edge. The silhouette of
 * interpolated normals runs beside the outline, by up to that much, and at creases and borders not along it
 * at all: what it leaves loose would form the outline of the result, and what lies farther is an inner
 * feature that would pull against it.
 *
 * Input 0 (Mesh): triangle mesh; triangles with a corner at or behind the eye of a perspective view have
 * no picture.
 *
 * Input 1 (Stroke): stroke polydata, for the view it carries (cell arrays ViewTransform,
 * ProjectionTransform, ViewportSize); where the mesh's picture is larger than 4096 pixels, the part round
 * the stroke is traced and loops are open at its edges.
 *
 * Input 2 (Curves): curves from vtkOversketchVisibility; cells with Visible 0 are ignored.
 *
 * Output 0: one polyline per loop in world space; a closed one repeats its first point id at the end. Point
 * arrays:
 * - MeshVertices, vtkIdType[3], and MeshWeights, double[3]: what the point hangs on, a silhouette point's or
 *   a mesh edge's binding; -1 and 0 where it hangs on nothing,
 * - Normals, double[3], and NormalDotView, double: of the mesh there, zero where the point hangs on nothing,
 * - Display, double[2] [px]: the place on the smoothed loop,
 * - Offset, double[2] [px]: the point's own picture minus Display; interpolated between bound points. A point
 *   that hangs on nothing lies at Display + Offset, its depth interpolated between bound points.
 *
 * Cell arrays: CurveId, int: the cell's index; Visible, unsigned char: 1; Hole, unsigned char: 1 for a loop
 * round uncovered pixels.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke. A mesh without
 * points gives an empty output silently.
 *
 * Deterministic, for any number of threads. Cost: triangles times their height in pixels; the loops are kept
 * while mesh and view stand (GetTraceCount).
 *
 * @sa vtkOversketchVisibility, vtkOversketchMatch
 */
#ifndef vtkOversketchOutline_h
#define vtkOversketchOutline_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchOutline : public vtkOversketchFilter
{
public:
  static vtkOversketchOutline* New();
  vtkTypeMacro(vtkOversketchOutline, vtkOversketchFilter);

  /**
   * The stroke whose view is used, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  /**
   * The curves to attach, on port 2.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(2, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(2, curves); }

  /**
   * How often the loops have been traced since the filter was made.
   */
  vtkIdType GetTraceCount();

protected:
  vtkOversketchOutline();
  ~vtkOversketchOutline() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchOutline(const vtkOversketchOutline&) = delete;
  void operator=(const vtkOversketchOutline&) = delete;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
