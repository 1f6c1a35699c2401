#include "vtkOversketchStellarSimplify.h"

#include "vtkOversketchFilterTools.h"

#include "Stellar/simplify.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarTools.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <optional>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchStellarSimplify);

vtkOversketchStellarSimplify::vtkOversketchStellarSimplify()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

vtkIdType vtkOversketchStellarSimplify::GetInputPoint(vtkIdType point) const
{
  const std::vector<int>& from = this->Kept<StellarStep>().PointFrom();
  return point >= 0 && point < static_cast<vtkIdType>(from.size()) ? from[static_cast<std::size_t>(point)]
                                                                   : -1;
}

void vtkOversketchStellarSimplify::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  CurveStep step{ vtkPolyData::GetData(inputs[0]),
    vtkPolyData::GetData(inputs[1]),
    vtkPolyData::GetData(outputs),
    nullptr,
    ContextOf(this) };
  if (step.curves && step.curves->GetNumberOfPoints() == 0)
  {
    step.curves = nullptr;
  }
  this->Kept<StellarStep>().Provide(step,
    { MaskKey(step.mesh) },
    { this->Tolerance,
      this->Radius,
      static_cast<double>(this->Distance),
      static_cast<double>(this->ConnectedOnly) },
    nullptr,
    StellarStep::Motion::None,
    [&](const Forest& before) -> std::optional<Forest>
    {
      ++this->SimplifyCount;
      SimplifyOptions options;
      options.tolerance = LengthOf(this->Tolerance, 1e-4, before, "Tolerance");
      options.radius = LengthOf(this->Radius, 0.03, before, "Radius");
      options.distance = this->Distance == Geodesic ? CurveDistance::Geodesic : CurveDistance::Straight;
      options.connectedOnly = this->ConnectedOnly;
      options.staying = { MaskedPointsOf(step.mesh) };
      const FeatureCurves curves = step.curves ? CurvesOf(step.curves) : FeatureCurves();
      const std::shared_ptr<const Raised> raised = RaisedOf(step.mesh);
      if (step.curves && raised && raised->curves == WholeKey(step.curves) &&
          raised->radius == options.radius && raised->distance == options.distance &&
          raised->connectedOnly == options.connectedOnly)
      {
        const DisplacedFrom from{ *raised->before, *raised->reached };
        return simplify(before, curves, options, step.context, &this->Welded, &from);
      }
      return simplify(before, curves, options, step.context, &this->Welded);
    });
}

void vtkOversketchStellarSimplify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ConnectedOnly: " << this->ConnectedOnly << "\n";
  os << indent << "Welded: " << this->Welded << "\n";
  os << indent << "SimplifyCount: " << this->SimplifyCount << "\n";
}
