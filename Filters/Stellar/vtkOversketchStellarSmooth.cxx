#include "vtkOversketchStellarSmooth.h"

#include "Stellar/smooth.h"
#include "vtkOversketchStellarTools.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchStellarSmooth::Cache
{
  StellarStep Step;
};

vtkStandardNewMacro(vtkOversketchStellarSmooth);

vtkOversketchStellarSmooth::vtkOversketchStellarSmooth()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchStellarSmooth::~vtkOversketchStellarSmooth() = default;

void vtkOversketchStellarSmooth::SetCurvesData(vtkPolyData* curves)
{
  this->SetInputData(1, curves);
}

int vtkOversketchStellarSmooth::RequestData(vtkInformation*,
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
      const std::vector<double> values{ static_cast<double>(this->Rings),
        this->Relaxation,
        static_cast<double>(this->Iterations),
        this->MinimumAngle };
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
          ++this->SmoothCount;
          SmoothOptions options;
          options.rings = this->Rings;
          options.relaxation = this->Relaxation;
          options.iterations = this->Iterations;
          options.minimumAngle = this->MinimumAngle;
          MidpointRule rule;
          rule.curves = &curves;
          Forest forest = before;
          const SmoothReport report = smooth(forest, options, rule, context);
          this->Moved = report.moved;
          this->Refused = report.refused;
          return forest;
        });
    });
}

void vtkOversketchStellarSmooth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rings: " << this->Rings << "\n";
  os << indent << "Relaxation: " << this->Relaxation << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "Moved: " << this->Moved << "\n";
  os << indent << "Refused: " << this->Refused << "\n";
  os << indent << "SmoothCount: " << this->SmoothCount << "\n";
}
