#include "main_window.h"

#include "files.h"
#include "focus_frame.h"
#include "history_panel.h"
#include "latency.h"
#include "lesson.h"
#include "looks.h"
#include "option_presets.h"
#include "scene_panel.h"
#include "status_labels.h"
#include "step_lines.h"
#include "stroke_lines.h"
#include "systems.h"
#include "tools.h"
#include "view_menu.h"
#include "viewport.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QOpenGLWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyle>
#include <QStyleFactory>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

const QSize frameRoom(16, 48); // px as Qt counts them, of a window's frame

} // namespace

MainWindow::MainWindow(QWidget* parent)
  : QMainWindow(parent)
  , OpenDocument(new Document(this))
  , Large(new LargeModels(this->OpenDocument, [this] { return !this->View->tool()->isBusy(); }))
  , View(new Viewport(this))
  , Tools(oversketch_studio::makeTools(this->View, this->OpenDocument))
  , Sides(new QSplitter(Qt::Horizontal, this))
  , Scene(new ScenePanel(this->OpenDocument, this))
  , History(new HistoryPanel(this->OpenDocument, this))
  , Look(new ViewMenu(
      this->View,
      this->OpenDocument,
      [this] { return this->nodeMeant(); },
      this))
  , Lines(new StrokeLines(this->View))
  , Advice(new AdviceLabel(this))
  , Teacher(new LessonPlayer(this->OpenDocument, this))
  , Anyway(new QPushButton(this))
  , Mode(new QLabel(this))
  , Progress(new QProgressBar(this))
  , Cancel(new QPushButton(tr("&Cancel"), this))
  , BusyTimer(new QTimer(this))
{
  for (Tool* tool : this->Tools)
  {
    this->Canvases << tool->makeCanvas(this->Sides); // at the left
  }
  this->Sides->addWidget(new FocusFrame(this->View, this->Sides));
  this->Sides->setChildrenCollapsible(false);
  this->Sides->setSizes({ this->width(), this->width() }); // halves, also of what is not seen yet
  this->setCentralWidget(this->Sides);
  this->setAcceptDrops(true);
  this->addDock(tr("&Scene"), "scene_dock", this->Scene);
  this->addDock(tr("&History"), "history_dock", this->History);
  for (Tool* tool : this->Tools)
  {
    QWidget* panel = tool->makePanel(this);
    this->ToolDocks << (panel ? this->addDock(tool->title(), tool->objectName() + "_dock", panel) : nullptr);
  }
  this->makeMenus();
  this->makeTools();
  this->makeStatus();
  this->listenToModels();
  this->listenToRows();
  this->listenToDocument();
  this->listenToPanels();
  for (Tool* tool : this->Tools)
  {
    this->listenToTool(tool);
  }
  QSettings settings;
  this->resize(1200, 800);
  this->restoreGeometry(settings.value("geometry").toByteArray());
  // Whole on this screen, also what it was on a larger one, with a frame, which it has only once it is shown.
  const QRect screen = this->screen()->availableGeometry();
  this->resize(this->size().boundedTo(screen.size() - frameRoom));
  if (!screen.contains(this->geometry()))
  {
    this->move(screen.topLeft());
  }
  this->restoreState(settings.value("state").toByteArray());
  this->apply(Preferences::read());
  connect(this->View, &Viewport::cameraMoves, this, [this] { this->ShowsHints = false; });
  this->View->installEventFilter(this);
  for (QWidget* canvas : this->Canvases)
  {
    for (QWidget* one : canvas ? canvas->findChildren<QOpenGLWidget*>() : QList<QOpenGLWidget*>())
    {
      one->installEventFilter(this);
    }
  }
  this->setTool(this->Tools.first());
  this->View->setFocus();
  this->refresh();
}

MainWindow::~MainWindow()
{
  this->hide(); // a field that loses the focus gives out what was typed, as long as there is who takes it
}

void MainWindow::listenToDocument()
{
  connect(this->OpenDocument, &Document::opened, this, &MainWindow::opened);
  connect(this->OpenDocument, &Document::changed, this, &MainWindow::changed);
  connect(this->OpenDocument, &Document::shown, this, &MainWindow::showResult);
  connect(this->OpenDocument, &Document::detailed, this, &MainWindow::showDetails);
  connect(this->OpenDocument, &Document::idle, this, &MainWindow::refresh);
  this->OpenDocument->setLook([this] { return lookOf(*this->View); });
}

