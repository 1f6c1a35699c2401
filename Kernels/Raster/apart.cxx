#include "Raster/apart.h"

#include "Stroke/meetings.h"
#include "Stroke/resample.h"

#include <algorithm>
#include <set>

namespace oversketch
{
namespace
{

// The samples that are among the places, ascending.
std::vector<int> keptOf(const std::vector<Blend>& places)
{
  std::vector<int> kept;
  for (const Blend& place : places)
  {
    if (place.from == place.to)
    {
      kept.push_back(place.from);
    }
  }
  return kept;
}

// The samples that were dropped in a piece of a resampled stroke; those at the place of the one before them
// would make a piece without length.
void droppedIn(const Polyline& points, const Blend& from, const Blend& to, std::set<int>& dropped)
{
  const int count = static_cast<int>(points.size());
  const int end = to.to > from.from ? to.to : to.to + count; // past a closed stroke's last sample
  Vector2 before = points[from.from];
  for (int i = from.from + 1; i < end; ++i)
  {
    const Vector2& place = points[i % count];
    if (place != before && place != points[end % count])
    {
      dropped.insert(i % count);
      before = place;
    }
  }
}

} // namespace

void keepApart(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double spacing,
  std::vector<std::vector<Blend>>& places,
  const Context& context)
{
  std::vector<PlaneCurve> curves(strokes.size());
  const auto lay = [&](std::size_t i)
  {
    Polyline points;
    for (const Blend& place : places[i])
    {
      points.push_back(place.of(strokes[i].points));
    }
    curves[i] = { onRaster(frame, points), strokes[i].closed };
  };
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    lay(i);
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    const std::vector<std::vector<int>> meeting = meetingSegments(curves, context);
    for (std::size_t i = 0; i < strokes.size(); ++i)
    {
      std::set<int> dropped;
      for (const int segment : meeting[i])
      {
        const Blend& next = places[i][(segment + 1) % places[i].size()];
        droppedIn(strokes[i].points, places[i][segment], next, dropped);
      }
      if (dropped.empty())
      {
        continue;
      }
      std::vector<int> kept = keptOf(places[i]);
      kept.insert(kept.end(), dropped.begin(), dropped.end());
      std::sort(kept.begin(), kept.end());
      places[i] = evenPlaces(strokes[i].points, kept, spacing, strokes[i].closed);
      lay(i);
      changed = true;
    }
  }
}

} // namespace oversketch
