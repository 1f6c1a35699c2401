#include "place_tool.h"

#include "document.h"
#include "pieces.h"
#include "point_normals.h"
#include "systems.h"
#include "viewport.h"

#include "pen_view.h"

#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchJoinedParts.h"
#include "vtkOversketchTransform.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStaticCellLocator.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <utility>
#include <vector>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch::Vector2;
using oversketch::Vector3;

namespace
{

constexpr const char* placingSystem = "Transform";
constexpr const char* moveName = "Move";
constexpr const char* turnName = "Turn";
constexpr const char* scaleName = "Scale";
constexpr const char* partName = "Part";
constexpr const char* copyName = "Copy";

template <typename T>
T placingValue(const Step& step, const char* property)
{
  return std::get<T>(valueOf(step, *findParameter(*findSystem(placingSystem), property)));
}

Pose poseOf(const Step& step)
{
  const auto read = [&step](const char* property)
  { return Vector3(placingValue<std::vector<double>>(step, property).data()); };
  return { read(moveName), read(turnName), read(scaleName) };
}

// Rounded, so that the step's form shows all digits.
void setPose(const Pose& pose, Step& step)
{
  const std::pair<const char*, Vector3> values[] = {
    { moveName, pose.move }, { turnName, pose.turn }, { scaleName, pose.scale }
  };
  for (const auto& [property, value] : values)
  {
    std::vector<double> numbers(3);
    std::transform(value.begin(),
      value.end(),
      numbers.begin(),
      [](double number) { return QString::number(number, 'g', 7).toDouble(); });
    step.values[property] = numbers;
  }
}

Step placing(int part)
{
  Step step;
  step.system = placingSystem;
  step.values[partName] = part;
  return step;
}

vtkIntArray* partNumbers(vtkPolyData* mesh)
{
  return vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("PartId"));
}

// The placed part, without points where that is not there; of a mesh without numbers all is part 0.
vtkSmartPointer<vtkPolyData> aloneOf(vtkPolyData* mesh, int part)
{
  const bool isAll = part < 0 || (part == 0 && !partNumbers(mesh));
  return isAll ? vtkSmartPointer<vtkPolyData>(mesh) : oversketch_files::partAlone(mesh, part);
}

} // namespace

struct PlaceTool::Surface
{
  vtkSmartPointer<vtkPolyData> mesh;
  vtkNew<vtkStaticCellLocator> locator;

  explicit Surface(vtkPolyData* of)
    : mesh(of)
  {
    this->locator->SetDataSet(of);
  }
  struct Hit
  {
    Vector3 place;
    int part;
  };
  // The nearest to the eye through a pixel.
  std::optional<Hit> at(const oversketch::View& view, const Vector2& display) const
  {
    if (this->mesh->GetNumberOfPolys() == 0)
    {
      return std::nullopt;
    }
    this->locator->BuildLocator();
    const oversketch::Sight sight = oversketch::sightAt(view, display, Vector3(this->mesh->GetCenter()));
    const double far = this->mesh->GetLength() + (sight.origin() - Vector3(this->mesh->GetCenter())).norm();
    const Vector3 from = view.perspective() ? view.eye() : Vector3(sight.pointAt(-far)),
                  to = sight.pointAt(far);
    double along = 0.0, coordinates[3];
    Vector3 place;
    int piece = 0;
    vtkIdType face = -1;
    if (!this->locator->IntersectWithLine(
          from.data(), to.data(), 0.0, along, place.data(), coordinates, piece, face))
    {
      return std::nullopt;
    }
    vtkIntArray* numbers = partNumbers(this->mesh);
    return Hit{ place, numbers ? numbers->GetValue(face) : 0 };
  }
};

struct PlaceTool::Drag
{
  GizmoGrip grip;
  Vector2 start;
  PlaceGizmo::Stand from;
  vtkSmartPointer<vtkPolyData> rest; // the mesh as it is shown
  Vector3 foot;                      // the middle of it, of the part
  vtkNew<vtkOversketchTransform> step{};
  vtkNew<vtkPolyData> shown{};
  std::unique_ptr<Surface> round{}; // once it is asked for
  bool hasMoved = false;
};

