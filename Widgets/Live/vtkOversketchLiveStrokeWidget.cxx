#include "vtkOversketchLiveStrokeWidget.h"

#include "hosted_system.h"
#include "vtkOversketchLiveStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"
#include "vtkOversketchSystem.h"
#include "widget_events.h"

#include "vtkCommand.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <string>

oversketchRepresentationMacro(LiveStroke);

// The stroke that can still be changed, and the mesh that it made of the base.
struct vtkOversketchLiveStrokeWidget::Internals : oversketch::HostedSystem
{
  vtkSmartPointer<vtkPolyData> stroke;
  vtkNew<vtkPolyData> result;         // the output, but for what is dragged
  vtkSmartPointer<vtkPoints> dragged; // null while the output is the result
  vtkNew<vtkPolyData> held;           // what the last run took hold of
  bool stale = false;

  explicit Internals(vtkPolyData* live)
    : stroke(live)
  {
  }

  bool exists() { return this->stroke->GetNumberOfPoints() > 0; }
  // It is another one, or has been changed.
  void strokeChanges()
  {
    this->endDrag();
    this->stale = true;
  }
  // The mesh that the stroke made becomes the one that the next is drawn on; or the mesh is again as before.
  void commit()
  {
    this->endDrag();
    if (this->exists())
    {
      this->HostedSystem::commit();
      this->forget();
    }
  }
  void drop()
  {
    this->endDrag();
    this->HostedSystem::drop();
    this->result->ShallowCopy(this->base());
    this->forget();
  }
  void forget()
  {
    this->stroke->Initialize();
    this->held->Initialize();
    this->stale = false;
    this->say({});
  }
  bool update(bool& isNews);
  // Asks the system for a preview, which changes none of its parameters.
  template <typename Question>
  void ask(const Question& question)
  {
    const bool current = !this->exists() || !this->isNewer();
    question();
    if (current)
    {
      this->look();
    }
  }
  bool middle(double place[3]);
  // The part of the present mesh that moved; empty where there is none.
  vtkSmartPointer<vtkPolyData> region()
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    if (this->acted())
    {
      this->system()->GetRegion(part);
    }
    return part;
  }
  void drag(const double translation[3]);
  void endDrag()
  {
    if (this->dragged)
    {
      this->dragged = nullptr;
      this->output()->ShallowCopy(this->result);
    }
  }
};

// Brings the mesh up to date where the source, the stroke or the system has changed. A source that has
// changed starts anew, without a stroke. Returns whether anything changed.
bool vtkOversketchLiveStrokeWidget::Internals::update(bool& isNews)
{
  const bool isOther = this->follow();
  if (isOther)
  {
    this->drop();
  }
  if (!this->exists() || this->dragged || !(this->stale || this->isNewer()))
  {
    return isOther;
  }
  this->system()->SetInputData(0, this->base());
  this->system()->SetInputData(1, this->stroke);
  const oversketch::Message why =
    this->run([](const oversketch::Message& warning) { vtkGenericWarningMacro(<< warning.text()); });
  isNews = this->say(this->acted() ? oversketch::Message() : why);
  this->stale = false;
  this->held->Initialize();
  this->result->ShallowCopy(this->output());
  if (this->acted())
  {
    this->system()->GetHold(this->held);
  }
  return true;
}

// A place in the middle of what the stroke took hold of; of the mesh where it did not. False without a
// stroke.
bool vtkOversketchLiveStrokeWidget::Internals::middle(double place[3])
{
  if (!this->exists() || (this->held->GetNumberOfPoints() == 0 && this->base()->GetNumberOfPoints() == 0))
  {
    return false;
  }
  if (this->held->GetNumberOfPoints() > 0)
  {
    this->held->GetPoint(this->held->GetNumberOfPoints() / 2, place);
  }
  else
  {
    this->base()->GetCenter(place);
  }
  return true;
}

// Shows the mesh with the stroke moved by a vector [world], where the system can tell.
void vtkOversketchLiveStrokeWidget::Internals::drag(const double translation[3])
{
  if (!this->acted() || this->stale)
  {
    return; // only the line goes
  }
  if (!this->dragged)
  {
    this->dragged = vtkSmartPointer<vtkPoints>::New();
    this->dragged->SetDataType(this->result->GetPoints()->GetDataType());
    this->dragged->DeepCopy(this->result->GetPoints());
  }
  if (this->system()->Drag(translation, this->dragged))
  {
    this->output()->SetPoints(this->dragged);
    this->output()->Modified();
  }
}

vtkOversketchLiveStrokeWidget::vtkOversketchLiveStrokeWidget()
  : Inner(std::make_unique<Internals>(this->GetStroke()))
{
}

