#include "main_window.h"

#include "document.h"
#include "files.h"
#include "history_panel.h"
#include "latency.h"
#include "looks.h"
#include "mesh_file.h"
#include "resources.h"
#include "view.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QStyle>
#include <QStyleFactory>
#include <QTimer>
#include <QToolBar>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch_files::Failed;

namespace
{

constexpr int recentFiles = 10;
constexpr int patience = 500; // ms

QString meshFilter()
{
  QString extensions;
  for (const QString& extension : QString::fromLatin1(oversketch_files::meshExtensions).split(' '))
  {
    extensions += " *" + extension;
  }
  return extensions.mid(1);
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , document_(new Document(this))
  , view_(new View(this))
  , history_(new HistoryPanel(this->document_, this))
  , advice_(new QLabel(this))
  , mode_(new QLabel(this))
  , progress_(new QProgressBar(this))
  , cancel_(new QPushButton(tr("Cancel"), this))
  , patience_(new QTimer(this))
{
  this->setCentralWidget(this->view_);
  this->setAcceptDrops(true);
  auto* dock = new QDockWidget(tr("History"), this);
  dock->setObjectName("history dock");
  dock->setWidget(this->history_);
  this->addDockWidget(Qt::RightDockWidgetArea, dock);
  this->makeActions();
  this->makeStatus();

  connect(this->document_, &Document::opened, this, [this] { this->reset_ = true; });
  connect(this->document_,
    &Document::changed,
    this,
    [this]
    {
      if (!this->drawn_)
      {
        this->view_->clearStroke(); // it tells nothing of what is shown from here on
      }
      this->view_->showSection(nullptr);
      this->refresh();
    });
  connect(this->document_, &Document::shown, this, &MainWindow::showResult);
  connect(this->document_, &Document::idle, this, &MainWindow::refresh);
  connect(this->document_,
    &Document::progressed,
    this,
    [this](const QString& stage, double share)
    {
      this->progress_->setFormat(stage);
      this->progress_->setValue(static_cast<int>(100.0 * share));
    });
  connect(this->view_, &View::strokeDrawn, this, &MainWindow::strokeDrawn);
  connect(this->view_, &View::quitAsked, this, &MainWindow::close, Qt::QueuedConnection);
  connect(this->history_,
    &HistoryPanel::redrawAsked,
    this,
    [this](int node)
    {
      this->redrawn_ = node;
      this->setDrawing(true);
      this->view_->lookFrom(this->document_->session().nodes[static_cast<std::size_t>(node)].action->stroke);
      this->advise();
    });
  connect(this->history_,
    &HistoryPanel::viewAsked,
    this,
    [this](int node) {
      this->view_->lookFrom(this->document_->session().nodes[static_cast<std::size_t>(node)].action->stroke);
    });
  connect(this->history_, &HistoryPanel::selected, this, &MainWindow::select);

  QSettings settings;
  this->resize(1200, 800);
  this->restoreGeometry(settings.value("geometry").toByteArray());
  this->restoreState(settings.value("state").toByteArray());
  this->setDark(settings.value("dark", true).toBool());
  this->view_->setStabilizer(settings.value("stabilizer", 6.0).toDouble());
  this->setDrawing(true);
  this->view_->setFocus();
  this->refresh();
}

MainWindow::~MainWindow() = default;

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

void MainWindow::makeActions()
{
  QMenu* file = this->menuBar()->addMenu(tr("&File"));
  this->add(file, tr("&Open…"), QKeySequence::Open, [this] { this->openAsked(); });
  this->recent_ = file->addMenu(tr("Open &recent"));
  connect(this->recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  this->save_ = this->add(file, tr("&Save session"), QKeySequence::Save, [this] { this->save(); });
  this->add(file, tr("Save session &as…"), QKeySequence::SaveAs, [this] { this->saveAs(); });
  this->add(file, tr("&Export mesh…"), QKeySequence(tr("Ctrl+E")), [this] { this->exportAsked(); });
  file->addSeparator();
  this->add(file, tr("&Quit"), QKeySequence(tr("Ctrl+Q")), [this] { this->close(); });

  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  this->undo_ = this->add(edit, tr("&Undo"), QKeySequence(tr("Ctrl+Z")), [this] { this->document_->undo(); });
  this->redo_ = this->add(edit, tr("&Redo"), {}, [this] { this->document_->redo(); });
  this->redo_->setShortcuts({ QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y")) });

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
  this->dark_ = this->add(show, tr("&Dark"), {}, [this] { this->setDark(this->dark_->isChecked()); });
  this->dark_->setCheckable(true);
  this->add(show,
    tr("&Keys and mode"),
    QKeySequence(tr("F1")),
    [this] { this->view_->showKeys(!this->view_->showsKeys()); });
  this->add(show, tr("&Screenshot"), QKeySequence(tr("F12")), [this] { this->screenshot(); });

  auto* bar = this->addToolBar(tr("Tools"));
  bar->setObjectName("tools bar");
  bar->addActions({ this->draw_, this->turn_ });
  bar->addSeparator();
  bar->addActions({ this->undo_, this->redo_ });
  bar->addSeparator();
  this->mirror_ = mirrorChoice(bar);
  this->mirror_->setObjectName("mirror");
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
  this->mode_->setObjectName("mode");
  this->progress_->setRange(0, 100);
  this->progress_->setMaximumWidth(220);
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
  connect(this->cancel_, &QPushButton::clicked, this->document_, &Document::cancel);
  connect(this->document_,
    &Document::autosaveFailed,
    this,
    [this](const QString& why) {
      this->advice_->setText(tr("The session cannot be kept while you work: %1. Save it yourself.").arg(why));
    });
}

bool MainWindow::tried(const std::function<void()>& run)
{
  try
  {
    run();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    QMessageBox::critical(this, tr("Oversketch"), tr("Out of memory; the file is too large or damaged."));
  }
  catch (const std::exception& error)
  {
    QMessageBox::critical(this, tr("Oversketch"), QString::fromStdString(error.what()));
  }
  return false;
}

void MainWindow::tell(const QStringList& notes)
{
  if (!notes.isEmpty())
  {
    QMessageBox::information(this, tr("Oversketch"), notes.join('\n'));
  }
}

bool MainWindow::open(const QString& path)
{
  QStringList notes;
  bool opened = false;
  this->tried(
    [&]
    {
      opened = this->document_->open(
        path, [this] { return this->mayLeave(); }, notes);
    });
  if (opened)
  {
    this->remember(path);
    this->view_->showHint({});
    this->redrawn_ = -1;
    this->tell(notes);
  }
  return opened;
}

bool MainWindow::offerRecovery()
{
  for (const LeftBehind& left : leftBehind(autosaveRoot()))
  {
    QMessageBox box(QMessageBox::Question,
      tr("Oversketch"),
      tr("Oversketch ended before your work on %1 was saved. Open it again?")
        .arg(QString::fromStdString(left.meshName)),
      QMessageBox::NoButton,
      this);
    box.setInformativeText(tr("It holds %n stroke(s).", nullptr, static_cast<int>(left.strokes)));
    QPushButton* again = box.addButton(tr("Open it"), QMessageBox::AcceptRole);
    QPushButton* away = box.addButton(tr("Throw it away"), QMessageBox::DestructiveRole);
    box.addButton(tr("Ask next time"), QMessageBox::RejectRole);
    box.setDefaultButton(again);
    box.exec();
    if (box.clickedButton() == again)
    {
      return this->tried([&] { this->document_->recover(left); });
    }
    if (box.clickedButton() == away)
    {
      removeLeftBehind(left);
    }
  }
  return false;
}

void MainWindow::openShippedModel()
{
  const QString path = shippedModel();
  QStringList none;
  if (!path.isEmpty() && this->tried(
                           [&]
                           {
                             this->document_->open(
                               path, [] { return true; }, none);
                           }))
  {
    this->view_->showHint(tr("Draw here, beside the outline, and it follows"));
  }
}

void MainWindow::openAsked()
{
  const QString path = QFileDialog::getOpenFileName(this,
    tr("Open a model or a session"),
    QSettings().value("folder").toString(),
    tr("Models and sessions (%1 *.oversketch);;All files (*)").arg(meshFilter()));
  if (!path.isEmpty())
  {
    this->open(path);
  }
}

bool MainWindow::save()
{
  const QString path = this->document_->path();
  return path.isEmpty() ? this->saveAs() : this->tried([&] { this->document_->save(path); });
}

bool MainWindow::saveAs()
{
  if (!this->document_->isOpen())
  {
    return false;
  }
  QString path = QFileDialog::getSaveFileName(this,
    tr("Save the session"),
    QDir(QSettings().value("folder").toString())
      .filePath(QFileInfo(this->document_->name()).completeBaseName() + ".oversketch"),
    tr("Sessions (*.oversketch)"));
  if (path.isEmpty())
  {
    return false;
  }
  if (QFileInfo(path).suffix() != "oversketch")
  {
    path += ".oversketch";
  }
  return this->tried(
    [&]
    {
      this->document_->save(path);
      this->remember(path);
    });
}

void MainWindow::exportAsked()
{
  if (!this->document_->isOpen())
  {
    return;
  }
  const QString path = QFileDialog::getSaveFileName(this,
    tr("Export the mesh"),
    QDir(QSettings().value("folder").toString())
      .filePath(QFileInfo(this->document_->name()).completeBaseName() + ".ply"),
    tr("Meshes (%1)").arg(meshFilter()));
  if (!path.isEmpty())
  {
    this->tried([&] { this->tell(this->document_->save(path)); });
  }
}

void MainWindow::screenshot()
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name =
    tr("Oversketch %1.png").arg(QDateTime::currentDateTime().toString("yyyy-MM-dd hh.mm.ss"));
  QString path = QFileDialog::getSaveFileName(
    this, tr("Save a picture of the model"), QDir(folder).filePath(name), tr("Pictures (*.png)"));
  if (path.isEmpty())
  {
    return;
  }
  if (QFileInfo(path).suffix() != "png")
  {
    path += ".png";
  }
  const bool overlays =
    QMessageBox::question(this, tr("Oversketch"), tr("With the lines and texts over the model?")) ==
    QMessageBox::Yes;
  if (!this->view_->screenshot(path, overlays))
  {
    QMessageBox::critical(this, tr("Oversketch"), tr("%1 could not be written.").arg(path));
  }
}

bool MainWindow::mayLeave()
{
  if (!this->document_->isOpen() || !this->document_->isModified())
  {
    return true;
  }
  const auto answer = QMessageBox::question(this,
    tr("Oversketch"),
    tr("Save the session of %1?").arg(this->document_->name()),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
    QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->save());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->mayLeave())
  {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue("geometry", this->saveGeometry());
  settings.setValue("state", this->saveState());
  this->document_->discardAutosave();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  const QList<QUrl> urls = event->mimeData()->urls();
  event->acceptProposedAction();
  if (urls.isEmpty())
  {
    return;
  }
  // Who dragged it need not wait for an answer to our questions.
  const QString path = urls.first().toLocalFile();
  QTimer::singleShot(0, this, [this, path] { this->open(path); });
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

void MainWindow::strokeDrawn(vtkPolyData* stroke)
{
  if (!this->document_->isOpen() || stroke->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->view_->showHint({});
  this->drawn_ = true;
  if (this->redrawn_ >= 0 &&
      static_cast<std::size_t>(this->redrawn_) < this->document_->session().nodes.size())
  {
    this->document_->redraw(this->redrawn_, stroke);
    this->redrawn_ = -1;
    this->drawn_ = false;
    return;
  }
  this->document_->addStroke(stroke, {}, this->document_->mirrorPlane(this->mirror_->currentIndex()));
  this->drawn_ = false;
}

void MainWindow::setDrawing(bool drawing)
{
  this->view_->setDrawing(drawing);
  (drawing ? this->draw_ : this->turn_)->setChecked(true);
  this->mode_->setText(drawing ? tr("Draw") : tr("Turn"));
  this->redrawn_ = drawing ? this->redrawn_ : -1;
  this->advise();
}

void MainWindow::setDark(bool dark)
{
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(dark ? darkPalette() : QApplication::style()->standardPalette());
  this->dark_->setChecked(dark);
  this->view_->setDark(dark);
  QSettings().setValue("dark", dark);
}

// Shows where the stroke took hold.
void MainWindow::select(int node)
{
  const auto& states = this->document_->result().nodes;
  this->redrawn_ = -1;
  this->view_->showSection(node >= 0 && static_cast<std::size_t>(node) < states.size()
                             ? states[static_cast<std::size_t>(node)].matched
                             : nullptr);
  this->advise();
}

void MainWindow::showResult()
{
  const Worker::Result& result = this->document_->result();
  Latency::of().meshComes();
  this->view_->showMesh(result.display, this->reset_);
  this->reset_ = false;
  this->refresh();
}

void MainWindow::refresh()
{
  const bool open = this->document_->isOpen();
  this->undo_->setEnabled(this->document_->canUndo());
  this->redo_->setEnabled(this->document_->canRedo());
  this->save_->setEnabled(open);
  this->setWindowModified(this->document_->isModified());
  this->setWindowTitle(open ? tr("%1[*] - Oversketch").arg(this->document_->name()) : tr("Oversketch"));
  if (!this->document_->isBusy())
  {
    this->patience_->stop();
    this->progress_->hide();
    this->cancel_->hide();
  }
  else if (!this->patience_->isActive() && !this->progress_->isVisible())
  {
    this->patience_->start();
  }
  this->advise();
}

// What to do next.
void MainWindow::advise()
{
  if (!this->document_->isOpen())
  {
    this->advice_->setText(tr("Open a model with Ctrl+O, or drop one here."));
    return;
  }
  const auto& nodes = this->document_->session().nodes;
  const auto& states = this->document_->result().nodes;
  if (this->redrawn_ >= 0)
  {
    this->advice_->setText(tr("Draw the stroke anew."));
  }
  else if (!nodes.empty() && states.size() == nodes.size() && nodes.back().on &&
           !states.back().failure.empty())
  {
    this->advice_->setText(
      tr("The last stroke did nothing: %1").arg(QString::fromStdString(states.back().failure)));
  }
  else if (!this->view_->isDrawing())
  {
    this->advice_->setText(tr("Drag the model to turn it. D draws."));
  }
  else if (nodes.empty())
  {
    this->advice_->setText(tr("Draw a line beside a limb's outline: the limb follows. The middle button "
                              "turns the model, F1 lists the keys."));
  }
  else
  {
    this->advice_->setText(
      tr("Draw on, or change a stroke on the right. Ctrl+Z undoes. The middle button turns the model."));
  }
}

} // namespace oversketch_studio
