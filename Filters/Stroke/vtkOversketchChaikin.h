/**
 * @class vtkOversketchChaikin
 * @brief smooth strokes: corners cut off by Chaikin's scheme
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-A: strokes are smoothed
 * by Chaikin's subdivision in the picture, before they are projected. Each pass puts a sample at a quarter
 * and at three quarters of every segment; their limit is the quadratic B-spline of the samples. The paper
 * leaves open, and here is chosen: the number of passes; an open stroke keeps its ends; a stroke that comes
 * back to its start becomes a ring. Departure: a stroke whose ends are nearer than 8 px is no ring
 * where they are half its length or more apart, which is a hook of a few pixels.
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates [px from the viewport's lower left
 * corner, y up]; z is ignored. Any number of strokes, from any views; one that repeats its first point id at
 * the end is closed.
 *
 * Output 0 (Strokes): one polyline per stroke, z = 0, a closed one repeating its first point id at the end.
 * Point arrays (Pressure, Time and any other) are cut as the places are; cell and field data, the view arrays
 * among them, are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming the stroke, when there is no
 * polyline or there are other cells, and for a stroke with fewer than two samples or one that is not finite.
 * A polydata without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the samples of the output, which double with each pass.
 *
 * @sa vtkOversketchStrokeThinning vtkOversketchSurfaceStroke
 */
#ifndef vtkOversketchChaikin_h
#define vtkOversketchChaikin_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchChaikin : public vtkOversketchFilter
{
public:
  static vtkOversketchChaikin* New();
  vtkTypeMacro(vtkOversketchChaikin, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Passes [0 to 6, default 2].
   */
  vtkSetClampMacro(Iterations, int, 0, 6);
  vtkGetMacro(Iterations, int);
  ///@}

protected:
  vtkOversketchChaikin() = default;
  ~vtkOversketchChaikin() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Iterations = 2;
};

#endif
