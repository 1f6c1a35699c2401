// Which steps of a system run, counted. Header-only.
#ifndef oversketch_testing_harness_executions_h
#define oversketch_testing_harness_executions_h

#include "vtkOversketchSystem.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <map>
#include <set>
#include <string>

namespace oversketch_test
{

class Executions
{
public:
  explicit Executions(vtkOversketchSystem* system)
  {
    this->Told->SetClientData(this);
    this->Told->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { ++static_cast<Executions*>(self)->Of[static_cast<vtkAlgorithm*>(caller)]; });
    for (int i = 0; i < system->GetNumberOfStages(); ++i)
    {
      const char* name = system->GetStage(i);
      this->Names[system->GetStep(name)] = name;
      system->GetStep(name)->AddObserver(vtkCommand::StartEvent, this->Told);
    }
  }
  // The steps that ran since the last call.
  std::set<std::string> Ran()
  {
    std::set<std::string> names;
    for (const auto& [step, count] : this->Of)
    {
      names.insert(this->Names[step]);
    }
    this->Of.clear();
    return names;
  }

private:
  vtkNew<vtkCallbackCommand> Told;
  std::map<vtkAlgorithm*, int> Of;
  std::map<vtkAlgorithm*, std::string> Names;
};

} // namespace oversketch_test
#endif
