#include "vtkOversketchKept.h"

#include "vtkPolyData.h"

namespace oversketch
{

StepKey::StepKey(const std::vector<MeshKey>& inputs, const std::vector<double>& parameters)
  : Inputs(inputs)
  , Values(parameters)
{
}

StepKey::StepKey(const std::vector<MeshKey>& inputs, const View& view, const std::vector<double>& parameters)
  : StepKey(inputs, parameters)
{
  for (const Eigen::Matrix4d* matrix : { &view.viewTransform(), &view.projectionTransform() })
  {
    this->Values.insert(this->Values.end(), matrix->data(), matrix->data() + matrix->size());
  }
  this->Values.push_back(view.width());
  this->Values.push_back(view.height());
}

void AddText(std::vector<double>& values, const std::string& text)
{
  values.push_back(static_cast<double>(text.size()));
  values.insert(values.end(), text.begin(), text.end());
}

void KeptOutput::Provide(const StepKey& key,
  vtkPolyData* output,
  const std::function<void(vtkPolyData* result)>& make)
{
  if (!this->Result || this->Key != key)
  {
    this->Result = nullptr; // so that nothing stale is left when making fails
    auto result = vtkSmartPointer<vtkPolyData>::New();
    make(result);
    this->Result = result;
    this->Key = key;
  }
  output->ShallowCopy(this->Result);
}

} // namespace oversketch