vtkOversketchLiveStrokeWidget::~vtkOversketchLiveStrokeWidget()
{
  this->StopWatching();
}

void vtkOversketchLiveStrokeWidget::SetInputConnection(vtkAlgorithmOutput* mesh)
{
  this->Inner->setSource(mesh);
}

void vtkOversketchLiveStrokeWidget::SetInputData(vtkPolyData* mesh)
{
  this->Inner->setSource(mesh);
}

vtkAlgorithmOutput* vtkOversketchLiveStrokeWidget::GetOutputPort()
{
  return this->Inner->outputPort();
}

vtkPolyData* vtkOversketchLiveStrokeWidget::GetOutput()
{
  return this->Inner->output();
}

void vtkOversketchLiveStrokeWidget::Update()
{
  bool isNews = false;
  if (!this->IsMoving() && this->Inner->update(isNews))
  {
    this->Refresh();
  }
  if (isNews)
  {
    this->Tell(this->GetMessage());
  }
}

void vtkOversketchLiveStrokeWidget::SetSystem(vtkOversketchSystem* system)
{
  this->EndMove(false);
  if (system && system != this->GetSystem())
  {
    this->Inner->setSystem(system);
    this->Inner->strokeChanges();
  }
}

vtkOversketchSystem* vtkOversketchLiveStrokeWidget::GetSystem()
{
  return this->Inner->system();
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
  this->Inner->strokeChanges();
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
  if (this->Inner->exists())
  {
    this->Inner->commit();
    this->Refresh();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

void vtkOversketchLiveStrokeWidget::Drop()
{
  this->EndMove(false);
  if (this->Inner->exists())
  {
    this->Inner->drop();
    this->Refresh();
    this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    this->Render();
  }
}

const char* vtkOversketchLiveStrokeWidget::GetMessage()
{
  return this->Inner->text();
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
    this->Inner->watch(this->CurrentRenderer, this);
    this->WatchedWindow = this->CurrentRenderer->GetRenderWindow();
    this->FrameTag = this->WatchedWindow->AddObserver( // about to draw a frame, perhaps of the pen alone
      vtkCommand::StartEvent,
      this,
      &vtkOversketchLiveStrokeWidget::LookNow);
    this->Update();
  }
}

void vtkOversketchLiveStrokeWidget::StopWatching()
{
  this->Inner->stopWatching();
  if (this->WatchedWindow)
  {
    this->WatchedWindow->RemoveObserver(this->FrameTag);
    this->WatchedWindow = nullptr;
  }
}

void vtkOversketchLiveStrokeWidget::Refresh()
{
  Internals& inner = *this->Inner;
  vtkOversketchLiveStrokeRepresentation* representation = this->GetLiveStrokeRepresentation();
  const bool stands = inner.middle(this->Place);
  representation->SetStroke(stands ? this->GetStroke() : nullptr, this->Place);
  representation->SetRegion(this->ShowRegion && !this->IsMoving() ? inner.region() : nullptr);
  representation->SetText(this->GetMessage());
  this->SetTookHold(inner.said().empty());
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
  this->Inner->ask([&] { this->Look(this->Inner->result, view); });
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
  vtkPolyData* mesh = this->Inner->result;
  if (moves)
  {
    this->GetLiveStrokeRepresentation()->PutMoved(stroke);
    mesh = this->Inner->base();
  }
  else if (this->IsRedrawing())
  {
    mesh = nullptr;
  }
  else
  {
    drawn->GetPolyData(stroke);
  }
  this->Inner->ask([&] { this->Look(mesh, stroke); });
}

void vtkOversketchLiveStrokeWidget::TakeStroke(vtkPolyData* stroke)
{
  if (this->IsNew())
  {
    this->Inner->commit();
  }
  this->Keep(stroke);
  this->Inner->strokeChanges();
  this->Inner->say({});
  this->Update();
  this->Refresh();
}

void vtkOversketchLiveStrokeWidget::StrokeMoves()
{
  this->LookAgain();
  this->Inner->drag(this->GetTranslation());
}

void vtkOversketchLiveStrokeWidget::EndMove(bool keep)
{
  if (this->IsMoving() && this->LooksWhileMoving())
  {
    this->Look(nullptr, nullptr);
  }
  this->Inner->endDrag();
  this->Superclass::EndMove(keep);
}

bool vtkOversketchLiveStrokeWidget::UseKey(const std::string& key)
{
  if (key == "Escape" && this->Inner->exists())
  {
    this->Drop();
  }
  else if ((key == "Return" || key == "KP_Enter") && this->Inner->exists())
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
