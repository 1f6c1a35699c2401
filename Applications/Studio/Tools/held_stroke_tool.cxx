#include "held_stroke_tool.h"

#include "document.h"
#include "latency.h"
#include "mirror_choice.h"
#include "systems.h"
#include "viewport.h"

#include "vtkOversketchHeldStrokeRepresentation.h"
#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCallbackCommand.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// px as Qt counts them: the lines' width, and how near to one the cursor takes hold of it.
constexpr float lineWidth = 3.0F;
constexpr double grabDistance = 6.0;

} // namespace

HeldStrokeTool::HeldStrokeTool(const std::string& system, Viewport* viewport, const Document* document)
  : Tool(viewport)
  , system_(system)
  , input_(findInput(*findSystem(system), SystemInput::Kind::Stroke)->name)
  , viewport_(viewport)
  , document_(document)
  , penSection_(*findSystem(system), this->widget_)
{
  this->widget_->SetInteractor(viewport->interactor());
  this->widget_->SetDefaultRenderer(viewport->renderer());
  this->observer_->SetClientData(this);
  this->observer_->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<HeldStrokeTool*>(self)->heard(event); });
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent })
  {
    this->widget_->AddObserver(event, this->observer_);
  }
  // Return leaves the stroke alone, so that the next one can begin on it; a move of the camera, its preview.
  connect(viewport,
    &Viewport::returned,
    this,
    [this]
    {
      if (!this->draws() && !this->moves())
      {
        this->offerNothing();
      }
    });
  connect(viewport, &Viewport::cameraMoves, this, [this] { this->preview_ = nullptr; });
  connect(&this->penSection_, &PenSection::frameWanted, viewport, &Viewport::renderNow);
}

HeldStrokeTool::~HeldStrokeTool()
{
  this->widget_->RemoveObserver(this->observer_);
  this->widget_->SetEnabled(0);
  this->widget_->SetInteractor(nullptr);
}

vtkOversketchStrokeWidget* HeldStrokeTool::pen() const
{
  return this->widget_->GetPen();
}

QVector<QPair<QString, QString>> HeldStrokeTool::keys() const
{
  return { { tr("Left drag"), tr("draw; on the red line: move it") },
    { tr("Shift + left drag"), tr("on the red line: draw a part anew; else: pan") } };
}

QWidget* HeldStrokeTool::makeOptions(QWidget* parent)
{
  if (!findSystem(this->system_)->mirrored)
  {
    return nullptr;
  }
  auto* options = new QWidget(parent);
  auto* label = new QLabel(tr("New strokes act on"), options);
  this->mirror_ = mirrorChoice(options);
  label->setBuddy(this->mirror_);
  this->mirror_->setObjectName("mirror");
  this->mirror_->setAccessibleName(tr("New strokes act on"));
  this->mirror_->setToolTip(tr("Strokes act on one side of the model, or on both sides of this plane"));
  auto* row = new QHBoxLayout(options);
  row->setContentsMargins(6, 0, 6, 0);
  row->addWidget(label);
  row->addWidget(this->mirror_);
  row->addStretch();
  connect(this->mirror_,
    QOverload<int>::of(&QComboBox::activated),
    this,
    [this] { this->viewport_->showMirror(this->document_->mirrorPlane(this->mirror_->currentIndex())); });
  return options;
}

void HeldStrokeTool::start()
{
  this->widget_->SetEnabled(1);
  this->viewport_->setHandCursor(Qt::CrossCursor);
}

void HeldStrokeTool::stop()
{
  this->widget_->SetEnabled(0);
}

bool HeldStrokeTool::draws() const
{
  return this->pen()->IsDrawing();
}

bool HeldStrokeTool::moves() const
{
  return this->widget_->IsMoving();
}

void HeldStrokeTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  this->following_ = state.following;
  this->widget_->HoldStroke(linesOf(step, this->input_), place.data());
  this->viewport_->renderSoon();
}

void HeldStrokeTool::offerNothing()
{
  this->following_ = nullptr;
  this->widget_->HoldStroke(nullptr, nullptr);
  this->viewport_->renderSoon();
}

void HeldStrokeTool::setFollowing(const std::shared_ptr<const Following>& following)
{
  this->following_ = following;
}

void HeldStrokeTool::setMesh(vtkPolyData* mesh)
{
  this->penSection_.setMesh(mesh);
}

// VTK counts the screen's own pixels.
void HeldStrokeTool::setPixelRatio(double ratio)
{
  this->ratio_ = ratio;
  vtkOversketchStrokeRepresentation* drawn = this->pen()->GetStrokeRepresentation();
  for (vtkProperty2D* line : { drawn->GetProperty(),
         drawn->GetSectionProperty(),
         this->widget_->GetHeldStrokeRepresentation()->GetProperty() })
  {
    line->SetLineWidth(static_cast<float>(lineWidth * ratio));
  }
  this->widget_->SetGrabDistance(grabDistance * ratio);
  this->pen()->SetStabilizer(this->steadiness_ * ratio);
}

void HeldStrokeTool::setSteadiness(double pixels)
{
  this->steadiness_ = pixels;
  this->pen()->SetStabilizer(pixels * this->ratio_);
}

void HeldStrokeTool::setPressure(double pressure)
{
  this->pen()->SetPressure(pressure);
}

void HeldStrokeTool::showLines(bool show)
{
  this->widget_->GetHeldStrokeRepresentation()->SetVisibility(show);
}

void HeldStrokeTool::heard(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::StartInteractionEvent:
      this->viewport_->hideHint();
      this->preview_ = nullptr;
      if (this->draws())
      {
        this->penSection_.lineBegins();
      }
      break;
    case vtkCommand::InteractionEvent:
      if (this->moves())
      {
        this->followHand();
      }
      else
      {
        Latency::of().sample();
        this->penSection_.lineGrows();
      }
      break;
    case vtkCommand::EndInteractionEvent:
      this->letGo();
      break;
    default:
      this->strokeEnds();
  }
}

void HeldStrokeTool::strokeEnds()
{
  Latency::of().strokeEnd();
  Step step;
  step.system = this->system_;
  step.inputs[this->input_] = Lines(this->widget_->GetStroke());
  if (this->widget_->IsNew())
  {
    this->following_ = nullptr; // until it has been run
    step.mirror = this->mirror_ ? this->document_->mirrorPlane(this->mirror_->currentIndex()) : std::nullopt;
    emit this->drawn(step);
    return;
  }
  if (this->preview_)
  {
    this->viewport_->showPreview(this->preview_->mesh()); // until the result comes
  }
  emit this->changed(step);
}

// The mesh under the hand: a preview, until the document has run the moved stroke.
void HeldStrokeTool::followHand()
{
  vtkPolyData* shown = this->viewport_->mesh();
  if (!this->preview_)
  {
    if (!this->following_ || !shown || shown->GetNumberOfPoints() != this->following_->count)
    {
      emit this->movesAlone();
      return;
    }
    this->preview_ = std::make_unique<Preview>(shown, this->following_);
    this->viewport_->showPreview(this->preview_->mesh());
  }
  this->preview_->moveTo(this->widget_->GetTranslation());
}

// The mesh is as it was; of a stroke that was moved the preview stays: see strokeEnds.
void HeldStrokeTool::letGo()
{
  if (this->preview_ && this->viewport_->mesh() == this->preview_->mesh())
  {
    this->viewport_->showPreview(this->preview_->rest());
  }
  emit this->left();
}

} // namespace oversketch_studio
