// What a hand does beside drawing: the camera, a pen's pressure, fingers, rows of the history, menus,
// options.
#include "hand.h"

#include "axis_gizmo.h"
#include "document.h"
#include "main_window.h"
#include "mouse.h"
#include "pen.h"
#include "step_list.h"
#include "viewport.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QMenu>
#include <QNativeGestureEvent>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace oversketch_studio
{

namespace
{

std::array<double, 7> lookOf(Viewport* view)
{
  vtkCamera* camera = view->renderer()->GetActiveCamera();
  std::array<double, 7> look{};
  camera->GetPosition(look.data());
  camera->GetFocalPoint(look.data() + 3);
  look[6] = camera->GetParallelScale() + camera->GetViewAngle();
  return look;
}

} // namespace

// A line over the view, or over the picture that is drawn over.
int Hand::lineWithAPen()
{
  auto* pad = this->Window.findChild<QWidget*>("drawing_pad");
  QWidget* on = pad && pad->isVisible() && this->oneIn(2) ? pad : this->View;
  std::vector<QPoint> way{ this->place(on) };
  const int steps = 4 + this->upTo(8);
  const QPoint by = this->near({ 0, 0 }, 25);
  for (int i = 0; i < steps; ++i)
  {
    way.push_back(this->near(way.back() + by, 4));
  }
  drawWithPen(on, way);
  ++this->Doing.pressed;
  return steps + 3;
}

// One draws, two turn or zoom, or the second comes while the first draws; now and then a tap.
int Hand::fingers()
{
  static QTouchDevice* screen = QTest::createTouchDevice(); // a server has it as long as the program goes
  ++this->Doing.touched;
  QPoint first = this->place(this->View), second = this->near(first, 120);
  const int alone = this->upTo(4), together = this->oneIn(3) ? 0 : 1 + this->upTo(5);
  QTest::touchEvent(this->View, screen).press(0, first, this->View);
  for (int i = 0; i < alone; ++i)
  {
    first = this->near(first, 25);
    QTest::touchEvent(this->View, screen).move(0, first, this->View);
    QApplication::processEvents();
  }
  if (together > 0)
  {
    QTest::touchEvent(this->View, screen).move(0, first, this->View).press(1, second, this->View);
    for (int i = 0; i < together; ++i)
    {
      first = this->near(first, 25);
      second = this->near(second, 25);
      QTest::touchEvent(this->View, screen).move(0, first, this->View).move(1, second, this->View);
      QApplication::processEvents();
    }
    QTest::touchEvent(this->View, screen).move(0, first, this->View).release(1, second, this->View);
  }
  QTest::touchEvent(this->View, screen).release(0, first, this->View);
  return alone + together + 2;
}

// The axes in the corner, Alt or the space bar held, the middle button, a trackpad, the keys of the sides.
int Hand::look()
{
  const auto before = lookOf(this->View);
  ++this->Doing.looks;
  int events = 3;
  const auto drag = [&](QWidget* on, const QPoint& from, Qt::MouseButton button, Qt::KeyboardModifiers held)
  {
    QPoint at = from;
    QTest::mousePress(on, button, held, at);
    for (int i = 0; i < 3; ++i)
    {
      at = this->near(at, 30);
      moveMouse(on, at, button);
      QApplication::processEvents();
    }
    QTest::mouseRelease(on, button, held, at);
    events += 3;
  };
  const QPoint place = this->place(this->View);
  switch (this->upTo(6))
  {
    case 0:
    {
      auto* gizmo = this->Window.findChild<AxisGizmo*>();
      const int axis = this->upTo(2);
      const QPoint end = gizmo->end(axis, this->oneIn(2)).toPoint();
      this->oneIn(2) ? QTest::mouseClick(gizmo, Qt::LeftButton, Qt::NoModifier, end)
                     : drag(gizmo, end, Qt::LeftButton, Qt::NoModifier);
      break;
    }
    case 1:
      drag(this->View, place, Qt::LeftButton, Qt::AltModifier);
      break;
    case 2:
      QTest::keyPress(this->View, Qt::Key_Space);
      drag(this->View, place, Qt::LeftButton, Qt::NoModifier);
      QTest::keyRelease(this->View, Qt::Key_Space);
      break;
    case 3:
      drag(this->View, place, Qt::MiddleButton, this->oneIn(3) ? Qt::ShiftModifier : Qt::NoModifier);
      break;
    case 4:
    {
      static const Qt::KeyboardModifiers held[] = { Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier };
      const QPoint by = this->near({ 0, 0 }, 60);
      QWheelEvent scroll(place,
        this->View->mapToGlobal(place),
        by,
        8 * by,
        Qt::NoButton,
        held[this->upTo(2)],
        Qt::ScrollUpdate,
        false);
      QApplication::sendEvent(this->View, &scroll);
      break;
    }
    case 5:
    {
      QNativeGestureEvent pinch(Qt::ZoomNativeGesture,
        nullptr,
        place,
        place,
        this->View->mapToGlobal(place),
        0.01 * (this->upTo(60) - 30),
        0,
        0);
      QApplication::sendEvent(this->View, &pinch);
      break;
    }
    default:
      QTest::keyClick(this->View, static_cast<Qt::Key>(Qt::Key_1 + this->upTo(5)), Qt::ControlModifier);
      break;
  }
  QApplication::processEvents();
  this->Doing.looked += lookOf(this->View) != before;
  return events;
}

// The model before the selected step, as long as the key is held; now and then something else meanwhile.
int Hand::glance()
{
  QTest::keyPress(this->View, Qt::Key_U);
  for (int i = this->upTo(4); i >= 0; --i)
  {
    moveMouse(this->View, this->place(this->View), Qt::NoButton);
    QTest::qWait(2);
  }
  if (this->oneIn(4))
  {
    QTest::keyClick(this->View, Qt::Key_Z, Qt::ControlModifier);
  }
  QTest::keyRelease(this->View, Qt::Key_U);
  return 4;
}

// A row to another place, or the marker; now and then given up.
int Hand::dragInTheHistory()
{
  auto* list = this->Window.findChild<StepList*>("history");
  QWidget* rows = list->viewport();
  if (!list->isVisible() || list->count() == 0)
  {
    return 1;
  }
  ++this->Doing.rows;
  const auto order = [this]
  {
    std::vector<int> ids{ this->OpenDocument->shownTo() };
    for (const oversketch_session::Node& node : this->OpenDocument->session().nodes)
    {
      ids.push_back(node.id);
    }
    return ids;
  };
  const std::vector<int> before = order();
  QPoint at = list->markerRect().center();
  if (!this->oneIn(3))
  {
    QListWidgetItem* row = list->itemOf(this->upTo(list->steps() - 1));
    list->scrollToItem(row);
    at = list->visualItemRect(row).center() - QPoint(0, 4);
  }
  QTest::mousePress(rows, Qt::LeftButton, Qt::NoModifier, at);
  constexpr int steps = 4;
  const QPoint by(0, (this->upTo(120) - 60) / 2);
  for (int i = 0; i < steps; ++i)
  {
    at += by;
    moveMouse(rows, at);
    QApplication::processEvents();
  }
  if (this->oneIn(6))
  {
    QTest::keyClick(list, Qt::Key_Escape);
  }
  QTest::mouseRelease(rows, Qt::LeftButton, Qt::NoModifier, at);
  this->Doing.ordered += order() != before;
  return steps + 2;
}

// What a row's menu has, or a key.
int Hand::keyInTheHistory()
{
  auto* list = this->Window.findChild<StepList*>("history");
  if (!list->isVisible() || list->count() == 0)
  {
    return 1;
  }
  QListWidgetItem* row = list->item(this->upTo(list->count() - 1));
  list->scrollToItem(row);
  const QPoint at = list->visualItemRect(row).center() - QPoint(0, 4);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier, at);
  if (this->oneIn(3))
  {
    QContextMenuEvent menu(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
    QApplication::sendEvent(list->viewport(), &menu); // until the menu has been answered
    return 2;
  }
  static const QPair<Qt::Key, Qt::KeyboardModifiers> keys[] = { { Qt::Key_F2, Qt::NoModifier },
    { Qt::Key_F3, Qt::NoModifier },
    { Qt::Key_BracketLeft, Qt::NoModifier },
    { Qt::Key_BracketRight, Qt::NoModifier },
    { Qt::Key_Space, Qt::NoModifier },
    { Qt::Key_Delete, Qt::NoModifier },
    { Qt::Key_Up, Qt::ControlModifier },
    { Qt::Key_Down, Qt::ControlModifier },
    { Qt::Key_D, Qt::ControlModifier },
    { Qt::Key_R, Qt::ControlModifier },
    { Qt::Key_L, Qt::ControlModifier },
    { Qt::Key_H, Qt::ControlModifier },
    { Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier } };
  const auto& key = keys[this->upTo(static_cast<int>(std::size(keys)) - 1)];
  QTest::keyClick(list, key.first, key.second);
  return 2;
}

// Any of the window's menus, examples and recent files among them; what is chosen there comes after.
int Hand::menu()
{
  QVector<QMenu*> menus;
  for (const QAction* action : this->Window.findChildren<QAction*>())
  {
    if (action->menu() && action->isEnabled())
    {
      menus << action->menu();
    }
  }
  ++this->Doing.menus;
  menus[this->upTo(menus.size() - 1)]->popup(this->Window.mapToGlobal({ 60, 60 }));
  return 1;
}

// Of a tool or a step: mirror, lengths, what is ticked. Or the window's size.
int Hand::option()
{
  if (this->oneIn(6))
  {
    this->Window.resize(560 + this->upTo(500), 400 + this->upTo(400));
    return 1;
  }
  auto all = this->Window.findChildren<QWidget*>();
  const auto isNone = [](const QWidget* one)
  {
    return !one->isVisible() || !one->isEnabled() ||
           !(qobject_cast<const QComboBox*>(one) || qobject_cast<const QCheckBox*>(one) ||
             qobject_cast<const QAbstractSpinBox*>(one));
  };
  all.erase(std::remove_if(all.begin(), all.end(), isNone), all.end());
  if (!all.isEmpty())
  {
    QWidget* one = all[this->upTo(all.size() - 1)];
    one->setFocus();
    const bool ticks = qobject_cast<QCheckBox*>(one) != nullptr;
    QTest::keyClick(one, ticks ? Qt::Key_Space : this->oneIn(2) ? Qt::Key_Up : Qt::Key_Down);
    this->View->setFocus();
  }
  return 1;
}

} // namespace oversketch_studio
