/**
 * @class vtkOversketchRedraw
 * @brief strokes drawn over a drawing correct its curves
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.1: a stroke drawn over another one corrects it
 * (over-sketching; the paper gives no algorithm). Here the curve of least mean distance to the new stroke is
 * corrected where ends of the new one are within 0.02 of the canvas's longest side of it: with both, the arc
 * between their feet is replaced, on a closed curve the one nearer to the new stroke; with one, on an open
 * curve, all from its foot to the nearer free end. Else the stroke is a new one. Joints are blended as
 * Kernels/Stroke/resketch.h says.
 *
 * Input 0 (Curves): curves of vtkOversketchCanvas. Field array Canvas.
 * Input 1 (Corrections, optional): stroke polydata as vtkOversketchCanvas takes them, in display coordinates,
 * each with its view; any number, applied in their order.
 *
 * Output 0 (Curves): the curves in their order, then new ones; points in world space, z = 0, double; samples
 * outside the blends stay as they are. Without corrections, the input. It has
 * - point array ArcLength, and those that curves and corrections have both (Pressure, Time), blended as the
 *   places are,
 * - cell arrays StrokeId and Closed, and those of the curves: of a new stroke what its correction says, else
 * 0, of SnapRadius 10. Magnetic, SnapRadius and Treatment are made where only corrections have them,
 * - the field arrays of the curves.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Canvas or a correction's view;
 * BadStroke, naming the stroke or the correction, as vtkOversketchCanvas, and for a correction without two
 * places that differ. Curves without points give an empty output silently.
 *
 * Deterministic. Cost: the samples of the corrections times the square root of the curves'. The result stays,
 * as the same arrays, while all that is read does.
 *
 * @sa vtkOversketchCanvas
 */
#ifndef vtkOversketchRedraw_h
#define vtkOversketchRedraw_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchRedraw : public vtkOversketchFilter
{
public:
  static vtkOversketchRedraw* New();
  vtkTypeMacro(vtkOversketchRedraw, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The strokes drawn over the drawing, on port 1.
   */
  void SetCorrectionsConnection(vtkAlgorithmOutput* strokes) { this->SetInputConnection(1, strokes); }
  void SetCorrectionsData(vtkPolyData* strokes) { this->SetInputData(1, strokes); }

  /**
   * How many times corrections have been applied: executions that the kept result did not answer.
   */
  vtkGetMacro(CorrectionCount, vtkIdType);

protected:
  vtkOversketchRedraw();
  ~vtkOversketchRedraw() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType CorrectionCount = 0;
};

#endif
