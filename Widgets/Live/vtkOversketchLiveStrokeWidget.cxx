#include "vtkOversketchLiveStrokeWidget.h"

#include "live_stroke.h"
#include "vtkOversketchLiveStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "vtkOversketchSystem.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"

#include <string>

struct vtkOversketchLiveStrokeWidget::Internals
{
  oversketch::LiveStroke live;
  std::string told; // the message that was sent

  explicit Internals(vtkPolyData* stroke)
    : live(stroke)
  {
  }
};

vtkOversketchLiveStrokeWidget::vtkOversketchLiveStrokeWidget()
  : Inner(std::make_unique<Internals>(this->GetStroke()))
{
  // The renderer is about to draw the mesh; the window a frame, perhaps of the pen alone.
  this->RendererObserver->SetClientData(this);
  this->RendererObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchLiveStrokeWidget*>(self)->Update(); });
  this->FrameObserver->SetClientData(this);
  this->FrameObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchLiveStrokeWidget*>(self)->LookNow(); });
}

vtkOversketchLiveStrokeWidget::~vtkOversketchLiveStrokeWidget()
{
  this->StopWatching();
}

void vtkOversketchLiveStrokeWidget::SetInputConnection(vtkAlgorithmOutput* mesh)
{
  this->Inner->live.setSource(mesh);
}

void vtkOversketchLiveStrokeWidget::SetInputData(vtkPolyData* mesh)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->SetInputConnection(producer->GetOutputPort());
}

vtkAlgorithmOutput* vtkOversketchLiveStrokeWidget::GetOutputPort()
{
  return this->Inner->live.outputPort();
}

vtkPolyData* vtkOversketchLiveStrokeWidget::GetOutput()
{
  return this->Inner->live.output();
}

void vtkOversketchLiveStrokeWidget::Update()
{
  if (!this->IsMoving() && this->Inner->live.update())
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

void vtkOversketchLiveStrokeWidget::SetSystem(vtkOversketchSystem* system)
{
  this->EndMove(false);
  this->Inner->live.setSystem(system);
}

vtkOversketchSystem* vtkOversketchLiveStrokeWidget::GetSystem()
{
  return this->Inner->live.system();
}

void vtkOversketchLiveStrokeWidget::SetStroke(vtkPolyData* stroke)
{
  if (!stroke || stroke->GetNumberOfPoints() == 0)
  {
    this->Drop();
    return;
  }
  this->EndMove(false);
  this->Keep(stroke);
  this->Inner->live.strokeChanges();
  this->Update();
  this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
  this->Render();
}

void vtkOversketchLiveStrokeWidget::HoldStroke(vtkPolyData* stroke, const double*)
{
  this->SetStroke(stroke);
}

void vtkOversketchLiveStrokeWidget::Commit()
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

void vtkOversketchLiveStrokeWidget::Drop()
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

const char* vtkOversketchLiveStrokeWidget::GetMessage()
{
  return this->Inner->live.message().c_str();
}

void vtkOversketchLiveStrokeWidget::SetShowRegion(bool show)
{
  if (show != this->ShowRegion)
  {
    this->ShowRegion = show;
    this->Refresh();
    this->Modified();
  }
}

void vtkOversketchLiveStrokeWidget::SetRepresentation(vtkOversketchLiveStrokeRepresentation* representation)
{
  this->Superclass::SetRepresentation(representation);
}

vtkOversketchLiveStrokeRepresentation* vtkOversketchLiveStrokeWidget::GetLiveStrokeRepresentation()
{
  this->CreateDefaultRepresentation();
  return static_cast<vtkOversketchLiveStrokeRepresentation*>(this->WidgetRep);
}

void vtkOversketchLiveStrokeWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    this->WidgetRep = vtkOversketchLiveStrokeRepresentation::New();
  }
}

void vtkOversketchLiveStrokeWidget::SetEnabled(int enabling)
{
  const bool before = this->Enabled;
  this->Superclass::SetEnabled(enabling);
  if (before && !this->Enabled)
  {
    this->StopWatching();
  }
  else if (!before && this->Enabled)
  {
    this->Watched = this->CurrentRenderer;
    this->Watched->AddObserver(vtkCommand::StartEvent, this->RendererObserver);
    this->WatchedWindow = this->Watched->GetRenderWindow();
    this->WatchedWindow->AddObserver(vtkCommand::StartEvent, this->FrameObserver);
    this->Update();
  }
}

