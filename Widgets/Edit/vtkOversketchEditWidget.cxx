#include "vtkOversketchEditWidget.h"

#include "edit_parts.h"
#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchAxisHandleRepresentation.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchEditRepresentation.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchRegionRepresentation.h"
#include "vtkOversketchRegionWidget.h"
#include "vtkOversketchShadingLevels.h"
#include "vtkOversketchStrokeWidget.h"
#include "widget_events.h"

#include "Mesh/context.h"
#include "Shading/layer_list.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrivialProducer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <tuple>
#include <utility>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchEditWidget);

struct vtkOversketchEditWidget::Internals : EditParts
{
  vtkNew<vtkCallbackCommand> observer, rendererObserver;

  vtkSmartPointer<vtkAlgorithm> source;
  int sourcePort = 0;
  vtkSmartPointer<vtkPolyData> sourceSeen;
  vtkMTimeType sourceTime = 0, systemTime = 0;
  vtkNew<vtkPolyData> base, preview, output; // what is edited; while something is dragged; what comes of it
  vtkNew<vtkTrivialProducer> producer;
  vtkNew<vtkOversketchEdit> system;
  bool stale = false, acted = false;
  MeshKey fed, shown; // the region that the widgets have, and the same after the edit
  Message said;
  std::string message;
  vtkWeakPointer<vtkRenderer> watched;

  // The region after the edit, before new triangles.
  vtkPolyData* moved()
  {
    return this->system->GetInnerOutput(
      this->planes->GetProfile()->GetNumberOfPoints() > 0 ? "Bend" : "Deform");
  }
  bool isWhole() { return this->region->HasReference() && this->region->HasBoundary(); }
};

vtkOversketchEditWidget::vtkOversketchEditWidget()
  : Inner(std::make_unique<Internals>())
{
  this->KeyPressActivationOff();
  this->Priority = 0.45f; // after the widgets
  const auto nothing = [](vtkAbstractWidget*) {};
  listenToHand(this->CallbackMapper, this, { nothing, nothing, nothing, Key });
  Internals& inner = *this->Inner;
  inner.producer->SetOutput(inner.output);
  inner.layers->GetLayerHandleRepresentation()->SetSideToModel();
  inner.areas->GetAreaSelectRepresentation()->SetSideToModel();
  inner.observer->SetClientData(this);
  inner.observer->SetCallback([](vtkObject* from, unsigned long event, void* self, void* text)
    { static_cast<vtkOversketchEditWidget*>(self)->Heard(from, event, static_cast<const char*>(text)); });
  for (vtkAbstractWidget* widget : inner.all())
  {
    for (const unsigned long event : { vtkCommand::StartInteractionEvent,
           vtkCommand::InteractionEvent,
           vtkCommand::EndInteractionEvent,
           vtkCommand::WidgetValueChangedEvent,
           vtkCommand::MessageEvent })
    {
      widget->AddObserver(event, inner.observer);
    }
  }
  // The renderer is about to draw the mesh.
  inner.rendererObserver->SetClientData(this);
  inner.rendererObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkOversketchEditWidget*>(self)->Update(); });
}

vtkOversketchEditWidget::~vtkOversketchEditWidget()
{
  Internals& inner = *this->Inner;
  for (vtkAbstractWidget* widget : inner.all())
  {
    widget->RemoveObserver(inner.observer);
  }
  inner.disc.setRenderer(nullptr);
  this->vtkOversketchEditWidget::SetEnabled(0);
  this->StopWatching();
  for (vtkAbstractWidget* widget : inner.byMode())
  {
    widget->SetInteractor(nullptr);
  }
}

void vtkOversketchEditWidget::SetInputConnection(vtkAlgorithmOutput* mesh)
{
  this->Inner->source = mesh ? mesh->GetProducer() : nullptr;
  this->Inner->sourcePort = mesh ? mesh->GetIndex() : 0;
}

void vtkOversketchEditWidget::SetInputData(vtkPolyData* mesh)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->SetInputConnection(producer->GetOutputPort());
}

