/**
 * @class vtkOversketchStrokeFilter
 * @brief clean strokes: jitter dropped, sampled uniformly, unusable ones refused
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 2 leaves the pen's samples as they
 * come; but jitter corrupts arc lengths (Eq. 4) and D depends on the sampling (Eq. 3). So samples nearer than
 * MinimumSpacing to the last one kept are dropped (the first and the last sample stay), and the rest is
 * sampled anew at equal arc lengths.
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates [px from the viewport's lower left
 * corner, y up]; z is ignored. Any number of strokes, from any views. Cell array ViewportSize, int[2] [px],
 * is read where it is there.
 *
 * Output 0: one polyline per stroke, z = 0. Point arrays (Pressure, Time and any other) are interpolated in
 * arc length; cell and field data, the view arrays among them, are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming the stroke, when there is no
 * polyline or there are other cells, and for a stroke with fewer than two samples, with a sample that is not
 * finite, shorter than MinimumLength, longer than MaximumLength or 1e5 px, or closed. Closed means that its
 * ends are nearer than twice MinimumSpacing, or nearer than a tenth of its length while it ends within
 * 90 degrees of the direction it started in; a U round the tip of a limb comes back in the opposite direction
 * and passes. A polydata without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the samples.
 *
 * @sa vtkOversketchMatch, vtkOversketchTargets
 */
#ifndef vtkOversketchStrokeFilter_h
#define vtkOversketchStrokeFilter_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchStrokeFilter : public vtkOversketchFilter
{
public:
  static vtkOversketchStrokeFilter* New();
  vtkTypeMacro(vtkOversketchStrokeFilter, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Samples nearer than this to the last one kept are dropped [px, >= 0, default 2].
   */
  vtkSetClampMacro(MinimumSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumSpacing, double);
  ///@}

  ///@{
  /**
   * Arc length between samples of the output, up to rounding to an integer number of steps [px, >= 0.01,
   * default 2].
   */
  vtkSetClampMacro(Spacing, double, 0.01, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Shorter strokes are refused [px, >= 0, default 10].
   */
  vtkSetClampMacro(MinimumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumLength, double);
  ///@}

  ///@{
  /**
   * Refuse closed strokes [default on]. Off for who opens them, as vtkOversketchMatch does.
   */
  vtkSetMacro(RefuseClosed, bool);
  vtkGetMacro(RefuseClosed, bool);
  vtkBooleanMacro(RefuseClosed, bool);
  ///@}

  ///@{
  /**
   * Strokes that carry a viewport and are longer than so many of its diagonals are refused: scribbles, which
   * look like no outline; and those with a sample farther beside the viewport than that is large [>= 0,
   * default 8; 0 for neither, as published].
   */
  vtkSetClampMacro(MaximumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumLength, double);
  ///@}

protected:
  vtkOversketchStrokeFilter() = default;
  ~vtkOversketchStrokeFilter() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double MinimumSpacing = 2.0;
  double Spacing = 2.0;
  double MinimumLength = 10.0;
  bool RefuseClosed = true;
  double MaximumLength = 8.0;
};

#endif
