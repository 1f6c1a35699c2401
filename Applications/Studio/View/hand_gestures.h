// Gestures beside those of the tool in the hand. They turn the model as a drag of the middle button does: two
// fingers on a trackpad, a pinch, and the left button while the space bar is held. And with Shift the left
// button smooths the model that it is pressed on.
#ifndef oversketch_applications_studio_view_hand_gestures_h
#define oversketch_applications_studio_view_hand_gestures_h

#include "mesh_picker.h"

#include <Qt>

class QEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QWheelEvent;

namespace oversketch_studio
{

class Tool;
class Viewport;

class HandGestures
{
public:
  explicit HandGestures(Viewport* view)
    : View(view)
  {
  }

  // Two fingers, or a pinch. Returns whether the event was that.
  bool moves(QEvent* event);
  // The space bar, and the left button with it, which is the middle one then. Returns whether the event was
  // that.
  bool holds(QEvent* event);
  // The left button with Shift on the model, and beside what the tool would redraw with it: until it is let
  // go, the tool that smooths is in the hand. Returns whether the event was that.
  bool smooths(QEvent* event);

private:
  bool scroll(const QWheelEvent& event);
  bool pinch(const QNativeGestureEvent& event);
  Tool* smoother() const; // null: none is built
  bool begins(const QMouseEvent& press);
  void send(const QMouseEvent& like, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

  Viewport* View;
  oversketch::MeshPicker Picker;
  Tool* Rests = nullptr; // the tool that waits while another one smooths
  bool Space = false, Turns = false;
};

} // namespace oversketch_studio
#endif
