#include "place_tool.h"

#include "document.h"
#include "pieces.h"
#include "systems.h"
#include "viewport.h"

#include "pen_view.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkAppendPolyData.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <utility>
#include <vector>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch::Pose;
using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;

namespace
{

constexpr const char* placingSystem = "Transform";

template <typename T>
T placingValue(const Step& step, const char* property)
{
  return std::get<T>(valueOf(step, *findParameter(*findSystem(placingSystem), property)));
}

Pose poseOf(const Step& step)
{
  const auto read = [&step](const char* property)
  { return Vector3(placingValue<std::vector<double>>(step, property).data()); };
  return { read("Move"), read("Turn"), read("Scale") };
}

void setPose(const Pose& pose, Step& step)
{
  const auto write = [&step](const char* property, const Vector3& value)
  { step.values[property] = std::vector<double>(value.data(), value.data() + 3); };
  write("Move", pose.move);
  write("Turn", pose.turn);
  write("Scale", pose.scale);
}

Step placing(int part)
{
  Step step;
  step.system = placingSystem;
  step.values["Part"] = part;
  return step;
}

} // namespace

PlaceTool::PlaceTool(Viewport* viewport, const Document* document)
  : Tool(viewport)
  , View(viewport)
  , OpenDocument(document)
  , Gizmo(viewport)
{
  this->setObjectName("place");
  viewport->installEventFilter(this);
  connect(document,
    &Document::opened,
    this,
    [this]
    {
      this->Part.reset();
      this->follow();
    });
  // It may have been locked, or a part of it hidden.
  connect(document,
    &Document::changed,
    this,
    [this]
    {
      this->Clickable = nullptr;
      this->followAtRest();
    });
}

PlaceTool::~PlaceTool() = default;

std::string PlaceTool::system() const
{
  return placingSystem;
}

// Four arrows from a square.
QPainterPath PlaceTool::icon() const
{
  QPainterPath path;
  path.addRect(9.5, 9.5, 5, 5);
  for (const QPointF& run : { QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0), QPointF(0, -1) })
  {
    const QPointF middle(12, 12), across(-run.y(), run.x());
    path.moveTo(middle + 4.5 * run);
    path.lineTo(middle + 10.5 * run);
    path.moveTo(middle + 7.5 * run + 2.5 * across);
    path.lineTo(middle + 10.5 * run);
    path.lineTo(middle + 7.5 * run - 2.5 * across);
  }
  return path;
}

QVector<QPair<QString, QString>> PlaceTool::keys() const
{
  return {
    { tr("Left click"), tr("on the model or a part of it: take it; double: its twin in the mirror") },
    { tr("Left drag"), tr("of an arrow: move; of a ring: turn; of a box: scale; beside: rotate the view") },
    { tr("Shift + a box"), tr("scale in all directions") },
    { tr("The square"), tr("move in the picture's plane; with Ctrl: onto the surface under the cursor") },
  };
}

QString PlaceTool::advice(const Situation&) const
{
  if (!this->OpenDocument->isOpen() || !this->OpenDocument->whyNoSteps(placingSystem).isEmpty())
  {
    return this->OpenDocument->isOpen() ? this->OpenDocument->whyNoSteps(placingSystem)
                                        : tr("File > Open, then click on the model.");
  }
  return this->Gizmo.stand()
           ? tr(
               "Arrows move it, rings turn it, boxes scale it (Shift: all alike), the square moves it in the "
               "picture (Ctrl: onto a surface). Escape lets go.")
           : tr("Click on the model or a part of it to move, turn and scale it. A double click adds its twin "
                "in the mirror.");
}

void PlaceTool::select(int node)
{
  if (this->OpenDocument->isOf(node, placingSystem))
  {
    this->Part = placingValue<int>(*this->OpenDocument->nodeAt(node)->step, "Part");
  }
}

void PlaceTool::start()
{
  this->Taken = true;
  this->View->camera()->SetModeToNavigate();
  this->View->setHandCursor(Qt::OpenHandCursor);
  this->follow();
}

void PlaceTool::stop()
{
  this->giveUp();
  this->Taken = false;
  this->Pressed.reset();
  this->follow();
}

void PlaceTool::offer(const Step& step, const Worker::NodeState& state, const Point&)
{
  this->Offered = step;
  this->Before = state.before;
  this->follow();
}

void PlaceTool::offerNothing()
{
  this->giveUp();
  this->Offered.reset();
  this->followAtRest();
}

void PlaceTool::setMesh(vtkPolyData*)
{
  this->giveUp();
  this->Clickable = nullptr;
  this->followAtRest();
}