vtkAlgorithmOutput* vtkOversketchEditWidget::GetOutputPort()
{
  return this->Inner->producer->GetOutputPort();
}

vtkPolyData* vtkOversketchEditWidget::GetOutput()
{
  return this->Inner->output;
}

vtkOversketchEdit* vtkOversketchEditWidget::GetEdit()
{
  return this->Inner->system;
}

vtkOversketchRegionWidget* vtkOversketchEditWidget::GetRegionWidget()
{
  return this->Inner->region;
}

vtkOversketchAxisHandleWidget* vtkOversketchEditWidget::GetAxisHandleWidget()
{
  return this->Inner->axes;
}

vtkOversketchLayerHandleWidget* vtkOversketchEditWidget::GetLayerHandleWidget()
{
  return this->Inner->layers;
}

vtkOversketchAreaSelectWidget* vtkOversketchEditWidget::GetAreaSelectWidget()
{
  return this->Inner->areas;
}

vtkOversketchProfilePlaneWidget* vtkOversketchEditWidget::GetProfilePlaneWidget()
{
  return this->Inner->planes;
}

bool vtkOversketchEditWidget::HasRegion() const
{
  return this->Inner->acted;
}

const char* vtkOversketchEditWidget::GetMessage()
{
  return this->Inner->message.c_str();
}

const Message& vtkOversketchEditWidget::GetSaid() const
{
  return this->Inner->said;
}

void vtkOversketchEditWidget::Say(const Message& said)
{
  this->Inner->said = said;
  const std::string message = said.text();
  const bool isNew = message != this->Inner->message;
  this->Inner->message = message;
  this->GetEditRepresentation()->SetText(message.c_str());
  if (isNew && !message.empty())
  {
    this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(message.c_str()));
  }
}

void vtkOversketchEditWidget::Update()
{
  Internals& inner = *this->Inner;
  if (inner.source)
  {
    inner.source->Update(inner.sourcePort);
    auto* mesh = vtkPolyData::SafeDownCast(inner.source->GetOutputDataObject(inner.sourcePort));
    if (mesh && (mesh != inner.sourceSeen || mesh->GetMTime() != inner.sourceTime))
    {
      inner.sourceSeen = mesh;
      inner.sourceTime = mesh->GetMTime();
      inner.base->ShallowCopy(mesh);
      this->Begin();
    }
  }
  if (!this->Previewing && (inner.stale || (inner.isWhole() && inner.system->GetMTime() > inner.systemTime)))
  {
    this->Run();
  }
}

// Without a line and a ring, on the mesh that there is.
void vtkOversketchEditWidget::Begin()
{
  Internals& inner = *this->Inner;
  inner.output->ShallowCopy(inner.base);
  inner.acted = inner.stale = this->Previewing = false;
  inner.region->SetModel(inner.base);
  inner.region->SetRegion(nullptr, nullptr);
  inner.areas->SetAreas(nullptr);
  inner.planes->SetProfile(nullptr);
  inner.system->SetOperations("");
  inner.system->SetLayers("");
  this->FeedWidgets();
  this->SetMode(Region);
  this->Say("");
}

// What the hand has made, as the system takes it.
void vtkOversketchEditWidget::ReadHand()
{
  Internals& inner = *this->Inner;
  vtkOversketchLayerHandleRepresentation* shading = inner.layers->GetLayerHandleRepresentation();
  const int areas = static_cast<int>(inner.areas->GetAreas()->GetNumberOfLines());
  if (const std::string left = layersOfAreas(inner.layers->GetLayers(), areas);
      left != inner.layers->GetLayers())
  {
    inner.layers->SetLayers(left.c_str());
  }
  shading->SetArea(areas - 1);
  inner.system->SetOperations(inner.axes->GetOperations());
  inner.system->SetLayers(inner.layers->GetLayers());
  inner.system->SetProfileAt(inner.planes->GetProfileAt());
  inner.disc.follow(inner.layers, inner.areas);
  inner.stale = true;
}

