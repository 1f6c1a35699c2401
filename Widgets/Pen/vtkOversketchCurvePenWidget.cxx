#include "vtkOversketchCurvePenWidget.h"

#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

vtkOversketchCurvePenWidget::vtkOversketchCurvePenWidget()
{
  this->KeyPressActivationOff();
  this->Priority = 0.55f; // before the pen
  const auto nothing = [](vtkAbstractWidget*) {};
  oversketch::listenToHand(this->CallbackMapper, this, { Press, nothing, nothing, Key });
  oversketch::listenTo(this->Pen.Get(), this, &vtkOversketchCurvePenWidget::Heard);
}

vtkOversketchCurvePenWidget::~vtkOversketchCurvePenWidget()
{
  this->vtkOversketchCurvePenWidget::SetEnabled(0);
  this->Pen->SetInteractor(nullptr);
}

vtkOversketchStrokeWidget* vtkOversketchCurvePenWidget::GetPen()
{
  return this->Pen;
}

void vtkOversketchCurvePenWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->Pen->SetEnabled(0);
  }
  const bool before = this->Enabled;
  this->Superclass::SetEnabled(enabling);
  if (!before && this->Enabled)
  {
    oversketch::workIn(this->CurrentRenderer, this->Interactor, this->Pen);
    this->ReadyPen();
  }
}

void vtkOversketchCurvePenWidget::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Superclass::SetInteractor(interactor); // ends with SetEnabled(0) where it changes
  this->Pen->SetInteractor(interactor);
}

void vtkOversketchCurvePenWidget::ReadyPen()
{
  if (!this->Pen->IsDrawing())
  {
    this->Pen->SetEnabled(this->Enabled && this->Wants(false));
  }
}

void vtkOversketchCurvePenWidget::Tell(const std::string& message)
{
  this->ShowText(message);
  this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(message.c_str()));
}

void vtkOversketchCurvePenWidget::Heard(vtkObject*, unsigned long event, void*)
{
  const vtkSmartPointer<vtkOversketchCurvePenWidget> alive(this); // an observer may let go of it
  if (event == vtkCommand::StartInteractionEvent)
  {
    this->Over = this->PressedOver;
    this->ShowText("");
  }
  else if (event == vtkCommand::EndInteractionEvent)
  {
    this->ReadyPen();
  }
  else if (event == vtkCommand::WidgetValueChangedEvent)
  {
    vtkNew<vtkPolyData> stroke;
    stroke->DeepCopy(this->Pen->GetStroke());
    this->Pen->GetStrokeRepresentation()->Clear(); // from here on it is this widget's
    const bool used = this->TakeStroke(stroke, this->Over);
    this->ReadyPen();
    if (!used)
    {
      return;
    }
  }
  this->InvokeEvent(event);
}

void vtkOversketchCurvePenWidget::Press(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCurvePenWidget>(widget);
  vtkRenderWindowInteractor* from = self->Interactor;
  const int* at = from->GetEventPosition();
  if (from->GetShiftKey() && !from->GetControlKey() && !from->GetAltKey() && self->CurrentRenderer &&
      self->CurrentRenderer->IsInViewport(at[0], at[1]) && self->Wants(true))
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Pen->SetEnabled(1);
    self->PressedOver = true;
    self->Pen->BeginStroke(at[0], at[1], self->Pen->GetPressure());
    self->PressedOver = false;
  }
}

void vtkOversketchCurvePenWidget::Key(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCurvePenWidget>(widget);
  const std::string key = oversketch::keyOf(self->Interactor);
  if (key == "Escape" && !self->Pen->IsDrawing() && !self->Pen->IsWaiting() && self->TakeBack())
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->ShowText("");
    self->ReadyPen();
    self->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    self->Render();
  }
}

void vtkOversketchCurvePenWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Drawing: " << this->Pen->IsDrawing() << "\n";
}
