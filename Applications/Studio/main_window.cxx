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
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QFrame>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QStyle>
#include <QStyleFactory>
#include <QTimer>
#include <QVBoxLayout>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch_files::Failed;

namespace
{

QString meshFilter()
{
  QString extensions;
  for (const QString& extension : QString::fromLatin1(oversketch_files::meshExtensions).split(' '))
  {
    extensions += " *" + extension;
  }
  return extensions.mid(1);
}

vtkSmartPointer<vtkPolyData> strokeOf(const Node& node)
{
  return linesOf(*node.step, "Stroke");
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , document_(new Document(this))
  , view_(new View(this))
  , frame_(new QFrame(this))
  , history_(new HistoryPanel(this->document_, this))
  , dock_(new QDockWidget(tr("History"), this))
  , advice_(new QLabel(this))
  , mode_(new QLabel(this))
  , progress_(new QProgressBar(this))
  , cancel_(new QPushButton(tr("&Cancel"), this))
  , patience_(new QTimer(this))
{
  auto* about = new QVBoxLayout(this->frame_);
  about->setContentsMargins(2, 2, 2, 2);
  about->addWidget(this->view_);
  this->frame_->setAutoFillBackground(true);
  this->setCentralWidget(this->frame_);
  this->setAcceptDrops(true);
  this->dock_->setObjectName("history dock");
  this->dock_->setWidget(this->history_);
  this->addDockWidget(Qt::RightDockWidgetArea, this->dock_);
  this->makeMenus();
  this->makeTools();
  this->makeStatus();

  connect(this->document_, &Document::opened, this, [this] { this->reset_ = true; });
  connect(this->document_,
    &Document::changed,
    this,
    [this]
    {
      if (!this->document_->isBusy()) // it has been saved
      {
        this->refresh();
        return;
      }
      this->view_->awaitMesh();
      if (!this->drawn_)
      {
        this->view_->clearStroke(); // it tells nothing of what is shown from here on
        this->offered_ = -1;
      }
      this->view_->showSection(nullptr);
      this->view_->showRegion(nullptr);
      this->refresh();
    });
  connect(this->document_, &Document::shown, this, &MainWindow::showResult);
  connect(this->document_, &Document::detailed, this, &MainWindow::showDetails);
  connect(this->document_, &Document::idle, this, &MainWindow::refresh);
  connect(this->view_, &View::strokeDrawn, this, &MainWindow::strokeDrawn);
  connect(this->view_, &View::strokeChanged, this, &MainWindow::strokeChanged);
  connect(this->view_,
    &View::lineMovesAlone,
    this,
    [this] { this->advice_->setText(tr("The model follows when you let go of the line.")); });
  connect(this->view_, &View::lineLeft, this, &MainWindow::advise);
  connect(this->view_, &View::quitAsked, this, &MainWindow::close, Qt::QueuedConnection);
  connect(this->history_,
    &HistoryPanel::redrawAsked,
    this,
    [this](int node)
    {
      this->redrawn_ = node;
      this->setDrawing(true);
      this->view_->lookFrom(strokeOf(this->document_->session().nodes[static_cast<std::size_t>(node)]));
      this->offerStroke();
      this->advise();
    });
  connect(this->history_,
    &HistoryPanel::viewAsked,
    this,
    [this](int node)
    { this->view_->lookFrom(strokeOf(this->document_->session().nodes[static_cast<std::size_t>(node)])); });
  connect(this->history_, &HistoryPanel::selected, this, &MainWindow::select);
  // Of the frame, not of the window, which is no longer one when it closes at its end and the focus goes.
  connect(qApp,
    &QApplication::focusChanged,
    this->frame_,
    [frame = this->frame_, view = static_cast<QWidget*>(this->view_)](QWidget*, QWidget* now)
    { frame->setBackgroundRole(now == view ? QPalette::Highlight : QPalette::Window); });

  QSettings settings;
  this->resize(1200, 800);
  this->restoreGeometry(settings.value("geometry").toByteArray());
  this->restoreState(settings.value("state").toByteArray());
  this->apply(Preferences::read());
  this->setDrawing(true);
  this->view_->setFocus();
  this->refresh();
}

MainWindow::~MainWindow() = default;

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
    box.setInformativeText(left.strokes == 1
                             ? tr("It holds one stroke.")
                             : tr("It holds %n strokes.", nullptr, static_cast<int>(left.strokes)));
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
    this->view_->showHint(tr("Draw a line like this, and the tail follows"));
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
  this->tried([&] { this->view_->screenshot(path, overlays); });
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
    this->offered_ = this->redrawn_;
    this->redrawn_ = -1;
    this->document_->redraw(this->offered_, stroke);
    this->drawn_ = false;
    return;
  }
  this->offered_ = static_cast<int>(this->document_->session().nodes.size());
  this->document_->addStroke(stroke, this->document_->mirrorPlane(this->mirror_->currentIndex()));
  this->drawn_ = false;
}

