#include "vtkOversketchOneStrokeWidget.h"

#include "live_stroke.h"
#include "pen_stroke.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchOneStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkOversketchOneStrokeWidget);

struct vtkOversketchOneStrokeWidget::Internals
{
  oversketch::LiveStroke live;
  oversketch::PenView seen; // at the last move of the cursor
  double place[3] = { 0.0, 0.0, 0.0 };
  bool placed = false; // the host has said where the stroke stands
  std::string told;    // the message that was sent
};

namespace
{

vtkOversketchOneStrokeWidget* cast(vtkAbstractWidget* widget)
{
  return static_cast<vtkOversketchOneStrokeWidget*>(widget);
}

} // namespace

vtkOversketchOneStrokeWidget::vtkOversketchOneStrokeWidget()
  : Inner(std::make_unique<Internals>())
{
  this->KeyPressActivationOff();
  this->Priority = 0.55f; // before the pen, after the camera's controls
  oversketch::listenToHand(this->CallbackMapper, this, { Press, MoveTo, Release, Key });
  this->Ear->SetClientData(this);
  this->Ear->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<vtkOversketchOneStrokeWidget*>(self)->Heard(event); });
  this->FrameEar->SetClientData(this);
  this->FrameEar->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchOneStrokeWidget*>(self)->FindSection(); });
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent })
  {
    this->Pen->AddObserver(event, this->Ear);
  }
}

vtkOversketchOneStrokeWidget::~vtkOversketchOneStrokeWidget()
{
  this->Pen->RemoveObserver(this->Ear);
  this->vtkOversketchOneStrokeWidget::SetEnabled(0);
  this->Pen->SetInteractor(nullptr);
}

void vtkOversketchOneStrokeWidget::SetInputConnection(vtkAlgorithmOutput* mesh)
{
  this->Inner->live.setSource(mesh);
}

void vtkOversketchOneStrokeWidget::SetInputData(vtkPolyData* mesh)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->SetInputConnection(producer->GetOutputPort());
}

vtkAlgorithmOutput* vtkOversketchOneStrokeWidget::GetOutputPort()
{
  return this->Inner->live.outputPort();
}

vtkPolyData* vtkOversketchOneStrokeWidget::GetOutput()
{
  return this->Inner->live.output();
}

void vtkOversketchOneStrokeWidget::Update()
{
  if (!this->IsMoving() && this->Inner->live.update(this->RunsStrokes))
  {
    this->Refresh();
  }
  const std::string message = this->GetMessage();
  if (message != this->Inner->told)
  {
    this->Inner->told = message;
    if (!message.empty())
    {
      this->Tell(message);
    }
  }
}

void vtkOversketchOneStrokeWidget::Tell(const std::string& message)
{
  this->GetOneStrokeRepresentation()->SetText(message.c_str());
  this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(message.c_str()));
}

void vtkOversketchOneStrokeWidget::SetOneStroke(vtkOversketchOneStroke* system)
{
  this->EndMove(false);
  this->Inner->live.setSystem(system);
}

vtkOversketchOneStroke* vtkOversketchOneStrokeWidget::GetOneStroke()
{
  return this->Inner->live.system();
}

vtkOversketchStrokeWidget* vtkOversketchOneStrokeWidget::GetPen()
{
  return this->Pen;
}

vtkPolyData* vtkOversketchOneStrokeWidget::GetStroke()
{
  return this->Inner->live.stroke();
}

void vtkOversketchOneStrokeWidget::SetStroke(vtkPolyData* stroke)
{
  if (!stroke || stroke->GetNumberOfPoints() == 0)
  {
    this->Drop();
    return;
  }
  this->EndMove(false);
  this->Inner->live.setStroke(stroke);
  this->Update();
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  this->Render();
}

void vtkOversketchOneStrokeWidget::SetStrokeAt(vtkPolyData* stroke, const double place[3])
{
  this->EndMove(false);
  this->Inner->placed = stroke && stroke->GetNumberOfPoints() > 0;
  if (this->Inner->placed)
  {
    std::copy_n(place, 3, this->Inner->place);
    this->Inner->live.setStroke(stroke);
  }
  else
  {
    this->Inner->live.stroke()->Initialize();
  }
  this->Refresh();
  this->Render();
}

