/**
 * @class vtkOversketchArrange
 * @brief strokes that cross, span what they are drawn in, or bound it together, as curves that do not cross
 *
 * Source: "Image-Assisted Modeling from Sketches" names crossing and spanning strokes, and boundaries of
 * several strokes, as future work and has them fail. Here, by our choice (Kernels/Planar/arrange.h), all
 * strokes get common samples where they meet, and the faces between them tell what bounds what. With this
 * step before vtkOversketchClassify, an outline may be drawn in several strokes, bodies may overlap and
 * strokes may cross the whole of one: what they divide are regions of one object.
 *
 * Input 0 (Curves): curves of vtkOversketchCanvas, magnetic or not, resampled. Field array Canvas.
 *
 * Output 0 (Curves): curves in the order of the strokes that they are parts of, closed ones with their first
 * point id repeated, and
 * - point array ArcLength, double, of each curve,
 * - point array Node, unsigned char: 1 where it meets another one,
 * - cell array StrokeId, int: the stroke that the curve is a part of, of an outline of several the first, by
 *   the input's StrokeId where it has one; Closed,
 * - the stroke's other cell arrays and the field arrays. Other point arrays are not passed.
 * A stroke that meets nothing comes out as it was.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming a stroke and the place, where two
 * parts of an outline hang together by one point; for a stroke without a finite sample, cells that are no
 * polylines, a canvas without extent; MissingArray without Canvas. Curves without points give an empty output
 * silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: some 10 ms for a dozen strokes. The
 * result stays, as the same arrays, while points, polylines, canvas and parameters do.
 *
 * @sa vtkOversketchResample vtkOversketchClassify
 */
#ifndef vtkOversketchArrange_h
#define vtkOversketchArrange_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchArrange : public vtkOversketchFilter
{
public:
  static vtkOversketchArrange* New();
  vtkTypeMacro(vtkOversketchArrange, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Open ends so near another stroke go on to it, and ends that run past one by less are cut off, both by at
   * most a fourth of their stroke: share of the canvas's longest side [0 to 0.1, default 0.02, as strokes
   * close; 0: ends stay where they were drawn].
   */
  vtkSetClampMacro(JoinDistance, double, 0.0, 0.1);
  vtkGetMacro(JoinDistance, double);
  ///@}

  /**
   * How many times strokes have been arranged: executions that the kept result did not answer.
   */
  vtkGetMacro(ArrangementCount, vtkIdType);

protected:
  vtkOversketchArrange() = default;
  ~vtkOversketchArrange() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double JoinDistance = 0.02;
  vtkIdType ArrangementCount = 0;
};

#endif
