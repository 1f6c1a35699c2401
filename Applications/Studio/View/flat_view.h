// A view of something flat, without a camera to turn. It draws one frame for all events that have come. Where
// the processor draws (drawsOnProcessor), its edges are smoothed when nothing moves any more.
#ifndef oversketch_applications_studio_view_flat_view_h
#define oversketch_applications_studio_view_flat_view_h

#include "vtkNew.h"

#include <QVTKOpenGLNativeWidget.h>

#include <optional>

class QTimer;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace oversketch_studio
{

class FlatView : public QVTKOpenGLNativeWidget
{
public:
  explicit FlatView(QWidget* parent = nullptr);
  ~FlatView() override;

  vtkRenderer* renderer() { return this->Renderer; }

protected:
  // Whether the hand is at something: edges wait.
  virtual bool isHeld() const { return false; }
  void paintGL() override;

private:
  void renderSoon();
  void renderNow();
  void renderSmooth();

  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkCallbackCommand> Observer;
  QTimer* const Rest;              // since the last frame
  std::optional<bool> OnProcessor; // once there is a context to ask
  bool RenderWaits = false;
};

} // namespace oversketch_studio
#endif
