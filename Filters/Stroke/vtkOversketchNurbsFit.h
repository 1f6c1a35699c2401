/**
 * @class vtkOversketchNurbsFit
 * @brief strokes as splines in the picture
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.2 and 4.1: samples
 * nearer than 10 px to each other are dropped, the others are control points of a spline of degree 3, which
 * begins and ends at the first and the last sample. The degree and the knots are not told there.
 *
 * Departures: the thesis builds the spline in space; here it is one in the picture, since in space it leaps
 * through the air wherever a part of the model hides another (FitSpace). A closed spline is periodic
 * (Periodic) and does not cross itself (CutLoops).
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates [px from the viewport's lower left
 * corner, y up]; z is ignored. Any number of strokes, from any views, open or closed; a closed one repeats
 * its first point id at the end. With FitSpace World they carry the view that they were drawn in.
 * Input 1 (Mesh, optional): triangle mesh, vtkPolyData, that FitSpace World lays the samples on.
 *
 * Output 0 (Curves): one polyline per stroke, a place of the spline each half pixel, z = 0, double; a closed
 * one repeats its first point id. Point arrays: CurveT, double: the spline's parameter, 0 to 1, of a closed
 * one below 1; those of the strokes, mixed as the control points are. Cell and field data, the view arrays
 * among them, are passed. Field arrays, curve after curve:
 * - NurbsDegree, int, and NurbsPointCount, int: the number of control points, one of each per curve,
 * - NurbsPoints, double[2]: control points [px], of a periodic curve its last ones are its first ones again;
 *   with FitSpace World double[3], in space,
 * - NurbsKnots, double: clamped to 0 and 1, of a periodic curve evenly running on, NurbsPointCount +
 *   NurbsDegree + 1 of them per curve.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming the stroke, when there is no
 * polyline or there are other cells, for a stroke with fewer than two samples that differ, one that is not
 * finite or over 1e5 px long, and for a closed one of fewer than three control points; with FitSpace World
 * also for one without a view or of which nothing lies on the mesh, and BadMesh, where there is none. A
 * polydata without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the strokes' length; of closed ones the square of the control points. With
 * FitSpace World the first stroke on a mesh builds its ray scene, as for vtkOversketchProjectCurve.
 *
 * @sa vtkOversketchProjectCurve vtkOversketchResample
 */
#ifndef vtkOversketchNurbsFit_h
#define vtkOversketchNurbsFit_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchNurbsFit : public vtkOversketchFilter
{
public:
  static vtkOversketchNurbsFit* New();
  vtkTypeMacro(vtkOversketchNurbsFit, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FitSpaceType
  {
    Picture = 0,
    World = 1
  };

  /**
   * The mesh that is drawn on, on port 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  ///@{
  /**
   * Where control points lie: in the picture (Picture, default), or, as published, where the samples' lines
   * of sight meet the mesh (World). There a sample beside the mesh, of which the thesis does not speak, is as
   * far away as the sample of its stroke nearest to it that meets it; places of the output are where the
   * spline in space is seen.
   */
  vtkSetClampMacro(FitSpace, int, Picture, World);
  vtkGetMacro(FitSpace, int);
  void SetFitSpaceToPicture() { this->SetFitSpace(Picture); }
  void SetFitSpaceToWorld() { this->SetFitSpace(World); }
  ///@}

  ///@{
  /**
   * Samples nearer than this to the last one kept are dropped; the last one replaces it, and of a closed
   * stroke those this near to the first go [px, >= 0, default 10].
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Close every stroke, as a boundary is, wherever it ends [default off: those that repeat their first point
   * id are closed].
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

  ///@{
  /**
   * Pass through the samples, which is what Sec. 4.1 calls fitted; off, samples are control points, as Sec.
   * 3.2 has it, and a shaky hand is smoothed [default off].
   */
  vtkSetMacro(Interpolate, bool);
  vtkGetMacro(Interpolate, bool);
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  ///@{
  /**
   * A closed spline has no corner where it begins [default on; off, as published, the first control point is
   * the last one too].
   */
  vtkSetMacro(Periodic, bool);
  vtkGetMacro(Periodic, bool);
  vtkBooleanMacro(Periodic, bool);
  ///@}

  ///@{
  /**
   * Where the control points' polygon of a closed stroke crosses itself its shorter part is cut out [default
   * on; off as published].
   */
  vtkSetMacro(CutLoops, bool);
  vtkGetMacro(CutLoops, bool);
  vtkBooleanMacro(CutLoops, bool);
  ///@}

protected:
  vtkOversketchNurbsFit();
  ~vtkOversketchNurbsFit() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int FitSpace = Picture;
  double Spacing = 10.0;
  bool Closed = false;
  bool Interpolate = false;
  bool Periodic = true;
  bool CutLoops = true;
};

#endif
