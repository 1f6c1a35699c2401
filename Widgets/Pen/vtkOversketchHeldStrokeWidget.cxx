#include "vtkOversketchHeldStrokeWidget.h"

#include "pen_stroke.h"
#include "vtkOversketchHeldStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkOversketchHeldStrokeWidget);
oversketchRepresentationMacro(HeldStroke);

struct vtkOversketchHeldStrokeWidget::Internals
{
  oversketch::PenView seen; // at the last move of the cursor
};

vtkOversketchHeldStrokeWidget::vtkOversketchHeldStrokeWidget()
  : Inner(std::make_unique<Internals>())
{
  this->KeyPressActivationOff();
  this->Priority = 0.55f; // before the pen, after the camera's controls
  oversketch::listenToHand(this->CallbackMapper, this, { Press, MoveTo, Release, Key, Forward, Backward });
  oversketch::listenTo(this->Pen.Get(),
    this,
    &vtkOversketchHeldStrokeWidget::Heard,
    { vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent });
}

vtkOversketchHeldStrokeWidget::~vtkOversketchHeldStrokeWidget()
{
  this->vtkOversketchHeldStrokeWidget::SetEnabled(0);
  this->Pen->SetInteractor(nullptr);
}

vtkOversketchStrokeWidget* vtkOversketchHeldStrokeWidget::GetPen()
{
  return this->Pen;
}

void vtkOversketchHeldStrokeWidget::HoldStroke(vtkPolyData* stroke, const double place[3])
{
  this->EndMove(false);
  if (stroke && stroke->GetNumberOfPoints() > 0)
  {
    std::copy_n(place, 3, this->Place);
    this->Keep(stroke);
  }
  else
  {
    this->Stroke->Initialize();
  }
  this->Refresh();
  this->Render();
}

void vtkOversketchHeldStrokeWidget::Tell(const std::string& message)
{
  this->GetHeldStrokeRepresentation()->SetText(message.c_str());
  this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(message.c_str()));
}

double* vtkOversketchHeldStrokeWidget::GetTranslation()
{
  return this->GetHeldStrokeRepresentation()->GetTranslation();
}

void vtkOversketchHeldStrokeWidget::SetRepresentation(vtkOversketchHeldStrokeRepresentation* representation)
{
  this->EndMove(false);
  this->SetWidgetRepresentation(representation);
  this->Refresh();
}

void vtkOversketchHeldStrokeWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->EndMove(false);
    this->Pen->SetEnabled(0);
  }
  const bool before = this->Enabled;
  this->Superclass::SetEnabled(enabling);
  if (!before && this->Enabled)
  {
    oversketch::workIn(this->CurrentRenderer, this->Interactor, this->Pen);
    this->Pen->SetEnabled(1);
  }
}

void vtkOversketchHeldStrokeWidget::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Superclass::SetInteractor(interactor); // ends with SetEnabled(0) where it changes
  this->Pen->SetInteractor(interactor);
}

void vtkOversketchHeldStrokeWidget::Refresh()
{
  vtkOversketchHeldStrokeRepresentation* representation = this->GetHeldStrokeRepresentation();
  representation->SetStroke(this->Stroke, this->Place);
  representation->SetText("");
  if (!representation->HasStroke())
  {
    representation->HighlightedOff();
  }
}

void vtkOversketchHeldStrokeWidget::Heard(vtkObject*, unsigned long event, void*)
{
  const vtkSmartPointer<vtkOversketchHeldStrokeWidget> alive(this); // an observer may let go of it
  switch (event)
  {
    case vtkCommand::StartInteractionEvent:
      this->Redrawing = this->PressedOver;
      this->LineBegins();
      break;
    case vtkCommand::InteractionEvent:
      this->LineGrows();
      break;
    case vtkCommand::EndInteractionEvent:
      this->GetHeldStrokeRepresentation()->ShowStrokeOn();
      this->LineEnds();
      break;
    case vtkCommand::MouseWheelForwardEvent:
      this->UseWheel(1);
      return;
    case vtkCommand::MouseWheelBackwardEvent:
      this->UseWheel(-1);
      return;
    default:
      this->PenHasDrawn();
  }
  this->InvokeEvent(event);
}

void vtkOversketchHeldStrokeWidget::PenHasDrawn()
{
  this->NewStroke = !this->Redrawing;
  this->Redrawing = false;
  this->TookHold = true;
  if (this->NewStroke && this->CurrentRenderer)
  {
    this->CurrentRenderer->GetActiveCamera()->GetFocalPoint(this->Place);
  }
  this->Pen->GetStrokeRepresentation()->Clear(); // from here on it is this widget's
  this->TakeStroke(this->Pen->GetStroke());
}

void vtkOversketchHeldStrokeWidget::TakeStroke(vtkPolyData* stroke)
{
  this->Keep(stroke);
  this->Refresh();
}

void vtkOversketchHeldStrokeWidget::Keep(vtkPolyData* stroke)
{
  vtkNew<vtkPolyData> copy; // of one that may be this one
  copy->DeepCopy(stroke);
  this->Stroke->ShallowCopy(copy);
}

bool vtkOversketchHeldStrokeWidget::IsOver(const int at[2])
{
  return this->GrabDistance > 0.0 &&
         this->GetHeldStrokeRepresentation()->DistanceTo(at[0], at[1]) <= this->GrabDistance;
}

