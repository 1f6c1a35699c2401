// The mouse, moved: the server's own moves come when it likes, and run together while frames are drawn.
#ifndef oversketch_applications_studio_testing_mouse_h
#define oversketch_applications_studio_testing_mouse_h

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

#include <vector>

namespace oversketch_studio
{

inline void moveMouse(QWidget* over,
  const QPoint& at,
  Qt::MouseButtons held = Qt::LeftButton,
  Qt::KeyboardModifiers keys = Qt::NoModifier)
{
  QMouseEvent move(QEvent::MouseMove, at, over->mapToGlobal(at), Qt::NoButton, held, keys);
  QApplication::sendEvent(over, &move);
}

// Moves through the places at(first) to at(last). A frame is drawn for each four moves and for the last, as
// where a quick hand draws.
template <typename At>
void sweepMouse(QWidget* over, int first, int last, const At& at, Qt::KeyboardModifiers keys = Qt::NoModifier)
{
  constexpr int movesOfFrame = 4;
  for (int i = first; i <= last; ++i)
  {
    moveMouse(over, at(i), Qt::LeftButton, keys);
    if (i == last || (i - first) % movesOfFrame == movesOfFrame - 1)
    {
      QApplication::processEvents();
    }
  }
}

inline void sweepMouse(QWidget* over,
  const std::vector<QPoint>& way,
  Qt::KeyboardModifiers keys = Qt::NoModifier)
{
  sweepMouse(
    over, 0, static_cast<int>(way.size()) - 1, [&](int i) { return way[i]; }, keys);
}

} // namespace oversketch_studio
#endif
