// How the steps over a 4-8 mesh run, and what they keep; the mesh itself is vtkOversketchStellarTools.cxx's.
#include "vtkOversketchStellarTools.h"

#include "vtkAlgorithm.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace oversketch
{

CurveStep CurveStepOf(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  CurveStep step{ vtkPolyData::GetData(inputs[0]),
    vtkPolyData::GetData(inputs[1]),
    vtkPolyData::GetData(outputs),
    filter->GetNumberOfInputPorts() > 2 ? vtkPolyData::GetData(inputs[2]) : nullptr,
    ContextOf(filter) };
  if (step.curves->GetNumberOfPoints() == 0)
  {
    SharedForest(step.mesh, step.context); // refuses what is none
    step.output->ShallowCopy(step.mesh);
    step.curves = nullptr;
  }
  return step;
}

void StellarStep::Provide(const StepKey& key,
  vtkPolyData* input,
  vtkPolyData* output,
  const std::function<Made()>& make)
{
  if (!this->Stem || this->Key != key)
  {
    *this = StellarStep(); // so that nothing stale is left when making fails
    Made made = make();
    this->After = made.forest;
    this->Arrays = StellarCarry(std::move(made.origins));
    this->Turns = made.turns;
    this->Stem = StellarPolyData(
      this->After, made.digest, made.sameCells ? input : nullptr, made.forest == this->Before, made.curvesOf);
    this->Key = key;
  }
  output->ShallowCopy(this->Stem);
  if (this->Turns && input->GetPointData()->GetNormals())
  {
    this->Arrays.Turn(turnsOf(*this->Before, *this->After));
    this->Turns = false;
  }
  this->Arrays.Carry(input, output);
}

void StellarStep::Provide(const CurveStep& step,
  const std::vector<MeshKey>& otherInputs,
  const std::vector<double>& values,
  const FeatureCurves* curves,
  Motion motion,
  const Change& change)
{
  std::vector<MeshKey> inputs{ StellarKey(step.mesh), step.curves ? WholeKey(step.curves) : MeshKey() };
  inputs.insert(inputs.end(), otherInputs.begin(), otherInputs.end());
  // Forest and curves of inputs that are as they were are known to fit.
  const StepKey inputsKey(inputs, {});
  const auto known = this->InputsKey == inputsKey ? this->Before : nullptr;
  const auto last = known ? this->Stem : nullptr;
  this->Provide(StepKey(inputs, values),
    step.mesh,
    step.output,
    [&]
    {
      this->Before = known ? known : SharedForest(step.mesh, step.context);
      Made made;
      made.turns = motion == Motion::Rise;
      made.curvesOf = made.turns ? last : nullptr; // the stroke has ended in both
      const Forest& before = *this->Before;
      if (curves && !known)
      {
        RequireSameCurves(step.mesh, before, *curves);
      }
      this->InputsKey = inputsKey;
      std::optional<Forest> changed = change(before);
      made.forest = changed ? std::make_shared<const Forest>(std::move(*changed)) : this->Before;
      made.origins = [from = this->Before, to = made.forest, slides = motion == Motion::Slide]
      { return originsOf(*from, *to, slides); };
      made.sameCells = before.faces.size() == made.forest->faces.size();
      if (motion != Motion::Rise) // what rises ends the stroke
      {
        made.digest = curves ? digest(*curves) : WholeNumber(step.mesh->GetFieldData(), "CurveDigest");
      }
      if (made.digest && !HasSnapped(*made.forest))
      {
        made.digest = std::nullopt;
      }
      return made;
    });
}

} // namespace oversketch
