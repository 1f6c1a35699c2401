// Gestures that turn the model besides a drag of the middle button: two fingers on a trackpad, a pinch, and
// the left button while the space bar is held.
#ifndef oversketch_applications_studio_view_hand_gestures_h
#define oversketch_applications_studio_view_hand_gestures_h

class QEvent;
class QNativeGestureEvent;
class QWheelEvent;

namespace oversketch_studio
{

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

private:
  bool scroll(const QWheelEvent& event);
  bool pinch(const QNativeGestureEvent& event);

  Viewport* View;
  bool Space = false, Turns = false;
};

} // namespace oversketch_studio
#endif
