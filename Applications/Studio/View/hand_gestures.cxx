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
      QMouseEvent middle(event->type(),
        mouse->localPos(),
        mouse->windowPos(),
        mouse->screenPos(),
        Qt::MiddleButton,
        press ? Qt::MiddleButton : Qt::NoButton,
        mouse->modifiers());
      QApplication::sendEvent(this->View, &middle);
      return true;
    }
    default:
      return false;
  }
}

} // namespace oversketch_studio
