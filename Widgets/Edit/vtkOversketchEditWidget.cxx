#include "vtkOversketchEditWidget.h"

#include "disc_window.h"
#include "hosted_system.h"
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

#include "Shading/layer_list.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchEditWidget);
oversketchRepresentationMacro(Edit);

// Widgets, those over the model in the order of the modes, and the system that they are of.
struct vtkOversketchEditWidget::Internals : HostedSystem
{
  vtkNew<vtkOversketchRegionWidget> region;
  vtkNew<vtkOversketchAxisHandleWidget> axes;
  vtkNew<vtkOversketchLayerHandleWidget> layers;
  vtkNew<vtkOversketchAreaSelectWidget> areas;
  vtkNew<vtkOversketchProfilePlaneWidget> planes;
  DiscWindow disc;
  vtkNew<vtkOversketchEdit> edit;
  vtkNew<vtkPolyData> preview; // the output while something is dragged
  bool stale = false;
  MeshKey fed, shown; // the region that the widgets have, and the same after the edit

  std::array<vtkAbstractWidget*, 5> byMode()
  {
    return { this->region, this->axes, this->layers, this->areas, this->planes };
  }
  // The region after the edit, before new triangles.
  vtkPolyData* moved()
  {
    return this->edit->GetInnerOutput(
      this->planes->GetProfile()->GetNumberOfPoints() > 0 ? "Bend" : "Deform");
  }
  bool isWhole() { return this->region->HasReference() && this->region->HasBoundary(); }
  // Shows what lassos hold over the model while others than their widget have the hand, or no more.
  void showAreas(bool show)
  {
    if (!this->watched())
    {
      return;
    }
    vtkOversketchAreaSelectRepresentation* held = this->areas->GetAreaSelectRepresentation();
    if (show && this->areas->GetAreas()->GetNumberOfLines() > 0)
    {
      held->SetRenderer(this->watched());
      this->watched()->AddViewProp(held);
    }
    else if (!this->areas->GetEnabled())
    {
      this->watched()->RemoveViewProp(held);
    }
  }
};

vtkOversketchEditWidget::vtkOversketchEditWidget()
  : Inner(std::make_unique<Internals>())
{
  this->KeyPressActivationOff();
  this->Priority = 0.45f; // after the widgets
  const auto nothing = [](vtkAbstractWidget*) {};
  listenToHand(this->CallbackMapper, this, { nothing, nothing, nothing, Key });
  Internals& inner = *this->Inner;
  inner.setSystem(inner.edit);
  inner.layers->GetLayerHandleRepresentation()->SetSideToModel();
  inner.areas->GetAreaSelectRepresentation()->SetSideToModel();
  const auto hear = [this](vtkAbstractWidget* widget)
  { listenTo(widget, this, &vtkOversketchEditWidget::Heard, { vtkCommand::MessageEvent }); };
  for (vtkAbstractWidget* widget : inner.byMode())
  {
    hear(widget);
  }
  hear(inner.disc.layers());
  hear(inner.disc.areas());
}

vtkOversketchEditWidget::~vtkOversketchEditWidget()
{
  this->Inner->disc.setRenderer(nullptr);
  this->vtkOversketchEditWidget::SetEnabled(0);
  for (vtkAbstractWidget* widget : this->Inner->byMode())
  {
    widget->SetInteractor(nullptr);
  }
}

void vtkOversketchEditWidget::SetInputConnection(vtkAlgorithmOutput* mesh)
{
  this->Inner->setSource(mesh);
}

void vtkOversketchEditWidget::SetInputData(vtkPolyData* mesh)
{
  this->Inner->setSource(mesh);
}

vtkAlgorithmOutput* vtkOversketchEditWidget::GetOutputPort()
{
  return this->Inner->outputPort();
}

vtkPolyData* vtkOversketchEditWidget::GetOutput()
{
  return this->Inner->output();
}

vtkOversketchEdit* vtkOversketchEditWidget::GetEdit()
{
  return this->Inner->edit;
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
  return this->Inner->acted();
}

const char* vtkOversketchEditWidget::GetMessage()
{
  return this->Inner->text();
}

const Message& vtkOversketchEditWidget::GetSaid() const
{
  return this->Inner->said();
}

void vtkOversketchEditWidget::Say(const Message& said)
{
  const bool isNews = this->Inner->say(said);
  this->GetEditRepresentation()->SetText(this->GetMessage());
  if (isNews)
  {
    this->InvokeEvent(vtkCommand::MessageEvent, const_cast<char*>(this->GetMessage()));
  }
}

void vtkOversketchEditWidget::Update()
{
  Internals& inner = *this->Inner;
  if (inner.follow())
  {
    this->Begin();
  }
  if (!this->Previewing && (inner.stale || (inner.isWhole() && inner.isNewer())))
  {
    this->Run();
  }
}

// Without a line and a ring, on the mesh that there is.
void vtkOversketchEditWidget::Begin()
{
  Internals& inner = *this->Inner;
  inner.drop();
  inner.stale = this->Previewing = false;
  inner.region->SetModel(inner.base());
  inner.region->SetRegion(nullptr, nullptr);
  inner.areas->SetAreas(nullptr);
  inner.planes->SetProfile(nullptr);
  inner.edit->SetOperations("");
  inner.edit->SetLayers("");
  this->FeedWidgets();
  this->SetMode(Region);
  this->Say("");
}

// Reads what the hand has made, as the system takes it.
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
  inner.edit->SetOperations(inner.axes->GetOperations());
  inner.edit->SetLayers(inner.layers->GetLayers());
  inner.edit->SetProfileAt(inner.planes->GetProfileAt());
  inner.disc.follow(inner.layers, inner.areas);
  inner.stale = true;
}