void MainWindow::listenToPanels()
{
  connect(this->History,
    &HistoryPanel::redrawAsked,
    this,
    [this](int node)
    {
      if (Tool* tool = this->toolOf(node))
      {
        this->OpenDocument->showTo(std::max(this->OpenDocument->shownTo(), node + 1));
        this->setTool(tool);
        this->Redrawn = node;
        this->lookFrom(node);
        this->offerStep();
        this->advise();
      }
    });
  connect(this->History,
    &HistoryPanel::lineAsked,
    this,
    [this](int node, int line)
    {
      if (Tool* tool = this->toolOf(node))
      {
        this->setTool(tool);
        tool->redraw(line);
        this->advise();
      }
    });
  connect(this->History, &HistoryPanel::viewAsked, this, &MainWindow::lookFrom);
  connect(this->History, &HistoryPanel::selected, this, &MainWindow::select);
  connect(this->Scene, &ScenePanel::addAsked, this, &MainWindow::addPictureAsked);
  connect(this->Scene,
    &ScenePanel::viewAsked,
    this,
    [this](int picture)
    { this->View->lookFrom(this->OpenDocument->session().pictures[indexOf(picture)]->frame.own()); });
}

void MainWindow::listenToTool(Tool* tool)
{
  connect(tool, &Tool::drawn, this, &MainWindow::stepDrawn);
  connect(tool, &Tool::changed, this, &MainWindow::stepChanged);
  connect(tool, &Tool::remade, this, &MainWindow::stepRemade);
  connect(tool, &Tool::shaped, this, &MainWindow::stepShaped);
  connect(tool, &Tool::edited, this->OpenDocument, &Document::redraw);
  connect(tool, &Tool::placed, this->OpenDocument, &Document::setPlacement);
  connect(tool, &Tool::givenUp, this->OpenDocument, &Document::undo);
  connect(tool,
    &Tool::swapAsked,
    this,
    [this] { this->Sides->insertWidget(0, this->Sides->widget(this->Sides->count() - 1)); });
  connect(tool,
    &Tool::movesAlone,
    this,
    [this] { this->Advice->setText(tr("The model follows when you let go of the line.")); });
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
      this->View->awaitMesh();
      this->View->showSection(nullptr);
      this->View->showRegion(nullptr);
      this->History->refresh();
      [[fallthrough]];
    case Document::Change::Pictures:
      this->View->showPictures(this->OpenDocument->session().pictures);
      this->Scene->refresh();
      break;
    case Document::Change::Saved:
      break;
  }
  this->refresh();
}

// The tool that draws on what the session begins with; a model that was opened is drawn on itself.
void MainWindow::opened()
{
  const Session& session = this->OpenDocument->session();
  if (!session.mesh)
  {
    this->View->clearMesh();
  }
  if (this->FrameOnNextMesh)
  {
    this->Look->setUpAxis(this->OpenDocument->upAxis());
  }
  Tool* first = session.nodes.empty() || session.mesh ? nullptr : this->toolOf(0);
  const int at = first ? this->Tools.indexOf(first) : -1;
  if (at >= 0 && this->Canvases[at])
  {
    this->setTool(first);
  }
  else if (this->Canvases[this->Tools.indexOf(this->View->tool())])
  {
    this->setTool(this->Tools.first());
  }
}

void MainWindow::stepDrawn(const Step& step)
{
  if (!this->OpenDocument->isOpen())
  {
    return;
  }
  this->stopTeaching();
  const int count = this->OpenDocument->shownTo();
  if (this->Redrawn >= 0 && this->Redrawn < count)
  {
    this->Offered = this->Redrawn;
    this->Redrawn = -1;
    this->OpenDocument->redraw(this->Offered, step);
    return;
  }
  this->Offered = count;
  this->OpenDocument->add(step);
  if (this->History->current() >= 0)
  {
    this->History->selectStep(count); // the hand has what it made, no longer another
  }
}

// A step of another kind may have come under the hand meanwhile.
void MainWindow::stepChanged(const Step& step)
{
  if (this->OpenDocument->isOf(this->Offered, step.system))
  {
    this->OpenDocument->redraw(this->Offered, step);
  }
}

