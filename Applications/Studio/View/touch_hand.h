// A screen that is touched: one finger draws as the left button does, two turn the model and zoom; and how a
// pen is pressed.
#ifndef oversketch_applications_studio_view_touch_hand_h
#define oversketch_applications_studio_view_touch_hand_h

#include <QEvent>
#include <QObject>
#include <QPointF>

#include <functional>

class QTabletEvent;
class QTouchEvent;
class QWidget;

namespace oversketch_studio
{

class TouchHand : public QObject
{
  Q_OBJECT

public:
  // The acts of a view: whether the finger draws or holds something, which Escape gives up; zoom
  // by a factor about a place; take the pressure [0 to 1].
  struct Acts
  {
    std::function<bool()> holds;
    std::function<void(double factor, const QPointF& about)> zoom;
    std::function<void(double pressure)> press;
  };
  // Takes a view's touches, and the pressure of its pen, from here on.
  TouchHand(QWidget* view, Acts acts);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Doing
  {
    Nothing,
    Waiting, // one finger that has not moved yet
    Drawing,
    Two, // fingers that have not moved yet
    Turning,
    Zooming
  };
  void pressed(const QTabletEvent& event);
  void touched(const QTouchEvent& event);
  void oneFinger(const QPointF& at);
  void twoFingers(const QPointF& middle, double apart);
  void lift();
  void giveUp();
  void send(QEvent::Type type, Qt::MouseButton button, const QPointF& at);

  QWidget* View;
  Acts Act;
  Doing Does = Doing::Nothing;
  QPointF Began, Last;
  double Apart = 0.0; // that two fingers were when they began, and last
};

} // namespace oversketch_studio
#endif
