/**
 * @class vtkOversketchViewStroke
 * @brief the strokes that polylines in space are, seen by a camera
 *
 * For hosts whose own tools draw in space (ParaView's polyline and spline sources): each polyline is
 * projected to display coordinates and gets the view that it was projected with, as if it had been drawn over
 * that picture. Several make a drawing. The camera is told in the terms of vtkCamera, by the names of
 * ParaView's render view.
 *
 * Input 0 (Polyline): vtkPolyData of one or more polylines, in world space.
 * Output 0: the strokes, a cell for each polyline in their order: points in display coordinates [px from the
 * viewport's lower left corner, y up], double, z = 0; cell arrays ViewTransform, ProjectionTransform (double,
 * 16 components, row-major) and ViewportSize (int, 2 components). Arrays of the input are dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke when there are other cells than
 * polylines, a point is not finite or lies at or behind the eye (the message names it), or the camera sees
 * nothing (focal point at the position, view up along the line of sight, viewport without size). A polydata
 * without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the points.
 *
 * @sa vtkOversketchOneStroke vtkOversketchStrokeFilter
 */
#ifndef vtkOversketchViewStroke_h
#define vtkOversketchViewStroke_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchViewStroke : public vtkOversketchFilter
{
public:
  static vtkOversketchViewStroke* New();
  vtkTypeMacro(vtkOversketchViewStroke, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the eye is [world, default (0, 0, 1)].
   */
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  ///@}

  ///@{
  /**
   * Point that it looks at [world, default (0, 0, 0)].
   */
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  ///@}

  ///@{
  /**
   * Which way is up in the picture [world, default (0, 1, 0)].
   */
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  ///@}

  ///@{
  /**
   * Full height of what a perspective camera sees, an angle [degrees, 0.01 to 179.9, default 30].
   */
  vtkSetClampMacro(CameraViewAngle, double, 0.01, 179.9);
  vtkGetMacro(CameraViewAngle, double);
  ///@}

  ///@{
  /**
   * Half the height of what a parallel camera sees [world, >= 1e-30, default 1].
   */
  vtkSetClampMacro(CameraParallelScale, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(CameraParallelScale, double);
  ///@}

  ///@{
  /**
   * A parallel camera; off: a perspective one [default off].
   */
  vtkSetMacro(CameraParallelProjection, bool);
  vtkGetMacro(CameraParallelProjection, bool);
  vtkBooleanMacro(CameraParallelProjection, bool);
  ///@}

  ///@{
  /**
   * Width and height of the viewport [px, default 800 and 600].
   */
  vtkSetVector2Macro(ViewSize, int);
  vtkGetVector2Macro(ViewSize, int);
  ///@}

protected:
  vtkOversketchViewStroke() = default;
  ~vtkOversketchViewStroke() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double CameraPosition[3] = { 0.0, 0.0, 1.0 };
  double CameraFocalPoint[3] = { 0.0, 0.0, 0.0 };
  double CameraViewUp[3] = { 0.0, 1.0, 0.0 };
  double CameraViewAngle = 30.0;
  double CameraParallelScale = 1.0;
  bool CameraParallelProjection = false;
  int ViewSize[2] = { 800, 600 };
};

#endif