PlaceTool::PlaceTool(Viewport* viewport, const Document* document)
  : Tool(viewport)
  , View(viewport)
  , OpenDocument(document)
  , Gizmo(viewport)
{
  this->setObjectName("place");
  viewport->installEventFilter(this);
  connect(document, &Document::opened, this, [this] { this->Part.reset(); });
  connect(document, &Document::changed, this, [this] { this->follow(); });
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
  if (!this->canPlace())
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
    this->Part = placingValue<int>(*this->OpenDocument->nodeAt(node)->step, partName);
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
  this->follow();
}

void PlaceTool::setMesh(vtkPolyData*)
{
  this->giveUp();
  this->follow();
}

bool PlaceTool::canPlace() const
{
  return this->OpenDocument->isOpen() && this->OpenDocument->whyNoSteps(placingSystem).isEmpty();
}

bool PlaceTool::changesOffered() const
{
  return this->Offered && this->Before && this->Part &&
         placingValue<int>(*this->Offered, partName) == *this->Part &&
         placingValue<int>(*this->Offered, copyName) == 0;
}

void PlaceTool::follow()
{
  vtkPolyData* mesh = this->changesOffered() ? this->Before.Get() : this->View->mesh();
  if (!this->Taken || !this->Part || !mesh || !this->canPlace())
  {
    this->Gizmo.show(std::nullopt);
  }
  else if (!this->Held && !this->OpenDocument->isBusy())
  {
    const auto own = aloneOf(mesh, *this->Part);
    const PlaceGizmo::Stand stand{ Vector3(own->GetCenter()),
      this->changesOffered() ? poseOf(*this->Offered) : Pose() };
    this->Part = own->GetNumberOfPoints() > 0 ? this->Part : std::nullopt; // it may be there no more
    this->Gizmo.show(this->Part ? std::optional(stand) : std::nullopt);
  }
}

bool PlaceTool::eventFilter(QObject*, QEvent* event)
{
  const auto type = event->type();
  if (this->Taken && type == QEvent::KeyPress)
  {
    const bool wasHeld = this->Held != nullptr; // then all keys are the hand's
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    {
      this->Part = wasHeld ? this->Part : std::nullopt;
      this->giveUp();
      this->follow();
      emit this->left();
    }
    return wasHeld;
  }
  if (!this->Taken || (type != QEvent::MouseButtonPress && type != QEvent::MouseButtonDblClick &&
                        type != QEvent::MouseMove && type != QEvent::MouseButtonRelease))
  {
    return false;
  }
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  const double ratio = this->View->devicePixelRatioF();
  const Vector2 at(ratio * mouse.localPos().x(), ratio * (this->View->height() - mouse.localPos().y()) - 1.0);
  const bool isLeft = mouse.button() == Qt::LeftButton;
  if (this->Held) // nobody else hears of a drag
  {
    if (type == QEvent::MouseMove)
    {
      this->pull(at, mouse.modifiers());
    }
    else if (type == QEvent::MouseButtonRelease && isLeft)
    {
      this->letGo();
    }
    return true;
  }
  if (type == QEvent::MouseMove && mouse.buttons() == Qt::NoButton)
  {
    this->Gizmo.light(this->Gizmo.at(at));
  }
  else if (type == QEvent::MouseButtonRelease && isLeft)
  {
    const auto from = std::exchange(this->Pressed, std::nullopt);
    const bool isClick =
      from && (mouse.pos() - *from).manhattanLength() < QApplication::startDragDistance() / 2;
    const auto part = isClick ? this->partAt(at) : this->Part;
    if (part != this->Part)
    {
      this->Part = part;
      this->follow();
      this->Gizmo.light(this->Gizmo.at(at));
      emit this->left();
    }
  }
  else if (isLeft)
  {
    return (type == QEvent::MouseButtonDblClick && this->makeTwin(at)) || this->press(mouse, at);
  }
  return false;
}