void vtkOversketchEditWidget::Connect()
{
  Internals& inner = *this->Inner;
  const auto orNone = [](vtkPolyData* data) { return data->GetNumberOfPoints() > 0 ? data : nullptr; };
  inner.edit->SetInputData(0, inner.base());
  inner.edit->SetReferenceData(inner.region->GetReference());
  inner.edit->SetBoundaryData(inner.region->GetBoundary());
  inner.edit->SetProfileData(orNone(inner.planes->GetProfile()));
  inner.edit->SetAreasData(orNone(inner.areas->GetAreas()));
}

// The mesh without new triangles, by what a drag changes alone.
void vtkOversketchEditWidget::Preview()
{
  Internals& inner = *this->Inner;
  if (inner.acted())
  {
    this->Connect();
    if (inner.edit->PreviewEdit(inner.preview))
    {
      inner.output()->ShallowCopy(inner.preview);
      inner.output()->Modified();
      inner.planes->ShowSectionOn(inner.moved());
      if (this->Mode == Shade)
      {
        inner.layers->GetLayerHandleRepresentation()->SetRegion(inner.moved());
      }
    }
    inner.look();
  }
}

void vtkOversketchEditWidget::Run()
{
  Internals& inner = *this->Inner;
  inner.stale = false;
  Message message;
  if (inner.isWhole())
  {
    this->Connect();
    message = inner.run();
  }
  else
  {
    inner.drop();
    if (inner.region->HasReference())
    {
      this->Connect();
      message = inner.edit->Prepare() ? Message() : runAndReport(inner.edit).second; // it may be none already
    }
  }
  this->FeedWidgets();
  this->Say(message);
  this->ShowMoved();
}

void vtkOversketchEditWidget::ShowMoved()
{
  vtkNew<vtkPolyData> moved;
  if (this->ShowRegion && this->Inner->acted() && !this->Previewing)
  {
    this->Inner->edit->GetRegion(moved);
  }
  this->GetEditRepresentation()->SetRegion(moved);
}

// The region, where it is another one, and what the host may have set of the system.
void vtkOversketchEditWidget::FeedWidgets()
{
  Internals& inner = *this->Inner;
  vtkPolyData* mesh = inner.acted() ? inner.edit->GetInnerOutput("Distance") : nullptr;
  const MeshKey now = mesh ? WholeKey(mesh) : MeshKey();
  if (now != inner.fed)
  {
    inner.fed = now;
    const auto curve = [&](int port)
    {
      return mesh ? vtkPolyData::SafeDownCast(inner.edit->GetStep("Enclose")->GetInputDataObject(port, 0))
                  : nullptr;
    };
    inner.axes->SetCurve(curve(1), mesh);
    inner.planes->SetRegion(mesh, curve(1), curve(2));
    inner.disc.setRegion(mesh);
  }
  // Lines that are seen on the model are where the edit has taken it, with its new triangles.
  inner.planes->ShowSectionOn(inner.acted() ? inner.moved() : nullptr);
  const bool isNew =
    inner.acted() && inner.edit->GetMovedPoints() > 0 && inner.edit->GetRule() != vtkOversketchEdit::Off;
  vtkPolyData* seen = !inner.acted() ? nullptr
                      : isNew        ? inner.edit->GetInnerOutput("Retriangulate")
                                     : inner.moved();
  const MeshKey shown = seen ? WholeKey(seen) : MeshKey();
  if (shown != inner.shown)
  {
    inner.shown = shown;
    inner.layers->SetRegion(seen);
    inner.areas->SetRegion(seen);
  }
  vtkOversketchLayerHandleRepresentation* shading = inner.layers->GetLayerHandleRepresentation();
  inner.axes->SetOperations(inner.edit->GetOperations());
  inner.layers->SetLayers(inner.edit->GetLayers());
  shading->SetLevels(inner.edit->GetLevels());
  inner.planes->SetProfileAt(inner.edit->GetProfileAt());
  inner.region->GetRegionRepresentation()->SetLineWas(
    this->RegionInAllModes && inner.acted() && inner.edit->GetMovedPoints() > 0);
  if (inner.acted())
  {
    // A stroke that redraws the line is drawn over it where it was.
    inner.region->ShowCurves(
      this->RegionInAllModes ? nullptr : inner.edit->GetReferenceOutput(), inner.edit->GetBoundaryOutput());
  }
  const bool hasAreas = inner.acted() && inner.areas->GetAreas()->GetNumberOfPoints() > 0;
  auto* step = vtkOversketchShadingLevels::SafeDownCast(inner.edit->GetStep("Shading"));
  shading->SetDisplay(hasAreas ? step->GetDisplayOutput() : nullptr);
  inner.disc.follow(inner.layers, inner.areas);
  inner.showAreas(this->Mode == Shade);
}

void vtkOversketchEditWidget::Heard(vtkObject* from, unsigned long event, void* text)
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
    this->InvokeEvent(event, text);
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
          workIn(this->CurrentRenderer, this->Interactor, widgets[i]);
        }
        widgets[i]->SetEnabled(held);
      }
    }
  }
  inner.disc.hold(isHeld(Shade), isHeld(Areas));
  inner.showAreas(this->Mode == Shade);
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
  if (inner.acted())
  {
    inner.commit();
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
  const auto self = oversketch::called<vtkOversketchEditWidget>(widget);
  const std::string key = oversketch::keyOf(self->Interactor);
  if ((key == "Return" || key == "KP_Enter") && self->Inner->acted())
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
    inner.showAreas(false);
  }
  this->Superclass::SetEnabled(enabling);
  if (before && !this->Enabled)
  {
    inner.stopWatching();
  }
  else if (!before && this->Enabled)
  {
    inner.watch(this->CurrentRenderer, this);
    this->Update();
    this->TakeUp();
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
