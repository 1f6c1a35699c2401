#include "hand_gestures.h"

#include "tool.h"
#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr double fingersOfZoom = 240.0; // px that two fingers go for a factor of e

} // namespace

bool HandGestures::moves(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Wheel:
      return this->scroll(*static_cast<QWheelEvent*>(event));
    case QEvent::NativeGesture:
      return this->pinch(*static_cast<QNativeGestureEvent*>(event));
    default:
      return false;
  }
}

// A mouse's wheel has no phases.
bool HandGestures::scroll(const QWheelEvent& event)
{
  if (event.phase() == Qt::NoScrollPhase)
  {
    return false;
  }
  const double ratio = this->View->devicePixelRatioF();
  const QPointF by =
    ratio * (event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8.0 : QPointF(event.pixelDelta()));
  vtkOversketchInteractorStyle* camera = this->View->camera();
  if (event.modifiers() & Qt::ControlModifier)
  {
    this->View->zoomAt(std::exp(by.y() / ratio / fingersOfZoom), event.position());
  }
  else if (event.modifiers() & Qt::ShiftModifier)
  {
    camera->PanBy(by.x(), -by.y());
  }
  else
  {
    camera->TurnBy(by.x(), -by.y());
  }
  return true;
}

bool HandGestures::pinch(const QNativeGestureEvent& event)
{
  if (event.gestureType() != Qt::ZoomNativeGesture)
  {
    return false;
  }
  this->View->zoomAt(1.0 + event.value(), event.localPos());
  return true;
}

bool HandGestures::holds(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->key() != Qt::Key_Space)
      {
        return false;
      }
      if (!key->isAutoRepeat())
      {
        this->Space = event->type() == QEvent::KeyPress;
      }
      return true;
    }
    case QEvent::FocusOut:
      this->Space = false;
      return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const bool press = event->type() != QEvent::MouseButtonRelease;
      if (mouse->button() != Qt::LeftButton || !(press ? this->Space : this->Turns))
      {
        return false;
      }
      this->Turns = press;
      this->send(*mouse, Qt::MiddleButton, mouse->modifiers());
      return true;
    }
    default:
      return false;
  }
}

// As if another button had been pressed or let go, or with other keys.
void HandGestures::send(const QMouseEvent& like, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
  QMouseEvent event(like.type(),
    like.localPos(),
    like.windowPos(),
    like.screenPos(),
    button,
    like.type() == QEvent::MouseButtonRelease ? Qt::NoButton : button,
    modifiers);
  QApplication::sendEvent(this->View, &event);
}

Tool* HandGestures::smoother() const
{
  return this->View->findChild<Tool*>("relax");
}

bool HandGestures::begins(const QMouseEvent& press)
{
  Tool* tool = this->View->tool();
  if (press.button() != Qt::LeftButton || press.modifiers() != Qt::ShiftModifier || !tool || tool->isBusy() ||
      !this->smoother() || tool == this->smoother())
  {
    return false;
  }
  const double ratio = this->View->devicePixelRatioF();
  const double x = ratio * press.localPos().x(),
               y = ratio * (this->View->height() - press.localPos().y()) - 1.0;
  return !tool->takesShift(x, y) && this->Picker.pick(int(x), int(y), this->View->renderer());
}

bool HandGestures::smooths(QEvent* event)
{
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease)
  {
    return false;
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::MouseButtonPress && !this->Rests && this->begins(*mouse))
  {
    this->Rests = this->View->tool();
    this->View->setTool(this->smoother());
    this->send(*mouse, Qt::LeftButton, Qt::NoModifier);
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton && this->Rests)
  {
    Tool* before = std::exchange(this->Rests, nullptr); // what is sent is not asked again
    this->send(*mouse, Qt::LeftButton, Qt::NoModifier);
    if (this->View->tool() == this->smoother()) // no other was chosen meanwhile
    {
      this->View->setTool(before);
    }
    return true;
  }
  return false;
}

} // namespace oversketch_studio
