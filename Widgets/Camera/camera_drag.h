// A turn, a pan or a zoom on its way: always from the press, so that a way there and back again ends where it
// began.
#ifndef oversketch_widgets_camera_camera_drag_h
#define oversketch_widgets_camera_camera_drag_h

#include "camera_state.h"
#include "mesh_picker.h"

class vtkRenderer;

namespace oversketch
{

class CameraDrag
{
public:
  enum class Kind
  {
    Trackball, // a turn that keeps the picked point under the cursor
    Turntable, // an upright one about the picked point
    Pan,
    Zoom
  };
  // The button that holds it is the caller's number.
  CameraDrag(Kind kind,
    int button,
    double x,
    double y,
    vtkRenderer* in,
    MeshPicker& picker,
    const FirstView& first,
    int up); // the world's axis that is: 1 for y, 2 for z

  int button() const { return this->Button; }
  // The hand is at a display position.
  void move(double x, double y, FirstView& first);
  // The camera as it was.
  void takeBack(vtkCamera* camera) const { this->AtPress.putInto(camera); }
  bool hasMoved() const { return this->Moved; }

private:
  Kind What;
  int Up, Button;
  double X, Y, Height, Zoom; // px
  CameraState AtPress, From; // as it was, and as the drag takes it
  SightLines Sight;
  Line Pressed;
  Eigen::Vector3d Anchor, Pivot; // the point that stays under the cursor; that of a turn
  bool Moved = false;
};

} // namespace oversketch
#endif
