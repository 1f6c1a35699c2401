// Figures that the steps of vtkOversketchAugment count, over all its strokes.
#include "vtkOversketchAugmentPipeline.h"

#include "Mesh/shape.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStellarCurves.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace oversketch;

namespace
{

double LongestSegment(vtkPolyData* curves)
{
  double longest = 0.0;
  for (const FeatureCurve& curve : CurvesOf(curves))
  {
    for (int i = 0; i < curve.segmentCount(); ++i)
    {
      longest = std::max(longest, (curve.points[curve.segmentEnd(i)] - curve.points[i]).norm());
    }
  }
  return longest;
}

// In degrees; 0 where a triangle has no area.
double SmallestAngle(vtkPolyData* mesh)
{
  const auto data = SharedMesh(mesh);
  const std::vector<Vector3>& points = data->Surface().points;
  double least = 1.0; // the sine squared
  for (const Triangle& t : data->Surface().triangles)
  {
    least = std::min(least, narrowness(points[t[0]], points[t[1]], points[t[2]]));
  }
  return std::asin(std::sqrt(least)) * 180.0 / std::acos(-1.0);
}

} // namespace

void vtkOversketchAugment::Pipeline::AddFigures()
{
  vtkOversketchAugmentFigures& sum = *this->Counted;
  sum.Crossings += this->Snap->GetCrossings();
  sum.Residual += this->Snap->GetResidual();
  sum.RefusedMoves += this->Snap->GetRefused() + this->Smooth->GetRefused();
  sum.FacesAdded += this->Snap->GetFacesAdded();
  sum.FlippedFaces += this->Displace->GetFlippedFaces();
  sum.HeldBack += this->Displace->GetHeldBack();
  sum.LeastShare = std::min(sum.LeastShare, this->Displace->GetLeastShare());
  const int cutting = this->Displace->GetIntersectingFaces();
  sum.IntersectingFaces = cutting < 0 || sum.IntersectingFaces < 0 ? -1 : sum.IntersectingFaces + cutting;
  if (const int places = this->Displace->GetCrestPlaces())
  {
    const double least = this->Displace->GetCrestMinimum();
    sum.CrestMinimum = sum.CrestPlaces ? std::min(sum.CrestMinimum, least) : least;
    sum.CrestSum += places * this->Displace->GetCrestMean();
    sum.CrestPlaces += places;
  }
  sum.LongestSegment =
    std::max(sum.LongestSegment, ::LongestSegment(this->Self->StageOutput(this->CurvesName())));
}

vtkOversketchSystem::FigureList vtkOversketchAugment::Figures()
{
  const Pipeline& inner = *this->Inner;
  if (!inner.Counted || !inner.Made)
  {
    return {};
  }
  const vtkOversketchAugmentFigures& sum = *inner.Counted;
  return { { "base.pairs", inner.Base->GetPairs() },
    { "base.unpaired", inner.Base->GetUnpaired() },
    { "met.crossings", sum.Crossings },
    { "met.residual", sum.Residual },
    { "met.refused_moves", sum.RefusedMoves },
    { "met.faces_added", sum.FacesAdded },
    { "met.flipped_faces", sum.FlippedFaces },
    { "met.self_intersecting_faces", sum.IntersectingFaces < 0 ? std::nan("") : sum.IntersectingFaces },
    { "met.crest_mean", sum.CrestPlaces ? sum.CrestSum / sum.CrestPlaces : std::nan("") },
    { "met.crest_minimum", sum.CrestPlaces ? sum.CrestMinimum : std::nan("") },
    { "met.longest_curve_segment", sum.LongestSegment },
    { "met.smallest_angle", ::SmallestAngle(inner.Made->Last) } };
}

Message vtkOversketchAugment::Pipeline::Remark() const
{
  if (!this->Counted || !this->Made)
  {
    return {};
  }
  constexpr double lowCrest = 0.75; // of the height; lines over good triangles stay above 0.85
  constexpr double fewCrossings = 0.01;
  const vtkOversketchAugmentFigures& sum = *this->Counted;
  std::vector<Message> said;
  const auto count = [&said](int number, const char* one, const char* many)
  {
    if (number > 0)
    {
      said.emplace_back(number == 1 ? one : many, number);
    }
  };
  count(sum.IntersectingFaces,
    "%1 triangle newly passes through others",
    "%1 triangles newly pass through others");
  count(sum.FlippedFaces, "%1 triangle is turned over", "%1 triangles are turned over");
  if (sum.CrestPlaces && sum.CrestMinimum < lowCrest)
  {
    said.emplace_back(
      "the crest has %1 % of its height where it is lowest", std::lround(100.0 * sum.CrestMinimum));
  }
  if (sum.HeldBack > 0)
  {
    said.emplace_back("the model is too thin there, or too near, for the height: it stops before the other "
                      "side, at %1 % of it",
      std::lround(100.0 * sum.LeastShare));
  }
  if (sum.Residual > 1 + fewCrossings * sum.Crossings)
  {
    said.emplace_back("at %1 of %2 places where lines cross edges the mesh does not follow them",
      sum.Residual,
      sum.Crossings);
  }
  if (said.empty())
  {
    return {};
  }
  return { "Not all is as drawn: %1. %2",
    said,
    this->Self->SketchMode == Silhouette
      ? Message("Draw nearer to the outline; a limb is pulled by one-stroke.")
      : Message("Draw it less high or wider.") };
}
