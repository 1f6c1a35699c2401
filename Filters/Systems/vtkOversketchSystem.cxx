#include "vtkOversketchSystem.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <type_traits>

using namespace oversketch;

bool vtkOversketchSystem::Preview(vtkPolyData*, vtkPolyData*, vtkPolyData* hold)
{
  hold->Initialize();
  return false;
}

void vtkOversketchSystem::GetHold(vtkPolyData* hold)
{
  hold->Initialize();
}

void vtkOversketchSystem::GetRegion(vtkPolyData* region)
{
  region->Initialize();
}

bool vtkOversketchSystem::Drag(const double*, vtkPoints*)
{
  return false;
}

double vtkOversketchSystem::GetFigure(const char* name)
{
  double number = std::nan("");
  for (const auto& [known, figure] : this->Figures())
  {
    if (name && known == name)
    {
      std::visit(
        [&number](const auto& value)
        {
          if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
          {
            number = static_cast<double>(value);
          }
        },
        figure);
    }
  }
  return number;
}

void vtkOversketchSystem::AddStage(const char* name, vtkAlgorithm* step, double share, Listed listed)
{
  this->Stages.push_back({ name, step, share, listed });
}

const vtkOversketchSystem::Stage* vtkOversketchSystem::Find(const char* name) const
{
  for (const Stage& stage : this->Stages)
  {
    if (name && stage.Name == name)
    {
      return &stage;
    }
  }
  return nullptr;
}

const vtkOversketchSystem::Stage* vtkOversketchSystem::FindListed(int index) const
{
  for (const Stage& stage : this->Stages)
  {
    if (stage.IsListed == Listed::Yes && index-- == 0)
    {
      return &stage;
    }
  }
  return nullptr;
}

const char* vtkOversketchSystem::GetStage(int index) const
{
  return index >= 0 && index < this->GetNumberOfStages()
           ? this->Stages[static_cast<std::size_t>(index)].Name.c_str()
           : nullptr;
}

vtkAlgorithm* vtkOversketchSystem::GetStep(const char* name)
{
  const Stage* stage = this->Find(name);
  return stage ? stage->Step : nullptr;
}

int vtkOversketchSystem::GetNumberOfInnerOutputs() const
{
  return static_cast<int>(std::count_if(this->Stages.begin(),
    this->Stages.end(),
    [](const Stage& stage) { return stage.IsListed == Listed::Yes; }));
}

const char* vtkOversketchSystem::GetInnerOutputName(int index) const
{
  const Stage* stage = this->FindListed(index);
  return stage ? stage->Name.c_str() : nullptr;
}

vtkPolyData* vtkOversketchSystem::StageOutput(const char* name)
{
  vtkAlgorithm* step = this->GetStep(name);
  return step ? vtkPolyData::SafeDownCast(step->GetOutputDataObject(0)) : nullptr;
}

vtkDataObject* vtkOversketchSystem::UpdatedInput(int port)
{
  if (this->GetNumberOfInputConnections(port) == 0)
  {
    return nullptr;
  }
  vtkAlgorithmOutput* source = this->GetInputConnection(port, 0);
  source->GetProducer()->Update(source->GetIndex());
  return this->GetInputDataObject(port, 0);
}

void vtkOversketchSystem::PutTriangles(vtkPolyData* mesh,
  const std::vector<char>& chosen,
  int corners,
  vtkPolyData* region)
{
  std::vector<vtkIdType> number(chosen.size(), -1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    const auto isChosen = [&chosen](vtkIdType id) { return chosen[static_cast<std::size_t>(id)] != 0; };
    if (std::count_if(ids->begin(), ids->end(), isChosen) >= corners)
    {
      triangles->InsertNextCell(3);
      for (const vtkIdType point : *ids)
      {
        vtkIdType& id = number[static_cast<std::size_t>(point)];
        id = id >= 0 ? id : points->InsertNextPoint(mesh->GetPoint(point));
        triangles->InsertCellPoint(id);
      }
    }
  }
  region->SetPoints(points);
  region->SetPolys(triangles);
}

double vtkOversketchSystem::GetStageTime(const char* name) const
{
  const Stage* stage = this->Find(name);
  return stage ? stage->Seconds : 0.0;
}

