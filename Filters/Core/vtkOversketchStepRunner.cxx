#include "vtkOversketchStepRunner.h"

#include "vtkOversketchFilterTools.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"

#include <utility>

namespace oversketch
{

StepRunner::StepRunner(vtkAlgorithm* step, Listener listener)
  : Step(step)
  , Who(std::move(listener))
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
    { static_cast<StepRunner*>(self)->Hear(event, data); });
  for (const unsigned long event :
    { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
  {
    this->Step->AddObserver(event, this->Observer);
  }
  this->Step->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
}

StepRunner::~StepRunner()
{
  this->Step->RemoveObserver(this->Observer);
  this->Step->GetExecutive()->RemoveObserver(this->Observer);
}

void StepRunner::Hear(unsigned long event, const void* data)
{
  if (event == vtkCommand::ProgressEvent)
  {
    if (this->Who.progress)
    {
      this->Who.progress(this->Step->GetProgress());
    }
    if (this->Cancelled())
    {
      this->Step->SetAbortExecute(1);
    }
  }
  else if (event == vtkCommand::WarningEvent)
  {
    if (this->Who.warning)
    {
      this->Who.warning(MessageOf(data));
    }
  }
  else if (this->FirstError.empty()) // the executive of a failed step adds an error of its own
  {
    this->FirstError = MessageOf(data);
  }
}

void StepRunner::Run()
{
  this->Run([this] { this->Step->Update(); });
}

void StepRunner::Run(const std::function<void()>& work)
{
  const auto require = [this]
  {
    if (this->Cancelled())
    {
      throw Error(Failure::Cancelled, "cancelled");
    }
  };
  require();
  this->FirstError = {};
  this->Step->SetAbortExecute(0); // set after the last run's work was done, it would stop this one
  try
  {
    work();
    require();
    if (!this->FirstError.empty())
    {
      const auto code =
        static_cast<long>(this->Step->GetErrorCode()) - static_cast<long>(vtkErrorCode::UserError);
      throw Error(code > 0 ? static_cast<Failure>(code) : Failure::InnerStep, this->FirstError);
    }
  }
  catch (const Error&)
  {
    this->Step->Modified(); // it may have stopped half-way, and a failed run counts as done for its pipeline
    throw;
  }
}

} // namespace oversketch
