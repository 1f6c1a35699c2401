/**
 * @class vtkOversketchScanFill
 * @brief the texels of the disc that lie in areas drawn round them
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.4.1, area selection:
 * scan-line polygon fill by the odd-parity rule, of strokes that may cross themselves. Of each stroke the
 * last pixel is joined with the first. Kernels/Shading/scan_fill.h has the rules for pixels on an edge, and
 * where the printed text contradicts itself. Left open there, and chosen here: pixels are the disc's texels,
 * not the window's, so a selection stays when the window changes.
 *
 * Input 0 (Strokes): polylines, one for each area; with the cell arrays of a view (Filters/Stroke/README.md)
 * [display px] drawn over the disc, without them [disc] on it.
 *
 * Output 0 (Areas): the strokes on the disc, z = 0, closed, in their order, with the input's cell arrays but
 * those of the view.
 * Output 1 (Mask, vtkImageData): Resolution x Resolution samples over the disc, x and y from -1 to 1, with
 * the unsigned char point array Area, its scalars, of one component for each stroke: 1 inside.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming stroke and sample, for cells that
 * are no polylines, samples that are not finite, do not meet the disc's plane or lie far outside it, and for
 * more than 64 strokes; MissingArray for a part of a view. Strokes of fewer than three distinct texels select
 * nothing. Strokes without points give empty outputs silently.
 *
 * Deterministic. Cost: linear in samples and texels. Mask and areas stay, as the same arrays, while strokes
 * and Resolution do.
 *
 * @sa vtkOversketchShadingLevels
 */
#ifndef vtkOversketchScanFill_h
#define vtkOversketchScanFill_h

#include "OversketchFiltersShadingModule.h" // For export macro
#include "vtkOversketchFilter.h"

class vtkImageData;

class OVERSKETCHFILTERSSHADING_EXPORT vtkOversketchScanFill : public vtkOversketchFilter
{
public:
  static vtkOversketchScanFill* New();
  vtkTypeMacro(vtkOversketchScanFill, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mask, on port 1.
   */
  vtkImageData* GetMaskOutput();

  ///@{
  /**
   * Texels along each side of the mask, preferably a power of two [16 to 2048, default 512].
   */
  vtkSetClampMacro(Resolution, int, 16, 2048);
  vtkGetMacro(Resolution, int);
  ///@}

  /**
   * How many times masks have been filled: executions that the kept one did not answer.
   */
  vtkGetMacro(FillCount, vtkIdType);

protected:
  vtkOversketchScanFill();
  ~vtkOversketchScanFill() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Resolution = 512;
  vtkIdType FillCount = 0;

  struct Cache;
};

#endif
