#include "vtkOversketchStellarDisplace.h"

#include "Stellar/displace.h"
#include "vtkOversketchStellarRaised.h"
#include "vtkOversketchStellarTools.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace oversketch;

struct vtkOversketchStellarDisplace::Cache
{
  StellarStep Step;
  // Distances stay while only heights and profiles change.
  StepKey ReachKey;
  std::shared_ptr<const CurvesReached> Reached;
  // Then the result before the last is made the next one, where nobody else holds it.
  std::shared_ptr<const Forest> Spare;
  std::shared_ptr<const oversketch::Raised> Made; // how the last result came about
  MeshKey Counted;                                // that IntersectingFaces is of
};

vtkStandardNewMacro(vtkOversketchStellarDisplace);

namespace
{

// Faces that rose, or that one of those cuts, and that cut a face with which they share no point.
int CountCuts(vtkPolyData* mesh, const Context& context)
{
  vtkNew<vtkPolyData> shape; // a locator makes links in what it is given
  shape->SetPoints(mesh->GetPoints());
  shape->SetPolys(mesh->GetPolys());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(shape);
  locator->BuildLocator();
  vtkDataArray* feature = mesh->GetPointData()->GetArray("Feature");
  const vtkIdType count = shape->GetNumberOfCells();
  std::vector<char> cuts(static_cast<std::size_t>(count), 0);
  vtkNew<vtkIdList> own, other, near;
  for (vtkIdType f = 0; f < count; ++f)
  {
    if (f % 4096 == 0)
    {
      context.checkpoint(static_cast<double>(f) / static_cast<double>(count));
    }
    shape->GetCellPoints(f, own);
    const vtkIdType* ids = own->GetPointer(0);
    if (std::none_of(ids, ids + 3, [feature](vtkIdType id) { return feature->GetComponent(id, 0) != 0.0; }))
    {
      continue;
    }
    double box[6], p[3][3], q[3][3];
    shape->GetCellBounds(f, box);
    for (int k = 0; k < 3; ++k)
    {
      shape->GetPoint(ids[k], p[k]);
    }
    locator->FindCellsWithinBounds(box, near);
    for (vtkIdType i = 0; i < near->GetNumberOfIds(); ++i)
    {
      const vtkIdType g = near->GetId(i);
      shape->GetCellPoints(g, other);
      const vtkIdType* others = other->GetPointer(0);
      if (std::find_first_of(ids, ids + 3, others, others + 3) != ids + 3)
      {
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        shape->GetPoint(others[k], q[k]);
      }
      if (vtkTriangle::TrianglesIntersect(p[0], p[1], p[2], q[0], q[1], q[2]))
      {
        cuts[static_cast<std::size_t>(f)] = cuts[static_cast<std::size_t>(g)] = 1;
      }
    }
  }
  return static_cast<int>(std::count(cuts.begin(), cuts.end(), 1));
}

} // namespace

vtkOversketchStellarDisplace::vtkOversketchStellarDisplace()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
}

vtkOversketchStellarDisplace::~vtkOversketchStellarDisplace() = default;

void vtkOversketchStellarDisplace::SetCurvesData(vtkPolyData* curves)
{
  this->SetInputData(1, curves);
}

void vtkOversketchStellarDisplace::SetSketchData(vtkPolyData* sketch)
{
  this->SetInputData(2, sketch);
}

int vtkOversketchStellarDisplace::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkOversketchStellarDisplace::SetProfile(const char* text)
{
  SetText(this, this->Profile, text);
}