vtkMTimeType vtkOversketchSystem::GetMTime()
{
  vtkMTimeType latest = this->Superclass::GetMTime();
  for (const Stage& stage : this->Stages)
  {
    latest = std::max(latest, stage.Step->GetMTime());
  }
  return latest;
}

namespace
{

// A result that no filter would take as its input is none.
void requireTaken(vtkPolyData* result)
{
  if (!result || result->GetNumberOfPoints() == 0)
  {
    return;
  }
  const double reach = ReachOf(result);
  if (!(reach <= LargestCoordinate))
  {
    throw Error(Failure::BadMesh,
      "The result reaches %1, and no step takes coordinates beyond %2; ask for less, or scale what it is "
      "made of.",
      reach,
      LargestCoordinate);
  }
}

} // namespace

void vtkOversketchSystem::SetRemark(const Message& remark)
{
  this->Remark = remark;
  this->RemarkText = remark.text();
  if (!remark.empty())
  {
    Warn(this, remark);
  }
}

int vtkOversketchSystem::RunSystem(const std::function<void()>& body)
{
  this->Done = 0.0;
  this->Passes = 1;
  this->Warnings.clear();
  this->Remark = {};
  this->RemarkText.clear();
  for (Stage& stage : this->Stages)
  {
    stage.Seconds = 0.0;
  }
  this->Timed = true;
  const int result = RunFilter(this,
    [&]
    {
      body();
      requireTaken(vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)));
    });
  this->Timed = false;
  return result;
}

int vtkOversketchSystem::RunOnMesh(vtkInformationVector** inputs,
  vtkInformationVector* outputs,
  const MeshBody& body)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  return this->RunSystem(
    [&]
    {
      if (mesh->GetNumberOfPoints() > 0)
      {
        body(mesh, output);
      }
    });
}

bool vtkOversketchSystem::Try(const std::function<bool()>& body)
{
  this->Done = 0.0;
  this->Passes = 1;
  this->Warnings.clear();
  this->SetAbortExecute(0);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    return body();
  }
  catch (const Error& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError + static_cast<unsigned long>(error.failure()));
  }
  catch (const std::bad_alloc&)
  {
    this->SetErrorCode(vtkErrorCode::UserError + static_cast<unsigned long>(Failure::Unexpected));
  }
  return false;
}

bool vtkOversketchSystem::TryPrepare(const std::function<void(vtkPolyData*)>& body)
{
  auto* mesh = vtkPolyData::SafeDownCast(this->UpdatedInput(0));
  const auto prepare = [&]
  {
    body(mesh);
    return true;
  };
  return mesh && mesh->GetNumberOfPoints() > 0 && this->Try(prepare);
}

bool vtkOversketchSystem::TryPreview(vtkPolyData* mesh,
  vtkPolyData* stroke,
  vtkPolyData* hold,
  const std::function<bool()>& body)
{
  hold->Initialize();
  return mesh && stroke && mesh->GetNumberOfPoints() > 0 && this->Try(body);
}

void vtkOversketchSystem::RunStage(const char* name, const std::function<void()>& work)
{
  const auto stage = std::find_if(
    this->Stages.begin(), this->Stages.end(), [name](const Stage& known) { return known.Name == name; });
  StepRunner::Listener listener;
  const double part = stage->Share / static_cast<double>(this->Passes);
  // A stage that runs again takes no share of its own.
  listener.progress = [&](double share) { this->UpdateProgress(std::min(1.0, this->Done + share * part)); };
  listener.warning = [this](const Message& message)
  {
    const Message said = this->Said(message);
    if (this->Warnings.insert(said).second) // several steps may say the same
    {
      Warn(this, said);
    }
  };
  listener.cancelled = [this] { return this->GetAbortExecute() != 0; };
  StepRunner runner(stage->Step, listener);
  const struct Shown // for as long as the step runs, also when it throws
  {
    Shown(vtkOversketchSystem* system, const Stage* running)
      : System(system)
    {
      this->System->Running = running;
    }
    ~Shown() { this->System->Running = nullptr; }
    vtkOversketchSystem* System;
  } shown(this, &*stage);
  const auto start = std::chrono::steady_clock::now();
  try
  {
    runner.Run(work ? work : [&stage] { stage->Step->Update(); });
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), this->Said(error.message()));
  }
  if (this->Timed)
  {
    stage->Seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  this->Done = std::min(1.0, this->Done + part);
}

void vtkOversketchSystem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Remark: " << this->RemarkText << "\n";
}
