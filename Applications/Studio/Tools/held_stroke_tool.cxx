#include "held_stroke_tool.h"

#include "document.h"
#include "latency.h"
#include "step_panel.h"
#include "systems.h"
#include "viewport.h"

#include "Stroke/stroke.h"

#include "vtkOversketchHeldStrokeRepresentation.h"
#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// px as Qt counts them: the lines' width, and how near to one the cursor takes hold of it.
constexpr float lineWidth = 3.0F;
constexpr double strokeGrabDistance = 6.0;

// Empty for a system that is given none.
std::string strokeInputOf(const std::string& system)
{
  const SystemInput* input = findInput(*findSystem(system), SystemInput::Kind::Stroke);
  return input ? input->name : std::string();
}

double lengthOf(vtkPolyData* stroke)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < stroke->GetNumberOfPoints(); ++i)
  {
    double from[3];
    stroke->GetPoint(i - 1, from);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(from, stroke->GetPoint(i)));
  }
  return length;
}

} // namespace

HeldStrokeTool::HeldStrokeTool(const std::string& system,
  Viewport* viewport,
  const Document* document,
  SectionFinder::Look look)
  : Tool(viewport)
  , System(system)
  , Input(strokeInputOf(system))
  , View(viewport)
  , OpenDocument(document)
  , Section(*findSystem(system), this->Widget, std::move(look))
{
  this->Widget->SetInteractor(viewport->interactor());
  this->Widget->SetDefaultRenderer(viewport->renderer());
  this->Widget->GetHeldStrokeRepresentation()->ShowFromElsewhereOff(); // StrokeLines does
  this->Widget->AddObserver(vtkCommand::StartInteractionEvent, this, &HeldStrokeTool::begins);
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &HeldStrokeTool::handMoves);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this, &HeldStrokeTool::letGo);
  this->Widget->AddObserver(vtkCommand::WidgetValueChangedEvent, this, &HeldStrokeTool::strokeEnds);
  // Return leaves the stroke alone, so that the next one can begin on it; a move of the camera, its preview.
  connect(viewport,
    &Viewport::returned,
    this,
    [this]
    {
      if (!this->isBusy())
      {
        this->offerNothing();
      }
    });
  // Another model begins without a mirror plane.
  connect(document,
    &Document::begun,
    this,
    [this]
    {
      if (this->Mirror && this->Mirror->currentIndex() != 0)
      {
        this->Mirror->setCurrentIndex(0);
        this->View->showMirror(std::nullopt);
      }
    });
  connect(viewport, &Viewport::cameraMoves, this, [this] { this->MovePreview = nullptr; });
  connect(&this->Section, &PenSection::frameWanted, viewport, &Viewport::renderNow);
}

HeldStrokeTool::~HeldStrokeTool()
{
  this->Widget->RemoveAllObservers();
  this->Widget->SetEnabled(0);
  this->Widget->SetInteractor(nullptr);
}

vtkOversketchStrokeWidget* HeldStrokeTool::pen() const
{
  return this->Widget->GetPen();
}

QVector<QPair<QString, QString>> HeldStrokeTool::keys() const
{
  return { { tr("Left drag"), tr("draw; on the red line: move it") },
    { tr("Shift + left drag"), tr("on the red line: redraw a part") } };
}

void HeldStrokeTool::setBar(QWidget* bar)
{
  this->Bar = bar;
  bar->hide();
}

void HeldStrokeTool::beginWithModels(const std::function<void(double)>& begin)
{
  const auto with = [this, begin](vtkPolyData* mesh)
  {
    this->Sized = mesh != nullptr;
    begin(mesh ? mesh->GetLength() : 0.0);
  };
  const Document* document = this->OpenDocument;
  connect(document, &Document::opened, this, [document, with] { with(document->session().mesh); });
  connect(document,
    &Document::shown,
    this,
    [this, document, with]
    {
      if (!this->Sized && document->result().mesh)
      {
        with(document->result().mesh);
      }
    });
  with(nullptr);
}