// While a result is awaited the gizmo stands where the hand has put it.
void PlaceTool::followAtRest()
{
  if (!this->OpenDocument->isBusy() && !this->Held)
  {
    this->follow();
  }
}

bool PlaceTool::changesOffered() const
{
  return this->Offered && this->Before && this->Part &&
         placingValue<int>(*this->Offered, "Part") == *this->Part &&
         placingValue<int>(*this->Offered, "Copy") == 0;
}

void PlaceTool::follow()
{
  vtkPolyData* shown = this->View->mesh();
  const bool can = this->Taken && this->Part && shown && this->OpenDocument->isOpen() &&
                   this->OpenDocument->whyNoSteps(placingSystem).isEmpty();
  if (!can)
  {
    this->Gizmo.show(std::nullopt);
    return;
  }
  vtkPolyData* mesh = this->changesOffered() ? this->Before.Get() : shown;
  const Eigen::AlignedBox3d box = boxOfPoints(mesh, pointsOfPart(mesh, *this->Part));
  if (box.isEmpty()) // the part is there no more
  {
    this->Part.reset();
    this->Gizmo.show(std::nullopt);
    return;
  }
  this->Gizmo.show(
    PlaceGizmo::Stand{ box.center(), this->changesOffered() ? poseOf(*this->Offered) : Pose() });
}

Vector2 PlaceTool::placeOf(const QMouseEvent& mouse) const
{
  const double ratio = this->View->devicePixelRatioF();
  return { ratio * mouse.localPos().x(), ratio * (this->View->height() - mouse.localPos().y()) - 1.0 };
}

bool PlaceTool::eventFilter(QObject*, QEvent* event)
{
  if (!this->Taken)
  {
    return false;
  }
  const auto type = event->type();
  if (type == QEvent::KeyPress)
  {
    const bool wasHeld = this->Held != nullptr; // then all keys are the hand's
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    {
      this->Part = wasHeld ? this->Part : std::nullopt;
      this->giveUp();
      this->followAtRest();
      emit this->left();
    }
    return wasHeld;
  }
  if (type != QEvent::MouseButtonPress && type != QEvent::MouseButtonDblClick && type != QEvent::MouseMove &&
      type != QEvent::MouseButtonRelease)
  {
    return false;
  }
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  const Vector2 at = this->placeOf(mouse);
  if (type == QEvent::MouseMove)
  {
    if (this->Held)
    {
      this->pull(at, mouse.modifiers());
      return true;
    }
    if (mouse.buttons() == Qt::NoButton)
    {
      this->Gizmo.light(this->Gizmo.at(at));
    }
    return false;
  }
  if (mouse.button() != Qt::LeftButton)
  {
    return this->Held != nullptr; // nobody else hears of a drag
  }
  if (type != QEvent::MouseButtonRelease)
  {
    const bool isSecond = std::exchange(this->Clicked, false) && type == QEvent::MouseButtonDblClick;
    return (isSecond && this->makeTwin(at)) || this->press(mouse);
  }
  if (this->Held)
  {
    this->Clicked = !this->Held->hasMoved;
    this->letGo();
    return true;
  }
  const auto from = std::exchange(this->Pressed, std::nullopt);
  this->Clicked = from && (mouse.pos() - *from).manhattanLength() < QApplication::startDragDistance() / 2;
  if (this->Clicked)
  {
    this->click(at);
  }
  return false;
}

// What is shown is awaited first: a drag begins on it.
bool PlaceTool::press(const QMouseEvent& mouse)
{
  const auto grip = this->Gizmo.at(this->placeOf(mouse));
  if (grip && this->View->mesh() && !(mouse.modifiers() & Qt::AltModifier) && !this->OpenDocument->isBusy())
  {
    this->Held = std::make_unique<Drag>(Drag{
      *grip, this->placeOf(mouse), *this->Gizmo.stand(), PartPreview(this->View->mesh(), *this->Part) });
    this->Gizmo.light(grip);
    this->View->showRegion(nullptr); // it lies where the part was
    return true;
  }
  const bool mayClick = mouse.type() == QEvent::MouseButtonPress && mouse.modifiers() == Qt::NoModifier;
  this->Pressed = mayClick ? std::optional<QPoint>(mouse.pos()) : std::nullopt;
  return false;
}