void MainWindow::stepRemade(const Step& step)
{
  if (this->OpenDocument->isOf(this->Offered, step.system))
  {
    this->OpenDocument->remake(this->Offered, step);
  }
}

void MainWindow::stepShaped(const Values& values, bool mergesIntoLast)
{
  if (this->OpenDocument->nodeAt(this->Offered))
  {
    this->OpenDocument->setValues(this->Offered, values, mergesIntoLast);
  }
}

void MainWindow::setTool(Tool* tool)
{
  const int at = this->Tools.indexOf(tool);
  for (int i = 0; i < this->ToolDocks.size(); ++i)
  {
    if (this->ToolDocks[i])
    {
      this->ToolDocks[i]->setVisible(i == at);
    }
  }
  this->View->setTool(tool);
  this->selectDrawing(tool);
  this->History->turnTo(tool->system());
  this->ToolActions[at]->setChecked(true);
  this->Options->setCurrentIndex(at);
  this->Presets->setTool(tool);
  this->Mode->setText(tool->name());
  this->Redrawn = this->OpenDocument->isOf(this->Redrawn, tool->system()) ? this->Redrawn : -1;
  this->Speaks = -1;
  this->chooseLine();
  this->advise();
}

// A drawing is changed with its form at hand; what is drawn on the model then is a step of its own.
void MainWindow::selectDrawing(const Tool* tool)
{
  if (!this->OpenDocument->isOpen())
  {
    return;
  }
  if (this->OpenDocument->isOf(this->History->current(), drawingSystem) != (tool->system() == drawingSystem))
  {
    this->History->selectStep(tool->node());
  }
}

Tool* MainWindow::toolOf(int node) const
{
  const std::string& system = this->OpenDocument->nodeAt(node)->step->system;
  if (Tool* held = this->View->tool(); held && held->system() == system)
  {
    return held;
  }
  for (Tool* tool : this->Tools)
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
  if (const auto stroke = strokeOf(this->OpenDocument->session(), *this->OpenDocument->nodeAt(node)->step))
  {
    this->View->lookFrom(stroke);
  }
}

void MainWindow::apply(const Preferences& preferences)
{
  this->Settings = preferences;
  QApplication::setStyle(plainStyle());
  QApplication::setPalette(preferences.dark ? darkPalette() : QApplication::style()->standardPalette());
  this->Dark->setChecked(preferences.dark);
  this->View->setDark(preferences.dark);
  this->Look->setDark(preferences.dark);
  this->drawToolIcons();
  for (Tool* tool : this->Tools)
  {
    tool->setDark(preferences.dark);
    tool->setSteadiness(preferences.stabilizer);
  }
  this->OpenDocument->setBackend(preferences.backend);
  this->placeForHand(preferences.leftHanded);
}

void MainWindow::askPreferences()
{
  PreferencesDialog dialog(this->Settings, this);
  if (dialog.exec() == QDialog::Accepted)
  {
    this->apply(dialog.preferences());
    this->Settings.write();
  }
}

void MainWindow::select(int node)
{
  this->Redrawn = -1;
  this->View->tool()->redraw(-1);
  for (Tool* tool : this->Tools)
  {
    tool->select(node);
    tool->selectLine(this->History->currentLine());
  }
  this->showSection(node);
  this->offerStep();
  this->chooseLine();
  this->refresh();
}

void MainWindow::showSection(int node)
{
  const auto& states = this->OpenDocument->result().nodes;
  const bool isSeen = node >= 0 && indexOf(node) < states.size() && this->OpenDocument->session().shown;
  this->View->showSection(isSeen ? states[indexOf(node)].hold.Get() : nullptr);
}

void MainWindow::offerNothing()
{
  this->Offered = -1;
  for (Tool* tool : this->Tools)
  {
    tool->offerNothing();
  }
}

int MainWindow::nodeMeant() const
{
  const bool open = this->OpenDocument->isOpen();
  const int last = open ? this->OpenDocument->shownTo() - 1 : -1;
  return this->History->current() >= 0 ? std::min(this->History->current(), last) : last;
}

