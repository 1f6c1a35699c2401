// What a hand draws and drags: strokes, regions, lines over a picture, parts.
#include "hand.h"

#include "document.h"
#include "main_window.h"
#include "mouse.h"
#include "part_drag.h"
#include "step_list.h"
#include "systems.h"
#include "tool.h"
#include "viewport.h"

#include "pen_view.h"

#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QTest>

#include <array>
#include <cmath>

namespace oversketch_studio
{

// A bow beside the outermost point of the model in some direction, as a person draws it; of a tool that draws
// on the model, as far inside.
int Hand::strokeBesideTheModel()
{
  if (this->View->tool()->system().empty() || this->oneIn(4))
  {
    QTest::keyClick(this->View, this->oneIn(2) ? Qt::Key_D : Qt::Key_B);
  }
  if (this->oneIn(2))
  {
    QTest::keyClick(this->View, Qt::Key_Return); // whatever stroke could be taken hold of
  }
  vtkRenderer* renderer = this->View->renderer();
  vtkPolyData* mesh = this->OpenDocument->result().mesh;
  const double angle = 2.0 * M_PI * this->upTo(359) / 360.0;
  const double x = std::cos(angle), y = std::sin(angle);
  double outermost[2] = { 0.0, 0.0 }, most = -1e300;
  for (vtkIdType i = 0; mesh && i < mesh->GetNumberOfPoints(); ++i)
  {
    double place[4] = { 0.0, 0.0, 0.0, 1.0 };
    mesh->GetPoint(i, place);
    renderer->SetWorldPoint(place);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    if (at[0] * x + at[1] * y > most)
    {
      most = at[0] * x + at[1] * y;
      outermost[0] = at[0];
      outermost[1] = at[1];
    }
  }
  const double ratio = this->View->devicePixelRatioF();
  const auto onView = [&](double a, double b)
  { return QPoint(static_cast<int>(a / ratio), this->View->height() - 1 - static_cast<int>(b / ratio)); };
  if (!this->View->rect().contains(onView(outermost[0], outermost[1])))
  {
    QTest::keyClick(this->View, Qt::Key_W); // back to where it is seen
    return 1;
  }
  const double beside = 4 + this->upTo(25), half = 15 + this->upTo(45);
  const double away = this->View->tool()->system() == "Augment" ? -beside : beside;
  constexpr int steps = 9;
  for (int i = 0; i <= steps; ++i)
  {
    const double t = 2.0 * i / steps - 1.0, out = away * (1.0 - 1.3 * t * t), along = half * t;
    const QPoint at = onView(outermost[0] + out * x - along * y, outermost[1] + out * y + along * x);
    if (i == 0)
    {
      QTest::mousePress(this->View, Qt::LeftButton, Qt::NoModifier, at);
    }
    QTest::mouseMove(this->View, at);
    QApplication::processEvents();
    if (i == steps)
    {
      QTest::mouseRelease(this->View, Qt::LeftButton, Qt::NoModifier, at);
    }
  }
  return steps + 3;
}

// Where the last stroke lies, if the view is still the one that it was drawn in.
int Hand::dragOfTheStroke()
{
  const auto& nodes = this->OpenDocument->session().nodes;
  if (nodes.empty())
  {
    return this->strokeBesideTheModel();
  }
  using namespace oversketch_session;
  const Step& step = *nodes.back().step;
  const SystemInput* drawn = findInput(*findSystem(step.system), SystemInput::Kind::Stroke);
  const auto stroke = linesOf(step, drawn->name);
  if (!stroke) // of another step
  {
    return this->editOfARegion();
  }
  if (stroke->GetNumberOfPoints() == 0) // a drawing without lines
  {
    return this->lineOnThePad();
  }
  if (this->View->tool()->system() != step.system && !this->oneIn(4)) // whose line is taken hold of
  {
    QTest::keyClick(this->View, step.system == "Augment" ? Qt::Key_B : Qt::Key_D);
  }
  if (!this->oneIn(4))
  {
    this->View->lookFrom(stroke);
    QApplication::processEvents();
  }
  const double* at = stroke->GetPoint(this->upTo(static_cast<int>(stroke->GetNumberOfPoints()) - 1));
  const double ratio = this->View->devicePixelRatioF();
  QPoint place(static_cast<int>(at[0] / ratio), this->View->height() - 1 - static_cast<int>(at[1] / ratio));
  QTest::mouseMove(this->View, place);
  QTest::mousePress(this->View, Qt::LeftButton, this->oneIn(4) ? Qt::ShiftModifier : Qt::NoModifier, place);
  constexpr int steps = 3;
  for (int i = 0; i < steps; ++i)
  {
    place = this->near(place, 12);
    QTest::mouseMove(this->View, place);
    QApplication::processEvents();
  }
  QTest::mouseRelease(this->View, Qt::LeftButton, Qt::NoModifier, place);
  return steps + 3;
}

int Hand::line(QWidget* on, const std::vector<QPoint>& way, Qt::KeyboardModifiers held)
{
  QTest::mouseMove(on, way.front());
  QTest::mousePress(on, Qt::LeftButton, held, way.front());
  sweepMouse(on, way);
  if (this->oneIn(12))
  {
    QTest::keyClick(this->View, Qt::Key_Escape);
  }
  QTest::mouseRelease(on, Qt::LeftButton, held, way.back());
  QApplication::processEvents();
  return static_cast<int>(way.size()) + 3;
}

// A line and a ring round it, over the model's middle or beside it, and then whatever a tool of system B lets
// be dragged there, on the model or in a dock; now and then with Shift over a part of the ring.
int Hand::editOfARegion()
{
  static const Qt::Key tools[] = { Qt::Key_E, Qt::Key_A, Qt::Key_S };
  QTest::keyClick(this->View, tools[this->upTo(2)]);
  if (this->oneIn(4))
  {
    QTest::keyClick(this->View, Qt::Key_Return);
  }
  if (!this->oneIn(4))
  {
    QTest::keyClick(this->View, Qt::Key_W); // wheel and drags have led the model away from the middle
  }
  const QPoint middle = this->near(this->View->rect().center(), this->oneIn(3) ? 120 : 40);
  const int length = 4 + this->upTo(50), around = length + 4 + this->upTo(40);
  const auto ring = [&](int steps, double share)
  {
    std::vector<QPoint> way;
    for (int i = 0; i <= steps; ++i)
    {
      const double angle = 2.0 * M_PI * share * i / steps;
      way.push_back(middle + QPoint(static_cast<int>(1.2 * around * std::cos(angle)),
                               static_cast<int>(around * std::sin(angle))));
    }
    return way;
  };
  int events = this->line(this->View, { middle - QPoint(length, 0), middle, middle + QPoint(length, 0) });
  events += this->line(this->View, ring(14, 1.0));
  if (this->oneIn(4))
  {
    events += this->line(this->View, ring(6, 0.3), Qt::ShiftModifier);
  }
  const auto drag = [&](QWidget* on, QPoint from)
  {
    std::vector<QPoint> way{ from };
    for (int i = 0; i < 3; ++i)
    {
      way.push_back(this->near(way.back(), 20));
    }
    return this->line(on, way);
  };
  for (const char* name : { "disc_picture", "profile_picture" })
  {
    auto* picture = this->Window.findChild<QWidget*>(name);
    if (picture && picture->isVisible() && this->oneIn(2))
    {
      events += drag(picture, this->near(picture->rect().center(), picture->height() / 3));
    }
  }
  // What was made is taken hold of once more, as soon as it is there.
  const QPoint held = this->near(middle, length);
  events += drag(this->View, held);
  const bool isThere = QTest::qWaitFor([this] { return this->OpenDocument->isSettled(); }, 600000);
  return isThere ? events + drag(this->View, held) : events;
}

// A ring in the picture that is drawn over, or a part of one; of a size that a limb, a body or a dot has.
int Hand::lineOnThePad()
{
  auto* pad = this->Window.findChild<QWidget*>("drawing_pad");
  if (!pad || !pad->isVisible())
  {
    QTest::keyClick(this->View, Qt::Key_G);
    return 1;
  }
  const QPoint middle = this->place(pad);
  const int radius = 1 + this->upTo(150), steps = 6 + this->upTo(14);
  const double round = 2.0 * M_PI * (this->oneIn(3) ? 0.01 * this->upTo(100) : 1.0);
  const Qt::KeyboardModifiers held = this->oneIn(4) ? Qt::ShiftModifier : Qt::NoModifier;
  const auto at = [&](int i)
  {
    const double angle = round * i / steps;
    return middle +
           QPoint(static_cast<int>(radius * std::cos(angle)), static_cast<int>(radius * std::sin(angle)));
  };
  QTest::mousePress(pad, Qt::LeftButton, held, at(0));
  for (int i = 1; i <= steps; ++i)
  {
    QTest::mouseMove(pad, at(i));
    QApplication::processEvents();
  }
  QTest::mouseRelease(pad, Qt::LeftButton, held, at(steps));
  return steps + 2;
}

// Of one of its handles, where the last frame shows them. A part is drawn on and placed whose row is
// selected; of several it is any.
int Hand::dragOfAPart()
{
  const auto& nodes = this->OpenDocument->session().nodes;
  std::vector<int> parts;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i].step->part)
    {
      parts.push_back(static_cast<int>(i));
    }
  }
  if (parts.empty()) // undone, or deleted
  {
    return this->lineOnThePad();
  }
  int events = 0;
  const int part = parts[static_cast<std::size_t>(this->upTo(static_cast<int>(parts.size()) - 1))];
  auto* list = this->Window.findChild<StepList*>("history");
  if (this->View->tool()->system() != oversketch_session::drawingSystem)
  {
    QTest::keyClick(this->View, Qt::Key_G);
    ++events;
  }
  if (this->View->tool()->node() != part)
  {
    QListWidgetItem* row = list->itemOf(part);
    list->scrollToItem(row);
    QTest::mouseClick(
      list->viewport(), Qt::LeftButton, Qt::NoModifier, list->visualItemRect(row).center() - QPoint(0, 4));
    ++events;
  }
  QApplication::processEvents();
  std::array<oversketch::Vector2, 6> seen;
  const double ratio = this->View->devicePixelRatioF();
  const auto isThere = [&]
  {
    return seeHandles(oversketch::PenView::of(this->View->renderer()).kernelView(),
      *nodes[indexOf(part)].step->part,
      56.0 * ratio,
      seen);
  };
  const auto place = [&](std::size_t handle)
  {
    const oversketch::Vector2 at = seen[handle] / ratio;
    return QPoint(static_cast<int>(at[0]), this->View->height() - 1 - static_cast<int>(at[1]));
  };
  const auto handle = static_cast<std::size_t>(this->upTo(5));
  if (this->View->tool()->node() != part || !isThere() || !this->View->rect().contains(place(handle)))
  {
    QTest::keyClick(this->View, Qt::Key_W); // back to where it is seen
    return events + 1;
  }
  ++this->Doing.partDrags;
  QPoint at = place(handle);
  const Qt::KeyboardModifiers held = this->oneIn(4) ? Qt::ShiftModifier : Qt::NoModifier;
  QTest::mouseMove(this->View, at);
  QTest::mousePress(this->View, Qt::LeftButton, held, at);
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i)
  {
    at = this->near(at, 25);
    moveMouse(this->View, at);
    QApplication::processEvents();
  }
  if (this->oneIn(5))
  {
    QTest::keyClick(this->View, Qt::Key_Escape);
  }
  QTest::mouseRelease(this->View, Qt::LeftButton, held, at);
  return events + steps + 3;
}

} // namespace oversketch_studio
