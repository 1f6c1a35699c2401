/**
 * @class vtkOversketchOneStrokeWidget
 * @brief draw a stroke over a mesh and the mesh follows; take hold of the stroke again and it follows on
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 2, Figs. 1 and 2. A pen over a mesh
 * (vtkOversketchLiveStrokeWidget, whose header says what the hand does) and the system
 * (vtkOversketchOneStroke), for any vtkRenderWindowInteractor.
 *
 * While the pen is down the section of the silhouette that the stroke takes hold of is shown (blue) under the
 * stroke (red), over the last frame. A stroke that takes hold of nothing leaves the mesh as it was and stays
 * as the live stroke, to be corrected.
 *
 * While the live stroke is moved the mesh is a preview: the last deformation with all its targets moved
 * (vtkOversketchOneStroke::Drag); what is shown after the release is the system's own result on the moved
 * stroke. The curves that the section is found on are made when the cursor first moves in a view, at the
 * latest when the pen goes down; the section is found once a frame.
 *
 * @sa vtkOversketchLiveStrokeWidget, vtkOversketchOneStroke
 */
#ifndef vtkOversketchOneStrokeWidget_h
#define vtkOversketchOneStrokeWidget_h

#include "OversketchWidgetsOneStrokeModule.h" // For export macro
#include "vtkOversketchLiveStrokeWidget.h"

class vtkOversketchOneStroke;

class OVERSKETCHWIDGETSONESTROKE_EXPORT vtkOversketchOneStrokeWidget : public vtkOversketchLiveStrokeWidget
{
public:
  static vtkOversketchOneStrokeWidget* New();
  vtkTypeMacro(vtkOversketchOneStrokeWidget, vtkOversketchLiveStrokeWidget);

  ///@{
  /**
   * The system that runs, for its parameters: after a change the mesh follows with the next render. One of
   * the host's may be set; the widget connects its inputs.
   */
  void SetOneStroke(vtkOversketchOneStroke* system);
  vtkOversketchOneStroke* GetOneStroke();
  ///@}

protected:
  vtkOversketchOneStrokeWidget();
  ~vtkOversketchOneStrokeWidget() override;
};

#endif
