// A VTK window in a Qt widget. It draws one frame for all events that have come. Where the processor draws,
// its edges are smoothed when nothing moves any more.
#ifndef oversketch_applications_studio_view_frame_view_h
#define oversketch_applications_studio_view_frame_view_h

#include "vtkNew.h"

#include <QVTKOpenGLNativeWidget.h>

#include <optional>

class QTimer;
class vtkGenericOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderer;

namespace oversketch_studio
{

constexpr int edgeSamples = 4; // a pixel, where edges are smoothed
constexpr int restTime = 200;  // ms without a frame, after which nothing moves any more

// Tells whether a window's pictures are drawn by the processor (Mesa's llvmpipe or softpipe): ambient
// occlusion and several samples a pixel would make each frame wait. Asks the context, which must be there.
bool drawsOnProcessor(vtkRenderWindow* window);

class FrameView : public QVTKOpenGLNativeWidget
{
public:
  explicit FrameView(QWidget* parent = nullptr);
  ~FrameView() override;

  vtkRenderer* renderer() const { return this->Renderer; }
  // A frame with the next turn of the event loop, and at once.
  void renderSoon();
  virtual void renderNow();

protected:
  // The ground of a dark window or a light one.
  void setGround(bool dark);
  // Whether the hand is at something: edges wait.
  virtual bool isHeld() const { return false; }
  // Whether a frame that is asked for waits for something that is to come.
  virtual bool awaits() const { return false; }
  virtual void renderSmooth();
  void paintGL() override;
  bool onProcessor(); // false as long as there is no context to ask

  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  QTimer* const Rest; // since the last frame
  bool RenderWaits = false;

private:
  void asked(); // by VTK

  std::optional<bool> OnProcessor;
  unsigned long Observer = 0;
};

} // namespace oversketch_studio
#endif
