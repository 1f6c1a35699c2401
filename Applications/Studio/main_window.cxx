#include "main_window.h"

#include "files.h"
#include "history_panel.h"
#include "latency.h"
#include "looks.h"
#include "scene_panel.h"
#include "tools.h"
#include "viewport.h"

#include <QAction>
#include <QApplication>
#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStyle>
#include <QStyleFactory>
#include <QTimer>
#include <QVBoxLayout>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

std::size_t indexOf(int node)
{
  return static_cast<std::size_t>(node);
}

// The first stroke that a step was given, with its view.
vtkSmartPointer<vtkPolyData> strokeOf(const Step& step)
{
  const SystemRow* row = findSystem(step.system);
  const SystemInput* input = row ? findInput(*row, SystemInput::Kind::Stroke) : nullptr;
  return input ? linesOf(step, input->name) : nullptr;
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , document_(new Document(this))
  , view_(new Viewport(this))
  , tools_(oversketch_studio::makeTools(this->view_, this->document_))
  , frame_(new QFrame(this))
  , scene_(new ScenePanel(this->document_, this))
  , history_(new HistoryPanel(this->document_, this))
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
  this->addDock(tr("&Scene"), "scene_dock", this->scene_);
  this->addDock(tr("&History"), "history_dock", this->history_);
  this->makeMenus();
  this->makeTools();
  this->makeStatus();
  this->listenToDocument();
  this->listenToPanels();
  for (Tool* tool : this->tools_)
  {
    this->listenToTool(tool);
  }
  connect(this->view_, &Viewport::quitAsked, this, &MainWindow::close, Qt::QueuedConnection);
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
  this->setTool(this->tools_.first());
  this->view_->setFocus();
  this->refresh();
}

MainWindow::~MainWindow() = default;

void MainWindow::listenToDocument()
{
  connect(this->document_, &Document::opened, this, [this] { this->reset_ = true; });
  connect(this->document_, &Document::changed, this, &MainWindow::changed);
  connect(this->document_, &Document::shown, this, &MainWindow::showResult);
  connect(this->document_, &Document::detailed, this, &MainWindow::showDetails);
  connect(this->document_, &Document::idle, this, &MainWindow::refresh);
}

void MainWindow::listenToPanels()
{
  connect(this->history_,
    &HistoryPanel::redrawAsked,
    this,
    [this](int node)
    {
      if (Tool* tool = this->toolOf(node))
      {
        this->setTool(tool);
        this->redrawn_ = node;
        this->lookFrom(node);
        this->offerStep();
        this->advise();
      }
    });
  connect(this->history_, &HistoryPanel::viewAsked, this, &MainWindow::lookFrom);
  connect(this->history_, &HistoryPanel::selected, this, &MainWindow::select);
  connect(this->scene_, &ScenePanel::addAsked, this, &MainWindow::addPictureAsked);
  connect(this->scene_,
    &ScenePanel::viewAsked,
    this,
    [this](int picture)
    { this->view_->lookFrom(this->document_->session().pictures[indexOf(picture)]->frame.own()); });
}

void MainWindow::listenToTool(Tool* tool)
{
  connect(tool, &Tool::drawn, this, &MainWindow::stepDrawn);
  connect(tool, &Tool::changed, this, &MainWindow::stepChanged);
  connect(tool,
    &Tool::movesAlone,
    this,
    [this] { this->advice_->setText(tr("The model follows when you let go of the line.")); });
  connect(tool, &Tool::left, this, &MainWindow::advise);
}

void MainWindow::changed(Document::Change change)
{
  switch (change)
  {
    case Document::Change::Edited:
      this->offerNothing(); // it tells nothing of what is shown from here on
      [[fallthrough]];
    case Document::Change::Drawn:
      this->view_->awaitMesh();
      this->view_->showSection(nullptr);
      this->view_->showRegion(nullptr);
      this->history_->refresh();
      [[fallthrough]];
    case Document::Change::Pictures:
      this->view_->showPictures(this->document_->session().pictures);
      this->scene_->refresh();
      break;
    case Document::Change::Saved:
      break;
  }
  this->refresh();
}

void MainWindow::stepDrawn(const Step& step)
{
  if (!this->document_->isOpen())
  {
    return;
  }
  this->view_->showHint({});
  const int count = static_cast<int>(this->document_->session().nodes.size());
  if (this->redrawn_ >= 0 && this->redrawn_ < count)
  {
    this->offered_ = this->redrawn_;
    this->redrawn_ = -1;
    this->document_->redraw(this->offered_, step);
    return;
  }
  this->offered_ = count;
  this->document_->add(step);
}

void MainWindow::stepChanged(const Step& step)
{
  if (this->offered_ >= 0 && indexOf(this->offered_) < this->document_->session().nodes.size())
  {
    this->document_->redraw(this->offered_, step);
  }
}

