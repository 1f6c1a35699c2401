#include "vtkOversketchStellarSnap.h"

#include "vtkOversketchFilterTools.h"

#include "Stellar/leaves.h"
#include "Stellar/refine.h"
#include "Stellar/snap.h"
#include "Stellar/snap_foot.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarSource.h"
#include "vtkOversketchStellarTools.h"

#include "vtkObjectFactory.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStellarSnap);

vtkOversketchStellarSnap::vtkOversketchStellarSnap()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchStellarSnap::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const CurveStep step = CurveStepOf(this, inputs, outputs);
  if (!step.curves)
  {
    return;
  }
  std::vector<double> values{ static_cast<double>(this->Order),
    static_cast<double>(this->MaximumResidualRounds) };
  if (this->SnapFoot)
  {
    values.insert(values.end(), { this->Radius, this->Sharpness, static_cast<double>(this->ConnectedOnly) });
  }
  const FeatureCurves curves = CurvesOf(step.curves);
  this->Kept<StellarStep>().Provide(step,
    { SourceKey(step), PartsKey(step.mesh), MaskKey(step.mesh) },
    values,
    &curves,
    StellarStep::Motion::Slide,
    [&](const Forest& before)
    {
      ++this->SnapCount;
      SnapOptions options;
      options.order = this->Order == AllAtOnce ? SnapOrder::AllAtOnce : SnapOrder::Nearest;
      options.maximumResidualRounds = this->MaximumResidualRounds;
      options.parts = PartsOf(step.mesh, before);
      options.staying = { MaskedPointsOf(step.mesh) };
      const MidpointRule rule =
        midpointRule(before, &curves, SourceOf(step, before, this->Kept<std::shared_ptr<const Source>>()));
      Forest forest = before.roomyCopy();
      const SnapReport report = snap(forest, curves, options, rule, step.context);
      this->Crossings = report.crossings;
      this->Residual = report.residual;
      this->Snapped = report.snapped;
      this->Refused = report.refused;
      this->FacesAdded = report.facesAdded;
      this->FootMoved = 0;
      if (this->SnapFoot)
      {
        FootOptions foot;
        foot.radius = LengthOf(this->Radius, 0.03, before, "Radius");
        foot.sharpness = this->Sharpness;
        foot.connectedOnly = this->ConnectedOnly;
        foot.parts = options.parts;
        foot.staying = options.staying;
        this->FootMoved = snapFoot(forest, curves, foot, step.context).moved;
      }
      if (report.split)
      {
        forest = canonical(forest, step.context).forest;
      }
      return forest;
    });
}

void vtkOversketchStellarSnap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "MaximumResidualRounds: " << this->MaximumResidualRounds << "\n";
  os << indent << "SnapFoot: " << this->SnapFoot << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Sharpness: " << this->Sharpness << "\n";
  os << indent << "ConnectedOnly: " << this->ConnectedOnly << "\n";
  os << indent << "Crossings: " << this->Crossings << "\n";
  os << indent << "Residual: " << this->Residual << "\n";
  os << indent << "Snapped: " << this->Snapped << "\n";
  os << indent << "Refused: " << this->Refused << "\n";
  os << indent << "FacesAdded: " << this->FacesAdded << "\n";
  os << indent << "FootMoved: " << this->FootMoved << "\n";
  os << indent << "SnapCount: " << this->SnapCount << "\n";
}
