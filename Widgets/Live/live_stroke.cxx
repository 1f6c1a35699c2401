#include "live_stroke.h"

#include "Mesh/context.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSystem.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkPoints.h"
#include "vtkTrivialProducer.h"

namespace oversketch
{

LiveStroke::LiveStroke(vtkPolyData* stroke)
  : Stroke(stroke)
{
  this->Producer->SetOutput(this->Output);
}

LiveStroke::~LiveStroke() = default;

void LiveStroke::setSystem(vtkOversketchSystem* system)
{
  if (system && system != this->System)
  {
    this->endDrag();
    this->System = system;
    this->Stale = true;
  }
}

void LiveStroke::setSource(vtkAlgorithmOutput* source)
{
  this->Source = source ? source->GetProducer() : nullptr;
  this->SourcePort = source ? source->GetIndex() : 0;
}

vtkAlgorithmOutput* LiveStroke::outputPort()
{
  return this->Producer->GetOutputPort();
}

void LiveStroke::strokeChanges()
{
  this->endDrag();
  this->Stale = true;
}

void LiveStroke::commit()
{
  this->endDrag();
  if (this->exists())
  {
    this->Base->ShallowCopy(this->Output);
    this->Stroke->Initialize();
    this->Held->Initialize();
    this->Message.clear();
    this->Acted = this->Stale = false;
  }
}

void LiveStroke::drop()
{
  this->endDrag();
  this->Stroke->Initialize();
  this->Held->Initialize();
  this->Message.clear();
  this->Acted = this->Stale = false;
  this->Result->ShallowCopy(this->Base);
  this->Output->ShallowCopy(this->Base);
}

bool LiveStroke::update()
{
  bool changed = false;
  if (this->Source)
  {
    this->Source->Update(this->SourcePort);
    auto* mesh = vtkPolyData::SafeDownCast(this->Source->GetOutputDataObject(this->SourcePort));
    if (mesh && (mesh != this->SourceSeen || mesh->GetMTime() != this->SourceTime))
    {
      this->SourceSeen = mesh;
      this->SourceTime = mesh->GetMTime();
      this->Base->ShallowCopy(mesh);
      this->drop();
      changed = true;
    }
  }
  if (this->exists() && !this->Dragged && (this->Stale || this->System->GetMTime() > this->SystemTime))
  {
    this->run();
    changed = true;
  }
  return changed;
}

void LiveStroke::run()
{
  this->System->SetInputData(0, this->Base);
  this->System->SetInputData(1, this->Stroke);
  this->System->Modified(); // what ran before may have had another mesh in the same data object
  this->Message.clear();
  try
  {
    StepRunner::Listener listener;
    listener.warning = [](const oversketch::Message& message) { vtkGenericWarningMacro(<< message.text()); };
    StepRunner(this->System, listener).Run();
  }
  catch (const Error& error)
  {
    this->Message = error.what();
  }
  this->Stale = false;
  this->Acted = this->Message.empty();
  this->Held->Initialize();
  if (this->Acted)
  {
    this->Result->ShallowCopy(this->System->GetOutput());
    this->System->GetHold(this->Held);
  }
  else
  {
    this->Result->ShallowCopy(this->Base);
  }
  this->Output->ShallowCopy(this->Result);
  this->SystemTime = this->System->GetMTime();
}

void LiveStroke::ask(const std::function<void()>& question)
{
  const bool current = !this->exists() || this->System->GetMTime() <= this->SystemTime;
  question();
  if (current)
  {
    this->SystemTime = this->System->GetMTime();
  }
}

bool LiveStroke::middle(double place[3])
{
  if (!this->exists())
  {
    return false;
  }
  if (this->Held->GetNumberOfPoints() > 0)
  {
    this->Held->GetPoint(this->Held->GetNumberOfPoints() / 2, place);
    return true;
  }
  if (this->Base->GetNumberOfPoints() == 0)
  {
    return false;
  }
  this->Base->GetCenter(place);
  return true;
}

vtkSmartPointer<vtkPolyData> LiveStroke::region()
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  if (this->Acted)
  {
    this->System->GetRegion(part);
  }
  return part;
}

void LiveStroke::drag(const double translation[3])
{
  if (!this->Acted || this->Stale)
  {
    return; // only the line goes
  }
  if (!this->Dragged)
  {
    this->Dragged = vtkSmartPointer<vtkPoints>::New();
    this->Dragged->SetDataType(this->Result->GetPoints()->GetDataType());
    this->Dragged->DeepCopy(this->Result->GetPoints());
  }
  if (this->System->Drag(translation, this->Dragged))
  {
    this->Output->SetPoints(this->Dragged);
    this->Output->Modified();
  }
}

void LiveStroke::endDrag()
{
  if (this->Dragged)
  {
    this->Dragged = nullptr;
    this->Output->ShallowCopy(this->Result);
  }
}

} // namespace oversketch
