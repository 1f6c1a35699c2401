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
  this->Provide(key, Outputs{ output }, [&make](const Outputs& results) { make(results[0]); });
}

void KeptOutput::Provide(const StepKey& key,
  const Outputs& outputs,
  const std::function<void(const Outputs& results)>& make)
{
  const auto& results = this->Results.Provide(key,
    [&]
    {
      std::vector<vtkSmartPointer<vtkPolyData>> made;
      for (std::size_t i = 0; i < outputs.size(); ++i)
      {
        made.push_back(vtkSmartPointer<vtkPolyData>::New());
      }
      make(Outputs(made.begin(), made.end()));
      return made;
    });
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    outputs[i]->ShallowCopy(results[i]);
  }
}

} // namespace oversketch