void vtkOversketchEditWidget::Connect()
{
  Internals& inner = *this->Inner;
  const auto orNone = [](vtkPolyData* data) { return data->GetNumberOfPoints() > 0 ? data : nullptr; };
  inner.system->SetInputData(0, inner.base);
  inner.system->SetReferenceData(inner.region->GetReference());
  inner.system->SetBoundaryData(inner.region->GetBoundary());
  inner.system->SetProfileData(orNone(inner.planes->GetProfile()));
  inner.system->SetAreasData(orNone(inner.areas->GetAreas()));
}

// The mesh without new triangles, by what a drag changes alone.
void vtkOversketchEditWidget::Preview()
{
  Internals& inner = *this->Inner;
  if (inner.acted)
  {
    this->Connect();
    if (inner.system->PreviewEdit(inner.preview))
    {
      inner.output->ShallowCopy(inner.preview);
      inner.output->Modified();
      inner.planes->ShowSectionOn(inner.moved());
      if (this->Mode == Shade)
      {
        inner.layers->GetLayerHandleRepresentation()->SetRegion(inner.moved());
      }
    }
    inner.systemTime = inner.system->GetMTime();
  }
}

void vtkOversketchEditWidget::Run()
{
  Internals& inner = *this->Inner;
  inner.stale = inner.acted = false;
  Message message;
  if (inner.isWhole())
  {
    this->Connect();
    inner.system->Modified(); // what ran before may have had another mesh in the same data object
    std::tie(inner.acted, message) = ranTold(inner.system);
    inner.systemTime = inner.system->GetMTime();
  }
  else if (inner.region->HasReference())
  {
    this->Connect();
    message = inner.system->Prepare() ? Message() : ranTold(inner.system).second; // it may be none already
  }
  inner.output->ShallowCopy(inner.acted ? inner.system->GetOutput() : inner.base.Get());
  this->FeedWidgets();
  this->Say(message);
  this->ShowMoved();
}

void vtkOversketchEditWidget::ShowMoved()
{
  vtkNew<vtkPolyData> moved;
  if (this->ShowRegion && this->Inner->acted && !this->Previewing)
  {
    this->Inner->system->GetRegion(moved);
  }
  this->GetEditRepresentation()->SetRegion(moved);
}

// The region, where it is another one, and what the host may have set of the system.
void vtkOversketchEditWidget::FeedWidgets()
{
  Internals& inner = *this->Inner;
  vtkPolyData* mesh = inner.acted ? inner.system->GetInnerOutput("Distance") : nullptr;
  const MeshKey now = mesh ? WholeKey(mesh) : MeshKey();
  if (now != inner.fed)
  {
    inner.fed = now;
    const auto curve = [&](int port)
    {
      return mesh ? vtkPolyData::SafeDownCast(inner.system->GetStep("Enclose")->GetInputDataObject(port, 0))
                  : nullptr;
    };
    inner.axes->SetCurve(curve(1), mesh);
    inner.planes->SetRegion(mesh, curve(1), curve(2));
    inner.disc.setRegion(mesh);
  }
  // What is seen on the model is where the edit has taken it, with its new triangles.
  inner.planes->ShowSectionOn(inner.acted ? inner.moved() : nullptr);
  const bool isNew =
    inner.acted && inner.system->GetMovedPoints() > 0 && inner.system->GetRule() != vtkOversketchEdit::Off;
  vtkPolyData* seen = !inner.acted ? nullptr
                      : isNew      ? inner.system->GetInnerOutput("Retriangulate")
                                   : inner.moved();
  const MeshKey shown = seen ? WholeKey(seen) : MeshKey();
  if (shown != inner.shown)
  {
    inner.shown = shown;
    inner.layers->SetRegion(seen);
    inner.areas->SetRegion(seen);
  }
  vtkOversketchLayerHandleRepresentation* shading = inner.layers->GetLayerHandleRepresentation();
  inner.axes->SetOperations(inner.system->GetOperations());
  inner.layers->SetLayers(inner.system->GetLayers());
  shading->SetLevels(inner.system->GetLevels());
  inner.planes->SetProfileAt(inner.system->GetProfileAt());
  inner.region->GetRegionRepresentation()->SetLineWas(
    this->RegionInAllModes && inner.acted && inner.system->GetMovedPoints() > 0);
  if (inner.acted)
  {
    // What redraws the line is drawn over it where it was.
    inner.region->ShowCurves(this->RegionInAllModes ? nullptr : inner.system->GetReferenceOutput(),
      inner.system->GetBoundaryOutput());
  }
  const bool hasAreas = inner.acted && inner.areas->GetAreas()->GetNumberOfPoints() > 0;
  auto* step = vtkOversketchShadingLevels::SafeDownCast(inner.system->GetStep("Shading"));
  shading->SetDisplay(hasAreas ? step->GetDisplayOutput() : nullptr);
  inner.disc.follow(inner.layers, inner.areas);
  inner.showAreas(inner.watched, this->Mode == Shade);
}

