// The last frame of a window, kept as a picture to draw over: while it is frozen, the window's renderers stay
// as they are and a frame costs the picture and what is drawn over it, however large the scene is.
#ifndef oversketch_widgets_pen_last_frame_h
#define oversketch_widgets_pen_last_frame_h

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkPlaneSource;
class vtkRenderWindow;
class vtkTexture;
class vtkTexturedActor2D;

namespace oversketch
{

class LastFrame
{
public:
  LastFrame();
  ~LastFrame();

  // Takes the picture that the window shows and switches its renderers' drawing off. False, and nothing
  // changed, when the picture could not be read.
  bool freeze(vtkRenderWindow* window);
  // Switches on again what freeze() switched off. The next frame is a full one.
  void thaw();
  bool frozen() const { return this->Frozen; }
  // True while the window has the size that it was frozen with.
  bool fits() const;
  // Covers the whole window, above all others; add to it what is to be drawn over the picture.
  vtkRenderer* overlay() { return this->Overlay; }

private:
  vtkNew<vtkRenderer> Overlay;
  vtkNew<vtkTexture> Texture;
  vtkNew<vtkTexturedActor2D> Picture;
  vtkNew<vtkPlaneSource> Rectangle;
  vtkWeakPointer<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Off;
  int Layers = 1, Size[2] = { 0, 0 };
  bool Frozen = false;
};

} // namespace oversketch
#endif
