#include "Stroke/livewire.h"

#include "Stroke/corridor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{
namespace
{

// A path with, of each pixel, whether it is strong and the part of the stroke it belongs to.
struct Wire
{
  std::vector<Pixel> pixels;
  std::vector<std::uint8_t> strong;
  std::vector<int> parts;
};

// Two paths meet at a seed that may lie off the way of both, and then go to it and back side by side. Says
// how many pixels of the first one's end and of the second one's begin to leave out, so that the rest runs
// on: of pixels that are neighbours, those farthest from the seed, within `reach` of it. The seed is the last
// pixel of one and the first of the other.
std::array<int, 2> spur(const std::vector<Pixel>& first, const std::vector<Pixel>& second, int reach)
{
  std::array<int, 2> most{ 0, 0 };
  const int n = std::min(reach, static_cast<int>(first.size()) - 1);
  const int m = std::min(reach, static_cast<int>(second.size()) - 1);
  for (int i = 1; i <= n; ++i)
  {
    for (int j = 1; j <= m; ++j)
    {
      const Pixel &a = first[first.size() - 1 - i], &b = second[j];
      if ((a - b).cwiseAbs().maxCoeff() <= 1 && i + j > most[0] + most[1])
      {
        most = { i, j };
      }
    }
  }
  return most;
}

// Gaussian along the run with its ends fixed; near them the window shrinks.
Polyline smoothed(const Polyline& run, double sigma, const NearestPlace& stroke, double radius)
{
  if (sigma <= 0.0)
  {
    return run;
  }
  Polyline result = run;
  const int count = static_cast<int>(run.size()), window = static_cast<int>(std::ceil(3.0 * sigma));
  for (int i = 1; i + 1 < count; ++i)
  {
    const int reach = std::min({ window, i, count - 1 - i });
    Vector2 sum = run[i];
    double weights = 1.0;
    for (int k = 1; k <= reach; ++k)
    {
      const double weight = std::exp(-0.5 * k * k / (sigma * sigma));
      sum += weight * (run[i - k] + run[i + k]);
      weights += 2.0 * weight;
    }
    // A corridor may be bent: what would leave it stays.
    const Vector2 place = sum / weights;
    result[i] = stroke(place, radius).segment >= 0 ? place : run[i];
  }
  return result;
}

} // namespace

