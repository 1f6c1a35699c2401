#include "edit_hand.h"

#include "document.h"
#include "latency.h"
#include "message_text.h"
#include "viewport.h"

#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchAxisHandleRepresentation.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchEditRepresentation.h"
#include "vtkOversketchEditWidget.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneRepresentation.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchRegionRepresentation.h"
#include "vtkOversketchRegionWidget.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCommand.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr double curveGrabDistance = 8.0, shortestLine = 10.0; // px as Qt counts them

} // namespace

EditHand::EditHand(Viewport* viewport, const Document* document)
  : View(viewport)
  , OpenDocument(document)
  , Soon(new QTimer(this))
  , Mode(vtkOversketchEditWidget::Direct)
{
  this->Widget->SetInteractor(viewport->interactor());
  this->Widget->SetDefaultRenderer(viewport->renderer());
  this->Widget->SetCurrentRenderer(viewport->renderer());
  this->Widget->RegionInAllModesOn();
  // Triangles are the document's, on a thread of its own.
  this->Widget->GetEdit()->SetRuleToOff();
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent,
         vtkCommand::MessageEvent })
  {
    this->Widget->AddObserver(event, this, &EditHand::heard);
  }
  this->Soon->setSingleShot(true);
  connect(this->Soon, &QTimer::timeout, this, &EditHand::arrange);
  // Return is done with the edit, so that the next line can be drawn there.
  connect(viewport,
    &Viewport::returned,
    this,
    [this]
    {
      if (this->Held && !this->draws() && !this->moves())
      {
        this->LeftId = this->Offered ? this->OfferedId : this->LeftId;
        this->Offered.reset();
        this->dropLine();
      }
    });
  connect(document,
    &Document::opened,
    this,
    [this]
    {
      this->Offered.reset();
      this->select();
    });
}

EditHand::~EditHand()
{
  this->Widget->RemoveAllObservers();
  this->Widget->SetEnabled(0);
  this->Widget->SetInteractor(nullptr);
}

void EditHand::takeUp(int mode)
{
  this->Held = true;
  this->Mode = mode;
  this->arrange();
}

void EditHand::putDown()
{
  this->Held = false;
  this->Message.clear();
  this->Widget->SetEnabled(0);
  this->stopFollowing();
}

void EditHand::setMode(int mode)
{
  this->Mode = mode;
  if (this->Held)
  {
    this->arrange();
  }
}

void EditHand::offer(const Step& step, const Worker::NodeState& state)
{
  const auto& nodes = this->OpenDocument->session().nodes;
  const auto node =
    std::find_if(nodes.begin(), nodes.end(), [&](const Node& one) { return one.step.get() == &step; });
  const int id = node == nodes.end() ? 0 : node->id;
  if (id != 0 && id == this->LeftId)
  {
    return; // the hand is done with it, until it is selected
  }
  this->OfferedId = id;
  this->Offered = step;
  this->State = state;
  this->arrange();
}

// The places of those steps after the offered one that are on and shown; none while a line waits for its
// ring.
std::vector<std::size_t> EditHand::later() const
{
  if (!this->Offered || this->isLineAlone())
  {
    return {};
  }
  const auto& nodes = this->OpenDocument->session().nodes;
  const int offered = rowOf(nodes, this->OfferedId), shown = this->OpenDocument->shownTo();
  std::vector<std::size_t> places;
  for (int i = offered + 1; offered >= 0 && i < shown; ++i)
  {
    if (nodes[indexOf(i)].on)
    {
      places.push_back(indexOf(i));
    }
  }
  return places;
}

QStringList EditHand::lost() const
{
  QStringList names;
  const auto& states = this->OpenDocument->result().nodes;
  for (const std::size_t i : this->later())
  {
    if (i < states.size() && (!states[i].failure.empty() || states[i].elsewhere))
    {
      names << QString::fromStdString(this->OpenDocument->session().nodes[i].name);
    }
  }
  return names;
}

