/**
 * @class vtkOversketchStrokeThinning
 * @brief fewer samples: those too near to the one before are left out
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-A: a sample within a
 * threshold of earlier samples is discarded. The paper gives no threshold; here it is Spacing, measured from
 * the last sample kept only, or a stroke that crosses itself would lose samples there. Departure: the sample
 * where the pen was lifted always stays, so that a stroke ends where the hand ended it.
 *
 * Input 0 (Strokes): stroke polydata: polylines in display coordinates [px from the viewport's lower left
 * corner, y up]; z is ignored. Any number of strokes, from any views, open or closed; a closed one repeats
 * its first point id at the end.
 *
 * Output 0 (Strokes): the same strokes with the samples that stay, z = 0. Point arrays go with their samples;
 * cell and field data, the view arrays among them, are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke, naming the stroke, when there is no
 * polyline or there are other cells, and for a stroke with fewer than two samples or one that is not finite.
 * A polydata without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the samples.
 *
 * @sa vtkOversketchChaikin vtkOversketchSurfaceStroke
 */
#ifndef vtkOversketchStrokeThinning_h
#define vtkOversketchStrokeThinning_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchStrokeThinning : public vtkOversketchFilter
{
public:
  static vtkOversketchStrokeThinning* New();
  vtkTypeMacro(vtkOversketchStrokeThinning, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Samples nearer than this to the last one kept are left out [px, >= 0, default 4].
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

protected:
  vtkOversketchStrokeThinning() = default;
  ~vtkOversketchStrokeThinning() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Spacing = 4.0;
};

#endif
