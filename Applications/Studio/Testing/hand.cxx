#include "hand.h"

#include "document.h"
#include "main_window.h"
#include "mesh_file.h"
#include "tool.h"
#include "viewport.h"

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
#include <QRegularExpression>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
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
  this->partDrags += other.partDrags;
  this->placed += other.placed;
  this->edits += other.edits;
  this->looks += other.looks;
  this->looked += other.looked;
  this->rows += other.rows;
  this->ordered += other.ordered;
  this->glances += other.glances;
  this->pressed += other.pressed;
  this->touched += other.touched;
  this->menus += other.menus;
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
      [this](int, const oversketch_session::PartPlace&, bool mergesIntoLast)
      { this->Doing.placed += !mergesIntoLast; });
  }
  connect(this->OpenDocument, &Document::opened, this, [this] { ++this->Doing.opened; });
  connect(this->OpenDocument, &Document::beforeCame, this, [this] { ++this->Doing.glances; });
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
  const int x = this->upTo(std::max(on->width() - 1, 0)); // docks can leave a view no room
  return { x, this->upTo(std::max(on->height() - 1, 0)) };
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
  switch (this->upTo(23))
  {
    case 0:
    case 1:
      events = this->Draws || this->oneIn(3) ? this->lineOnThePad() : this->strokeBesideTheModel();
      break;
    case 2:
    case 3:
    case 9:
      events = this->Draws ? this->dragOfAPart() : this->dragOfTheStroke();
      break;
    case 4:
    case 5:
    case 6:
      events = this->press();
      break;
    case 7:
    case 8:
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
    case 10:
      events = this->look();
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
      events = this->Draws ? this->lineOnThePad() : this->editOfARegion();
      break;
    case 20:
      events = this->oneIn(2) ? this->lineWithAPen() : this->fingers();
      break;
    case 21:
      events = this->oneIn(2)   ? this->dragInTheHistory()
               : this->oneIn(2) ? this->keyInTheHistory()
                                : this->glance();
      break;
    case 22:
      events = this->oneIn(2) ? this->menu() : this->option();
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
    Qt::Key_4,
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
    Qt::Key_Q,
    Qt::Key_6,
    Qt::Key_7,
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
  auto widgets = this->Window.findChildren<QWidget*>();
  const auto isUnseen = [](const QWidget* one) { return !one->isVisible() || one->size().isEmpty(); };
  widgets.erase(std::remove_if(widgets.begin(), widgets.end(), isUnseen), widgets.end());
  QWidget* one = widgets[this->upTo(widgets.size() - 1)];
  QTest::mouseClick(one, Qt::LeftButton, Qt::NoModifier, this->place(one));
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
    // A picture of the view may have the name that an export's texture asks for; models and sessions are no
    // pictures.
    static const QRegularExpression noPicture(
      "(?<!\\.png) is no PNG, JPEG, WebP, BMP or TIFF picture, or a damaged one\\.$");
    if (box->icon() == QMessageBox::Critical && !box->text().contains(damaged) &&
        !box->text().contains("would replace drawn.png") && !noPicture.match(box->text()).hasMatch())
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
      const QStringList extensions = QString::fromLatin1(oversketch_files::writtenExtensions).split(' ');
      name += extensions[this->upTo(extensions.size() - 1)];
    }
    path = QDir(this->Folder).filePath(name);
  }
  dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
  static_cast<QDialog*>(dialog)->accept();
}

} // namespace oversketch_studio
