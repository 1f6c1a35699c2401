#include "vtkOversketchStellarSmooth.h"

#include "vtkOversketchFilterTools.h"

#include "Stellar/refine.h"
#include "Stellar/smooth.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarSource.h"
#include "vtkOversketchStellarTools.h"

#include "vtkObjectFactory.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStellarSmooth);

vtkOversketchStellarSmooth::vtkOversketchStellarSmooth()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchStellarSmooth::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const CurveStep step = CurveStepOf(this, inputs, outputs);
  if (!step.curves)
  {
    return;
  }
  const std::vector<double> values{ static_cast<double>(this->Rings), static_cast<double>(this->Iterations) };
  const FeatureCurves curves = CurvesOf(step.curves);
  this->Kept<StellarStep>().Provide(step,
    { SourceKey(step), PartsKey(step.mesh), MaskKey(step.mesh) },
    values,
    &curves,
    StellarStep::Motion::Slide,
    [&](const Forest& before)
    {
      ++this->SmoothCount;
      SmoothOptions options;
      options.rings = this->Rings;
      options.iterations = this->Iterations;
      options.parts = PartsOf(step.mesh, before);
      options.staying = { MaskedPointsOf(step.mesh) };
      const MidpointRule rule =
        midpointRule(before, &curves, SourceOf(step, before, this->Kept<std::shared_ptr<const Source>>()));
      Forest forest = before;
      const SmoothReport report = smooth(forest, options, rule, step.context);
      this->Moved = report.moved;
      this->Refused = report.refused;
      return forest;
    });
}

void vtkOversketchStellarSmooth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rings: " << this->Rings << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "Moved: " << this->Moved << "\n";
  os << indent << "Refused: " << this->Refused << "\n";
  os << indent << "SmoothCount: " << this->SmoothCount << "\n";
}
