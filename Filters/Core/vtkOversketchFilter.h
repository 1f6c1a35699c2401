/**
 * @class vtkOversketchFilter
 * @brief base of the filters, which keeps what each of them promises of a run
 *
 * A filter does its work in Execute and throws oversketch::Error where it cannot: bad input, a cancel and
 * what nobody expected come out alike (oversketch::RunFilter). Where input 0 has no points there is no work:
 * every output is empty, silently. One that has work all the same overrides RequestData instead.
 *
 * @sa vtkOversketchBackendFilter vtkOversketchSystem
 */
#ifndef vtkOversketchFilter_h
#define vtkOversketchFilter_h

#include "OversketchFiltersCoreModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <map>
#include <memory>
#include <typeindex>

class OVERSKETCHFILTERSCORE_EXPORT vtkOversketchFilter : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkOversketchFilter, vtkPolyDataAlgorithm);

protected:
  vtkOversketchFilter() = default;
  ~vtkOversketchFilter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /**
   * The filter's work, where input 0 is a polydata with points.
   */
  virtual void Execute(vtkInformationVector**, vtkInformationVector*) {}

  /**
   * What a filter keeps from run to run, one of each type; made when it is first asked for.
   */
  template <typename State>
  State& Kept() const
  {
    std::shared_ptr<void>& state = this->States[typeid(State)];
    if (!state)
    {
      state = std::make_shared<State>();
    }
    return *static_cast<State*>(state.get());
  }

private:
  mutable std::map<std::type_index, std::shared_ptr<void>> States;
};

#endif