void MainWindow::strokeChanged(vtkPolyData* stroke)
{
  if (this->offered_ >= 0 &&
      static_cast<std::size_t>(this->offered_) < this->document_->session().nodes.size())
  {
    this->drawn_ = true;
    this->document_->redraw(this->offered_, stroke);
    this->drawn_ = false;
  }
}

void MainWindow::setDrawing(bool drawing)
{
  this->view_->setDrawing(drawing);
  (drawing ? this->draw_ : this->turn_)->setChecked(true);
  this->mode_->setText(drawing ? tr("Draw") : tr("Turn"));
  this->redrawn_ = drawing ? this->redrawn_ : -1;
  this->advise();
}

void MainWindow::askPreferences()
{
  PreferencesDialog dialog(this->preferences_, this);
  if (dialog.exec() == QDialog::Accepted)
  {
    this->apply(dialog.preferences());
    this->preferences_.write();
  }
}

void MainWindow::apply(const Preferences& preferences)
{
  this->preferences_ = preferences;
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(preferences.dark ? darkPalette() : QApplication::style()->standardPalette());
  this->dark_->setChecked(preferences.dark);
  this->view_->setDark(preferences.dark);
  this->view_->setStabilizer(preferences.stabilizer);
  this->document_->setBackend(preferences.backend);
}

void MainWindow::select(int node)
{
  this->redrawn_ = -1;
  this->showSection(node);
  this->offerStroke();
  this->advise();
}

void MainWindow::showSection(int node)
{
  const auto& states = this->document_->result().nodes;
  this->view_->showSection(node >= 0 && static_cast<std::size_t>(node) < states.size()
                             ? states[static_cast<std::size_t>(node)].hold.Get()
                             : nullptr);
}

void MainWindow::offerStroke()
{
  const auto& nodes = this->document_->session().nodes;
  const auto& states = this->document_->result().nodes;
  const int last = static_cast<int>(nodes.size()) - 1;
  const int node = this->history_->current() >= 0 ? this->history_->current() : last;
  this->offered_ = -1;
  this->view_->showRegion(nullptr);
  // What the next stroke replaces is not in its way; what is not up to date cannot be shown following.
  if (this->redrawn_ >= 0 || node < 0 || node > last || states.size() != nodes.size() ||
      !nodes[static_cast<std::size_t>(node)].on || this->document_->isBusy())
  {
    this->view_->clearStroke();
    return;
  }
  const auto& state = states[static_cast<std::size_t>(node)];
  Point place{};
  if (state.section)
  {
    place = state.section->middle;
  }
  else
  {
    this->document_->session().mesh->GetCenter(place.data());
  }
  this->offered_ = node;
  this->view_->offerStroke(strokeOf(nodes[static_cast<std::size_t>(node)]), place, state.following);
  this->view_->showRegion(this->region_->isChecked() ? state.region.Get() : nullptr);
}

void MainWindow::showResult()
{
  const Worker::Result& result = this->document_->result();
  Latency::of().meshComes();
  this->view_->showMesh(result.display, this->reset_);
  this->reset_ = false;
  this->showSection(this->history_->current());
  if (!this->document_->isBusy())
  {
    this->offerStroke();
  }
  this->refresh();
}

// The stroke was offered with the mesh; now the mesh can follow it.
void MainWindow::showDetails()
{
  if (this->document_->isBusy())
  {
    return;
  }
  const auto& states = this->document_->result().nodes;
  if (this->offered_ >= 0 && static_cast<std::size_t>(this->offered_) < states.size())
  {
    const auto& state = states[static_cast<std::size_t>(this->offered_)];
    this->view_->setFollowing(state.following);
    this->view_->showRegion(this->region_->isChecked() ? state.region.Get() : nullptr);
  }
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
    this->advice_->setText(tr("Draw the selected stroke anew. T leaves it as it is."));
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
  else if (this->history_->current() >= 0)
  {
    this->advice_->setText(
      tr("Blue is where the selected stroke took hold. Change how it acts on the right, or "
         "draw it anew (Ctrl+R)."));
  }
  else if (nodes.empty())
  {
    this->advice_->setText(tr("Draw a line beside a limb's outline: the limb follows. The middle button "
                              "turns the model, F1 lists the keys."));
  }
  else
  {
    this->advice_->setText(
      tr("Draw on, or drag the red line to move the stroke (Shift: draw a part anew; Return: "
         "leave it and draw there). Ctrl+Z undoes. The "
         "middle button turns the model."));
  }
}

} // namespace oversketch_studio
