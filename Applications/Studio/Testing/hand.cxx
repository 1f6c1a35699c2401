#include "hand.h"

#include "document.h"
#include "main_window.h"
#include "mesh_file.h"
#include "mouse.h"
#include "part_drag.h"
#include "systems.h"
#include "tool.h"
#include "viewport.h"

#include "pen_view.h"

#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace oversketch_studio
{

namespace
{

constexpr Qt::KeyboardModifiers modifiers[] = { Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier };

bool quits(const QAction* action)
{
  return action && action->text().contains("Quit");
}

} // namespace

const char* const Hand::damaged = "damaged.ply";

void Hand::Deeds::add(const Deeds& other)
{
  this->strokes += other.strokes;
  this->moved += other.moved;
  this->undone += other.undone;
  this->redone += other.redone;
  this->meshes += other.meshes;
  this->questions += other.questions;
  this->opened += other.opened;
  this->lines += other.lines;
  this->placed += other.placed;
  this->edits += other.edits;
}

Hand::Hand(unsigned seed, MainWindow& window, const QString& folder)
  : Random(seed)
  , Window(window)
  , View(window.findChild<Viewport*>())
  , OpenDocument(window.findChild<Document*>())
  , Folder(folder)
{
  for (Tool* tool : window.findChildren<Tool*>())
  {
    connect(tool, &Tool::drawn, this, [this] { ++this->Doing.strokes; });
    connect(tool, &Tool::changed, this, [this] { ++this->Doing.moved; });
    connect(tool, &Tool::edited, this, [this] { ++this->Doing.lines; });
    connect(tool, &Tool::remade, this, [this] { ++this->Doing.edits; });
    connect(tool,
      &Tool::placed,
      this,
      [this](int, const oversketch_session::PartPlace&, bool goesOn) { this->Doing.placed += !goesOn; });
  }
  connect(this->OpenDocument, &Document::opened, this, [this] { ++this->Doing.opened; });
  connect(this->OpenDocument,
    &Document::detailed,
    this,
    [this]
    {
      this->Doing.meshes += this->Shown != this->OpenDocument->digest();
      this->Shown = this->OpenDocument->digest();
    });
  connect(this->OpenDocument,
    &Document::progressed,
    this,
    [this](int, const QString& stage, double share)
    { this->Stage = QString("%1 %2 %").arg(stage).arg(100.0 * share); });
  for (const QAction* action : window.findChildren<QAction*>())
  {
    if (action->text() == "&Undo")
    {
      connect(action, &QAction::triggered, this, [this] { ++this->Doing.undone; });
    }
    else if (action->text() == "&Redo")
    {
      connect(action, &QAction::triggered, this, [this] { ++this->Doing.redone; });
    }
  }
  // Whoever asks waits in a loop of its own, where timers go on. The answer comes from outside of the timer's
  // call, which would not come again while a question follows from it.
  auto* timer = new QTimer(this);
  connect(timer,
    &QTimer::timeout,
    this,
    [this]
    {
      if (!this->Answering && QThread::currentThread()->loopLevel() > 0)
      {
        this->Answering = true;
        QMetaObject::invokeMethod(
          this, [this] { this->answer(); }, Qt::QueuedConnection);
      }
    });
  timer->start(5);
}

QPoint Hand::place(QWidget* on)
{
  const int x = this->upTo(on->width() - 1);
  return { x, this->upTo(on->height() - 1) };
}

QPoint Hand::near(const QPoint& place, int distance)
{
  const int x = this->upTo(2 * distance) - distance;
  return place + QPoint(x, this->upTo(2 * distance) - distance);
}

// A mesh or a session that is there, or what says it were one.
QString Hand::file()
{
  QStringList names = QDir(this->Folder).entryList(QDir::Files, QDir::Name);
  names.removeAll("drawn.png");
  return QDir(this->Folder).filePath(names[this->upTo(names.size() - 1)]);
}

int Hand::act()
{
  int events = 0;
  switch (this->upTo(21))
  {
    case 0:
    case 1:
      events = this->Draws || this->oneIn(3) ? this->lineOnThePad() : this->strokeBesideTheModel();
      break;
    case 2:
    case 3:
      events = this->Draws ? this->dragOfAPart() : this->dragOfTheStroke();
      break;
    case 4:
    case 5:
    case 6:
      events = this->press();
      break;
    case 7:
    case 8:
    case 9:
    case 10:
      QTest::mouseMove(this->View, this->place(this->View));
      events = 1;
      break;
    case 11:
    case 12:
      QTest::mouseRelease(this->View,
        this->oneIn(4) ? Qt::MiddleButton : Qt::LeftButton,
        Qt::NoModifier,
        this->place(this->View));
      events = 1;
      break;
    case 13:
    case 14:
      events = this->key();
      break;
    case 15:
      events = this->undoAndRedo();
      break;
    case 16:
      events = this->oneIn(3) ? this->drop() : this->wheel();
      break;
    case 17:
    case 18:
      events = this->click();
      break;
    case 19:
      events = this->Draws      ? this->lineOnThePad()
               : this->oneIn(2) ? this->editOfARegion()
                                : this->dragOfTheStroke();
      break;
    default:
      events = this->menuEntry();
      break;
  }
  QApplication::processEvents();
  for (int i = 0; i < 10 && QApplication::activePopupWidget(); ++i)
  {
    this->answerPopup(QApplication::activePopupWidget());
    QApplication::processEvents();
  }
  while (QWidget* popup = QApplication::activePopupWidget())
  {
    popup->close();
  }
  return events;
}

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
  vtkRenderer* renderer = this->View->renderWindow()->GetRenderers()->GetFirstRenderer();
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
  if (this->oneIn(2))
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
  for (const QPoint& at : way)
  {
    moveMouse(on, at);
    QApplication::processEvents();
  }
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
  return events + drag(this->View, this->near(middle, length));
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

// Of one of its handles, where the last frame shows them.
int Hand::dragOfAPart()
{
  const auto& nodes = this->OpenDocument->session().nodes;
  const int node = this->View->tool()->node();
  const auto& part = node < 0 ? std::nullopt : nodes[indexOf(node)].step->part;
  vtkRenderer* renderer = this->View->renderWindow()->GetRenderers()->GetFirstRenderer();
  std::array<oversketch::Vector2, 6> seen;
  const double ratio = this->View->devicePixelRatioF();
  if (!part || !seeHandles(oversketch::PenView::of(renderer).kernelView(), *part, 56.0 * ratio, seen))
  {
    return this->lineOnThePad();
  }
  const oversketch::Vector2 at = seen[static_cast<std::size_t>(this->upTo(5))] / ratio;
  QPoint place(static_cast<int>(at[0]), this->View->height() - 1 - static_cast<int>(at[1]));
  const Qt::KeyboardModifiers held = this->oneIn(4) ? Qt::ShiftModifier : Qt::NoModifier;
  QTest::mouseMove(this->View, place);
  QTest::mousePress(this->View, Qt::LeftButton, held, place);
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i)
  {
    place = this->near(place, 25);
    moveMouse(this->View, place);
    QApplication::processEvents();
  }
  if (this->oneIn(5))
  {
    QTest::keyClick(this->View, Qt::Key_Escape);
  }
  QTest::mouseRelease(this->View, Qt::LeftButton, held, place);
  return steps + 3;
}

