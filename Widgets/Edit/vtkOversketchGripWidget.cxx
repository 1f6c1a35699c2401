#include "vtkOversketchGripWidget.h"

#include "vtkOversketchGripRepresentation.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

vtkOversketchGripWidget::vtkOversketchGripWidget()
{
  this->KeyPressActivationOff();
  this->Priority = 0.57f; // before pens, after the camera's controls
  oversketch::listenToHand(this->CallbackMapper, this, { Press, MoveTo, Release, Key });
}

vtkOversketchGripWidget::~vtkOversketchGripWidget() = default; // heirs have let go of what they drag

vtkOversketchGripRepresentation* vtkOversketchGripWidget::GetGripRepresentation()
{
  this->CreateDefaultRepresentation();
  return static_cast<vtkOversketchGripRepresentation*>(this->WidgetRep);
}

void vtkOversketchGripWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->StopDragging(false);
    this->GetGripRepresentation()->SetActiveGrip(0);
  }
  this->Superclass::SetEnabled(enabling);
}

void vtkOversketchGripWidget::Tell(const std::string& message)
{
  this->GetGripRepresentation()->SetText(message.c_str());
  this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(message.c_str()));
}

void vtkOversketchGripWidget::ValueChanged()
{
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  this->Render();
}

void vtkOversketchGripWidget::StopDragging(bool keep)
{
  if (!this->Dragging)
  {
    return;
  }
  this->Dragging = false;
  this->ReleaseFocus();
  if (this->Interactor && this->Interactor->GetRenderWindow()) // it may go first
  {
    this->EndInteraction();
  }
  const bool changed = this->LetGo(keep);
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  if (changed)
  {
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  }
}

void vtkOversketchGripWidget::Press(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchGripWidget>(widget);
  vtkRenderWindowInteractor* from = self->Interactor;
  const int at[2] = { from->GetEventPosition()[0], from->GetEventPosition()[1] };
  if (self->Dragging || from->GetShiftKey() || from->GetControlKey() || from->GetAltKey() ||
      !self->CurrentRenderer || !self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    return;
  }
  vtkOversketchGripRepresentation* representation = self->GetGripRepresentation();
  representation->SetText("");
  const int grip = representation->GetGripAt(at[0], at[1]);
  if (!self->Grasp(grip, at))
  {
    return;
  }
  self->Dragging = true;
  self->EventCallbackCommand->SetAbortFlag(1);
  self->GrabFocus(self->EventCallbackCommand);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent);
  self->Render();
}

void vtkOversketchGripWidget::MoveTo(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchGripWidget>(widget);
  const int at[2] = { self->Interactor->GetEventPosition()[0], self->Interactor->GetEventPosition()[1] };
  if (self->Dragging)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Pull(at);
    self->InvokeEvent(vtkCommand::InteractionEvent);
    self->Render();
  }
  else if (self->CurrentRenderer && self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    vtkOversketchGripRepresentation* representation = self->GetGripRepresentation();
    const int grip = representation->GetGripAt(at[0], at[1]);
    if (grip != representation->GetActiveGrip())
    {
      representation->SetActiveGrip(grip);
      self->RequestCursorShape(grip ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
      self->Render();
    }
  }
}

void vtkOversketchGripWidget::Release(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchGripWidget>(widget);
  if (self->Dragging)
  {
    MoveTo(widget);
    self->StopDragging(true);
    self->Render();
  }
}

void vtkOversketchGripWidget::Key(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchGripWidget>(widget);
  const std::string key = oversketch::keyOf(self->Interactor);
  bool used = self->Dragging;
  if (self->Dragging)
  {
    if (key == "Escape")
    {
      self->StopDragging(false);
      self->Render();
    }
  }
  else
  {
    used = self->UseKey(key);
  }
  if (used)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchGripWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << this->Dragging << "\n";
}
