/**
 * @class vtkOversketchTrace
 * @brief the outline of a thing in a picture, and those of its holes, as strokes of a drawing
 *
 * For who would rather click on a cut-out, a silhouette or an evenly coloured thing than draw round it. It is
 * of no paper; Kernels/Raster/trace.h says which thing is meant and what is left out: whiskers that are
 * thinner than a hand draws, and holes as small.
 *
 * Input 0 (Picture, vtkImageData): one slice of 8 or 16 bits: grey, grey and alpha, RGB, RGB and alpha.
 *
 * Output 0 (Strokes): stroke polydata, closed, the outer rim first: as vtkOversketchDrawingWidget::GetDrawing
 * gives it. Points in px from the picture's lower left corner, y up, double. It has
 * - cell arrays ViewTransform, ProjectionTransform, ViewportSize: the picture's own view, which looks
 *   straight down and shows exactly the picture,
 * - cell array Magnetic, int: 0; SnapRadius, double: 10,
 * - cell array Treatment, int: 0 of the outer rim, Holes of the others,
 * - point arrays Pressure, float: 1; Time, double: 0.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without the picture's scalars;
 * BadStroke for scalars of another type or number of components, a place beyond the picture, where there is
 * nothing to trace, and for a picture as vtkOversketchCanvas. A picture without samples gives an empty output
 * silently.
 *
 * Deterministic: same result bit for bit for any number of threads. The result stays while scalars, place and
 * parameters do.
 *
 * @sa vtkOversketchCanvas vtkOversketchMagneticSnap vtkOversketchInflateDrawing
 */
#ifndef vtkOversketchTrace_h
#define vtkOversketchTrace_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchTrace : public vtkOversketchFilter
{
public:
  static vtkOversketchTrace* New();
  vtkTypeMacro(vtkOversketchTrace, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A place on the thing [px of the picture from its lower left corner, y up, default (-1, -1)]. Where x or y
   * is below 0 it is the largest thing.
   */
  vtkSetVector2Macro(Place, double);
  vtkGetVector2Macro(Place, double);
  ///@}

  /**
   * Fates of what a hole of the thing bounds, numbered as Treatment; Fill leaves their rims out.
   */
  enum HolesType
  {
    Fill = 0,
    Hole = 1,
    Tunnel = 2
  };

  ///@{
  /**
   * What becomes of the thing's holes [default Tunnel].
   */
  vtkSetClampMacro(Holes, int, Fill, Tunnel);
  vtkGetMacro(Holes, int);
  void SetHolesToFill() { this->SetHoles(Fill); }
  void SetHolesToHole() { this->SetHoles(Hole); }
  void SetHolesToTunnel() { this->SetHoles(Tunnel); }
  ///@}

  /**
   * How many times something has been traced: executions that the kept result did not answer.
   */
  vtkGetMacro(TraceCount, vtkIdType);

protected:
  vtkOversketchTrace();
  ~vtkOversketchTrace() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Place[2] = { -1.0, -1.0 };
  int Holes = Tunnel;
  vtkIdType TraceCount = 0;
};

#endif
