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

#include <memory>

namespace oversketch
{
class KeptOutput;
}

class OVERSKETCHFILTERSCORE_EXPORT vtkOversketchFilter : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkOversketchFilter, vtkPolyDataAlgorithm);

protected:
  vtkOversketchFilter();
  ~vtkOversketchFilter() override;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /**
   * The filter's work, where input 0 is a polydata with points.
   */
  virtual void Execute(vtkInformationVector**, vtkInformationVector*) {}

  // The last result (vtkOversketchKept.h).
  oversketch::KeptOutput& Kept() { return *this->LastResult; }

private:
  const std::unique_ptr<oversketch::KeptOutput> LastResult;
};

#endif
