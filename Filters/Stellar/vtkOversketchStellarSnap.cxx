#include "vtkOversketchStellarSnap.h"

#include "Stellar/leaves.h"
#include "Stellar/snap.h"
#include "vtkOversketchStellarTools.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchStellarSnap::Cache
{
  StellarStep Step;
};

vtkStandardNewMacro(vtkOversketchStellarSnap);

vtkOversketchStellarSnap::vtkOversketchStellarSnap()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchStellarSnap::~vtkOversketchStellarSnap() = default;

void vtkOversketchStellarSnap::SetCurvesData(vtkPolyData* curves)
{
  this->SetInputData(1, curves);
}

int vtkOversketchStellarSnap::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* curvesIn = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (mesh->GetNumberOfPoints() == 0)
      {
        return;
      }
      const Context context = ContextOf(this);
      if (curvesIn->GetNumberOfPoints() == 0)
      {
        SharedForest(mesh, context); // refuses what is none
        output->ShallowCopy(mesh);
        return;
      }
      const std::vector<double> values{
        static_cast<double>(this->Order), this->MinimumAngle, static_cast<double>(this->MaximumResidualRounds)
      };
      const FeatureCurves curves = CurvesOf(curvesIn);
      this->Internals->Step.Provide(mesh,
        { WholeKey(curvesIn) },
        values,
        &curves,
        StellarStep::Motion::Slide,
        output,
        context,
        [&](const Forest& before)
        {
          ++this->SnapCount;
          SnapOptions options;
          options.order = this->Order == AllAtOnce ? SnapOrder::AllAtOnce : SnapOrder::Nearest;
          options.minimumAngle = this->MinimumAngle;
          options.maximumResidualRounds = this->MaximumResidualRounds;
          MidpointRule rule;
          rule.curves = &curves;
          Forest forest = before.roomyCopy();
          const SnapReport report = snap(forest, curves, options, rule, context);
          this->Crossings = report.crossings;
          this->Residual = report.residual;
          this->Snapped = report.snapped;
          this->Refused = report.refused;
          this->FacesAdded = report.facesAdded;
          return canonical(forest, context).forest;
        });
    });
}

void vtkOversketchStellarSnap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "MaximumResidualRounds: " << this->MaximumResidualRounds << "\n";
  os << indent << "Crossings: " << this->Crossings << "\n";
  os << indent << "Residual: " << this->Residual << "\n";
  os << indent << "Snapped: " << this->Snapped << "\n";
  os << indent << "Refused: " << this->Refused << "\n";
  os << indent << "FacesAdded: " << this->FacesAdded << "\n";
  os << indent << "SnapCount: " << this->SnapCount << "\n";
}