int Hand::press()
{
  const Qt::MouseButton button = this->oneIn(4) ? Qt::MiddleButton : Qt::LeftButton;
  const Qt::KeyboardModifiers held = modifiers[this->upTo(2)];
  QTest::mousePress(this->View, button, held, this->place(this->View));
  return 1;
}

int Hand::key()
{
  static const Qt::Key keys[] = { Qt::Key_R,
    Qt::Key_X,
    Qt::Key_Y,
    Qt::Key_Z,
    Qt::Key_1,
    Qt::Key_2,
    Qt::Key_3,
    Qt::Key_W,
    Qt::Key_C,
    Qt::Key_H,
    Qt::Key_L,
    Qt::Key_I,
    Qt::Key_M,
    Qt::Key_J,
    Qt::Key_K,
    Qt::Key_P,
    Qt::Key_N,
    Qt::Key_D,
    Qt::Key_B,
    Qt::Key_G,
    Qt::Key_E,
    Qt::Key_A,
    Qt::Key_S,
    Qt::Key_5,
    Qt::Key_U,
    Qt::Key_0,
    Qt::Key_V,
    Qt::Key_F4,
    Qt::Key_T,
    Qt::Key_O,
    Qt::Key_F1,
    Qt::Key_Escape,
    Qt::Key_Backspace,
    Qt::Key_Return,
    Qt::Key_Delete,
    Qt::Key_Tab,
    Qt::Key_Space,
    Qt::Key_Up,
    Qt::Key_Down };
  const Qt::Key one = keys[this->upTo(static_cast<int>(std::size(keys)) - 1)];
  QWidget* focused = QApplication::focusWidget();
  QWidget* on = focused && this->oneIn(3) ? focused : this->View;
  QTest::keyClick(on, one, modifiers[this->upTo(1)]);
  return 1;
}