void vtkOversketchHeldStrokeWidget::Hover(const int at[2])
{
  vtkOversketchHeldStrokeRepresentation* representation = this->GetHeldStrokeRepresentation();
  const bool near = representation->GetShowStroke() && this->IsOver(at);
  if (near != representation->GetHighlighted())
  {
    representation->SetHighlighted(near);
    this->RequestCursorShape(near ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
    this->Render();
  }
  const auto view = oversketch::PenView::of(this->CurrentRenderer);
  if (view == this->Inner->seen)
  {
    this->CameraRests();
  }
  this->Inner->seen = view;
}

void vtkOversketchHeldStrokeWidget::BeginMove(const int at[2])
{
  this->Moving = true;
  this->Moved = false;
  std::copy_n(at, 2, this->Grip);
  this->Refresh();
  this->GrabFocus(this->EventCallbackCommand);
  this->StartInteraction();
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  this->Render();
}

void vtkOversketchHeldStrokeWidget::EndMove(bool keep)
{
  if (!this->Moving)
  {
    return;
  }
  vtkNew<vtkPolyData> stroke;
  this->GetHeldStrokeRepresentation()->PutMoved(stroke);
  if (!this->TookHold)
  {
    stroke->GetCellData()->RemoveArray("Moved");
  }
  const double* translation = this->GetTranslation();
  keep = keep && this->Moved;
  this->Moving = this->Moved = false;
  this->ReleaseFocus();
  if (this->Interactor && this->Interactor->GetRenderWindow()) // it may go first
  {
    this->EndInteraction();
  }
  if (keep)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Place[i] += translation[i];
    }
    this->NewStroke = false;
    this->TakeStroke(stroke);
  }
  else
  {
    this->Refresh();
  }
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  if (keep)
  {
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  }
}

void vtkOversketchHeldStrokeWidget::Press(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchHeldStrokeWidget>(widget);
  vtkRenderWindowInteractor* from = self->Interactor;
  const int* at = from->GetEventPosition();
  if (self->Moving || from->GetControlKey() || from->GetAltKey() || !self->CurrentRenderer ||
      !self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    return;
  }
  vtkOversketchHeldStrokeRepresentation* representation = self->GetHeldStrokeRepresentation();
  const bool over = from->GetShiftKey() != 0;
  if (!self->IsOver(at) || self->Pen->IsWaiting())
  {
    if (!over && representation->GetShowStroke() && representation->HasStroke() && !self->Pen->IsWaiting())
    {
      // The frame that the pen draws over is to be without the held stroke.
      representation->ShowStrokeOff();
      self->CurrentRenderer->GetRenderWindow()->Render();
      if (!self->Pen->BeginStroke(at[0], at[1], self->Pen->GetPressure()))
      {
        representation->ShowStrokeOn();
      }
      self->EventCallbackCommand->SetAbortFlag(1);
    }
    return; // the pen's, or the camera's
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  if (!representation->IsInReach() || (over && !representation->IsInItsView()))
  {
    representation->LookFromStroke();
    if (over && !representation->IsInItsView())
    {
      self->Tell(
        "The window has another size than when the stroke was drawn: the stroke can be moved, but not "
        "drawn over.");
    }
    self->Render();
  }
  else if (over)
  {
    self->Pen->GetStrokeRepresentation()->SetStroke(self->Stroke);
    self->PressedOver = true;
    self->Pen->BeginOver(at[0], at[1], self->Pen->GetPressure());
    self->PressedOver = false;
  }
  else
  {
    self->BeginMove(at);
  }
}

void vtkOversketchHeldStrokeWidget::MoveTo(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchHeldStrokeWidget>(widget);
  const int* at = self->Interactor->GetEventPosition();
  if (!self->Moving)
  {
    if (self->CurrentRenderer && self->CurrentRenderer->IsInViewport(at[0], at[1]))
    {
      self->Hover(at);
    }
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  self->GetHeldStrokeRepresentation()->Move(self->Grip[0], self->Grip[1], at[0], at[1]);
  self->Moved = self->Moved || at[0] != self->Grip[0] || at[1] != self->Grip[1];
  if (self->Moved)
  {
    self->StrokeMoves();
  }
  self->InvokeEvent(vtkCommand::InteractionEvent);
  self->Render();
}

void vtkOversketchHeldStrokeWidget::Release(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchHeldStrokeWidget>(widget);
  if (self->Moving)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    MoveTo(widget);
    self->EndMove(true);
    self->Render();
  }
}

void vtkOversketchHeldStrokeWidget::Key(vtkAbstractWidget* widget)
{
  const auto self = oversketch::called<vtkOversketchHeldStrokeWidget>(widget);
  const std::string key = oversketch::keyOf(self->Interactor);
  bool used = self->Moving;
  if (self->Moving)
  {
    if (key == "Escape")
    {
      self->EndMove(false);
      self->Render();
    }
  }
  else if (!self->Pen->IsDrawing() && !self->Pen->IsWaiting())
  {
    used = self->UseKey(key);
  }
  if (used)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchHeldStrokeWidget::Forward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchHeldStrokeWidget>(widget)->Wheel(1);
}

void vtkOversketchHeldStrokeWidget::Backward(vtkAbstractWidget* widget)
{
  oversketch::called<vtkOversketchHeldStrokeWidget>(widget)->Wheel(-1);
}

void vtkOversketchHeldStrokeWidget::Wheel(int notches)
{
  const vtkSmartPointer<vtkOversketchHeldStrokeWidget> alive(this); // an observer may let go of it
  const bool moving = this->Moving;
  if (this->UseWheel(notches) || moving)
  {
    this->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchHeldStrokeWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TookHold: " << (this->TookHold ? "on" : "off") << "\n";
  os << indent << "GrabDistance: " << this->GrabDistance << "\n";
  os << indent << "Moving: " << this->Moving << "\n";
  os << indent << "Place: " << this->Place[0] << " " << this->Place[1] << " " << this->Place[2] << "\n";
  os << indent << "Stroke: " << this->Stroke->GetNumberOfPoints() << " samples\n";
}