// Whether the picture that the offered step's weights are painted in is there, decoded.
bool EditHand::hasWeights()
{
  const Image* image = weightsOf(*this->Offered);
  if (!image || (this->Weights && *this->Weights->bytes == *image->bytes))
  {
    return true;
  }
  this->Weights = whenDecoded(this,
    image->bytes,
    [this](const SharedPicture& made)
    {
      this->Weights = made;
      this->arrangeSoon();
    });
  return bool(this->Weights);
}

void EditHand::offerNothing()
{
  this->Offered.reset();
  this->arrangeSoon(); // another one may be at once
}

void EditHand::select()
{
  this->LeftId = 0;
  this->dropLine();
}

void EditHand::dropLine()
{
  if (!this->Loaded.isInHistory)
  {
    this->Loaded.step.inputs.clear();
  }
  this->arrangeSoon();
}

void EditHand::setMesh(vtkPolyData* mesh)
{
  if (this->Rest)
  {
    this->Rest = mesh;
    this->View->showPreview(this->live()); // the hand is at it
  }
  if (!this->Offered)
  {
    this->arrangeSoon();
  }
}

std::array<vtkOversketchStrokeWidget*, 3> EditHand::pens() const
{
  return { this->Widget->GetRegionWidget()->GetPen(),
    this->Widget->GetAreaSelectWidget()->GetPen(),
    this->Widget->GetProfilePlaneWidget()->GetPen() };
}

bool EditHand::draws() const
{
  const auto pens = this->pens();
  return this->Widget->GetDiscAreaWidget()->GetPen()->IsDrawing() ||
         std::any_of(
           pens.begin(), pens.end(), [](vtkOversketchStrokeWidget* pen) { return pen->IsDrawing(); });
}

bool EditHand::moves() const
{
  return this->Widget->IsPreviewing() || this->Widget->GetAxisHandleWidget()->IsDragging() ||
         this->Widget->GetLayerHandleWidget()->IsDragging() ||
         this->Widget->GetDiscLayerWidget()->IsDragging() ||
         this->Widget->GetProfilePlaneWidget()->IsDragging();
}

bool EditHand::hasLine() const
{
  return this->Widget->GetRegionWidget()->HasReference();
}

bool EditHand::isLineAlone() const
{
  return !this->Loaded.isInHistory && !this->Loaded.step.inputs.empty() && !this->hasRegion();
}

bool EditHand::hasRegion() const
{
  return this->Widget->HasRegion();
}

void EditHand::setPixelRatio(double ratio)
{
  const double distance = curveGrabDistance * ratio;
  this->Widget->GetRegionWidget()->GetRegionRepresentation()->SetGrabDistance(distance);
  this->Widget->GetAxisHandleWidget()->GetAxisHandleRepresentation()->SetGrabDistance(distance);
  this->Widget->GetLayerHandleWidget()->GetLayerHandleRepresentation()->SetGrabDistance(distance);
  this->Widget->GetProfilePlaneWidget()->GetProfilePlaneRepresentation()->SetGrabDistance(distance);
}

void EditHand::setSteadiness(double pixels)
{
  for (vtkOversketchStrokeWidget* pen : this->pens())
  {
    pen->SetStabilizer(pixels * this->View->devicePixelRatioF());
  }
}

void EditHand::setPressure(double pressure)
{
  for (vtkOversketchStrokeWidget* pen : this->pens())
  {
    pen->SetPressure(pressure);
  }
}

void EditHand::showLines(bool show)
{
  this->Widget->GetEditRepresentation()->SetVisibility(show);
  this->Widget->GetRegionWidget()->GetRegionRepresentation()->SetVisibility(show);
  this->Widget->GetAxisHandleWidget()->GetAxisHandleRepresentation()->SetVisibility(show);
  this->Widget->GetLayerHandleWidget()->GetLayerHandleRepresentation()->SetVisibility(show);
  this->Widget->GetAreaSelectWidget()->GetAreaSelectRepresentation()->SetVisibility(show);
  this->Widget->GetProfilePlaneWidget()->GetProfilePlaneRepresentation()->SetVisibility(show);
}

void EditHand::setLevels(int levels)
{
  if (this->hasRegion() && levels != this->Widget->GetEdit()->GetLevels())
  {
    this->Widget->GetEdit()->SetLevels(levels);
    this->Widget->Update();
    this->publish();
  }
}

