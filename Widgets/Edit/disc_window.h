// The disc in a window of its own: its layers and its areas are changed there as on the model.
#ifndef oversketch_widgets_edit_disc_window_h
#define oversketch_widgets_edit_disc_window_h

#include "vtkNew.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkOversketchAreaSelectWidget;
class vtkOversketchLayerHandleWidget;
class vtkPolyData;
class vtkRenderer;

namespace oversketch
{

class DiscWindow
{
public:
  DiscWindow();
  ~DiscWindow();

  // Whose window has an interactor; null: none.
  void setRenderer(vtkRenderer* renderer);
  vtkRenderer* renderer() const;
  vtkOversketchLayerHandleWidget* layers() { return this->Layers; }
  vtkOversketchAreaSelectWidget* areas() { return this->Areas; }

  // Which of both the hand has; layers are seen in any case.
  void hold(bool layers, bool areas);
  void setRegion(vtkPolyData* mesh);
  // Shows what the model's own widgets show.
  void follow(vtkOversketchLayerHandleWidget* layers, vtkOversketchAreaSelectWidget* areas);

private:
  vtkNew<vtkOversketchLayerHandleWidget> Layers;
  vtkNew<vtkOversketchAreaSelectWidget> Areas;
  vtkWeakPointer<vtkRenderer> Window;
  vtkMTimeType SeenAreas = 0;
};

} // namespace oversketch
#endif