int vtkOversketchStellarDisplace::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunCurveStep(this,
    inputs,
    outputs,
    [&](const CurveStep& step)
    {
      vtkPolyData* sketch = step.third;
      Cache& cache = *this->Internals;
      RequireFinite(this->Height, "Height");
      const std::vector<double> reach{
        this->Radius, static_cast<double>(this->Distance), static_cast<double>(this->ConnectedOnly)
      };
      std::vector<double> values = reach;
      for (const double value : { this->Height,
             this->Sharpness,
             static_cast<double>(this->UsePressure),
             static_cast<double>(this->Normals),
             static_cast<double>(this->Combine) })
      {
        values.push_back(value);
      }
      AddText(values, this->Profile);
      const FeatureCurves curves = CurvesOf(step.curves, this->Height);
      const StepKey reachKey({ StellarKey(step.mesh), WholeKey(step.curves) }, reach);
      std::shared_ptr<const Forest> last; // a result with the same distances
      if (cache.ReachKey == reachKey)
      {
        last = cache.Step.Result();
      }
      else // what is of no use would only take memory
      {
        cache.Spare = nullptr;
        cache.Made = nullptr;
        cache.Reached = nullptr;
        cache.ReachKey = StepKey();
      }
      const vtkIdType done = this->DisplaceCount;
      this->Internals->Step.Provide(step.mesh,
        { WholeKey(step.curves), sketch ? WholeKey(sketch) : MeshKey() },
        values,
        &curves,
        StellarStep::Motion::Rise,
        step.output,
        step.context,
        [&](const Forest& before)
        {
          ++this->DisplaceCount;
          DisplaceOptions options;
          options.radius = LengthOf(this->Radius, 0.03, before, "Radius");
          options.height = this->Height == 0.0 ? 0.5 * options.radius : this->Height;
          options.sharpness = this->Sharpness;
          if (!this->Profile.empty())
          {
            options.profile = Profile::polyline(this->Profile);
          }
          options.distance = this->Distance == Geodesic ? CurveDistance::Geodesic : CurveDistance::Straight;
          options.connectedOnly = this->ConnectedOnly;
          options.usePressure = this->UsePressure;
          options.along = this->Normals == Current ? RiseAlong::Current : RiseAlong::Base;
          options.combine = this->Combine == Sum ? oversketch::Combine::Sum : oversketch::Combine::Nearest;
          std::vector<std::vector<Vector3>> moves;
          if (sketch)
          {
            for (const FeatureCurve& line : CurvesOf(sketch))
            {
              moves.push_back(line.points);
            }
            options.sketch = &moves;
          }
          if (!cache.Reached)
          {
            cache.Reached =
              std::make_shared<const CurvesReached>(reachedBy(before, curves, options, step.context));
            cache.ReachKey = reachKey;
            ++this->DistanceCount;
          }
          Forest forest = TakeForest(cache.Spare);
          const DisplaceReport report =
            displace(before, curves, *cache.Reached, options, step.context, forest);
          cache.Spare = last;
          cache.Made = std::make_shared<const Raised>(Raised{ SharedForest(step.mesh, step.context),
            cache.Reached,
            WholeKey(step.curves),
            options.radius,
            options.distance,
            options.connectedOnly });
          this->Moved = report.moved;
          this->FlippedFaces = report.flipped;
          this->Peak = report.peak;
          this->CrestPlaces = report.crests;
          this->CrestMean = report.crests ? report.crestSum / report.crests : std::nan("");
          this->CrestMinimum = report.crests ? report.crestMinimum : std::nan("");
          return forest;
        });
      if (this->DisplaceCount != done)
      {
        AddRaised(step.output, cache.Made);
      }
      const MeshKey counted(step.output);
      if (!this->CountIntersections)
      {
        this->IntersectingFaces = -1;
      }
      else if (this->IntersectingFaces < 0 || cache.Counted != counted)
      {
        this->IntersectingFaces = -1;
        this->IntersectingFaces = CountCuts(step.output, step.context);
        cache.Counted = counted;
      }
    });
}

void vtkOversketchStellarDisplace::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Sharpness: " << this->Sharpness << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ConnectedOnly: " << this->ConnectedOnly << "\n";
  os << indent << "UsePressure: " << this->UsePressure << "\n";
  os << indent << "Normals: " << this->Normals << "\n";
  os << indent << "Combine: " << this->Combine << "\n";
  os << indent << "CountIntersections: " << this->CountIntersections << "\n";
  os << indent << "Moved: " << this->Moved << "\n";
  os << indent << "FlippedFaces: " << this->FlippedFaces << "\n";
  os << indent << "Peak: " << this->Peak << "\n";
  os << indent << "CrestPlaces: " << this->CrestPlaces << "\n";
  os << indent << "CrestMean: " << this->CrestMean << "\n";
  os << indent << "CrestMinimum: " << this->CrestMinimum << "\n";
  os << indent << "IntersectingFaces: " << this->IntersectingFaces << "\n";
  os << indent << "DisplaceCount: " << this->DisplaceCount << "\n";
  os << indent << "DistanceCount: " << this->DistanceCount << "\n";
}
