// The window's menus, tool bar and status bar.
#include "main_window.h"

#include "history_panel.h"
#include "lesson.h"
#include "option_presets.h"
#include "options_stack.h"
#include "resources.h"
#include "scene_panel.h"
#include "status_labels.h"
#include "systems.h"
#include "tool.h"
#include "view_menu.h"
#include "viewport.h"

#include "vtkVersion.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

namespace oversketch_studio
{

namespace
{

constexpr int recentFiles = 10;
constexpr int wordPatience = 500; // ms
constexpr int toolIcon = 24;      // px as Qt counts them

} // namespace

QAction* MainWindow::add(QMenu* menu,
  const QString& text,
  const QKeySequence& keys,
  const std::function<void()>& run)
{
  QAction* action = menu->addAction(text);
  action->setShortcut(keys);
  connect(action, &QAction::triggered, this, run);
  return action;
}

void MainWindow::makeMenus()
{
  QMenu* file = this->menuBar()->addMenu(tr("&File"));
  this->add(file, tr("&Open…"), QKeySequence::Open, [this] { this->openAsked(); });
  if (oversketch_session::findSystem(oversketch_session::drawingSystem))
  {
    this->add(file, tr("&New from picture…"), QKeySequence::New, [this] { this->newFromPictureAsked(); });
    this->add(file,
      tr("New on an empty &canvas"),
      QKeySequence(tr("Ctrl+Shift+N")),
      [this] { this->openPicture({}); });
    this->add(file,
      tr("Add a pict&ure as a part…"),
      QKeySequence(tr("Ctrl+Shift+P")),
      [this] { this->addPartAsked(); });
    this->Back = this->add(file, tr("Picture of the &back…"), {}, [this] { this->addBackAsked(); });
    this->NoBack =
      this->add(file, tr("&Without a picture of the back"), {}, [this] { this->setBack(nullptr); });
  }
  this->Recent = file->addMenu(tr("Open &recent"));
  connect(this->Recent, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  this->Examples = file->addMenu(tr("E&xamples"));
  connect(this->Examples, &QMenu::aboutToShow, this, &MainWindow::fillExamples);
  this->Save = this->add(file, tr("&Save session"), QKeySequence::Save, [this] { this->save(); });
  this->add(file, tr("Save session &as…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { this->saveAs(); });
  this->Export =
    this->add(file, tr("&Export mesh…"), QKeySequence(tr("Ctrl+E")), [this] { this->exportAsked(); });
  file->addAction(this->Scene->exporting());
  this->Print = this->add(file, tr("Export &for print…"), {}, [this] { this->printAsked(); });
  this->add(file, tr("Save a &picture…"), QKeySequence(tr("F12")), [this] { this->screenshot(false); });
  this->add(file,
    tr("Save a picture with &lines…"),
    QKeySequence(tr("Shift+F12")),
    [this] { this->screenshot(true); });
  this->Turntable = this->add(file, tr("&Turntable…"), {}, [this] { this->turntableAsked(); });
  file->addSeparator();
  file->addActions({ this->Scene->modelAdding(), this->Scene->pictureAdding() });
  file->addSeparator();
  this->add(file, tr("&Quit"), QKeySequence(tr("Ctrl+Q")), [this] { this->close(); });

  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  // The history waits until the hand lets go: what it then makes would be written into another step.
  this->Undo = this->add(edit,
    tr("&Undo"),
    QKeySequence(tr("Ctrl+Z")),
    [this]
    {
      if (!this->View->tool()->isBusy())
      {
        this->OpenDocument->undo();
      }
    });
  this->Redo = this->add(edit,
    tr("&Redo"),
    {},
    [this]
    {
      if (!this->View->tool()->isBusy())
      {
        this->OpenDocument->redo();
      }
    });
  this->Redo->setShortcuts({ QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y")) });
  edit->addSeparator();
  this->add(edit, tr("&Preferences…"), QKeySequence(tr("Ctrl+,")), [this] { this->askPreferences(); });

  this->menuBar()->addMenu(tr("&Stroke"))->addActions(this->History->strokeActions());

  this->makeToolMenu();
  this->makeViewMenu();

  QMenu* help = this->menuBar()->addMenu(tr("&Help"));
  QMenu* teaching = help->addMenu(tr("&Lessons"));
  for (const Lesson& one : lessons())
  {
    this->add(teaching, one.title, {}, [this, one] { this->playLesson(one); });
  }
  teaching->menuAction()->setVisible(!teaching->isEmpty());
  this->add(help,
    tr("&Keys of the tool"),
    QKeySequence(tr("F1")),
    [this] { this->View->showKeys(!this->View->showsKeys()); });
  this->add(help,
    tr("&About Oversketch"),
    {},
    [this]
    {
      QMessageBox::about(this,
        tr("Oversketch"),
        tr("Oversketch %1\nDraw one line over a shape and the shape follows.\n\nVTK %2, Qt %3\nFree software "
           "under the BSD-3-Clause licence, without warranty.")
          .arg(QCoreApplication::applicationVersion(), vtkVersion::GetVTKVersion(), qVersion()));
    });
}

void MainWindow::makeToolMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&Tools"));
  auto* group = new QActionGroup(this);
  for (Tool* tool : this->Tools)
  {
    QAction* action = this->add(menu, tool->title(), tool->key(), [this, tool] { this->setTool(tool); });
    action->setCheckable(true);
    action->setToolTip(tool->help());
    // In the strip in two lines, where it is long.
    QString inStrip = tool->name();
    if (inStrip.size() > 10 && inStrip.contains(' '))
    {
      inStrip[inStrip.lastIndexOf(' ')] = '\n';
    }
    action->setIconText(inStrip);
    group->addAction(action);
    this->ToolActions << action;
  }
  menu->addSeparator();
  for (const Tool* tool : this->Tools)
  {
    menu->addActions(tool->actions());
  }
  this->Presets = new OptionPresets(this);
  menu->addMenu(this->Presets);
}

void MainWindow::makeViewMenu()
{
  QMenu* show = this->menuBar()->addMenu(tr("&View"));
  this->Dark = this->add(show,
    tr("&Dark"),
    {},
    [this]
    {
      this->Settings.dark = this->Dark->isChecked();
      this->apply(this->Settings);
      this->Settings.write();
    });
  this->Dark->setCheckable(true);
  this->Region =
    this->add(show, tr("&Region that moves"), QKeySequence(tr("O")), [this] { this->offerStep(); });
  this->Region->setCheckable(true);
  this->Look->addTo(show);
  show->addSeparator();
  show->addActions({ this->DockActions.begin(), this->DockActions.end() });
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* panel)
{
  auto* dock = new QDockWidget(QString(title).remove('&'), this);
  dock->setObjectName(name);
  dock->setWidget(panel);
  this->addDockWidget(Qt::RightDockWidgetArea, dock);
  dock->toggleViewAction()->setText(title);
  this->DockActions << dock->toggleViewAction();
  return dock;
}

// A strip of tools at the left, above the view the options of the one that is in the hand.
void MainWindow::makeTools()
{
  const auto fixed = [this](Qt::ToolBarArea area, const QString& title, const QString& name)
  {
    auto* bar = new QToolBar(title, this);
    this->addToolBar(area, bar);
    bar->setObjectName(name);
    bar->setMovable(false);
    bar->toggleViewAction()->setEnabled(false); // nothing else would show it again
    return bar;
  };
  QToolBar* bar = fixed(Qt::TopToolBarArea, tr("Options"), "options_bar");
  this->Options = new OptionsStack(bar);
  for (Tool* tool : this->Tools)
  {
    QWidget* options = tool->makeOptions(this->Options);
    this->Options->addWidget(options ? options : new QWidget(this->Options));
  }
  bar->addWidget(this->Options);
  auto* presets = new QToolButton(bar);
  presets->setObjectName("presets");
  presets->setText(tr("Presets"));
  presets->setToolTip(tr("Options that you have kept under a name"));
  presets->setMenu(this->Presets);
  presets->setPopupMode(QToolButton::InstantPopup);
  presets->setFocusPolicy(Qt::NoFocus); // keys have the menu
  const QAction* of = this->Presets->menuAction();
  connect(of, &QAction::changed, presets, [presets, of] { presets->setEnabled(of->isEnabled()); });
  bar->addWidget(presets);
  bar->addActions({ this->Undo, this->Redo });
  this->Strip = fixed(Qt::LeftToolBarArea, tr("Tools"), "tools_strip");
  this->Strip->setIconSize(QSize(toolIcon, toolIcon));
  this->Strip->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  this->Strip->addActions({ this->ToolActions.begin(), this->ToolActions.end() });
}

// In the colours that the window has now, as fine as the screen is.
void MainWindow::drawToolIcons()
{
  const qreal ratio = this->devicePixelRatioF();
  for (int i = 0; i < this->Tools.size(); ++i)
  {
    QPixmap picture(QSize(toolIcon, toolIcon) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(
      QApplication::palette().color(QPalette::ButtonText), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(this->Tools[i]->icon());
    painter.end();
    this->ToolActions[i]->setIcon(QIcon(picture));
  }
}

void MainWindow::makeStatus()
{
  this->Mode->setObjectName("mode");
  this->Progress->setAccessibleName(tr("Progress"));
  this->Progress->setRange(0, 100);
  this->Progress->setFixedWidth(220); // for the longest stage
  this->Progress->hide();
  this->Cancel->hide();
  this->statusBar()->addWidget(this->Advice, 1);
  connect(this->Teacher, &LessonPlayer::says, this, &MainWindow::advise);
  connect(this->Teacher,
    &LessonPlayer::ended,
    this,
    [this](bool whole)
    {
      this->ShowsHints = whole;
      this->advise();
    });
  this->Anyway->setObjectName("anyway");
  this->Anyway->setFocusPolicy(Qt::TabFocus); // a click leaves the keys with the view
  this->Anyway->hide();
  this->statusBar()->addWidget(this->Anyway);
  connect(this->Anyway,
    &QPushButton::clicked,
    this,
    [this]
    {
      if (this->OnAnyway)
      {
        this->OnAnyway();
      }
    });
  this->statusBar()->addPermanentWidget(this->Progress);
  this->statusBar()->addPermanentWidget(this->Cancel);
  this->statusBar()->addPermanentWidget(this->Look->triangles());
  this->statusBar()->addPermanentWidget(new KeptNote(this->OpenDocument, this));
  this->statusBar()->addPermanentWidget(this->Mode);
  connect(this->Look,
    &ViewMenu::told,
    this->statusBar(),
    [this](const QString& text) { this->statusBar()->showMessage(text); });
  this->BusyTimer->setSingleShot(true);
  this->BusyTimer->setInterval(wordPatience);
  connect(this->BusyTimer,
    &QTimer::timeout,
    this,
    [this]
    {
      this->Progress->show();
      this->Cancel->show();
    });
  connect(this->OpenDocument,
    &Document::progressed,
    this,
    [this](int node, const QString& stage, double share)
    {
      const Tool* tool = this->OpenDocument->nodeAt(node) ? this->toolOf(node) : nullptr;
      this->Progress->setFormat(tool ? tool->stage(stage) : stage);
      this->Progress->setValue(static_cast<int>(100.0 * share));
    });
  connect(this->Large,
    &LargeModels::progressed,
    this,
    [this](double share)
    {
      if (!this->OpenDocument->isBusy())
      {
        this->Progress->setFormat(tr("all triangles: %p%"));
        this->Progress->setValue(static_cast<int>(100.0 * share));
      }
      this->Progress->setVisible(this->Large->isMaking() || this->Cancel->isVisible());
    });
  connect(this->Cancel, &QPushButton::clicked, this->OpenDocument, &Document::cancel);
  connect(this->OpenDocument,
    &Document::autosaveFailed,
    this,
    [this](const QString& why) {
      this->Advice->setText(tr("The session cannot be kept while you work: %1. Save it yourself.").arg(why));
    });
}

void MainWindow::remember(const QString& path)
{
  QSettings settings;
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList recent = settings.value("recent").toStringList();
  recent.removeAll(whole);
  recent.prepend(whole);
  settings.setValue("recent", QStringList(recent.mid(0, recentFiles)));
  settings.setValue("folder", QFileInfo(path).absolutePath());
}

// Tools at the hand that draws, panels at the other.
void MainWindow::placeForHand(bool left)
{
  const auto tools = left ? Qt::RightToolBarArea : Qt::LeftToolBarArea;
  const auto panels = left ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea;
  if (this->toolBarArea(this->Strip) == tools)
  {
    return;
  }
  this->addToolBar(tools, this->Strip);
  for (auto* button : this->Strip->findChildren<QToolButton*>()) // the pointer stays where it was
  {
    button->setAttribute(Qt::WA_UnderMouse, false);
  }
  for (auto* dock : this->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (!dock->isFloating())
    {
      const bool shown = !dock->isHidden();
      this->addDockWidget(panels, dock);
      dock->setVisible(shown);
    }
  }
}

void MainWindow::fillExamples()
{
  this->Examples->clear();
  const QVector<Example> all = examples();
  for (const Example& one : all)
  {
    this->add(this->Examples, one.title, {}, [this, one] { this->openExample(one); });
  }
  if (all.isEmpty())
  {
    this->Examples->addAction(tr("None are installed"))->setEnabled(false);
  }
}

void MainWindow::fillRecent()
{
  this->Recent->clear();
  const QStringList recent = QSettings().value("recent").toStringList();
  for (const QString& path : recent)
  {
    this->add(this->Recent, path, {}, [this, path] { this->open(path); });
  }
  if (recent.isEmpty())
  {
    this->Recent->addAction(tr("None yet"))->setEnabled(false);
  }
}

} // namespace oversketch_studio