QWidget* HeldStrokeTool::makeOptions(QWidget* parent)
{
  if (this->Bar)
  {
    this->Bar->setParent(parent);
    this->Bar->show();
  }
  if (findSystem(this->System)->mirroring == Mirroring::None)
  {
    return this->Bar;
  }
  auto* options = new QWidget(this->Bar ? this->Bar : parent);
  auto* label = new QLabel(tr("Mirror"), options);
  this->Mirror = StepPanel::mirrorChoice(options);
  label->setBuddy(this->Mirror);
  this->Mirror->setObjectName("mirror");
  this->Mirror->setAccessibleName(tr("Mirror"));
  this->Mirror->setToolTip(tr("What you draw next also acts on the other side of this plane, whether the two "
                              "sides are alike or not. Off: on one side only."));
  auto* row = new QHBoxLayout(options);
  row->setContentsMargins(6, 0, 6, 0);
  row->addWidget(label);
  row->addWidget(this->Mirror);
  row->addStretch();
  connect(this->Mirror,
    QOverload<int>::of(&QComboBox::activated),
    this,
    [this] { this->View->showMirror(this->mirrorPlane()); });
  if (this->Bar) // in the same lines
  {
    this->Bar->layout()->addWidget(options);
  }
  return this->Bar ? this->Bar : options;
}

std::optional<MirrorPlane> HeldStrokeTool::mirrorPlane() const
{
  return this->Mirror ? this->OpenDocument->mirrorPlane(this->Mirror->currentIndex()) : std::nullopt;
}

Values HeldStrokeTool::options() const
{
  return this->Mirror ? Values{ { "Mirror", this->Mirror->currentIndex() } } : Values();
}

void HeldStrokeTool::setOptions(const Values& options)
{
  const auto mirror = options.find("Mirror");
  if (this->Mirror && mirror != options.end())
  {
    this->Mirror->setCurrentIndex(std::clamp(std::get<int>(mirror->second), 0, this->Mirror->count() - 1));
    this->View->showMirror(this->mirrorPlane());
  }
}

void HeldStrokeTool::start()
{
  this->Widget->SetEnabled(1);
  this->View->setHandCursor(Qt::CrossCursor);
}

void HeldStrokeTool::stop()
{
  this->Widget->SetEnabled(0);
}

bool HeldStrokeTool::draws() const
{
  return this->pen()->IsDrawing();
}

bool HeldStrokeTool::moves() const
{
  return this->Widget->IsMoving();
}

void HeldStrokeTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  this->Offered = step.values;
  this->Followed = state.following;
  this->Widget->SetTookHold(state.failure.empty());
  this->Widget->HoldStroke(linesOf(step, this->Input), place.data());
  this->View->renderSoon();
}

void HeldStrokeTool::offerNothing()
{
  this->Offered.reset();
  this->Followed = nullptr;
  this->Widget->HoldStroke(nullptr, nullptr);
  this->View->renderSoon();
}

// VTK counts the screen's own pixels.
void HeldStrokeTool::setPixelRatio(double ratio)
{
  this->Ratio = ratio;
  vtkOversketchStrokeRepresentation* drawn = this->pen()->GetStrokeRepresentation();
  for (vtkProperty2D* line : { drawn->GetProperty(),
         drawn->GetSectionProperty(),
         drawn->GetCrestProperty(),
         this->Widget->GetHeldStrokeRepresentation()->GetProperty() })
  {
    line->SetLineWidth(static_cast<float>(lineWidth * ratio));
  }
  this->Widget->SetGrabDistance(this->grabs() ? strokeGrabDistance * ratio : 0.0);
  this->pen()->SetStabilizer(this->Steadiness * ratio);
}

void HeldStrokeTool::setSteadiness(double pixels)
{
  this->Steadiness = pixels;
  this->pen()->SetStabilizer(pixels * this->Ratio);
}

void HeldStrokeTool::setPressure(double pressure)
{
  this->pen()->SetPressure(pressure);
}