void vtkOversketchLiveStrokeWidget::StopWatching()
{
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->RendererObserver);
    this->Watched = nullptr;
  }
  if (this->WatchedWindow)
  {
    this->WatchedWindow->RemoveObserver(this->FrameObserver);
    this->WatchedWindow = nullptr;
  }
}

void vtkOversketchLiveStrokeWidget::Refresh()
{
  Internals& inner = *this->Inner;
  vtkOversketchLiveStrokeRepresentation* representation = this->GetLiveStrokeRepresentation();
  const bool stands = inner.live.middle(this->Place);
  representation->SetStroke(stands ? this->GetStroke() : nullptr, this->Place);
  representation->SetRegion(this->ShowRegion && !this->IsMoving() ? inner.live.region() : nullptr);
  representation->SetText(this->GetMessage());
  this->SetTookHold(inner.live.message().empty());
  if (!representation->HasStroke())
  {
    representation->HighlightedOff();
  }
}

void vtkOversketchLiveStrokeWidget::LineBegins()
{
  this->MakeReady();
}

void vtkOversketchLiveStrokeWidget::MakeReady()
{
  vtkNew<vtkPolyData> view;
  this->GetPen()->GetStrokeRepresentation()->PutView(view);
  this->Inner->live.ask([&] { this->Look(this->Inner->live.result(), view); });
}

void vtkOversketchLiveStrokeWidget::Look(vtkPolyData* mesh, vtkPolyData* stroke)
{
  vtkNew<vtkPolyData> section;
  if (mesh)
  {
    this->GetSystem()->Preview(mesh, stroke, section);
  }
  this->GetPen()->GetStrokeRepresentation()->SetSection(section);
}

// Once a frame, however many samples have come since the last. A part that is drawn anew alone says nothing.
void vtkOversketchLiveStrokeWidget::LookNow()
{
  vtkOversketchStrokeRepresentation* drawn = this->GetPen()->GetStrokeRepresentation();
  const bool moves = this->IsMoving() && this->LooksWhileMoving();
  if (!this->Extended || !(drawn->IsDrawing() || moves))
  {
    return;
  }
  this->Extended = false;
  vtkNew<vtkPolyData> stroke;
  vtkPolyData* mesh = this->Inner->live.result();
  if (moves)
  {
    this->GetLiveStrokeRepresentation()->PutMoved(stroke);
    mesh = this->Inner->live.base();
  }
  else if (this->IsRedrawing())
  {
    mesh = nullptr;
  }
  else
  {
    drawn->GetPolyData(stroke);
  }
  this->Inner->live.ask([&] { this->Look(mesh, stroke); });
}

void vtkOversketchLiveStrokeWidget::TakeStroke(vtkPolyData* stroke)
{
  if (this->IsNew())
  {
    this->Inner->live.commit();
  }
  this->Keep(stroke);
  this->Inner->live.strokeChanges();
  this->Inner->told.clear();
  this->Update();
  this->Refresh();
}

void vtkOversketchLiveStrokeWidget::StrokeMoves()
{
  this->LookAgain();
  this->Inner->live.drag(this->GetTranslation());
}

void vtkOversketchLiveStrokeWidget::EndMove(bool keep)
{
  if (this->IsMoving() && this->LooksWhileMoving())
  {
    this->Look(nullptr, nullptr);
  }
  this->Inner->live.endDrag();
  this->Superclass::EndMove(keep);
}

bool vtkOversketchLiveStrokeWidget::UseKey(const std::string& key)
{
  if (key == "Escape" && this->Inner->live.exists())
  {
    this->Drop();
  }
  else if ((key == "Return" || key == "KP_Enter") && this->Inner->live.exists())
  {
    this->Commit();
  }
  else if ((key == "o" || key == "O") && !this->Interactor->GetControlKey() && !this->Interactor->GetAltKey())
  {
    this->SetShowRegion(!this->ShowRegion);
    this->Render();
  }
  else
  {
    return false;
  }
  return true;
}

void vtkOversketchLiveStrokeWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowRegion: " << this->ShowRegion << "\n";
  os << indent << "Message: " << this->GetMessage() << "\n";
}