void vtkOversketchOneStrokeWidget::Commit()
{
  this->EndMove(false);
  if (this->Inner->live.exists())
  {
    this->Inner->live.commit();
    this->Inner->told.clear();
    this->Refresh();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

void vtkOversketchOneStrokeWidget::Drop()
{
  this->EndMove(false);
  if (this->Inner->live.exists())
  {
    this->Inner->live.drop();
    this->Inner->told.clear();
    this->Refresh();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

const char* vtkOversketchOneStrokeWidget::GetMessage()
{
  return this->Inner->live.message().c_str();
}

void vtkOversketchOneStrokeWidget::SetShowRegion(bool show)
{
  if (show != this->ShowRegion)
  {
    this->ShowRegion = show;
    this->Refresh();
    this->Modified();
  }
}

double* vtkOversketchOneStrokeWidget::GetTranslation()
{
  return this->GetOneStrokeRepresentation()->GetTranslation();
}

void vtkOversketchOneStrokeWidget::SetRepresentation(vtkOversketchOneStrokeRepresentation* representation)
{
  this->EndMove(false);
  this->SetWidgetRepresentation(representation);
  this->Refresh();
}

vtkOversketchOneStrokeRepresentation* vtkOversketchOneStrokeWidget::GetOneStrokeRepresentation()
{
  this->CreateDefaultRepresentation();
  return static_cast<vtkOversketchOneStrokeRepresentation*>(this->WidgetRep);
}

void vtkOversketchOneStrokeWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    this->WidgetRep = vtkOversketchOneStrokeRepresentation::New();
  }
}

void vtkOversketchOneStrokeWidget::SetEnabled(int enabling)
{
  if (!enabling && this->Enabled)
  {
    this->EndMove(false);
    this->Pen->SetEnabled(0);
    if (this->Watched)
    {
      this->Watched->RemoveObserver(this->Ear);
      this->Watched = nullptr;
    }
    if (this->WatchedWindow)
    {
      this->WatchedWindow->RemoveObserver(this->FrameEar);
      this->WatchedWindow = nullptr;
    }
  }
  const bool before = this->Enabled;
  this->Superclass::SetEnabled(enabling);
  if (!before && this->Enabled)
  {
    this->Pen->SetInteractor(this->Interactor);
    this->Pen->SetDefaultRenderer(this->CurrentRenderer);
    this->Pen->SetCurrentRenderer(this->CurrentRenderer);
    this->Pen->SetEnabled(1);
    this->Watched = this->CurrentRenderer;
    this->Watched->AddObserver(vtkCommand::StartEvent, this->Ear);
    this->WatchedWindow = this->Watched->GetRenderWindow();
    this->WatchedWindow->AddObserver(vtkCommand::StartEvent, this->FrameEar);
    this->Update();
  }
}

void vtkOversketchOneStrokeWidget::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Superclass::SetInteractor(interactor); // ends with SetEnabled(0) where it changes
  this->Pen->SetInteractor(interactor);
}

// Brings what is drawn up to what is.
void vtkOversketchOneStrokeWidget::Refresh()
{
  Internals& inner = *this->Inner;
  if (!this->RunsStrokes && inner.placed)
  {
    this->GetOneStrokeRepresentation()->SetStroke(inner.live.stroke(), inner.place);
  }
  else
  {
    double place[3];
    const bool any = inner.live.middle(place);
    this->GetOneStrokeRepresentation()->SetStroke(any ? inner.live.stroke() : nullptr, place);
  }
  this->GetOneStrokeRepresentation()->SetRegion(
    this->ShowRegion && this->RunsStrokes && !this->Moving ? inner.live.region() : nullptr);
  this->GetOneStrokeRepresentation()->SetText(this->GetMessage());
  if (!this->GetOneStrokeRepresentation()->HasStroke())
  {
    this->GetOneStrokeRepresentation()->HighlightedOff();
  }
}

void vtkOversketchOneStrokeWidget::Heard(unsigned long event)
{
  if (event == vtkCommand::StartEvent)
  {
    this->Update(); // the renderer is about to draw
    return;
  }
  const vtkSmartPointer<vtkOversketchOneStrokeWidget> alive(this); // an observer may let go of it
  switch (event)
  {
    case vtkCommand::StartInteractionEvent:
      this->Redrawing = this->PressedOver;
      this->MakeCurvesReady();
      break;
    case vtkCommand::InteractionEvent:
      this->Extended = true;
      break;
    case vtkCommand::EndInteractionEvent:
      this->GetOneStrokeRepresentation()->ShowStrokeOn();
      break;
    default:
      this->PenHasDrawn();
  }
  this->InvokeEvent(event);
}

void vtkOversketchOneStrokeWidget::PutSought(vtkPolyData* stroke)
{
  stroke->Initialize();
  vtkOversketchStrokeRepresentation* drawn = this->Pen->GetStrokeRepresentation();
  if (drawn->IsDrawing() && drawn->GetNumberOfSamples() > 0)
  {
    if (!this->Redrawing)
    {
      drawn->GetPolyData(stroke);
    }
  }
  else if (this->CurrentRenderer)
  {
    oversketch::PenStroke begun;
    begun.view = oversketch::PenView::of(this->CurrentRenderer);
    begun.add(oversketch::Vector2::Zero(), 1.0, 0.0);
    begun.putInto(stroke);
  }
}

// The curves of the mesh in the renderer's view.
void vtkOversketchOneStrokeWidget::MakeCurvesReady()
{
  if (this->FindsSections)
  {
    vtkNew<vtkPolyData> stroke, none;
    this->PutSought(stroke);
    this->Inner->live.section(stroke, none);
  }
}

// Once a frame, however many samples have come since the last.
void vtkOversketchOneStrokeWidget::FindSection()
{
  if (!this->FindsSections || !this->Extended || !this->Pen->IsDrawing())
  {
    return;
  }
  this->Extended = false;
  vtkNew<vtkPolyData> stroke, section;
  this->PutSought(stroke);
  if (stroke->GetNumberOfPoints() > 0)
  {
    this->Inner->live.section(stroke, section);
  }
  this->Pen->GetStrokeRepresentation()->SetSection(section);
}

void vtkOversketchOneStrokeWidget::PenHasDrawn()
{
  Internals& inner = *this->Inner;
  if (this->RunsStrokes && !this->Redrawing)
  {
    inner.live.commit();
  }
  this->NewStroke = !this->Redrawing;
  this->Redrawing = false;
  inner.placed = inner.placed && !this->NewStroke;
  inner.live.setStroke(this->Pen->GetStroke());
  inner.told.clear();
  this->Pen->GetStrokeRepresentation()->Clear(); // from here on it is this widget's
  this->Update();
  this->Refresh();
}

void vtkOversketchOneStrokeWidget::Hover(const int at[2])
{
  vtkOversketchOneStrokeRepresentation* representation = this->GetOneStrokeRepresentation();
  const bool near =
    representation->GetShowStroke() && representation->DistanceTo(at[0], at[1]) <= this->GrabDistance;
  if (near != representation->GetHighlighted())
  {
    representation->SetHighlighted(near);
    this->RequestCursorShape(near ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
    this->Render();
  }
  // While the camera moves, no view stays; once it rests the curves are made ready for the pen.
  const auto view = oversketch::PenView::of(this->CurrentRenderer);
  if (view == this->Inner->seen)
  {
    this->MakeCurvesReady();
  }
  this->Inner->seen = view;
}

void vtkOversketchOneStrokeWidget::BeginMove(const int at[2])
{
  this->Moving = true;
  this->Moved = false;
  std::copy_n(at, 2, this->Grip);
  this->GetOneStrokeRepresentation()->SetRegion(nullptr);
  this->GrabFocus(this->EventCallbackCommand);
  this->StartInteraction();
  this->InvokeEvent(vtkCommand::StartInteractionEvent);
  this->Render();
}

void vtkOversketchOneStrokeWidget::EndMove(bool keep)
{
  if (!this->Moving)
  {
    return;
  }
  Internals& inner = *this->Inner;
  vtkNew<vtkPolyData> stroke;
  this->GetOneStrokeRepresentation()->PutMoved(stroke);
  const double* translation = this->GetTranslation();
  keep = keep && this->Moved;
  this->Moving = this->Moved = false;
  this->ReleaseFocus();
  if (this->Interactor && this->Interactor->GetRenderWindow()) // it may go first
  {
    this->EndInteraction();
  }
  inner.live.endDrag();
  if (keep)
  {
    for (int i = 0; i < 3; ++i)
    {
      inner.place[i] += translation[i];
    }
    inner.live.setStroke(stroke);
    inner.told.clear();
    this->NewStroke = false;
    this->Update();
  }
  this->Refresh();
  this->InvokeEvent(vtkCommand::EndInteractionEvent);
  if (keep)
  {
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  }
}

void vtkOversketchOneStrokeWidget::Press(vtkAbstractWidget* widget)
{
  const vtkSmartPointer<vtkOversketchOneStrokeWidget> self(cast(widget)); // an observer may let go of it
  vtkRenderWindowInteractor* from = self->Interactor;
  const int* at = from->GetEventPosition();
  if (self->Moving || from->GetControlKey() || from->GetAltKey() || !self->CurrentRenderer ||
      !self->CurrentRenderer->IsInViewport(at[0], at[1]))
  {
    return;
  }
  vtkOversketchOneStrokeRepresentation* representation = self->GetOneStrokeRepresentation();
  const bool over = from->GetShiftKey() != 0;
  if (representation->DistanceTo(at[0], at[1]) > self->GrabDistance || self->Pen->IsWaiting())
  {
    if (!over && representation->GetShowStroke() && representation->HasStroke() && !self->Pen->IsWaiting())
    {
      // The frame that the pen draws over is to be without the live stroke.
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
    self->Pen->GetStrokeRepresentation()->SetStroke(self->GetStroke());
    self->PressedOver = true;
    self->Pen->BeginOver(at[0], at[1], self->Pen->GetPressure());
    self->PressedOver = false;
  }
  else
  {
    self->BeginMove(at);
  }
}

void vtkOversketchOneStrokeWidget::MoveTo(vtkAbstractWidget* widget)
{
  const vtkSmartPointer<vtkOversketchOneStrokeWidget> self(cast(widget)); // an observer may let go of it
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
  vtkOversketchOneStrokeRepresentation* representation = self->GetOneStrokeRepresentation();
  representation->Move(self->Grip[0], self->Grip[1], at[0], at[1]);
  self->Moved = self->Moved || at[0] != self->Grip[0] || at[1] != self->Grip[1];
  if (self->RunsStrokes && self->Moved)
  {
    self->Inner->live.drag(representation->GetTranslation());
  }
  self->InvokeEvent(vtkCommand::InteractionEvent);
  self->Render();
}

void vtkOversketchOneStrokeWidget::Release(vtkAbstractWidget* widget)
{
  const vtkSmartPointer<vtkOversketchOneStrokeWidget> self(cast(widget)); // an observer may let go of it
  if (self->Moving)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    MoveTo(widget);
    self->EndMove(true);
    self->Render();
  }
}

void vtkOversketchOneStrokeWidget::Key(vtkAbstractWidget* widget)
{
  vtkOversketchOneStrokeWidget* self = cast(widget);
  const std::string key = self->Interactor->GetKeySym() ? self->Interactor->GetKeySym() : "";
  const vtkSmartPointer<vtkOversketchOneStrokeWidget> alive(self);
  bool used = self->Moving;
  if (self->Moving)
  {
    if (key == "Escape")
    {
      self->EndMove(false);
      self->Render();
    }
  }
  else if (self->RunsStrokes && !self->Pen->IsDrawing() && !self->Pen->IsWaiting())
  {
    used = true;
    if (key == "Escape" && self->Inner->live.exists())
    {
      self->Drop();
    }
    else if ((key == "Return" || key == "KP_Enter") && self->Inner->live.exists())
    {
      self->Commit();
    }
    else if ((key == "o" || key == "O") && !self->Interactor->GetControlKey() &&
             !self->Interactor->GetAltKey())
    {
      self->SetShowRegion(!self->ShowRegion);
      self->Render();
    }
    else
    {
      used = false;
    }
  }
  if (used)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
  }
}

void vtkOversketchOneStrokeWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowRegion: " << this->ShowRegion << "\n";
  os << indent << "GrabDistance: " << this->GrabDistance << "\n";
  os << indent << "FindsSections: " << this->FindsSections << "\n";
  os << indent << "RunsStrokes: " << this->RunsStrokes << "\n";
  os << indent << "Moving: " << this->Moving << "\n";
  os << indent << "Stroke: " << this->Inner->live.stroke()->GetNumberOfPoints() << " samples\n";
  os << indent << "Message: " << this->Inner->live.message() << "\n";
}