// Waits for what is shown first: a drag begins on it.
bool PlaceTool::press(const QMouseEvent& mouse, const Vector2& at)
{
  const auto grip = this->Gizmo.at(at);
  vtkPolyData* mesh = this->View->mesh();
  if (grip && mesh && !(mouse.modifiers() & Qt::AltModifier) && !this->OpenDocument->isBusy())
  {
    const auto own = aloneOf(mesh, *this->Part);
    const int up = this->View->camera()->GetUpAxis();
    Vector3 foot(own->GetCenter());
    foot[up] = own->GetBounds()[2 * up];
    this->Held.reset(new Drag{ *grip, at, *this->Gizmo.stand(), mesh, foot });
    vtkOversketchTransform* step = this->Held->step;
    step->SetInputData(this->changesOffered()
                         ? oversketch_files::withPointNormals(shallowCopyOf(this->Before.Get()))
                         : shallowCopyOf(mesh));
    step->SetPart(*this->Part);
    vtkNew<vtkCallbackCommand> nothing; // an error is told once, of the step that is made
    step->AddObserver(vtkCommand::ErrorEvent, nothing);
    this->Gizmo.light(grip);
    return true;
  }
  const bool mayClick = mouse.type() == QEvent::MouseButtonPress && mouse.modifiers() == Qt::NoModifier;
  this->Pressed = mayClick ? std::optional<QPoint>(mouse.pos()) : std::nullopt;
  return false;
}

void PlaceTool::pull(const Vector2& at, Qt::KeyboardModifiers keys)
{
  Drag& held = *this->Held;
  const auto view = oversketch::PenView::of(this->View->renderer()).sight();
  const double least = 0.5 * QApplication::startDragDistance() * this->View->devicePixelRatioF();
  if (!view || (!held.hasMoved && (at - held.start).norm() < least)) // a click trembles
  {
    return;
  }
  const auto& [middle, from] = held.from;
  Pose pose = posed(*view, middle, from, held.grip, held.start, at, (keys & Qt::ShiftModifier) != 0);
  if (held.grip.part == GizmoGrip::Square && (keys & Qt::ControlModifier))
  {
    held.round = held.round ? std::move(held.round) : this->surfaceRound();
    if (const auto hit = held.round->at(*view, at))
    {
      pose.move = from.move + hit->place - held.foot;
    }
  }
  held.hasMoved = true;
  held.step->SetMove(pose.move.data());
  held.step->SetTurn(pose.turn.data());
  held.step->SetScale(pose.scale.data());
  held.step->Update();
  if (held.step->GetOutput()->GetNumberOfPoints() == held.rest->GetNumberOfPoints()) // no later step adds any
  {
    held.shown->ShallowCopy(held.step->GetOutput());
    this->View->showPreview(held.shown);
  }
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
    if (this->View->mesh() == held->shown)
    {
      this->View->showPreview(held->rest);
    }
    this->Gizmo.show(held->from);
  }
}

// Other parts and other models. The picker of the view would see the part in the hand.
std::unique_ptr<PlaceTool::Surface> PlaceTool::surfaceRound() const
{
  vtkNew<vtkAppendPolyData> all;
  const Session& session = this->OpenDocument->session();
  std::set<int> without = hiddenOf(session, this->OpenDocument->result().parts);
  without.insert(*this->Part);
  if (*this->Part >= 0 && partNumbers(this->Held->rest))
  {
    all->AddInputData(oversketch_files::withoutParts(this->Held->rest, without));
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
  return std::make_unique<Surface>(all->GetOutput());
}

std::optional<int> PlaceTool::partAt(const Vector2& at)
{
  vtkPolyData* mesh = this->View->mesh();
  const auto view = oversketch::PenView::of(this->View->renderer()).sight();
  if (!mesh || !view || !this->canPlace() ||
      this->View->display().others().at(static_cast<int>(at[0]), static_cast<int>(at[1])))
  {
    return std::nullopt;
  }
  const Surface seen(oversketch_files::withoutParts(
    mesh, hiddenOf(this->OpenDocument->session(), this->OpenDocument->result().parts)));
  const auto hit = seen.at(*view, at);
  const bool isOne = oversketch_files::partsOf(mesh).size() < 2;
  const bool isJoined = hit && oversketch::JoinedParts(mesh).count(hit->part) > 0;
  return hit ? std::optional<int>(isOne || isJoined ? -1 : hit->part) : std::nullopt;
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
  step.values[copyName] = 1;
  step.values["MirrorOffset"] = this->OpenDocument->mirrorPlane(1)->offset;
  const std::vector<int> parts = oversketch_files::partsOf(this->View->mesh());
  this->Part = parts.empty() ? 1 : parts.back() + 1;
  emit this->drawn(step);
  return true;
}

} // namespace oversketch_studio