int Hand::undoAndRedo()
{
  const int undone = 1 + this->upTo(2), redone = this->upTo(2);
  for (int i = 0; i < undone + redone; ++i)
  {
    QTest::keyClick(
      this->View, Qt::Key_Z, Qt::ControlModifier | (i < undone ? Qt::NoModifier : Qt::ShiftModifier));
  }
  return undone + redone;
}

int Hand::wheel()
{
  const QPoint at = this->place(this->View);
  QWheelEvent turn(at,
    this->View->mapToGlobal(at),
    {},
    { 0, this->oneIn(2) ? 120 : -120 },
    Qt::NoButton,
    modifiers[this->upTo(2)],
    Qt::NoScrollPhase,
    false);
  QApplication::sendEvent(this->View, &turn);
  return 1;
}

int Hand::click()
{
  const auto widgets = this->Window.findChildren<QWidget*>();
  QWidget* one = widgets[this->upTo(widgets.size() - 1)];
  if (one->isVisible() && one->width() > 0 && one->height() > 0)
  {
    QTest::mouseClick(one, Qt::LeftButton, Qt::NoModifier, this->place(one));
  }
  return 1;
}

int Hand::menuEntry()
{
  auto actions = this->Window.findChildren<QAction*>();
  if (this->oneIn(2))
  {
    // Those that ask for a file, and the preferences.
    actions.erase(std::remove_if(actions.begin(),
                    actions.end(),
                    [](const QAction* action) { return !action->text().endsWith(QString::fromUtf8("…")); }),
      actions.end());
  }
  QAction* one = actions[this->upTo(actions.size() - 1)];
  if (one->isEnabled() && !quits(one) && !one->menu())
  {
    one->trigger();
  }
  return 1;
}

int Hand::drop()
{
  QMimeData files;
  files.setUrls({ QUrl::fromLocalFile(this->file()) });
  QDropEvent dropped({ 100, 100 }, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&this->Window, &dropped);
  return 1;
}

void Hand::answer()
{
  this->Answering = false;
  if (QWidget* popup = QApplication::activePopupWidget())
  {
    this->answerPopup(popup);
    return;
  }
  QWidget* asked = QApplication::activeModalWidget();
  if (!asked)
  {
    return;
  }
  ++this->Doing.questions;
  if (auto* file = qobject_cast<QFileDialog*>(asked))
  {
    this->answerFile(file);
  }
  else if (auto* box = qobject_cast<QMessageBox*>(asked))
  {
    if (box->icon() == QMessageBox::Critical && !box->text().contains(damaged))
    {
      this->Complaints << box->text();
    }
    const auto buttons = box->buttons();
    buttons[this->upTo(buttons.size() - 1)]->click();
  }
  else
  {
    for (int i = 0; i < 2; ++i)
    {
      const auto widgets = asked->findChildren<QWidget*>();
      QWidget* one = widgets[this->upTo(widgets.size() - 1)];
      if (one->isVisible() && asked->isVisible())
      {
        QTest::mouseClick(one, Qt::LeftButton, Qt::NoModifier, this->place(one));
      }
    }
    if (asked->isVisible() && !QApplication::activePopupWidget())
    {
      QTest::keyClick(asked, this->oneIn(2) ? Qt::Key_Return : Qt::Key_Escape);
    }
  }
}

void Hand::answerPopup(QWidget* popup)
{
  QWidget* keys = popup->focusWidget() ? popup->focusWidget() : popup;
  for (int i = this->upTo(6); i >= 0; --i)
  {
    QTest::keyClick(keys, Qt::Key_Down);
  }
  const auto* menu = qobject_cast<QMenu*>(popup);
  if (this->oneIn(3) || (menu && quits(menu->activeAction())))
  {
    popup->close();
  }
  else
  {
    QTest::keyClick(keys, Qt::Key_Return);
  }
}

void Hand::answerFile(QFileDialog* dialog)
{
  if (this->oneIn(3))
  {
    dialog->reject();
    return;
  }
  QString path = this->file();
  if (dialog->acceptMode() == QFileDialog::AcceptSave)
  {
    QString name = "drawn"; // the window adds the extension that it wants
    if (dialog->nameFilters().join(' ').contains("*.ply"))
    {
      const QStringList extensions = QString::fromLatin1(oversketch_files::meshExtensions).split(' ');
      name += extensions[this->upTo(extensions.size() - 1)];
    }
    path = QDir(this->Folder).filePath(name);
  }
  dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
  static_cast<QDialog*>(dialog)->accept();
}

} // namespace oversketch_studio
