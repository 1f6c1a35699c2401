// A pen with pressure, as a tablet has.
#ifndef oversketch_applications_studio_testing_pen_h
#define oversketch_applications_studio_testing_pen_h

#include <QApplication>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWidget>

#include <gtest/gtest.h>

#include <vector>

namespace oversketch_studio
{

// As a tablet's driver and Qt do it: the pen's event, and the mouse's of what is left to it.
inline void penAt(QWidget* on, QEvent::Type tablet, QEvent::Type mouse, const QPoint& at, double pressure)
{
  const bool ends = mouse == QEvent::MouseButtonRelease, moves = mouse == QEvent::MouseMove;
  const Qt::MouseButtons held = ends ? Qt::NoButton : Qt::MouseButtons(Qt::LeftButton);
  QTabletEvent pen(tablet,
    at,
    on->mapToGlobal(at),
    QTabletEvent::Stylus,
    QTabletEvent::Pen,
    pressure,
    0,
    0,
    0.0,
    0.0,
    0,
    Qt::NoModifier,
    1,
    Qt::LeftButton,
    held);
  QApplication::sendEvent(on, &pen);
  EXPECT_FALSE(pen.isAccepted()) << "Qt would make no mouse event of it";
  QMouseEvent event(
    mouse, at, on->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton, held, Qt::NoModifier);
  QApplication::sendEvent(on, &event);
}

// Pressed more and more.
inline void drawWithPen(QWidget* on, const std::vector<QPoint>& way)
{
  penAt(on, QEvent::TabletPress, QEvent::MouseButtonPress, way.front(), 0.2);
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    penAt(on, QEvent::TabletMove, QEvent::MouseMove, way[i], 0.2 + 0.6 * double(i) / double(way.size()));
    QApplication::processEvents();
  }
  penAt(on, QEvent::TabletRelease, QEvent::MouseButtonRelease, way.back(), 0.0);
}

} // namespace oversketch_studio
#endif
