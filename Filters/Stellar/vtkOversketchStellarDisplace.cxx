#include "vtkOversketchStellarDisplace.h"

#include "vtkOversketchFilterTools.h"

#include "Intersection/crossing_faces.h"
#include "Stellar/displace.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarTools.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
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

// Faces in pairs that meet after the displacement and did not before.
int CountCuts(vtkPolyData* before, vtkPolyData* after, const Context& context)
{
  vtkDataArray* feature = after->GetPointData()->GetArray("Feature");
  Mesh mesh = MeshOf(after);
  std::vector<char> rose;
  rose.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
  {
    rose.push_back(
      std::any_of(t.begin(), t.end(), [feature](int v) { return feature->GetComponent(v, 0) != 0.0; }));
  }
  const std::vector<FacePair> now = crossingFaces(mesh, rose, context);
  if (now.empty())
  {
    return 0;
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    before->GetPoint(v, mesh.points[v].data());
  }
  const std::vector<FacePair> was = crossingFaces(mesh, rose, context);
  std::vector<FacePair> pairs;
  std::set_difference(now.begin(), now.end(), was.begin(), was.end(), std::back_inserter(pairs));
  std::set<int> faces;
  for (const FacePair& pair : pairs)
  {
    faces.insert(pair.begin(), pair.end());
  }
  return static_cast<int>(faces.size());
}

} // namespace

vtkOversketchStellarDisplace::vtkOversketchStellarDisplace()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchStellarDisplace::SetProfile(const char* text)
{
  SetText(this, this->Profile, text);
}

void vtkOversketchStellarDisplace::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const CurveStep step = CurveStepOf(this, inputs, outputs);
  if (!step.curves)
  {
    return;
  }
  vtkPolyData* sketch = step.third;
  Cache& cache = this->Kept<Cache>();
  RequireFinite(this->Height, "Height");
  RequireFinite(this->Taper, "Taper");
  const std::vector<double> reach{
    this->Radius, this->Taper, static_cast<double>(this->Distance), static_cast<double>(this->ConnectedOnly)
  };
  std::vector<double> values = reach;
  for (const double value : { this->Height,
         this->Sharpness,
         static_cast<double>(this->UsePressure),
         static_cast<double>(this->Normals),
         static_cast<double>(this->Combine),
         static_cast<double>(this->HoldBack),
         static_cast<double>(this->KeepBaseNormals) })
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
  this->Kept<Cache>().Step.Provide(step,
    { sketch ? WholeKey(sketch) : MeshKey(), MaskKey(step.mesh) },
    values,
    &curves,
    StellarStep::Motion::Rise,
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
      options.taper = this->Taper;
      options.holdBack = this->HoldBack;
      options.keepBaseNormals = this->KeepBaseNormals;
      options.mask = MaskOf(step.mesh);
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
      const DisplaceReport report = displace(before, curves, *cache.Reached, options, step.context, forest);
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
      this->HeldBack = report.heldBack;
      this->LeastShare = report.leastShare;
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
    this->IntersectingFaces = CountCuts(step.mesh, step.output, step.context);
    cache.Counted = counted;
  }
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
  os << indent << "Taper: " << this->Taper << "\n";
  os << indent << "Normals: " << this->Normals << "\n";
  os << indent << "Combine: " << this->Combine << "\n";
  os << indent << "HoldBack: " << this->HoldBack << "\n";
  os << indent << "KeepBaseNormals: " << this->KeepBaseNormals << "\n";
  os << indent << "CountIntersections: " << this->CountIntersections << "\n";
  os << indent << "Moved: " << this->Moved << "\n";
  os << indent << "FlippedFaces: " << this->FlippedFaces << "\n";
  os << indent << "Peak: " << this->Peak << "\n";
  os << indent << "HeldBack: " << this->HeldBack << "\n";
  os << indent << "LeastShare: " << this->LeastShare << "\n";
  os << indent << "CrestPlaces: " << this->CrestPlaces << "\n";
  os << indent << "CrestMean: " << this->CrestMean << "\n";
  os << indent << "CrestMinimum: " << this->CrestMinimum << "\n";
  os << indent << "IntersectingFaces: " << this->IntersectingFaces << "\n";
  os << indent << "DisplaceCount: " << this->DisplaceCount << "\n";
  os << indent << "DistanceCount: " << this->DistanceCount << "\n";
}
