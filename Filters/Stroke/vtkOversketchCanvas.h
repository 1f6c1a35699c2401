/**
 * @class vtkOversketchCanvas
 * @brief the strokes of a drawing as curves on the plane that they are drawn on
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.1, Fig. 4: samples go from the window to the plane
 * z = 0, so that panning and zooming change no stroke. Each is seen in the view that its stroke carries,
 * which may be zoomed, tilted or in perspective; a sample whose view only grazes the plane is dropped. The
 * paper does not say when a stroke is closed: here, when its ends are at most 0.02 of the canvas's longest
 * side and a fifth of its own length apart.
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates with cell arrays ViewTransform,
 * ProjectionTransform and ViewportSize. Any number of strokes, each with its own view. One that repeats its
 * first point id at the end is closed; so is one of which a cell array Closed, which may be absent, says 1;
 * one of which it says 0 is open. Jitter is not dropped.
 * Input 1 (Picture, vtkImageData, optional): one slice, drawn at z = 0; its samples are squares round their
 * centres. Scalars are not read.
 *
 * The canvas is the rectangle of the picture; without one that of the strokes' field array Canvas (x and y of
 * the lower left corner, width, height); else the viewport of the view, where all strokes share one that is
 * orthographic and faces the plane, upright.
 *
 * Output 0 (Curves): one polyline per stroke, in their order, world space, z = 0, double; a closed one
 * repeats its first point id at the end. A stroke that leaves the canvas or is a mere dot is handed on as it
 * is, for vtkOversketchClassify to reject. It has
 * - point array ArcLength, double: from the curve's first point [world],
 * - the point arrays of the strokes (Pressure, Time),
 * - cell array StrokeId, int: the stroke's cell,
 * - cell array Closed, int: 1 for a closed one, else 0,
 * - the cell arrays of the strokes (Magnetic, SnapRadius, Treatment) but the view and Moved, so that nothing
 *   takes curves for strokes,
 * - field array Canvas, double[4]: x and y of the lower left corner, width, height [world].
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray; BadStroke, naming the stroke, when
 * there is no polyline or there are other cells, for a stroke without samples, with one that is not finite, a
 * view that is none or shows no sample on the plane; where there is no canvas; for a picture of several
 * slices, without samples, with a direction matrix other than the identity or a spacing that is not positive.
 * Strokes without points give an empty output silently.
 *
 * Deterministic. Cost: linear in the samples. The result stays, as the same arrays, while points, views,
 * Closed and the rectangle do; other cell arrays change none of them.
 *
 * @sa vtkOversketchRedraw vtkOversketchMagneticSnap vtkOversketchResample
 */
#ifndef vtkOversketchCanvas_h
#define vtkOversketchCanvas_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchCanvas : public vtkOversketchFilter
{
public:
  static vtkOversketchCanvas* New();
  vtkTypeMacro(vtkOversketchCanvas, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The picture that is drawn over, on port 1.
   */
  void SetPictureConnection(vtkAlgorithmOutput* picture) { this->SetInputConnection(1, picture); }
  void SetPictureData(vtkDataObject* picture) { this->SetInputData(1, picture); }

  /**
   * How many times strokes have been projected: executions that the kept result did not answer.
   */
  vtkGetMacro(ProjectionCount, vtkIdType);

protected:
  vtkOversketchCanvas();
  ~vtkOversketchCanvas() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType ProjectionCount = 0;
};

#endif
