#include "vtkOversketchOneStrokeWidget.h"

#include "live_stroke.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchOneStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"

#include <string>

vtkStandardNewMacro(vtkOversketchOneStrokeWidget);

struct vtkOversketchOneStrokeWidget::Internals
{
  oversketch::LiveStroke live;
  std::string told; // the message that was sent

  explicit Internals(vtkPolyData* stroke)
    : live(stroke)
  {
  }
};

vtkOversketchOneStrokeWidget::vtkOversketchOneStrokeWidget()
  : Inner(std::make_unique<Internals>(this->GetStroke()))
{
  // The renderer is about to draw the mesh; the window a frame, perhaps of the pen alone.
  this->RendererObserver->SetClientData(this);
  this->RendererObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchOneStrokeWidget*>(self)->Update(); });
  this->FrameObserver->SetClientData(this);
  this->FrameObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchOneStrokeWidget*>(self)->FindSection(); });
}

vtkOversketchOneStrokeWidget::~vtkOversketchOneStrokeWidget()
{
  this->StopWatching();
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

void vtkOversketchOneStrokeWidget::SetOneStroke(vtkOversketchOneStroke* system)
{
  this->EndMove(false);
  this->Inner->live.setSystem(system);
}

vtkOversketchOneStroke* vtkOversketchOneStrokeWidget::GetOneStroke()
{
  return this->Inner->live.system();
}

void vtkOversketchOneStrokeWidget::SetStroke(vtkPolyData* stroke)
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

void vtkOversketchOneStrokeWidget::HoldStroke(vtkPolyData* stroke, const double*)
{
  this->SetStroke(stroke);
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

void vtkOversketchOneStrokeWidget::SetRepresentation(vtkOversketchOneStrokeRepresentation* representation)
{
  this->Superclass::SetRepresentation(representation);
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

void vtkOversketchOneStrokeWidget::StopWatching()
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

void vtkOversketchOneStrokeWidget::Refresh()
{
  Internals& inner = *this->Inner;
  vtkOversketchOneStrokeRepresentation* representation = this->GetOneStrokeRepresentation();
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

void vtkOversketchOneStrokeWidget::LineBegins()
{
  this->MakeCurvesReady();
}

// The curves of the mesh in the renderer's view.
void vtkOversketchOneStrokeWidget::MakeCurvesReady()
{
  vtkNew<vtkPolyData> view, none;
  this->GetPen()->GetStrokeRepresentation()->PutView(view);
  this->Inner->live.section(view, none);
}

// Once a frame, however many samples have come since the last. A part that is drawn anew alone says nothing.
void vtkOversketchOneStrokeWidget::FindSection()
{
  vtkOversketchStrokeRepresentation* drawn = this->GetPen()->GetStrokeRepresentation();
  if (!this->Extended || !drawn->IsDrawing())
  {
    return;
  }
  this->Extended = false;
  vtkNew<vtkPolyData> stroke, section;
  if (!this->IsRedrawing())
  {
    drawn->GetPolyData(stroke);
    this->Inner->live.section(stroke, section);
  }
  drawn->SetSection(section);
}

void vtkOversketchOneStrokeWidget::TakeStroke(vtkPolyData* stroke)
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

void vtkOversketchOneStrokeWidget::StrokeMoves()
{
  this->Inner->live.drag(this->GetTranslation());
}

void vtkOversketchOneStrokeWidget::EndMove(bool keep)
{
  this->Inner->live.endDrag();
  this->Superclass::EndMove(keep);
}

bool vtkOversketchOneStrokeWidget::UseKey(const std::string& key)
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

void vtkOversketchOneStrokeWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowRegion: " << this->ShowRegion << "\n";
  os << indent << "Message: " << this->GetMessage() << "\n";
}