bool EditHand::isShading() const
{
  return this->Held && this->hasRegion() &&
         (this->Mode == vtkOversketchEditWidget::Shade || this->Mode == vtkOversketchEditWidget::Areas);
}

void EditHand::arrangeSoon()
{
  this->Soon->start(0);
}

// Gives the hand what it has before it: the step that is offered, or one to come.
void EditHand::arrange()
{
  this->Soon->stop();
  if (!this->Held)
  {
    return;
  }
  if (this->draws() || this->moves())
  {
    this->Late = true; // until it lets go
    return;
  }
  this->Late = false;
  if (!this->Offered || this->isLineAlone())
  {
    this->begin();
  }
  else if (!this->State.before || !this->hasWeights())
  {
    this->rest();
  }
  else
  {
    this->load({ *this->Offered, true, this->State.before, this->State.given, this->OfferedId });
    if (this->wantsAnother(*this->Offered) && !this->beginNext())
    {
      this->rest(); // until its mesh is there
    }
  }
  this->applyMode();
  if (this->isShading() && this->isMoved())
  {
    this->follow(); // greys lie on the surface that they are of, which has no new triangles
  }
  this->View->renderSoon();
  emit this->arranged();
}

void EditHand::rest()
{
  this->load(Work());
  this->Widget->SetEnabled(0);
}

void EditHand::begin()
{
  Work work;
  work.mesh = this->OpenDocument->result().mesh;
  if (!work.mesh)
  {
    this->rest();
    return;
  }
  if (!this->Loaded.isInHistory)
  {
    work.step = this->Loaded.step; // with its line
    work.given = this->Loaded.given;
  }
  this->load(work);
}

// A step has operations or a profile, not both.
bool EditHand::wantsAnother(const Step& step) const
{
  return this->Mode == vtkOversketchEditWidget::Profile
           ? !editText(step, operationsValue).empty()
           : this->Mode == vtkOversketchEditWidget::Direct && step.inputs.count(profileInput) > 0;
}

// The next step, on the mesh that this one makes, by its line and its ring where it has left them.
bool EditHand::beginNext()
{
  const SharedData& mesh = this->OpenDocument->result().mesh;
  if (this->OpenDocument->isBusy() || !mesh || !this->hasRegion())
  {
    return false;
  }
  Work work;
  work.mesh = mesh;
  const auto copyOf = [](vtkPolyData* curve)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(curve);
    return SharedData(copy);
  };
  work.step.inputs[lineInput] = StepOutput{ this->OfferedId, 1 };
  work.step.inputs[ringInput] = StepOutput{ this->OfferedId, 2 };
  work.given[lineInput] = copyOf(this->Widget->GetEdit()->GetReferenceOutput());
  work.given[ringInput] = copyOf(this->Widget->GetEdit()->GetBoundaryOutput());
  this->load(work);
  return this->hasRegion();
}

// The tool's, once there is a region.
void EditHand::applyMode()
{
  if (this->Loaded.mesh)
  {
    this->Widget->SetMode(this->hasRegion() ? this->Mode : int(vtkOversketchEditWidget::Region));
    this->Widget->SetEnabled(1);
  }
  const bool pen = !this->hasRegion() || this->Mode == vtkOversketchEditWidget::Areas;
  this->View->setHandCursor(pen ? Qt::CrossCursor : Qt::ArrowCursor);
}

void EditHand::heard(vtkObject*, unsigned long event, void* text)
{
  if (this->Loading)
  {
    return;
  }
  switch (event)
  {
    case vtkCommand::StartInteractionEvent:
      this->View->hideHint();
      this->Message.clear();
      break;
    case vtkCommand::InteractionEvent:
      if (this->Widget->IsPreviewing())
      {
        this->follow();
        this->Mode == vtkOversketchEditWidget::Shade ? Latency::of().layerDragged() : Latency::of().dragged();
      }
      else
      {
        Latency::of().sample();
      }
      break;
    case vtkCommand::EndInteractionEvent:
      this->stopFollowing();
      if (this->Late)
      {
        this->arrangeSoon(); // a change that it has made comes first
      }
      emit this->left();
      break;
    case vtkCommand::WidgetValueChangedEvent:
      this->publish();
      break;
    default:
      this->Message = QString::fromUtf8(static_cast<const char*>(text));
      emit this->left();
  }
}

