// The window's menus, tool bar and status bar.
#include "main_window.h"

#include "history_panel.h"
#include "tool.h"
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

namespace oversketch_studio
{

namespace
{

constexpr int recentFiles = 10;
constexpr int patience = 500; // ms
constexpr int toolIcon = 24;  // px as Qt counts them

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
  this->recent_ = file->addMenu(tr("Open &recent"));
  connect(this->recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  this->save_ = this->add(file, tr("&Save session"), QKeySequence::Save, [this] { this->save(); });
  this->add(file, tr("Save session &as…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { this->saveAs(); });
  this->add(file, tr("&Export mesh…"), QKeySequence(tr("Ctrl+E")), [this] { this->exportAsked(); });
  this->add(file, tr("Save a &picture…"), QKeySequence(tr("F12")), [this] { this->screenshot(); });
  file->addSeparator();
  this->add(file, tr("Add a p&icture…"), {}, [this] { this->addPictureAsked(); });
  file->addSeparator();
  this->add(file, tr("&Quit"), QKeySequence(tr("Ctrl+Q")), [this] { this->close(); });

  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  this->undo_ = this->add(edit, tr("&Undo"), QKeySequence(tr("Ctrl+Z")), [this] { this->document_->undo(); });
  this->redo_ = this->add(edit, tr("&Redo"), {}, [this] { this->document_->redo(); });
  this->redo_->setShortcuts({ QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y")) });
  edit->addSeparator();
  this->add(edit, tr("&Preferences…"), QKeySequence(tr("Ctrl+,")), [this] { this->askPreferences(); });

  this->menuBar()->addMenu(tr("&Stroke"))->addActions(this->history_->strokeActions());

  this->makeToolMenu();
  this->makeViewMenu();

  QMenu* help = this->menuBar()->addMenu(tr("&Help"));
  this->add(help,
    tr("&Keys and mode"),
    QKeySequence(tr("F1")),
    [this] { this->view_->showKeys(!this->view_->showsKeys()); });
  this->add(help,
    tr("&About Oversketch"),
    {},
    [this]
    {
      QMessageBox::about(this,
        tr("Oversketch"),
        tr("Oversketch %1\nDraw one line over a shape and the shape follows.\n\nVTK %2, Qt %3\n"
           "Free software under the BSD-3-Clause licence, without warranty.")
          .arg(QCoreApplication::applicationVersion(), vtkVersion::GetVTKVersion(), qVersion()));
    });
}

void MainWindow::makeToolMenu()
{
  QMenu* menu = this->menuBar()->addMenu(tr("&Tools"));
  auto* group = new QActionGroup(this);
  for (Tool* tool : this->tools_)
  {
    QAction* action = this->add(menu, tool->title(), tool->key(), [this, tool] { this->setTool(tool); });
    action->setCheckable(true);
    action->setToolTip(tool->help());
    group->addAction(action);
    this->toolActions_ << action;
  }
}

void MainWindow::makeViewMenu()
{
  QMenu* show = this->menuBar()->addMenu(tr("&View"));
  this->dark_ = this->add(show,
    tr("&Dark"),
    {},
    [this]
    {
      this->preferences_.dark = this->dark_->isChecked();
      this->apply(this->preferences_);
      this->preferences_.write();
    });
  this->dark_->setCheckable(true);
  this->region_ =
    this->add(show, tr("&Region that moves"), QKeySequence(tr("O")), [this] { this->offerStep(); });
  this->region_->setCheckable(true);
  show->addActions({ this->dockActions_.begin(), this->dockActions_.end() });
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* panel)
{
  auto* dock = new QDockWidget(QString(title).remove('&'), this);
  dock->setObjectName(name);
  dock->setWidget(panel);
  this->addDockWidget(Qt::RightDockWidgetArea, dock);
  dock->toggleViewAction()->setText(title);
  this->dockActions_ << dock->toggleViewAction();
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
  this->options_ = new QStackedWidget(bar);
  for (Tool* tool : this->tools_)
  {
    QWidget* options = tool->makeOptions(this->options_);
    this->options_->addWidget(options ? options : new QWidget(this->options_));
  }
  bar->addWidget(this->options_);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addActions({ this->undo_, this->redo_ });
  this->strip_ = fixed(Qt::LeftToolBarArea, tr("Tools"), "tools_strip");
  this->strip_->setIconSize(QSize(toolIcon, toolIcon));
  this->strip_->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  this->strip_->addActions({ this->toolActions_.begin(), this->toolActions_.end() });
}

// In the colours that the window has now, as fine as the screen is.
void MainWindow::drawToolIcons()
{
  const qreal ratio = this->devicePixelRatioF();
  for (int i = 0; i < this->tools_.size(); ++i)
  {
    QPixmap picture(QSize(toolIcon, toolIcon) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(
      QApplication::palette().color(QPalette::ButtonText), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(this->tools_[i]->icon());
    painter.end();
    this->toolActions_[i]->setIcon(QIcon(picture));
  }
}

void MainWindow::makeStatus()
{
  this->advice_->setObjectName("advice");
  this->advice_->setIndent(6);
  this->mode_->setObjectName("mode");
  this->progress_->setAccessibleName(tr("Progress"));
  this->progress_->setRange(0, 100);
  this->progress_->setFixedWidth(220); // for the longest stage
  this->progress_->hide();
  this->cancel_->hide();
  this->statusBar()->addWidget(this->advice_, 1);
  this->statusBar()->addPermanentWidget(this->progress_);
  this->statusBar()->addPermanentWidget(this->cancel_);
  this->statusBar()->addPermanentWidget(this->mode_);
  this->patience_->setSingleShot(true);
  this->patience_->setInterval(patience);
  connect(this->patience_,
    &QTimer::timeout,
    this,
    [this]
    {
      this->progress_->show();
      this->cancel_->show();
    });
  connect(this->document_,
    &Document::progressed,
    this,
    [this](int node, const QString& stage, double share)
    {
      const bool isThere = node < static_cast<int>(this->document_->session().nodes.size());
      const Tool* tool = isThere ? this->toolOf(node) : nullptr;
      this->progress_->setFormat(tool ? tool->stage(stage) : stage);
      this->progress_->setValue(static_cast<int>(100.0 * share));
    });
  connect(this->cancel_, &QPushButton::clicked, this->document_, &Document::cancel);
  connect(this->document_,
    &Document::autosaveFailed,
    this,
    [this](const QString& why) {
      this->advice_->setText(tr("The session cannot be kept while you work: %1. Save it yourself.").arg(why));
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

void MainWindow::fillRecent()
{
  this->recent_->clear();
  const QStringList recent = QSettings().value("recent").toStringList();
  for (const QString& path : recent)
  {
    this->add(this->recent_, path, {}, [this, path] { this->open(path); });
  }
  this->recent_->setDisabled(false);
  if (recent.isEmpty())
  {
    this->recent_->addAction(tr("None yet"))->setEnabled(false);
  }
}

} // namespace oversketch_studio
