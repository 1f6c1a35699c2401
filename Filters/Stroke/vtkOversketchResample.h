/**
 * @class vtkOversketchResample
 * @brief curves of a drawing at samples of nearly uniform distance
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.1: extraneous points are discarded, and points put
 * between widely spaced ones. The paper gives no distance: here it is h, 0.005 of the canvas's longest side.
 * Samples nearer than h / 2 to the last one kept are dropped, both ends kept; longer gaps than h are divided
 * evenly. What is kept stays where it is, so corners do. Departure: samples that were dropped stay where the
 * curves would cross, or touch, without them though they do not as drawn, as at the tip of a thin limb.
 *
 * Input 0 (Curves): curves of vtkOversketchCanvas, magnetic or not. Field array Canvas.
 *
 * Output 0 (Curves): the same curves at the new samples: points in world space, z = 0, double, point array
 * ArcLength; other point arrays are interpolated, cell and field arrays passed. A curve without two places
 * that differ, and a closed one of which fewer than three samples would be left, stay as they are.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Canvas; BadStroke, naming the
 * stroke, for cells that are no polylines, one without samples, with one that is not finite, or so long that
 * ten million samples would come of it. Curves without points give an empty output silently.
 *
 * Deterministic; a second run changes nothing. Cost: linear in the samples. The result stays, as the same
 * arrays, while points, point arrays and canvas do.
 *
 * @sa vtkOversketchCanvas vtkOversketchClassify
 */
#ifndef vtkOversketchResample_h
#define vtkOversketchResample_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchResample : public vtkOversketchFilter
{
public:
  static vtkOversketchResample* New();
  vtkTypeMacro(vtkOversketchResample, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How many times curves have been resampled: executions that the kept result did not answer.
   */
  vtkGetMacro(ResamplingCount, vtkIdType);

protected:
  vtkOversketchResample() = default;
  ~vtkOversketchResample() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType ResamplingCount = 0;
};

#endif
