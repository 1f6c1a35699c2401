// The thesis's table of camera keys, and the list of it that is shown on screen.
#ifndef oversketch_widgets_camera_camera_keys_h
#define oversketch_widgets_camera_camera_keys_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace oversketch
{

// A move of the camera by a key, in steps.
struct CameraAction
{
  enum Kind
  {
    None,
    Spin,  // sign 1: the picture turns counter-clockwise
    Look,  // along (1) or against (-1) an axis
    Turn,  // about an axis: clockwise (1)
    Orbit, // axis 0: to the right (1) or left (-1); axis 1: up or down
    Pan,   // axis 0: right or left; 1: up or down; 2: in or out
    Zoom,  // in or out
    Reset,
    Center,
    ShowKeys,
    Quit
  };
  Kind kind = None;
  int sign = 1, axis = 0;
};

// The action of a key, by its X11 symbol and the state of Shift, never by the case of a letter: with Caps
// Lock a plain key gives a capital, and Shift with a digit gives another symbol on each layout.
CameraAction cameraAction(const std::string& keySymbol, bool shift);

// The text that is shown on screen: the mode, and a line for each drag and key; at most 26 lines of 58
// characters.
std::string cameraHelp(bool drawing);

// The list in a corner of a renderer, over what is drawn there.
class KeyList
{
public:
  KeyList();
  ~KeyList();

  // Null shows it nowhere.
  void show(vtkRenderer* in, const std::string& text);

private:
  vtkNew<vtkTextActor> Actor;
  vtkWeakPointer<vtkRenderer> In;
};

} // namespace oversketch
#endif