void vtkOversketchEditWidget::Heard(vtkObject* from, unsigned long event, const char* text)
{
  const vtkSmartPointer<vtkOversketchEditWidget> alive(this); // an observer may let go of it
  Internals& inner = *this->Inner;
  const bool isPen = from == inner.region || from == inner.areas || from == inner.disc.areas();
  if (from == inner.disc.layers())
  {
    inner.layers->SetLayers(inner.disc.layers()->GetLayers());
  }
  else if (from == inner.disc.areas() && event == vtkCommand::WidgetValueChangedEvent)
  {
    inner.areas->SetAreas(inner.disc.areas()->GetAreas());
  }
  if (event == vtkCommand::MessageEvent)
  {
    this->InvokeEvent(event, const_cast<char*>(text));
    return;
  }
  if (event == vtkCommand::InteractionEvent && !isPen)
  {
    this->Previewing = true;
    this->ReadHand();
    this->Preview();
    this->GetEditRepresentation()->SetRegion(nullptr);
  }
  else if (event == vtkCommand::EndInteractionEvent && !isPen)
  {
    this->Previewing = false;
    this->ReadHand();
  }
  else if (event == vtkCommand::WidgetValueChangedEvent)
  {
    this->ReadHand();
    this->Update();
  }
  this->InvokeEvent(event);
}

void vtkOversketchEditWidget::SetMode(int mode)
{
  if (mode == this->Mode || mode < Region || mode > Profile)
  {
    return;
  }
  this->Mode = mode;
  this->TakeUp();
  this->Modified();
  this->Render();
}

void vtkOversketchEditWidget::SetRegionInAllModes(bool all)
{
  if (all != this->RegionInAllModes)
  {
    this->RegionInAllModes = all;
    this->TakeUp();
    this->Modified();
  }
}

// The widgets that the hand has now, and no other.
void vtkOversketchEditWidget::TakeUp()
{
  Internals& inner = *this->Inner;
  inner.region->SetRedrawOnly(this->RegionInAllModes && this->Mode != Region);
  const auto isHeld = [this](int mode)
  { return this->Enabled && (mode == this->Mode || (mode == Region && this->RegionInAllModes)); };
  const auto widgets = inner.byMode();
  for (const bool held : { false, true }) // what is put down lets go of the left button
  {
    for (std::size_t i = 0; i < widgets.size(); ++i)
    {
      if (isHeld(static_cast<int>(i)) == held && bool(widgets[i]->GetEnabled()) != held)
      {
        if (held)
        {
          widgets[i]->SetInteractor(this->Interactor);
          widgets[i]->SetDefaultRenderer(this->CurrentRenderer);
          widgets[i]->SetCurrentRenderer(this->CurrentRenderer);
        }
        widgets[i]->SetEnabled(held);
      }
    }
  }
  inner.disc.hold(isHeld(Shade), isHeld(Areas));
  inner.showAreas(inner.watched, this->Mode == Shade);
}

