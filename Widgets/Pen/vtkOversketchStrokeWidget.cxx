#include "vtkOversketchStrokeWidget.h"

#include "vtkOversketchInteractorStyle.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"
#include "vtkTrivialProducer.h"
#include "vtkWidgetCallbackMapper.h"
#include "vtkWidgetEvent.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkOversketchStrokeWidget);
oversketchRepresentationMacro(Stroke);

namespace
{

constexpr double backspaceLength = 20.0; // px

} // namespace

vtkOversketchStrokeWidget::vtkOversketchStrokeWidget()
{
  this->KeyPressActivationOff();
  this->Producer->SetOutput(this->Stroke);
  oversketch::listenToHand(this->CallbackMapper, this, { Press, Move, Release, Key, Forward, Backward });
  this->CallbackMapper->SetCallbackMethod(vtkCommand::ConfigureEvent, vtkWidgetEvent::Resize, this, Resized);
}

vtkOversketchStrokeWidget::~vtkOversketchStrokeWidget()
{
  this->vtkOversketchStrokeWidget::SetEnabled(0);
}

vtkAlgorithmOutput* vtkOversketchStrokeWidget::GetOutputPort()
{
  return this->Producer->GetOutputPort();
}

void vtkOversketchStrokeWidget::SetRepresentation(vtkOversketchStrokeRepresentation* representation)
{
  this->DropDrawing();
  this->SetWidgetRepresentation(representation);
}

void vtkOversketchStrokeWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->DropDrawing(); // no render: the window may be on its way out
    if (this->StyleInDraw)
    {
      this->StyleInDraw->SetModeToNavigate();
      this->StyleInDraw = nullptr;
    }
  }
  const bool before = this->Enabled;
  this->Superclass::SetEnabled(enabling);
  auto* style = this->Interactor
                  ? vtkOversketchInteractorStyle::SafeDownCast(this->Interactor->GetInteractorStyle())
                  : nullptr;
  if (!before && this->Enabled && style && style->GetMode() == vtkOversketchInteractorStyle::Navigate)
  {
    style->SetModeToDraw();
    this->StyleInDraw = style;
  }
}

bool vtkOversketchStrokeWidget::IsDrawing()
{
  return this->GetStrokeRepresentation()->IsDrawing();
}

bool vtkOversketchStrokeWidget::BeginStroke(double x, double y, double pressure)
{
  return this->Begin(x, y, pressure, this->Waiting);
}

bool vtkOversketchStrokeWidget::BeginOver(double x, double y, double pressure)
{
  if (!this->Waiting && !this->IsDrawing())
  {
    vtkNew<vtkPolyData> last;
    this->GetStrokeRepresentation()->GetPolyData(last);
    vtkDataArray* times = last->GetPointData()->GetArray("Time");
    const vtkIdType count = times ? times->GetNumberOfTuples() : 0;
    this->Began = vtkTimerLog::GetUniversalTime() - (count > 0 ? times->GetComponent(count - 1, 0) : 0.0);
  }
  return this->Begin(x, y, pressure, true);
}

bool vtkOversketchStrokeWidget::Begin(double x, double y, double pressure, bool over)
{
  vtkOversketchStrokeRepresentation* representation = this->GetStrokeRepresentation();
  if (!this->Enabled || representation->IsDrawing())
  {
    return false;
  }
  representation->BeginStroke(over);
  if (!representation->IsDrawing())
  {
    return false;
  }
  const vtkSmartPointer<vtkOversketchStrokeWidget> alive(this); // an observer may let go of it
  this->GrabFocus(this->EventCallbackCommand);
  this->StartInteraction();
  if (!over)
  {
    this->Began = vtkTimerLog::GetUniversalTime();
  }
  this->Pen[0] = x;
  this->Pen[1] = y;
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  this->AddSample(x, y, pressure, over ? -1.0 : 0.0);
  return this->IsDrawing();
}

void vtkOversketchStrokeWidget::AddSample(double x, double y, double pressure, double time)
{
  const vtkSmartPointer<vtkOversketchStrokeWidget> alive(this);
  vtkOversketchStrokeRepresentation* representation = this->GetStrokeRepresentation();
  if (!representation->IsDrawing() || !std::isfinite(x) || !std::isfinite(y))
  {
    return;
  }
  if (!representation->FitsRenderer())
  {
    this->CancelStroke();
    return;
  }
  this->Cursor[0] = x;
  this->Cursor[1] = y;
  const double dx = x - this->Pen[0], dy = y - this->Pen[1];
  const double distance = std::hypot(dx, dy);
  if (distance > this->Stabilizer)
  {
    const double part = 1.0 - this->Stabilizer / distance;
    this->Pen[0] += part * dx;
    this->Pen[1] += part * dy;
  }
  representation->AddSample(this->Pen[0],
    this->Pen[1],
    std::clamp(pressure, 0.0, 1.0),
    time >= 0.0 ? time : vtkTimerLog::GetUniversalTime() - this->Began);
  this->InvokeEvent(vtkCommand::InteractionEvent);
  this->Render();
}

void vtkOversketchStrokeWidget::RemoveLastSamples()
{
  if (this->IsDrawing() || this->Waiting)
  {
    vtkOversketchStrokeRepresentation* representation = this->GetStrokeRepresentation();
    representation->RemoveLast(backspaceLength);
    if (!representation->IsDrawing() && representation->GetNumberOfSamples() < 2)
    {
      this->Drop();
      return;
    }
    this->InvokeEvent(vtkCommand::InteractionEvent);
    this->Render();
  }
}

