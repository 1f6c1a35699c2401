// The window with a tool of system B in a hand that draws lines, rings and what they are dragged to.
#ifndef oversketch_applications_studio_testing_edits_h
#define oversketch_applications_studio_testing_edits_h

#include "edit_hand.h"
#include "edit_tool.h"
#include "evaluator.h"
#include "scene.h"

#include "vtkOversketchAxisHandleRepresentation.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchEditWidget.h"

#include <QLabel>
#include <QMouseEvent>
#include <QVTKOpenGLNativeWidget.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace oversketch_studio
{

using namespace oversketch_session;

using Way = std::vector<QPoint>;

struct Edits : Scene
{
  explicit Edits(Qt::Key tool = Qt::Key_E, const QSize& size = smallWindow)
    : Scene(size)
    , advice(this->window.findChild<QLabel*>("advice"))
  {
    QApplication::setActiveWindow(&this->window);
    this->press(tool);
    this->middle = this->seen(this->document->result().mesh->GetCenter()) - QPoint(20, 20);
  }

  void press(Qt::Key key, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    QTest::keyClick(this->view, key, held);
    this->settle();
  }
  void settle()
  {
    QApplication::processEvents();
    this->wait();
    QApplication::processEvents();
  }
  void send(QWidget* to, QEvent::Type type, const QPoint& at, Qt::KeyboardModifiers held)
  {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type,
      at,
      to->mapToGlobal(at),
      moves ? Qt::NoButton : Qt::LeftButton,
      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
      held);
    QApplication::sendEvent(to, &event);
    QApplication::processEvents();
  }
  // The button stays down where it is not to be let go of.
  void drag(QWidget* on, const Way& way, Qt::KeyboardModifiers held = Qt::NoModifier, bool letGo = true)
  {
    moveMouse(on, way.front(), Qt::NoButton);
    this->send(on, QEvent::MouseButtonPress, way.front(), held);
    sweepMouse(on, way, held);
    if (letGo)
    {
      this->letGo(on, way.back(), held);
    }
  }
  void letGo(QWidget* on, const QPoint& at, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    this->send(on, QEvent::MouseButtonRelease, at, held);
    this->settle();
  }
  void drag(const Way& way, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    this->drag(this->view, way, held);
  }
  static Way straight(const QPoint& from, const QPoint& to, int steps = 12)
  {
    Way way;
    for (int i = 0; i <= steps; ++i)
    {
      way.push_back(from + (to - from) * i / steps);
    }
    return way;
  }
  static Way ring(const QPoint& middle, double wide, double high, double from = 0.0, double to = 2.0 * M_PI)
  {
    Way way;
    for (int i = 0; i <= 60; ++i)
    {
      const double a = from + (to - from) * i / 60;
      way.emplace_back(middle + QPoint(static_cast<int>(std::lround(wide * std::cos(a))),
                                  static_cast<int>(std::lround(high * std::sin(a)))));
    }
    return way;
  }
  void drawLine() { this->drag(straight(this->middle - QPoint(35, 0), this->middle + QPoint(35, 0), 20)); }
  void drawRing(double wide = 75.0, double high = 40.0) { this->drag(ring(this->middle, wide, high)); }
  void drawBoth()
  {
    this->drawLine();
    this->drawRing();
    ASSERT_EQ(this->nodes().size(), 1u) << this->said();
    ASSERT_EQ(this->failures(), "");
  }
  // An arch over the cross-section, in the dock's picture of it.
  void drawProfile()
  {
    QWidget* picture = this->dockPicture("profile_picture");
    ASSERT_TRUE(picture && picture->isVisible());
    const int w = picture->width(), h = picture->height();
    this->drag(picture, ring({ w / 2, h / 2 }, 0.28 * w, 0.3 * h, M_PI, 2.0 * M_PI));
  }

  vtkOversketchAxisHandleRepresentation* axes()
  {
    auto* tool = static_cast<EditTool*>(this->window.findChild<Tool*>("direct"));
    return tool->hand().widget()->GetAxisHandleWidget()->GetAxisHandleRepresentation();
  }
  // Where a part of an axis of the selected handle can be taken hold of; the middle of all places of it.
  QPoint placeOn(int axis, int part)
  {
    QPoint sum;
    int count = 0;
    for (int x = this->middle.x() - 110; x < this->middle.x() + 110; x += 2)
    {
      for (int y = this->middle.y() - 140; y < this->middle.y() + 110; y += 2)
      {
        const int grip = this->axes()->GetGripAt(x, this->view->height() - 1 - y);
        if (grip > 0 && this->axes()->GetAxis(grip) == axis && this->axes()->GetPart(grip) == part)
        {
          sum += QPoint(x, y);
          ++count;
        }
      }
    }
    return count > 0 ? sum / count : QPoint();
  }
  // The first axis that is seen, or the last.
  int axisSeen(bool last = false)
  {
    int seen = -1;
    for (int axis = 0; axis < 3; ++axis)
    {
      if ((seen < 0 || last) && !this->placeOn(axis, vtkOversketchAxisHandleRepresentation::Scale).isNull())
      {
        seen = axis;
      }
    }
    return seen;
  }

  const std::vector<Node>& nodes() { return this->document->session().nodes; }
  const Step& step(int node) { return *this->nodes()[indexOf(node)].step; }
  std::string text(int node, const char* property)
  {
    return std::get<std::string>(valueOf(this->step(node), *findParameter(*findSystem("Edit"), property)));
  }
  std::string failures()
  {
    std::string all;
    for (const auto& node : this->document->result().nodes)
    {
      all += node.failure.text();
    }
    return all;
  }
  std::string said() { return this->advice->text().toStdString(); }
  std::string digest() { return this->document->digest(); }
  QWidget* dockPicture(const char* name) { return this->window.findChild<QVTKOpenGLNativeWidget*>(name); }
  vtkPolyData* shown() { return this->view->mesh(); }
  void shot(const char* name)
  {
    if (const QString folder = qEnvironmentVariable("OVERSKETCH_SHOTS"); !folder.isEmpty())
    {
      this->pictureAtRest();
      this->window.grab().save(folder + '/' + name + ".png");
    }
  }

  QLabel* advice;
  QPoint middle;
  int lastAxis = -1;
};

constexpr int ruleOff = 2;

// The digest of what a session makes under another rule of its last step.
inline std::string replayed(Session session, int rule)
{
  auto step = std::make_shared<Step>(*session.nodes.back().step);
  step->values["Rule"] = rule;
  session.nodes.back().step = step;
  return replayed(session);
}

} // namespace oversketch_studio
#endif
