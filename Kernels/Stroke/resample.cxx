#include "Stroke/resample.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// Rounding must not split a gap of exactly the spacing, nor drop a sample that is half of it away.
constexpr double slack = 1e-9;
constexpr double mostSamples = 1e7;

// The samples that stay: numbers of points.
std::vector<int> spread(const Polyline& points, double least, bool closed)
{
  if (closed)
  {
    return thinEvenly(points, least, true);
  }
  std::vector<int> kept = thinStroke(points, least, true);
  const int last = static_cast<int>(points.size()) - 1;
  if (kept.back() != last)
  {
    while (kept.size() > 1 && (points[kept.back()] - points[last]).norm() < least)
    {
      kept.pop_back();
    }
    kept.push_back(last);
  }
  return kept;
}

} // namespace

std::vector<Blend> resampled(const Polyline& points, double spacing, bool closed)
{
  if (!allFinite(points))
  {
    throw Error(Failure::BadStroke, "the stroke has a sample that is not finite");
  }
  if (!differs(points))
  {
    throw Error(Failure::BadStroke, "the stroke has fewer than two distinct points; draw a longer one");
  }
  if (!(spacing > 0.0) || arcLengths(points, closed).back() / spacing > mostSamples)
  {
    throw Error(
      Failure::BadStroke, "the spacing must be positive, and give no more than ten million samples");
  }
  return evenPlaces(points, spread(points, 0.5 * spacing * (1.0 - slack), closed), spacing, closed);
}

std::vector<Blend> evenPlaces(const Polyline& points, std::vector<int> kept, double spacing, bool closed)
{
  if (closed)
  {
    kept.push_back(0);
  }
  std::vector<Blend> places{ Blend::point(0) };
  for (std::size_t i = 1; i < kept.size(); ++i)
  {
    const int from = kept[i - 1], to = kept[i];
    const double gap = (points[from] - points[to]).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(gap / spacing * (1.0 - slack))));
    for (int step = 1; step < steps; ++step)
    {
      places.push_back({ from, to, static_cast<double>(step) / steps });
    }
    if (to != 0 || !closed)
    {
      places.push_back(Blend::point(to));
    }
  }
  return places;
}

std::vector<int> thinStroke(const Polyline& samples, double spacing, bool closed)
{
  std::vector<int> kept;
  const int count = static_cast<int>(samples.size());
  for (int i = 0; i < count; ++i)
  {
    if (kept.empty() || (samples[i] - samples[kept.back()]).norm() >= spacing)
    {
      kept.push_back(i);
    }
  }
  if (!closed && !kept.empty() && kept.back() != count - 1)
  {
    kept.push_back(count - 1);
  }
  return kept;
}

std::vector<int> thinEvenly(const Polyline& samples, double spacing, bool closed)
{
  std::vector<int> kept = thinStroke(samples, spacing, true);
  const int last = static_cast<int>(samples.size()) - 1;
  while (closed && kept.size() > 1 && (samples[kept.back()] - samples.front()).norm() < spacing)
  {
    kept.pop_back();
  }
  if (!closed && !kept.empty() && kept.back() != last)
  {
    if (kept.size() > 1)
    {
      kept.pop_back();
    }
    kept.push_back(last);
  }
  return kept;
}

std::vector<Blend> chaikinPass(int count, bool closed)
{
  std::vector<Blend> places;
  const int segments = closed ? count : count - 1;
  if (count < 2)
  {
    places.assign(static_cast<std::size_t>(count), Blend::point(0));
    return places;
  }
  for (int i = 0; i < segments; ++i)
  {
    const int next = (i + 1) % count;
    places.push_back({ i, next, 0.25 });
    places.push_back({ i, next, 0.75 });
  }
  if (!closed)
  {
    places.front() = Blend::point(0);
    places.back() = Blend::point(count - 1);
  }
  return places;
}

} // namespace oversketch