SnappedStroke snapped(const EdgeFeatures& features,
  const Polyline& stroke,
  bool closed,
  const std::vector<int>& seeds,
  const LivewireRules& rules,
  const Context& context)
{
  const int given = static_cast<int>(stroke.size());
  if (!allFinite(stroke))
  {
    throw Error(Failure::BadStroke, "the stroke has a sample that is not finite");
  }
  SnappedStroke result;
  if (given < 2)
  {
    result.points = stroke;
    result.snapped.assign(given, 0);
    for (int i = 0; i < given; ++i)
    {
      result.origins.push_back(Blend::point(i));
    }
    return result;
  }
  DrawnOver drawn{ features, rules, stroke, closed, std::max(rules.radius, DrawnOver::leastRadius) };
  if (closed)
  {
    drawn.points.push_back(stroke.front());
  }
  const int last = drawn.count() - 1;
  std::vector<int> ends{ 0 };
  for (const int seed : seeds)
  {
    if (seed < 0 || seed >= given || seed < ends.back())
    {
      throw Error(Failure::BadStroke, "the livewire's seeds must be the stroke's samples in ascending order");
    }
    if (seed > ends.back() && seed < last)
    {
      ends.push_back(seed);
    }
  }
  ends.push_back(last);

  Wire wire;
  const std::size_t partCount = ends.size() - 1;
  const auto [paths, strong] =
    rules.together ? pathsTogether(drawn, ends, context) : pathsBetweenSeeds(drawn, ends, context);
  // Pixels to leave out of each path's begin and end.
  const int reach = static_cast<int>(std::ceil(3.0 * drawn.radius));
  std::vector<int> fromBegin(partCount, 0), fromEnd(partCount, 0);
  for (std::size_t part = closed ? 0 : 1; !rules.together && part < partCount; ++part)
  {
    const std::size_t before = part > 0 ? part - 1 : partCount - 1;
    if (before != part && !paths[before].empty() && !paths[part].empty())
    {
      const auto [end, begin] = spur(paths[before], paths[part], reach);
      fromEnd[before] = end;
      fromBegin[part] = begin;
    }
  }
  for (std::size_t part = 0; part < partCount; ++part)
  {
    const std::vector<Pixel>& path = paths[part];
    const int size = static_cast<int>(path.size());
    // Cuts at both seeds may meet; the path's middle stays then.
    int begin = fromBegin[part], end = size - fromEnd[part];
    if (begin >= end)
    {
      begin = std::min(size / 2, begin);
      end = std::min(size, begin + 1);
    }
    for (int i = begin; i < end; ++i)
    {
      // A seed is in both its parts; strong in one of them is strong.
      if (i == 0 && !wire.pixels.empty() && wire.parts.back() + 1 == static_cast<int>(part) &&
          wire.pixels.back() == path[0])
      {
        wire.strong.back() = wire.strong.back() || strong[part][0];
        continue;
      }
      wire.pixels.push_back(path[i]);
      wire.strong.push_back(strong[part][i]);
      wire.parts.push_back(static_cast<int>(part));
    }
  }
  // Whether the path reaches from the stroke's one end to the other, where no path may be absent.
  const bool begins = !paths.front().empty(), finishes = !paths.back().empty();

  const NearestPlace nearest(drawn.points);
  std::vector<NearestPlace> parts;
  for (std::size_t part = 0; part + 1 < ends.size(); ++part)
  {
    parts.emplace_back(
      Polyline(drawn.points.begin() + ends[part], drawn.points.begin() + ends[part + 1] + 1));
  }
  // Where a pixel of the path lies along the stroke, in samples; looked for on its own part.
  const auto along = [&](int i)
  {
    const int part = wire.parts[i];
    const NearestPlace::Answer answer = parts[part](wire.pixels[i].cast<double>());
    return ends[part] + answer.segment + answer.t;
  };
  const auto keep = [&](double from, double to) // the samples in between, both left out
  {
    for (int i = std::max(0, static_cast<int>(std::floor(from)) + 1); i <= last && i < to; ++i)
    {
      result.points.push_back(drawn.points[i]);
      result.snapped.push_back(0);
      result.origins.push_back(Blend::point(i));
    }
  };
  double done = -1.0; // along the stroke, in samples
  const int count = static_cast<int>(wire.pixels.size());
  for (int begin = 0, end = 0; begin < count; begin = std::max(end, begin + 1))
  {
    for (end = begin; end < count && wire.strong[end]; ++end)
    {
    }
    if (end - begin < rules.shortestRun)
    {
      continue;
    }
    // A path that begins or ends on an edge takes the stroke's own end with it.
    const double from = begin == 0 && begins ? -0.5 : std::max(along(begin), done);
    const double to = end == count && finishes ? last + 0.5 : along(end - 1);
    if (to <= from)
    {
      continue; // the path turns back here
    }
    keep(done, from);
    Polyline run;
    for (int i = begin; i < end; ++i)
    {
      run.push_back(wire.pixels[i].cast<double>());
    }
    run = smoothed(run, rules.sigma, nearest, drawn.radius);
    double place = std::max(from, 0.0);
    for (std::size_t i = 0; i < run.size(); ++i)
    {
      place =
        std::max(place, std::min({ along(begin + static_cast<int>(i)), to, static_cast<double>(last) }));
      const int sample = std::clamp(static_cast<int>(std::floor(place)), 0, last - 1);
      result.points.push_back(run[i]);
      result.snapped.push_back(1);
      result.origins.push_back({ sample, sample + 1, place - sample });
    }
    done = to;
  }
  keep(done, last + 1.0);
  if (closed)
  {
    for (Blend& origin : result.origins)
    {
      origin.from = origin.from == last ? 0 : origin.from;
      origin.to = origin.to == last ? 0 : origin.to;
    }
    // The start is there twice: as drawn, or as the pixel that its seed moved to.
    if (result.points.size() > 2 && result.points.back() == result.points.front())
    {
      result.points.pop_back();
      result.snapped.pop_back();
      result.origins.pop_back();
    }
  }
  return result;
}

} // namespace oversketch
