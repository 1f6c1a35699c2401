#include "edit_parts.h"

#include "vtkOversketchStepRunner.h"

#include "Mesh/context.h"

#include "vtkAlgorithm.h"

namespace oversketch
{

std::pair<bool, std::string> ranTold(vtkAlgorithm* system)
{
  std::string said;
  try
  {
    StepRunner::Listener listener;
    listener.warning = [&](const std::string& warning) { said = warning; };
    StepRunner(system, listener).Run();
    return { true, said };
  }
  catch (const Error& error)
  {
    return { false, error.what() };
  }
}

} // namespace oversketch