void vtkOversketchEditWidget::SetDiscRenderer(vtkRenderer* renderer)
{
  this->Inner->disc.setRenderer(renderer);
  this->TakeUp();
}

vtkRenderer* vtkOversketchEditWidget::GetDiscRenderer()
{
  return this->Inner->disc.renderer();
}

vtkOversketchLayerHandleWidget* vtkOversketchEditWidget::GetDiscLayerWidget()
{
  return this->Inner->disc.layers();
}

vtkOversketchAreaSelectWidget* vtkOversketchEditWidget::GetDiscAreaWidget()
{
  return this->Inner->disc.areas();
}

void vtkOversketchEditWidget::Commit()
{
  Internals& inner = *this->Inner;
  this->Update();
  if (inner.acted)
  {
    inner.base->ShallowCopy(inner.output);
    this->Begin();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

void vtkOversketchEditWidget::Drop()
{
  if (this->Inner->region->HasReference())
  {
    this->Begin();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

void vtkOversketchEditWidget::SetShowRegion(bool show)
{
  if (show != this->ShowRegion)
  {
    this->ShowRegion = show;
    this->ShowMoved();
    this->Modified();
  }
}

void vtkOversketchEditWidget::Key(vtkAbstractWidget* widget)
{
  const vtkSmartPointer<vtkOversketchEditWidget> self(static_cast<vtkOversketchEditWidget*>(widget));
  const std::string key = self->Interactor->GetKeySym() ? self->Interactor->GetKeySym() : "";
  if ((key == "Return" || key == "KP_Enter") && self->Inner->acted)
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->Commit();
  }
  else if ((key == "o" || key == "O") && !self->Interactor->GetControlKey() && !self->Interactor->GetAltKey())
  {
    self->EventCallbackCommand->SetAbortFlag(1);
    self->SetShowRegion(!self->ShowRegion);
    self->Render();
  }
}

void vtkOversketchEditWidget::SetRepresentation(vtkOversketchEditRepresentation* representation)
{
  this->SetWidgetRepresentation(representation);
}

vtkOversketchEditRepresentation* vtkOversketchEditWidget::GetEditRepresentation()
{
  this->CreateDefaultRepresentation();
  return static_cast<vtkOversketchEditRepresentation*>(this->WidgetRep);
}

void vtkOversketchEditWidget::CreateDefaultRepresentation()
{
  if (!this->WidgetRep)
  {
    this->WidgetRep = vtkOversketchEditRepresentation::New();
  }
}

void vtkOversketchEditWidget::SetEnabled(int enabling)
{
  Internals& inner = *this->Inner;
  const bool before = this->Enabled;
  if (!enabling && before)
  {
    for (vtkAbstractWidget* widget : inner.byMode())
    {
      widget->SetEnabled(0);
    }
    inner.disc.hold(false, false);
    inner.showAreas(inner.watched, false);
  }
  this->Superclass::SetEnabled(enabling);
  if (before && !this->Enabled)
  {
    this->StopWatching();
  }
  else if (!before && this->Enabled)
  {
    inner.watched = this->CurrentRenderer;
    inner.watched->AddObserver(vtkCommand::StartEvent, inner.rendererObserver);
    this->Update();
    this->TakeUp();
  }
}

void vtkOversketchEditWidget::StopWatching()
{
  if (this->Inner->watched)
  {
    this->Inner->watched->RemoveObserver(this->Inner->rendererObserver);
    this->Inner->watched = nullptr;
  }
}

void vtkOversketchEditWidget::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Superclass::SetInteractor(interactor); // ends with SetEnabled(0) where it changes
  for (vtkAbstractWidget* widget : this->Inner->byMode())
  {
    widget->SetInteractor(interactor);
  }
}

void vtkOversketchEditWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "RegionInAllModes: " << this->RegionInAllModes << "\n";
  os << indent << "ShowRegion: " << this->ShowRegion << "\n";
  os << indent << "Previewing: " << this->Previewing << "\n";
  os << indent << "Message: " << this->GetMessage() << "\n";
}
