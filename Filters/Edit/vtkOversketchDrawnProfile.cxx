#include "vtkOversketchDrawnProfile.h"

#include "Stroke/canvas.h"
#include "Stroke/meetings.h"
#include "Stroke/polyline.h"
#include "Stroke/resample.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchPolylines.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <numeric>
#include <sstream>

namespace oversketch
{

namespace
{

// Steps of a drawn profile; a section has some tens of points. Up to so many samples stay among them, so that
// a section that is drawn as it is moves nothing.
constexpr int profileSteps = 400;
constexpr std::size_t profileSamples = 2048;

// Shares of a profile's length: smaller loops are a hand's trembling, ends nearer to each other are one
// place.
constexpr double leastLoop = 0.05, leastGap = 0.01;
// Share of the section's longer side: how far from it a profile that redraws it may begin or end.
constexpr double farthestEnd = 0.75;
// Cosine of the angle to the plane's normal, from which on a view no longer looks onto the plane.
constexpr double leastFacing = 0.7;

const char* const drawOnSection =
  "draw it over the section, or give places in its plane, where the section goes from x = 0 to 1";

[[noreturn]] void refuse(const Message& message)
{
  throw Error(Failure::BadStroke, message);
}

std::string textOf(const Vector2& place)
{
  std::ostringstream text;
  text.precision(3);
  text << '(' << place[0] << ", " << place[1] << ')';
  return text.str();
}

// Where the view onto the plane has them.
Polyline ontoPlane(const View& view, const Polyline& samples, const std::string& who)
{
  Polyline places;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto place = ontoCanvas(view, samples[i]);
    if (!place)
    {
      refuse({ "Sample %1 of the profile does not meet the section's plane in the view that it was drawn in; "
               "draw the profile again.",
        i });
    }
    places.push_back(*place);
  }
  const Vector3 towards = view.towardsViewer(Vector3(places.front()[0], places.front()[1], 0.0)).normalized();
  if (!(std::abs(towards[2]) >= leastFacing))
  {
    refuse({ "%1 was drawn in a view that looks at the section's plane askew, as one of the model does; %2.",
      who,
      drawOnSection });
  }
  return places;
}

void requireSection(const Polyline& line, const std::string& who)
{
  const double length = arcLengths(line).back();
  if (!(length > 0.0))
  {
    refuse({ "%1 has no length; draw it from side to side.", who });
  }
  if ((line.back() - line.front()).norm() < leastGap * length)
  {
    refuse({ "%1 is closed, it ends where it begins, at %2; draw one line from side to side.",
      who,
      textOf(line.front()) });
  }
}

Polyline pointsOf(vtkPolyData* line)
{
  Polyline points;
  for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
  {
    double place[3];
    line->GetPoint(i, place);
    points.emplace_back(place[0], place[1]);
  }
  return points;
}

bool sameTuple(vtkDataArray* one, vtkIdType i, vtkDataArray* other, vtkIdType j)
{
  bool same = one->GetNumberOfComponents() == other->GetNumberOfComponents();
  for (int k = 0; same && k < one->GetNumberOfComponents(); ++k)
  {
    same = one->GetComponent(i, k) == other->GetComponent(j, k);
  }
  return same;
}

} // namespace

void LayInPlane(vtkPolyData* profile, const std::string& who, vtkPolyData* drawn)
{
  Polyline samples = StrokeOf(profile);
  if (!ViewArraysOf(profile).empty())
  {
    samples = ontoPlane(ViewOf(profile), samples, who);
  }
  requireSection(samples, who);
  const double length = arcLengths(samples).back();
  const double step = length / profileSteps;
  Polyline laid;
  if (samples.size() > profileSamples)
  {
    laid = uniformPolyline(samples, step);
  }
  else
  {
    std::vector<int> all(samples.size());
    std::iota(all.begin(), all.end(), 0);
    for (const Blend& place : evenPlaces(samples, all, step, false))
    {
      laid.push_back(place.of(samples));
    }
  }
  if (const auto crossing = selfCrossing(laid, leastLoop * length))
  {
    refuse(
      { "%1 crosses itself near %2; draw it from side to side without a loop.", who, textOf(*crossing) });
  }
  Polylines line;
  line.Add(laid);
  drawn->Initialize();
  line.Put(drawn);
}

void RequireEndsBeside(vtkPolyData* section, vtkPolyData* drawn, const std::string& who)
{
  const NearestPlace nearest(pointsOf(section));
  const Polyline line = pointsOf(drawn);
  for (const auto& [end, does] : { std::pair(line.front(), "begins"), std::pair(line.back(), "ends") })
  {
    if (const double distance = nearest(end).distance; distance > farthestEnd)
    {
      refuse({ "%1 %2 at %3, %4 times the section's width away from it; %5.",
        who,
        does,
        textOf(end),
        std::round(100.0 * distance) / 100.0,
        drawOnSection });
    }
  }
}

void RequireOtherView(vtkPolyData* strokes,
  const std::vector<vtkSmartPointer<vtkPolyData>>& lines,
  const std::string& who,
  const std::string& plane)
{
  const std::vector<vtkDataArray*> its = ViewArraysOf(strokes);
  for (const auto& line : lines)
  {
    const std::vector<vtkDataArray*> others = ViewArraysOf(line);
    for (vtkIdType i = 0; i < strokes->GetNumberOfCells() && !its.empty() && its.size() == others.size(); ++i)
    {
      std::size_t same = 0;
      while (same < its.size() && sameTuple(its[same], i, others[same], 0))
      {
        ++same;
      }
      if (same == its.size())
      {
        refuse({ "%1 was drawn on the model, in the view of the line or of the ring; draw it over %2, in its "
                 "own view.",
          who,
          plane });
      }
    }
  }
}

} // namespace oversketch
