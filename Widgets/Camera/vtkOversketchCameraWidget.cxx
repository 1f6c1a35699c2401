#include "vtkOversketchCameraWidget.h"

#include "vtkOversketchCameraRepresentation.h"
#include "vtkOversketchInteractorStyle.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkOversketchCameraWidget);
oversketchRepresentationMacro(Camera);

vtkOversketchCameraWidget::vtkOversketchCameraWidget()
{
  this->KeyPressActivationOff();
  this->Priority = 0.6f; // before the pen
  oversketch::listenToHand(this->CallbackMapper, this, { Press, Move, Release, Key });
}

vtkOversketchCameraWidget::~vtkOversketchCameraWidget()
{
  this->vtkOversketchCameraWidget::SetEnabled(0);
}

void vtkOversketchCameraWidget::SetRepresentation(vtkOversketchCameraRepresentation* representation)
{
  this->Stop();
  this->SetWidgetRepresentation(representation);
}

void vtkOversketchCameraWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->Stop();
  }
  this->Superclass::SetEnabled(enabling);
}

void vtkOversketchCameraWidget::Stop()
{
  if (this->Dragging)
  {
    this->Dragging = 0;
    this->ReleaseFocus();
    this->EndInteraction();
    this->InvokeEvent(vtkCommand::EndInteractionEvent);
  }
}

void vtkOversketchCameraWidget::Press(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCameraWidget>(widget);
  vtkOversketchCameraRepresentation* controls = self->GetCameraRepresentation();
  const int* at = self->Interactor->GetEventPosition();
  const int what = controls->ComputeInteractionState(at[0], at[1]);
  if (self->Dragging || what == vtkOversketchCameraRepresentation::Outside ||
      !self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  vtkOversketchInteractorStyle* style = controls->GetStyle();
  style->FindPokedRenderer(at[0], at[1]);
  self->Dragging = what;
  self->Angle = controls->GetDialAngle(at[0], at[1]);
  self->Y = at[1];
  self->Spin = style->GetSpin();
  self->Zoom = style->GetZoom();
  self->GrabFocus(self->EventCallbackCommand);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent);
}

void vtkOversketchCameraWidget::Move(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCameraWidget>(widget);
  vtkOversketchCameraRepresentation* controls = self->GetCameraRepresentation();
  vtkOversketchInteractorStyle* style = self->Dragging ? controls->GetStyle() : nullptr;
  if (!style)
  {
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  const int* at = self->Interactor->GetEventPosition();
  if (self->Dragging == vtkOversketchCameraRepresentation::OnDial)
  {
    style->SetSpin(self->Spin + controls->GetDialAngle(at[0], at[1]) - self->Angle);
  }
  else
  {
    style->SetZoom(self->Zoom * controls->GetZoomRatio(at[1] - self->Y));
  }
  self->InvokeEvent(vtkCommand::InteractionEvent);
}

void vtkOversketchCameraWidget::Release(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCameraWidget>(widget);
  if (self->Dragging)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Stop();
  }
}

void vtkOversketchCameraWidget::Key(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchCameraWidget>(widget);
  if (!self->Dragging)
  {
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  vtkOversketchInteractorStyle* style = self->GetCameraRepresentation()->GetStyle();
  if (style && oversketch::keyOf(self->Interactor) == "Escape")
  {
    style->SetSpin(self->Spin);
    style->SetZoom(self->Zoom);
    self->Stop();
  }
}

void vtkOversketchCameraWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dragging: " << this->Dragging << "\n";
}