void PlaceTool::pull(const Vector2& at, Qt::KeyboardModifiers keys)
{
  const auto view = oversketch::PenView::of(this->View->renderer()).sight();
  const double least = 0.5 * QApplication::startDragDistance() * this->View->devicePixelRatioF();
  if (!view || (!this->Held->hasMoved && (at - this->Held->start).norm() < least)) // a click trembles
  {
    return;
  }
  const auto& [middle, from] = this->Held->from;
  Pose pose =
    posed(*view, middle, from, this->Held->grip, this->Held->start, at, (keys & Qt::ShiftModifier) != 0);
  if (this->Held->grip.part == GizmoGrip::Square && (keys & Qt::ControlModifier))
  {
    if (const auto surface = this->surfaceAt(*view, at))
    {
      const Eigen::AlignedBox3d box = this->Held->preview.box();
      const int up = this->View->camera()->GetUpAxis();
      Vector3 foot = box.center();
      foot[up] = box.min()[up];
      pose.move = from.move + *surface - foot;
    }
  }
  // From where it is shown, which is the pose that it was taken in.
  this->Held->hasMoved = true;
  this->Held->preview.moveTo(pose.about(middle) * from.about(middle).inverse());
  this->View->showPreview(this->Held->preview.mesh());
  this->Gizmo.show(PlaceGizmo::Stand{ middle, pose });
}

// The preview stays until the result comes.
void PlaceTool::letGo()
{
  const auto held = std::exchange(this->Held, nullptr);
  if (!held->hasMoved)
  {
    return;
  }
  Step step = this->changesOffered() ? *this->Offered : placing(*this->Part);
  setPose(this->Gizmo.stand()->pose, step);
  if (this->changesOffered())
  {
    emit this->shaped(step.values, false);
  }
  else
  {
    emit this->drawn(step);
  }
}

void PlaceTool::giveUp()
{
  if (const auto held = std::exchange(this->Held, nullptr))
  {
    if (held->hasMoved && this->View->mesh() == held->preview.mesh())
    {
      this->View->showPreview(held->preview.rest());
    }
    this->Gizmo.show(held->from);
  }
}

std::optional<Vector3> PlaceTool::surfaceAt(const oversketch::View& view, const Vector2& at)
{
  if (!this->Held->round)
  {
    vtkNew<vtkAppendPolyData> all;
    vtkPolyData* own = this->Held->preview.rest();
    const Session& session = this->OpenDocument->session();
    if (*this->Part >= 0 && !oversketch_files::partsOf(own).empty())
    {
      std::set<int> without = hiddenOf(session, this->OpenDocument->result().parts);
      without.insert(*this->Part);
      all->AddInputData(oversketch_files::withoutParts(own, without));
    }
    for (const auto& other : session.others)
    {
      if (other->own.shown && other->made.display)
      {
        all->AddInputData(other->made.display.own());
      }
    }
    if (all->GetNumberOfInputConnections(0) > 0)
    {
      all->Update();
    }
    this->Held->round = std::make_unique<SeenSurface>(all->GetOutput());
  }
  const auto hit = this->Held->round->at(view, at);
  return hit ? std::optional<Vector3>(hit->place) : std::nullopt;
}

std::optional<int> PlaceTool::partAt(const Vector2& at)
{
  vtkPolyData* mesh = this->View->mesh();
  const auto view = oversketch::PenView::of(this->View->renderer()).sight();
  if (!mesh || !view || !this->OpenDocument->isOpen() ||
      !this->OpenDocument->whyNoSteps(placingSystem).isEmpty() ||
      this->View->display().others().at(static_cast<int>(at[0]), static_cast<int>(at[1])))
  {
    return std::nullopt;
  }
  if (!this->Clickable)
  {
    const std::set<int> hidden = hiddenOf(this->OpenDocument->session(), this->OpenDocument->result().parts);
    this->Clickable = std::make_unique<SeenSurface>(oversketch_files::withoutParts(mesh, hidden));
  }
  const auto hit = this->Clickable->at(*view, at);
  const bool isOne = oversketch_files::partsOf(mesh).size() < 2;
  return hit ? std::optional<int>(isOne ? -1 : this->Clickable->partOf(hit->face)) : std::nullopt;
}

void PlaceTool::click(const Vector2& at)
{
  const auto part = this->partAt(at);
  if (part != this->Part)
  {
    this->Part = part;
    this->follow();
    this->Gizmo.light(this->Gizmo.at(at));
    emit this->left();
  }
}

// It is the hand's next.
bool PlaceTool::makeTwin(const Vector2& at)
{
  const auto part = this->OpenDocument->isBusy() ? std::nullopt : this->partAt(at);
  if (!part)
  {
    return false;
  }
  Step step = placing(*part);
  step.values["Copy"] = 1;
  const auto plane = this->OpenDocument->mirrorPlane(1); // none where the first step made the model
  step.values["MirrorOffset"] = plane ? plane->offset : this->View->mesh()->GetCenter()[0];
  const std::vector<int> parts = oversketch_files::partsOf(this->View->mesh());
  this->Part = parts.empty() ? 1 : parts.back() + 1;
  emit this->drawn(step);
  return true;
}

} // namespace oversketch_studio