// The mesh under the hand.
void EditHand::follow()
{
  if (!this->hasRegion())
  {
    return;
  }
  if (!this->Rest)
  {
    this->Rest = this->View->mesh();
    this->View->showRegion(nullptr);
  }
  this->View->showPreview(this->live());
}

vtkPolyData* EditHand::live()
{
  const bool isShown = this->Widget->IsPreviewing() || !this->Widget->GetEdit()->PreviewEdit(this->Live);
  vtkPolyData* live = isShown ? this->Widget->GetOutput() : this->Live.Get();
  const auto& plane = this->Loaded.step.mirror;
  return plane ? this->Mirrored.show(live, this->Widget->GetEdit(), *plane) : live;
}

void EditHand::stopFollowing()
{
  if (const auto rest = std::exchange(this->Rest, nullptr))
  {
    this->View->showPreview(rest);
  }
}

// Publishes what the hand has made, once the widget has run it.
void EditHand::publish()
{
  const vtkOversketchRegionWidget* region = this->Widget->GetRegionWidget();
  const bool isWhole = region->HasReference() && region->HasBoundary();
  QString said = wordsOfEdit(this->Widget->GetSaid(), region->HasBoundary());
  if (const double length =
        pixelsOf(this->Widget->GetRegionWidget()->GetReference()) / this->View->devicePixelRatioF();
      !isWhole && said.isEmpty() && length < shortestLine)
  {
    said = tr("The line is %1 px long.").arg(length, 0, 'f', 0);
  }
  if (isWhole ? !this->hasRegion() : !said.isEmpty())
  {
    this->refuse(said);
    return;
  }
  if (this->Loaded.isInHistory && this->Loaded.id != this->OfferedId)
  {
    this->load(Work(this->Loaded), true); // another row has come under the hand: it gets nothing of this one
    return;
  }
  this->Message = said;
  this->Loaded.step = this->made();
  if (isWhole)
  {
    const bool isNew = !std::exchange(this->Loaded.isInHistory, true);
    this->Offered = this->Loaded.step;
    this->State = {};
    this->State.before = this->Loaded.mesh;
    this->State.given = this->Loaded.given;
    this->LeftId = 0;
    if (this->isMoved())
    {
      this->View->showPreview(this->live()); // until the result comes
    }
    Latency::of().strokeEnd();
    if (isNew && Latency::of().isOn())
    {
      Latency::of().ringClosed();
      const auto inside = oversketch::ReadInside(this->Widget->GetEdit()->GetInnerOutput("Distance"));
      Latency::of().regionHas(inside.size());
    }
    if (isNew && !this->isMoved())
    {
      this->applyMode();
      this->View->renderNow(); // its greys, before the step takes the processors
    }
    const Step step = this->Loaded.step;
    isNew ? emit this->drawn(step) : emit this->remade(step);
    this->OfferedId = isNew ? idOf(this->OpenDocument->session(), step) : this->OfferedId;
    this->Loaded.id = this->OfferedId;
  }
  this->applyMode();
  emit this->left();
}

bool EditHand::isMoved() const
{
  return !editText(this->Loaded.step, operationsValue).empty() ||
         this->Loaded.step.inputs.count(profileInput) > 0;
}

// Takes back what cannot be, and says why.
void EditHand::refuse(const QString& why)
{
  const bool isRing = this->Widget->GetRegionWidget()->HasBoundary(), isNew = !this->Loaded.isInHistory;
  this->load(Work(this->Loaded), true);
  this->Message = !isNew   ? tr("%1 It is taken back: do it another way.").arg(why)
                  : isRing ? tr("%1 It is taken back: draw a ring round the whole line.").arg(why)
                           : tr("%1 It is taken back: draw another of 10 px or more.").arg(why);
  this->Widget->GetEditRepresentation()->SetText(this->Message.toUtf8().constData());
  this->applyMode();
  this->View->renderSoon();
  emit this->left();
}

} // namespace oversketch_studio
