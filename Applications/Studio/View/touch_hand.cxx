#include "touch_hand.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTimer>
#include <QTouchDevice>
#include <QTouchEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

namespace
{

constexpr double still = 8.0; // px as Qt counts them: less is no movement of a finger

} // namespace

TouchHand::TouchHand(QWidget* view, Acts acts)
  : QObject(view)
  , View(view)
  , Act(std::move(acts))
{
  view->setAttribute(Qt::WA_AcceptTouchEvents);
  view->installEventFilter(this);
}

bool TouchHand::eventFilter(QObject*, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      break;
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
      this->pressed(*static_cast<QTabletEvent*>(event));
      return false; // Qt makes a mouse event of what is left to it
    default:
      return false;
  }
  auto* touch = static_cast<QTouchEvent*>(event);
  if (!touch->device() || touch->device()->type() != QTouchDevice::TouchScreen)
  {
    return false; // a trackpad moves the cursor
  }
  touch->accept();
  this->touched(*touch);
  return true;
}

void TouchHand::pressed(const QTabletEvent& event)
{
  if (event.type() == QEvent::TabletRelease)
  {
    QTimer::singleShot(
      0, this, [this] { this->Act.press(1.0); }); // the mouse's release is the line's last sample
  }
  else
  {
    this->Act.press(event.pressure());
  }
}

void TouchHand::touched(const QTouchEvent& event)
{
  if (event.type() == QEvent::TouchCancel)
  {
    this->giveUp();
    return;
  }
  QVector<QPointF> fingers;
  for (const QTouchEvent::TouchPoint& point : event.touchPoints())
  {
    if (point.state() != Qt::TouchPointReleased)
    {
      fingers << point.pos();
    }
  }
  const bool hasTwo =
    this->Does == Doing::Two || this->Does == Doing::Turning || this->Does == Doing::Zooming;
  if (fingers.isEmpty())
  {
    this->lift();
  }
  else if (fingers.size() == 1 && !hasTwo)
  {
    this->oneFinger(fingers[0]);
  }
  else if (fingers.size() == 2)
  {
    this->twoFingers(0.5 * (fingers[0] + fingers[1]), QLineF(fingers[0], fingers[1]).length());
  }
  // One that stays of two does nothing more, nor do three.
}

// The finger may be the first of two: it draws once it moves.
void TouchHand::oneFinger(const QPointF& at)
{
  if (this->Does == Doing::Nothing)
  {
    this->Does = Doing::Waiting;
    this->Began = at;
  }
  else if (this->Does == Doing::Waiting && QLineF(at, this->Began).length() > still)
  {
    this->Does = Doing::Drawing;
    this->send(QEvent::MouseMove, Qt::NoButton, this->Began);
    this->send(QEvent::MouseButtonPress, Qt::LeftButton, this->Began);
  }
  this->Last = at;
  if (this->Does == Doing::Drawing)
  {
    this->send(QEvent::MouseMove, Qt::LeftButton, at);
  }
}

void TouchHand::twoFingers(const QPointF& middle, double apart)
{
  if (this->Does == Doing::Waiting || this->Does == Doing::Drawing)
  {
    this->giveUp(); // what the first finger had begun
  }
  if (this->Does == Doing::Nothing)
  {
    this->Does = Doing::Two;
    this->Began = middle;
    this->Apart = std::max(apart, 1.0);
  }
  this->Last = middle;
  // The one that is more than the other, until the fingers are lifted.
  const double turned = QLineF(middle, this->Began).length(), spread = std::abs(apart - this->Apart);
  if (this->Does == Doing::Two && std::max(turned, spread) > still)
  {
    this->Does = turned > spread ? Doing::Turning : Doing::Zooming;
    if (this->Does == Doing::Turning)
    {
      this->send(QEvent::MouseMove, Qt::NoButton, this->Began);
      this->send(QEvent::MouseButtonPress, Qt::MiddleButton, this->Began);
    }
  }
  if (this->Does == Doing::Turning)
  {
    this->send(QEvent::MouseMove, Qt::MiddleButton, middle);
  }
  else if (this->Does == Doing::Zooming)
  {
    const double last = std::exchange(this->Apart, std::max(apart, 1.0));
    this->Act.zoom(this->Apart / last, middle);
  }
}

void TouchHand::lift()
{
  const Doing was = this->Does;
  this->Does = Doing::Nothing;
  if (was == Doing::Waiting) // a tap is a click
  {
    this->send(QEvent::MouseMove, Qt::NoButton, this->Began);
    this->send(QEvent::MouseButtonPress, Qt::LeftButton, this->Began);
    this->send(QEvent::MouseButtonRelease, Qt::LeftButton, this->Began);
  }
  else if (was == Doing::Drawing || was == Doing::Turning)
  {
    this->send(
      QEvent::MouseButtonRelease, was == Doing::Drawing ? Qt::LeftButton : Qt::MiddleButton, this->Last);
  }
}

void TouchHand::giveUp()
{
  const Doing was = this->Does;
  this->Does = Doing::Nothing;
  if (was == Doing::Drawing)
  {
    if (this->Act.holds())
    {
      for (const QEvent::Type type : { QEvent::KeyPress, QEvent::KeyRelease })
      {
        QKeyEvent escape(type, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(this->View, &escape);
      }
    }
    this->send(QEvent::MouseButtonRelease, Qt::LeftButton, this->Last);
  }
  else if (was == Doing::Turning)
  {
    this->send(QEvent::MouseButtonRelease, Qt::MiddleButton, this->Last);
  }
}

void TouchHand::send(QEvent::Type type, Qt::MouseButton button, const QPointF& at)
{
  const bool moves = type == QEvent::MouseMove;
  const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
  QMouseEvent event(type,
    at,
    at,
    this->View->mapToGlobal(at.toPoint()),
    moves ? Qt::NoButton : button,
    held,
    Qt::NoModifier,
    Qt::MouseEventSynthesizedByApplication);
  QApplication::sendEvent(this->View, &event);
}

} // namespace oversketch_studio
