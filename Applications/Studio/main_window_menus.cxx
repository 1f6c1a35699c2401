// The window's menus, tool bar and status bar.
#include "main_window.h"

#include "document.h"
#include "history_panel.h"
#include "view.h"

#include "vtkVersion.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

namespace oversketch_studio
{

namespace
{

constexpr int recentFiles = 10;
constexpr int patience = 500; // ms

// The stages of vtkOversketchOneStroke that take long enough to be read, in words.
QString stageText(const QString& name)
{
  static const struct
  {
    const char *name, *text;
  } stages[] = {
    { "ShapeDiameter", QT_TRANSLATE_NOOP("oversketch_studio::MainWindow", "Measuring the thickness") },
    { "MixtureRegion", QT_TRANSLATE_NOOP("oversketch_studio::MainWindow", "Finding the limb") },
    { "Stretch", QT_TRANSLATE_NOOP("oversketch_studio::MainWindow", "Making triangles") },
    { "Restore", QT_TRANSLATE_NOOP("oversketch_studio::MainWindow", "Evening out triangles") },
  };
  for (const auto& stage : stages)
  {
    if (name == stage.name)
    {
      return MainWindow::tr(stage.text);
    }
  }
  return name.startsWith("Deform") || name.startsWith("Correction") ? MainWindow::tr("Deforming")
                                                                    : MainWindow::tr("Finding the outline");
}

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
  this->add(file, tr("&Quit"), QKeySequence(tr("Ctrl+Q")), [this] { this->close(); });

  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  this->undo_ = this->add(edit, tr("&Undo"), QKeySequence(tr("Ctrl+Z")), [this] { this->document_->undo(); });
  this->redo_ = this->add(edit, tr("&Redo"), {}, [this] { this->document_->redo(); });
  this->redo_->setShortcuts({ QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y")) });
  edit->addSeparator();
  this->add(edit, tr("&Preferences…"), QKeySequence(tr("Ctrl+,")), [this] { this->askPreferences(); });

  this->menuBar()->addMenu(tr("&Stroke"))->addActions(this->history_->strokeActions());

  QMenu* tools = this->menuBar()->addMenu(tr("&Tools"));
  auto* modes = new QActionGroup(this);
  this->draw_ = this->add(tools, tr("&Draw"), QKeySequence(tr("D")), [this] { this->setDrawing(true); });
  this->turn_ = this->add(tools, tr("&Turn"), QKeySequence(tr("T")), [this] { this->setDrawing(false); });
  for (QAction* mode : { this->draw_, this->turn_ })
  {
    mode->setCheckable(true);
    modes->addAction(mode);
  }
  this->draw_->setToolTip(tr("The left button draws (D). The middle button always turns."));
  this->turn_->setToolTip(tr("The left button turns the model (T)"));

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
    this->add(show, tr("&Region that moves"), QKeySequence(tr("O")), [this] { this->offerStroke(); });
  this->region_->setCheckable(true);
  QAction* history = this->dock_->toggleViewAction();
  history->setText(tr("&History"));
  show->addAction(history);

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

void MainWindow::makeTools()
{
  auto* bar = this->addToolBar(tr("Tools"));
  bar->setObjectName("tools bar");
  bar->toggleViewAction()->setEnabled(false); // nothing else would show it again
  bar->addActions({ this->draw_, this->turn_ });
  bar->addSeparator();
  bar->addActions({ this->undo_, this->redo_ });
  bar->addSeparator();
  auto* label = new QLabel(tr("New strokes act on "), bar);
  bar->addWidget(label);
  this->mirror_ = mirrorChoice(bar);
  label->setBuddy(this->mirror_);
  this->mirror_->setObjectName("mirror");
  this->mirror_->setAccessibleName(tr("New strokes act on"));
  this->mirror_->setToolTip(tr("Strokes act on one side of the model, or on both sides of this plane"));
  bar->addWidget(this->mirror_);
  connect(this->mirror_,
    QOverload<int>::of(&QComboBox::activated),
    this,
    [this] { this->view_->showMirror(this->document_->mirrorPlane(this->mirror_->currentIndex())); });
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
    [this](const QString& stage, double share)
    {
      this->progress_->setFormat(stageText(stage));
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