void HeldStrokeTool::setValues(const Values& values)
{
  this->StrokeValues = values;
  this->Section.setValues(values);
  if (this->draws())
  {
    this->View->renderSoon();
  }
}

void HeldStrokeTool::shape(const Values& values, bool mergesIntoLast)
{
  this->setValues(values);
  if (this->shapesOffered())
  {
    for (const auto& [name, value] : values)
    {
      (*this->Offered)[name] = value;
    }
    emit this->shaped(*this->Offered, mergesIntoLast);
  }
}

bool HeldStrokeTool::holds(double x, double y)
{
  const auto held = this->Widget->GetHeldStrokeRepresentation();
  return this->grabs() && held->GetShowStroke() && held->DistanceTo(x, y) <= this->Widget->GetGrabDistance();
}

void HeldStrokeTool::showLines(bool show)
{
  this->Widget->GetHeldStrokeRepresentation()->SetVisibility(show);
}

void HeldStrokeTool::begins()
{
  this->View->hideHint();
  this->MovePreview = nullptr;
  this->TakesLine.reset();
  if (this->draws())
  {
    this->Section.lineBegins();
  }
  else if (const auto before = this->meshBefore())
  {
    this->Section.setMesh(before);
    this->LooksBefore = true;
  }
}

void HeldStrokeTool::handMoves()
{
  if (this->moves())
  {
    this->followHand();
    return;
  }
  Latency::of().sample();
  vtkNew<vtkPolyData> line;
  this->pen()->GetStrokeRepresentation()->GetPolyData(line);
  if (!this->TakesLine && line->GetNumberOfPoints() > 0)
  {
    this->TakesLine = !this->Widget->IsRedrawing() && this->takesLine(line);
  }
  this->TakesLine.value_or(false) ? this->lineGrows(line) : this->Section.lineGrows();
}

void HeldStrokeTool::strokeEnds()
{
  Latency::of().strokeEnd();
  if (this->Widget->IsNew() && lengthOf(this->Widget->GetStroke()) < oversketch::StrokeRules().minimumLength)
  {
    emit this->tooShort(oversketch::StrokeRules().minimumLength);
    return;
  }
  if (this->Widget->IsNew() && this->TakesLine.value_or(false))
  {
    this->lineWhole(this->Widget->GetStroke());
    return;
  }
  Step step;
  step.system = this->System;
  step.values = this->StrokeValues;
  step.inputs[this->Input] = Lines(this->Widget->GetStroke());
  if (this->Widget->IsNew())
  {
    this->Followed = nullptr; // until it has been run
    step.mirror = this->mirrorPlane();
    emit this->drawn(step);
    return;
  }
  if (this->MovePreview)
  {
    this->View->showPreview(this->MovePreview->mesh()); // until the result comes
  }
  emit this->changed(step);
}

// The mesh under the hand: a preview, until the document has run the moved stroke.
void HeldStrokeTool::followHand()
{
  vtkPolyData* shown = this->View->mesh();
  if (!this->MovePreview)
  {
    if (!this->Followed || !shown || shown->GetNumberOfPoints() != this->Followed->count)
    {
      if (this->LooksBefore)
      {
        vtkNew<vtkPolyData> moved;
        this->Widget->GetHeldStrokeRepresentation()->PutMoved(moved);
        this->Section.lineMoves(moved);
      }
      emit this->movesAlone();
      return;
    }
    this->MovePreview = std::make_unique<Preview>(shown, this->Followed);
    this->View->showPreview(this->MovePreview->mesh());
  }
  this->MovePreview->moveTo(this->Widget->GetTranslation());
}

// The mesh is as it was; of a stroke that was moved the preview stays: see strokeEnds.
void HeldStrokeTool::letGo()
{
  if (std::exchange(this->LooksBefore, false))
  {
    this->Section.moveEnds();
    this->Section.setMesh(this->View->mesh());
  }
  if (this->MovePreview && this->View->mesh() == this->MovePreview->mesh())
  {
    this->View->showPreview(this->MovePreview->rest());
  }
  this->lineEnds();
  emit this->left();
}

} // namespace oversketch_studio
