// The mouse, moved: the server's own moves come when it likes, and run together while frames are drawn.
#ifndef oversketch_applications_studio_testing_mouse_h
#define oversketch_applications_studio_testing_mouse_h

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

namespace oversketch_studio
{

inline void moveMouse(QWidget* over, const QPoint& at, Qt::MouseButtons held = Qt::LeftButton)
{
  QMouseEvent move(QEvent::MouseMove, at, over->mapToGlobal(at), Qt::NoButton, held, Qt::NoModifier);
  QApplication::sendEvent(over, &move);
}

} // namespace oversketch_studio
#endif
