#include "live_stroke.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchOneStroke.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkPoints.h"
#include "vtkTrivialProducer.h"

namespace oversketch
{

LiveStroke::LiveStroke(vtkPolyData* stroke)
  : system_(vtkSmartPointer<vtkOversketchOneStroke>::New())
  , stroke_(stroke)
{
  this->producer_->SetOutput(this->output_);
}

LiveStroke::~LiveStroke() = default;

void LiveStroke::setSystem(vtkOversketchOneStroke* system)
{
  if (system && system != this->system_)
  {
    this->endDrag();
    this->system_ = system;
    this->stale_ = true;
  }
}

void LiveStroke::setSource(vtkAlgorithmOutput* source)
{
  this->source_ = source ? source->GetProducer() : nullptr;
  this->sourcePort_ = source ? source->GetIndex() : 0;
}

vtkAlgorithmOutput* LiveStroke::outputPort()
{
  return this->producer_->GetOutputPort();
}

void LiveStroke::strokeChanges()
{
  this->endDrag();
  this->stale_ = true;
}

void LiveStroke::commit()
{
  this->endDrag();
  if (this->exists())
  {
    this->base_->ShallowCopy(this->output_);
    this->stroke_->Initialize();
    this->held_->Initialize();
    this->message_.clear();
    this->acted_ = this->stale_ = false;
  }
}

void LiveStroke::drop()
{
  this->endDrag();
  this->stroke_->Initialize();
  this->held_->Initialize();
  this->message_.clear();
  this->acted_ = this->stale_ = false;
  this->result_->ShallowCopy(this->base_);
  this->output_->ShallowCopy(this->base_);
}

bool LiveStroke::update()
{
  bool changed = false;
  if (this->source_)
  {
    this->source_->Update(this->sourcePort_);
    auto* mesh = vtkPolyData::SafeDownCast(this->source_->GetOutputDataObject(this->sourcePort_));
    if (mesh && (mesh != this->sourceSeen_ || mesh->GetMTime() != this->sourceTime_))
    {
      this->sourceSeen_ = mesh;
      this->sourceTime_ = mesh->GetMTime();
      this->base_->ShallowCopy(mesh);
      this->drop();
      changed = true;
    }
  }
  if (this->exists() && !this->dragged_ && (this->stale_ || this->system_->GetMTime() > this->systemTime_))
  {
    this->run();
    changed = true;
  }
  return changed;
}

void LiveStroke::run()
{
  // The first error is the step's own; the executives add theirs.
  vtkNew<vtkCallbackCommand> ear;
  std::string said;
  ear->SetClientData(&said);
  ear->SetCallback(
    [](vtkObject*, unsigned long, void* text, void* data)
    {
      auto& first = *static_cast<std::string*>(text);
      if (first.empty())
      {
        first = MessageOf(data);
      }
    });
  const unsigned long tag = this->system_->AddObserver(vtkCommand::ErrorEvent, ear);
  vtkExecutive* executive = this->system_->GetExecutive();
  const unsigned long executiveTag = executive->AddObserver(vtkCommand::ErrorEvent, ear);
  this->system_->SetInputData(0, this->base_);
  this->system_->SetInputData(1, this->stroke_);
  this->system_->SetAbortExecute(0);
  this->system_->Modified(); // a run that failed counts as done for its pipeline
  this->system_->Update();
  this->system_->RemoveObserver(tag);
  executive->RemoveObserver(executiveTag);
  this->stale_ = false;
  this->acted_ = this->system_->GetErrorCode() == 0 && said.empty();
  this->message_ = said;
  this->held_->Initialize();
  if (this->acted_)
  {
    this->result_->ShallowCopy(this->system_->GetOutput());
    this->held_->ShallowCopy(this->system_->GetInnerOutput("Match"));
  }
  else
  {
    this->result_->ShallowCopy(this->base_);
  }
  this->output_->ShallowCopy(this->result_);
  this->systemTime_ = this->system_->GetMTime();
}

bool LiveStroke::section(vtkPolyData* stroke, vtkPolyData* section)
{
  const bool current = !this->exists() || this->system_->GetMTime() <= this->systemTime_;
  const bool found = this->system_->Preview(this->result_, stroke, section);
  if (current)
  {
    this->systemTime_ = this->system_->GetMTime(); // a look that found nothing changes no parameter
  }
  return found;
}

bool LiveStroke::middle(double place[3])
{
  if (!this->exists())
  {
    return false;
  }
  if (this->held_->GetNumberOfPoints() > 0)
  {
    this->held_->GetPoint(this->held_->GetNumberOfPoints() / 2, place);
    return true;
  }
  if (this->base_->GetNumberOfPoints() == 0)
  {
    return false;
  }
  this->base_->GetCenter(place);
  return true;
}

vtkSmartPointer<vtkPolyData> LiveStroke::region()
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  if (this->acted_)
  {
    this->system_->GetRegion(part);
  }
  return part;
}

void LiveStroke::drag(const double translation[3])
{
  if (!this->acted_ || this->stale_)
  {
    return; // only the line goes
  }
  if (!this->dragged_)
  {
    this->dragged_ = vtkSmartPointer<vtkPoints>::New();
    this->dragged_->SetDataType(this->result_->GetPoints()->GetDataType());
    this->dragged_->DeepCopy(this->result_->GetPoints());
  }
  if (this->system_->Drag(translation, this->dragged_))
  {
    this->output_->SetPoints(this->dragged_);
    this->output_->Modified();
  }
}

void LiveStroke::endDrag()
{
  if (this->dragged_)
  {
    this->dragged_ = nullptr;
    this->output_->ShallowCopy(this->result_);
  }
}

} // namespace oversketch
