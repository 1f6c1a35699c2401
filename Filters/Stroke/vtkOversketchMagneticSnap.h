/**
 * @class vtkOversketchMagneticSnap
 * @brief magnetic strokes of a drawing move to the edges of the picture under them
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.1, Fig. 3: intelligent scissors that search within
 * a fixed distance of the stroke, between seeds of its polyline approximation (tolerance 0.05 of the canvas's
 * longest side), and replace it only where edges are strong; elsewhere what was drawn stays. Corridor,
 * weights and thresholds are open there; Kernels/Stroke/livewire.h says what they are here. Departures: an
 * edge counts only where it runs along the stroke (within 45 degrees); what was replaced is smoothed (by a
 * deviation of 1 px), since stairs of pixels breed false corners; and paths are looked for together, near the
 * stroke, along edges of colours, since the strongest edge of the brightness within reach is often another
 * one.
 *
 * Input 0 (Curves): curves of vtkOversketchCanvas. Cell arrays Magnetic, without which no stroke is, and
 * SnapRadius, half the corridor's width [px of the picture; without it 10, less than 3 counts as 3]. Field
 * array Canvas.
 * Input 1 (Picture, vtkImageData, optional): one slice of 8 or 16 bits: grey, grey and alpha, RGB, RGB and
 * alpha; transparent pixels count as they look on white. Without magnetic strokes it is not needed.
 *
 * Output 0 (Curves): the curves in their order; points in world space, z = 0, double: those on edges found,
 * the others as they were to the bit. It has
 * - point array Snapped, unsigned char: 1 on an edge found, else 0,
 * - point array ArcLength, and those of the curves, interpolated,
 * - the cell and field arrays of the curves.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Canvas, without the picture's
 * scalars, or for Magnetic or SnapRadius of another size; BadStroke for a picture of other numbers, a
 * magnetic stroke without a picture, and as vtkOversketchCanvas. Curves without points give an empty output
 * silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: the edges of a picture, once, some
 * 20 ms for a million pixels, of colours some 50; then the corridor's pixels. Edges stay while the picture's
 * scalars do, a stroke's result while stroke, picture and parameters do.
 *
 * @sa vtkOversketchCanvas vtkOversketchResample
 */
#ifndef vtkOversketchMagneticSnap_h
#define vtkOversketchMagneticSnap_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchMagneticSnap : public vtkOversketchFilter
{
public:
  static vtkOversketchMagneticSnap* New();
  vtkTypeMacro(vtkOversketchMagneticSnap, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The picture that is drawn over, on port 1.
   */
  void SetPictureConnection(vtkAlgorithmOutput* picture) { this->SetInputConnection(1, picture); }
  void SetPictureData(vtkDataObject* picture) { this->SetInputData(1, picture); }

  ///@{
  /**
   * As the paper prints it: edges count at any angle, nothing is smoothed, and each part runs between the
   * strongest edges of the brightness beside its two seeds. Default off.
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * Finds the edges of the picture on port 1 now, so that the first stroke need not wait for them. What is
   * wrong with the picture is said when a stroke needs it.
   */
  void Prepare();

  ///@{
  /**
   * How many times edges of a picture have been found, and how many strokes have been searched for:
   * executions that kept ones did not answer.
   */
  vtkGetMacro(EdgeCount, vtkIdType);
  vtkGetMacro(SnapCount, vtkIdType);
  ///@}

protected:
  vtkOversketchMagneticSnap();
  ~vtkOversketchMagneticSnap() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool AsPublished = false;
  vtkIdType EdgeCount = 0;
  vtkIdType SnapCount = 0;

  struct Cache;
};

#endif