void MainWindow::offerStep()
{
  const auto& nodes = this->OpenDocument->session().nodes;
  const auto& states = this->OpenDocument->result().nodes;
  const int last = this->OpenDocument->shownTo() - 1;
  const int node = this->nodeMeant();
  this->View->showRegion(nullptr);
  // A step that the next stroke replaces is not in its way; what is not up to date cannot be shown following.
  const bool can = this->Redrawn < 0 && node >= 0 && node <= last && indexOf(last + 1) == states.size() &&
                   nodes[indexOf(node)].on && !this->OpenDocument->isBusy() && this->AcceptsSteps;
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
  else if (vtkPolyData* mesh = this->View->mesh())
  {
    mesh->GetCenter(place.data());
  }
  this->Offered = node;
  tool->offer(*nodes[indexOf(node)].step, state, place);
  this->View->showRegion(this->Region->isChecked() ? state.region.Get() : nullptr);
}

// The mesh is painted first; what follows on it can wait.
void MainWindow::showResult()
{
  const Worker::Result& result = this->OpenDocument->result();
  if (result.display)
  {
    Latency::of().meshComes();
    this->View->showMesh(result.display, this->FrameOnNextMesh);
    if (std::exchange(this->FrameOnNextMesh, false) && this->OpenDocument->look())
    {
      lookAs(*this->OpenDocument->look(), *this->View);
    }
    this->showSection(this->History->current());
    if (!this->OpenDocument->isBusy())
    {
      this->offerStep();
      this->chooseLine();
    }
    this->View->renderNow();
    for (Tool* tool : this->Tools)
    {
      tool->setMesh(result.display);
    }
  }
  else if (this->isNothingDrawn())
  {
    this->View->clearMesh();
    this->FrameOnNextMesh = true;
  }
  this->History->refresh();
  this->hearRows();
  this->refresh();
}

// The step was offered with the mesh; now the mesh can follow it.
void MainWindow::showDetails()
{
  if (this->OpenDocument->isBusy())
  {
    return;
  }
  const auto& states = this->OpenDocument->result().nodes;
  if (this->Offered >= 0 && indexOf(this->Offered) < states.size())
  {
    const auto& state = states[indexOf(this->Offered)];
    if (Tool* tool = this->toolOf(this->Offered))
    {
      tool->setFollowing(state.following);
    }
    this->View->showRegion(this->Region->isChecked() ? state.region.Get() : nullptr);
  }
}

// A drawing without strokes makes no model, also not the last one.
bool MainWindow::isNothingDrawn() const
{
  const Session& session = this->OpenDocument->session();
  const auto isDrawn = [](const Node& node) { return !strokesOf(*node.step).empty(); };
  return !this->OpenDocument->isBusy() && !session.nodes.empty() &&
         session.nodes.front().step->system == drawingSystem &&
         std::none_of(session.nodes.begin(), session.nodes.end(), isDrawn);
}

void MainWindow::refresh()
{
  const bool open = this->OpenDocument->isOpen();
  this->Undo->setEnabled(this->OpenDocument->canUndo());
  this->Redo->setEnabled(this->OpenDocument->canRedo());
  this->Save->setEnabled(open);
  // A drawing without lines has no mesh.
  this->Export->setEnabled(open && (this->OpenDocument->result().mesh || this->OpenDocument->session().mesh));
  this->Print->setEnabled(this->Export->isEnabled());
  this->Turntable->setEnabled(this->Export->isEnabled());
  if (this->Back)
  {
    const Node* drawing = this->OpenDocument->nodeAt(this->drawingMeant());
    this->Back->setEnabled(drawing);
    this->NoBack->setEnabled(
      drawing && drawing->step->inputs.count(findSystem(drawingSystem)->backTextureInput) > 0);
  }
  this->setWindowModified(this->OpenDocument->isModified());
  this->setWindowTitle(open ? tr("%1[*] - Oversketch").arg(this->OpenDocument->name()) : tr("Oversketch"));
  if (!this->OpenDocument->isBusy())
  {
    this->BusyTimer->stop();
    this->Progress->setVisible(this->Large->isMaking());
    this->Cancel->hide();
  }
  else if (!this->BusyTimer->isActive() && !this->Cancel->isVisible())
  {
    this->BusyTimer->start();
  }
  this->advise();
}

} // namespace oversketch_studio
