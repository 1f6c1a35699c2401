/**
 * Runs one algorithm as a part of another piece of work: a step of a system, a filter over a collection, a
 * system in a session. Not wrapped.
 */
#ifndef vtkOversketchStepRunner_h
#define vtkOversketchStepRunner_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/message.h"

#include "vtkNew.h"

#include <functional>

class vtkAlgorithm;
class vtkCallbackCommand;

namespace oversketch
{

/**
 * For as long as it lives: hears the step's errors, so that they are not printed, hands its progress and
 * warnings on and passes a cancel in. A step that tells nothing is not stopped before its end.
 */
class OVERSKETCHFILTERSCORE_EXPORT StepRunner
{
public:
  /**
   * Who wants to know; each may be absent.
   */
  struct Listener
  {
    std::function<void(double share)> progress;          // of the step [0 to 1]
    std::function<void(const Message& message)> warning; // see MessageOf
    std::function<bool()> cancelled;                     // asked whenever the step tells its progress
  };

  StepRunner(vtkAlgorithm* step, Listener listener);
  ~StepRunner();

  ///@{
  /**
   * Updates the step, or does with it what is given. Throws Error: Cancelled, or the first error that the
   * step told, with its failure (InnerStep where the step has none). The step is then Modified(), so that it
   * runs again.
   */
  void Run();
  void Run(const std::function<void()>& work);
  ///@}

private:
  void Hear(unsigned long event, const void* data);
  bool Cancelled() const { return this->Who.cancelled && this->Who.cancelled(); }

  vtkAlgorithm* Step;
  Listener Who;
  vtkNew<vtkCallbackCommand> Observer;
  Message FirstError;
};

} // namespace oversketch
#endif