void MainWindow::setTool(Tool* tool)
{
  const int at = this->tools_.indexOf(tool);
  this->view_->setTool(tool);
  this->toolActions_[at]->setChecked(true);
  this->options_->setCurrentIndex(at);
  const QString mode = tool->mode();
  this->mode_->setText(mode.left(1).toUpper() + mode.mid(1));
  this->redrawn_ = tool->system().empty() ? -1 : this->redrawn_;
  this->advise();
}

Tool* MainWindow::toolOf(int node) const
{
  const std::string& system = this->document_->session().nodes[indexOf(node)].step->system;
  for (Tool* tool : this->tools_)
  {
    if (tool->system() == system)
    {
      return tool;
    }
  }
  return nullptr;
}

void MainWindow::lookFrom(int node)
{
  this->view_->lookFrom(strokeOf(*this->document_->session().nodes[indexOf(node)].step));
}

void MainWindow::apply(const Preferences& preferences)
{
  this->preferences_ = preferences;
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(preferences.dark ? darkPalette() : QApplication::style()->standardPalette());
  this->dark_->setChecked(preferences.dark);
  this->view_->setDark(preferences.dark);
  this->drawToolIcons();
  for (Tool* tool : this->tools_)
  {
    tool->setSteadiness(preferences.stabilizer);
  }
  this->document_->setBackend(preferences.backend);
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

void MainWindow::select(int node)
{
  this->redrawn_ = -1;
  this->showSection(node);
  this->offerStep();
  this->advise();
}

void MainWindow::showSection(int node)
{
  const auto& states = this->document_->result().nodes;
  this->view_->showSection(
    node >= 0 && indexOf(node) < states.size() ? states[indexOf(node)].hold.Get() : nullptr);
}

void MainWindow::offerNothing()
{
  this->offered_ = -1;
  for (Tool* tool : this->tools_)
  {
    tool->offerNothing();
  }
}

void MainWindow::offerStep()
{
  const auto& nodes = this->document_->session().nodes;
  const auto& states = this->document_->result().nodes;
  const int last = static_cast<int>(nodes.size()) - 1;
  const int node = this->history_->current() >= 0 ? this->history_->current() : last;
  this->view_->showRegion(nullptr);
  // What the next stroke replaces is not in its way; what is not up to date cannot be shown following.
  const bool can = this->redrawn_ < 0 && node >= 0 && node <= last && states.size() == nodes.size() &&
                   nodes[indexOf(node)].on && !this->document_->isBusy();
  Tool* tool = can ? this->toolOf(node) : nullptr;
  this->offerNothing();
  if (!tool)
  {
    return;
  }
  const auto& state = states[indexOf(node)];
  Point place{};
  if (state.section)
  {
    place = state.section->middle;
  }
  else if (vtkPolyData* mesh = this->view_->mesh())
  {
    mesh->GetCenter(place.data());
  }
  this->offered_ = node;
  tool->offer(*nodes[indexOf(node)].step, state, place);
  this->view_->showRegion(this->region_->isChecked() ? state.region.Get() : nullptr);
}

// The mesh is painted first; what follows on it can wait.
void MainWindow::showResult()
{
  const Worker::Result& result = this->document_->result();
  if (result.display)
  {
    Latency::of().meshComes();
    this->view_->showMesh(result.display, this->reset_);
    this->reset_ = false;
    this->showSection(this->history_->current());
    if (!this->document_->isBusy())
    {
      this->offerStep();
    }
    this->view_->renderNow();
    for (Tool* tool : this->tools_)
    {
      tool->setMesh(result.display);
    }
  }
  this->history_->refresh();
  this->refresh();
}

// The step was offered with the mesh; now the mesh can follow it.
void MainWindow::showDetails()
{
  if (this->document_->isBusy())
  {
    return;
  }
  const auto& states = this->document_->result().nodes;
  if (this->offered_ >= 0 && indexOf(this->offered_) < states.size())
  {
    const auto& state = states[indexOf(this->offered_)];
    if (Tool* tool = this->toolOf(this->offered_))
    {
      tool->setFollowing(state.following);
    }
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
  if (this->redrawn_ < 0 && !nodes.empty() && states.size() == nodes.size() && nodes.back().on &&
      !states.back().failure.empty())
  {
    this->advice_->setText(
      tr("The last stroke did nothing: %1").arg(QString::fromStdString(states.back().failure)));
    return;
  }
  Tool::Situation situation;
  situation.empty = nodes.empty();
  situation.selected = this->history_->current() >= 0;
  situation.redraws = this->redrawn_ >= 0;
  this->advice_->setText(this->view_->tool()->advice(situation));
}

} // namespace oversketch_studio