void vtkOversketchStrokeWidget::StopDrawing()
{
  this->ReleaseFocus();
  if (this->Interactor && this->Interactor->GetRenderWindow()) // it may go first
  {
    this->EndInteraction();
  }
}

void vtkOversketchStrokeWidget::EndStroke()
{
  vtkOversketchStrokeRepresentation* representation = this->GetStrokeRepresentation();
  if (!representation->IsDrawing())
  {
    return;
  }
  const vtkSmartPointer<vtkOversketchStrokeWidget> alive(this);
  if (this->Cursor[0] != this->Pen[0] || this->Cursor[1] != this->Pen[1])
  {
    representation->AddSample(
      this->Cursor[0], this->Cursor[1], this->Pressure, vtkTimerLog::GetUniversalTime() - this->Began);
  }
  const bool whole = representation->EndStroke();
  this->Dropped = false;
  this->StopDrawing();
  this->Waiting = this->Waiting || (whole && !this->CommitOnRelease);
  const bool committed = whole && this->CommitOnRelease;
  if (committed)
  {
    this->Publish();
  }
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  if (committed)
  {
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  }
  this->Render();
}

bool vtkOversketchStrokeWidget::DropDrawing()
{
  if (!this->WidgetRep || !this->IsDrawing())
  {
    return false;
  }
  this->GetStrokeRepresentation()->DropStroke();
  this->Dropped = true;
  this->StopDrawing();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  return true;
}

void vtkOversketchStrokeWidget::CancelStroke()
{
  const vtkSmartPointer<vtkOversketchStrokeWidget> alive(this);
  if (this->DropDrawing())
  {
    this->Render();
  }
}

void vtkOversketchStrokeWidget::Publish()
{
  this->GetStrokeRepresentation()->GetPolyData(this->Stroke);
  this->Waiting = false;
}

void vtkOversketchStrokeWidget::Commit()
{
  if (this->Waiting && !this->IsDrawing())
  {
    this->Publish();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

void vtkOversketchStrokeWidget::Drop()
{
  if (this->Waiting && !this->IsDrawing())
  {
    this->GetStrokeRepresentation()->Clear();
    this->Waiting = false;
    this->Render();
  }
}

void vtkOversketchStrokeWidget::Press(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchStrokeWidget>(widget);
  vtkRenderWindowInteractor* from = self->Interactor;
  const int* at = from->GetEventPosition();
  if (!from->GetShiftKey() && !from->GetControlKey() && !from->GetAltKey() && self->CurrentRenderer &&
      self->CurrentRenderer->IsInViewport(at[0], at[1]) && self->BeginStroke(at[0], at[1], self->Pressure))
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchStrokeWidget::Move(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchStrokeWidget>(widget);
  if (self->IsDrawing())
  {
    const int* at = self->Interactor->GetEventPosition();
    self->EventCallbackCommand->SetAbortFlag(1);
    self->AddSample(at[0], at[1], self->Pressure);
  }
}

void vtkOversketchStrokeWidget::Release(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchStrokeWidget>(widget);
  if (self->IsDrawing())
  {
    const int* at = self->Interactor->GetEventPosition();
    self->EventCallbackCommand->SetAbortFlag(1);
    if (at[0] != self->Cursor[0] || at[1] != self->Cursor[1])
    {
      self->AddSample(at[0], at[1], self->Pressure);
    }
    self->EndStroke();
  }
}

void vtkOversketchStrokeWidget::Key(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchStrokeWidget>(widget);
  const std::string key = oversketch::keyOf(self->Interactor);
  const bool drawing = self->IsDrawing();
  if (!drawing && !self->Waiting)
  {
    return;
  }
  bool used = true;
  if (key == "Escape")
  {
    drawing ? self->CancelStroke() : self->Drop();
  }
  else if (key == "BackSpace")
  {
    self->RemoveLastSamples();
  }
  else if (key == "Return" || key == "KP_Enter")
  {
    self->Commit();
  }
  else
  {
    used = drawing;
  }
  if (used)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchStrokeWidget::Forward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchStrokeWidget>(widget)->Wheel(vtkCommand::MouseWheelForwardEvent);
}

void vtkOversketchStrokeWidget::Backward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchStrokeWidget>(widget)->Wheel(vtkCommand::MouseWheelBackwardEvent);
}

// It is not the camera's while the pen draws.
void vtkOversketchStrokeWidget::Wheel(unsigned long event)
{
  const vtkSmartPointer<vtkOversketchStrokeWidget> alive(this);
  if (this->IsDrawing())
  {
    this->EventCallbackCommand->SetAbortFlag(1);
    this->InvokeEvent(event);
  }
}

void vtkOversketchStrokeWidget::Resized(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchStrokeWidget>(widget);
  if (self->IsDrawing() && !self->GetStrokeRepresentation()->FitsRenderer())
  {
    self->CancelStroke();
  }
}

void vtkOversketchStrokeWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CommitOnRelease: " << this->CommitOnRelease << "\n";
  os << indent << "Stabilizer: " << this->Stabilizer << "\n";
  os << indent << "Pressure: " << this->Pressure << "\n";
  os << indent << "Waiting: " << this->Waiting << "\n";
  os << indent << "Stroke: " << this->Stroke->GetNumberOfPoints() << " samples\n";
}
