/**
 * The last result of a step, so that the same question is answered with the same arrays, and what tells one
 * question from another. For use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchKept_h
#define vtkOversketchKept_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/view.h"
#include "vtkOversketchFilterTools.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * Key of what a step has read: its inputs, with the arrays it looks at, its parameters, and the view where it
 * has one. Its result stands while this does.
 */
class OVERSKETCHFILTERSCORE_EXPORT StepKey
{
public:
  StepKey() = default;
  StepKey(const std::vector<MeshKey>& inputs, const std::vector<double>& parameters);
  StepKey(const std::vector<MeshKey>& inputs, const View& view, const std::vector<double>& parameters);
  bool operator==(const StepKey& other) const
  {
    return this->Inputs == other.Inputs && this->Values == other.Values;
  }
  bool operator!=(const StepKey& other) const { return !(*this == other); }

private:
  std::vector<MeshKey> Inputs;
  std::vector<double> Values;
};

/**
 * Adds the characters of a text parameter to the numbers of a key.
 */
OVERSKETCHFILTERSCORE_EXPORT void AddText(std::vector<double>& values, const std::string& text);

/**
 * Something that a step made, and what of.
 */
template <class Value>
class KeptValue
{
public:
  /**
   * Gives what is kept, where the key is the same, else what make gives. Nothing is kept when making throws.
   */
  template <class Make>
  const Value& Provide(const StepKey& key, const Make& make)
  {
    if (!this->Held || this->Key != key)
    {
      this->Held.reset(); // so that nothing stale is left when making fails
      this->Held.emplace(make());
      this->Key = key;
    }
    return *this->Held;
  }

private:
  StepKey Key;
  std::optional<Value> Held;
};

/**
 * The last result of a step.
 */
class OVERSKETCHFILTERSCORE_EXPORT KeptOutput
{
public:
  ///@{
  /**
   * Copies the kept result, shallowly, to the output, or results to outputs; first has them made where the
   * key is a new one. Nothing is kept when making throws.
   */
  using Outputs = std::vector<vtkPolyData*>;
  void Provide(const StepKey& key, vtkPolyData* output, const std::function<void(vtkPolyData* result)>& make);
  void Provide(const StepKey& key,
    const Outputs& outputs,
    const std::function<void(const Outputs& results)>& make);
  ///@}

private:
  KeptValue<std::vector<vtkSmartPointer<vtkPolyData>>> Results;
};

} // namespace oversketch
#endif
