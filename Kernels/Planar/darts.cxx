#include "Planar/darts.h"

#include <algorithm>
#include <map>
#include <random>

namespace oversketch
{
namespace
{

constexpr double dartShare = 0.7;
constexpr double leastRadius = 6.0; // px

// A pixel where a dart may lie, and its distance r [px].
struct Candidate
{
  int x, y, object;
  double radius;
};

std::vector<Candidate> farFromRims(const DistanceMaps& maps, DartMode mode)
{
  std::vector<double> greatest; // T, of each object
  if (mode == DartMode::Published)
  {
    for (std::size_t i = 0; i < maps.object.size(); ++i)
    {
      if (maps.object[i] >= 0)
      {
        greatest.resize(std::max<std::size_t>(greatest.size(), maps.object[i] + 1), 0.0);
        greatest[maps.object[i]] = std::max<double>(greatest[maps.object[i]], maps.distance[i]);
      }
    }
  }
  std::vector<Candidate> result;
  for (int y = 0; y < maps.frame.height; ++y)
  {
    for (int x = 0; x < maps.frame.width; ++x)
    {
      const std::size_t i = maps.frame.index(x, y);
      const int object = maps.object[i];
      if (object < 0 || !(maps.distance[i] > 0.0f))
      {
        continue;
      }
      const double radius = mode == DartMode::Published
                              ? 0.5 * greatest[object]
                              : std::max(dartShare * static_cast<double>(maps.thickness[i]), leastRadius);
      if (maps.distance[i] >= radius)
      {
        result.push_back({ x, y, object, radius });
      }
    }
  }
  return result;
}

// Leaves out what is nearer than 0.7 r to a line of its object.
void keepClearOf(const std::vector<StrokeLine>& lines,
  const Frame& frame,
  std::vector<Candidate>& candidates,
  const Context& context)
{
  std::map<int, std::vector<NearestPlace>> ofObject;
  for (const StrokeLine& line : lines)
  {
    Polyline pixels;
    for (const Vector2& place : line.places)
    {
      pixels.push_back(frame.toPixels(place));
    }
    ofObject[line.object].emplace_back(pixels, line.closed);
  }
  std::vector<char> clear(candidates.size(), 1);
  context.parallelFor(static_cast<int>(candidates.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        if (i % 4096 == 0 && context.cancelled())
        {
          return;
        }
        const Candidate& c = candidates[i];
        const auto found = ofObject.find(c.object);
        if (found == ofObject.end())
        {
          continue;
        }
        const double limit = dartShare * c.radius;
        clear[i] = std::all_of(found->second.begin(),
          found->second.end(),
          [&](const NearestPlace& nearest) { return nearest(Vector2(c.x, c.y), limit).distance >= limit; });
      }
    });
  context.checkpoint(0.3);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (clear[i])
    {
      candidates[kept++] = candidates[i];
    }
  }
  candidates.resize(kept);
}

} // namespace

std::vector<Vector2> throwDarts(const DistanceMaps& maps,
  const std::vector<StrokeLine>& lines,
  DartMode mode,
  unsigned int seed,
  const Context& context)
{
  std::vector<Vector2> darts;
  if (mode == DartMode::Off)
  {
    return darts;
  }
  std::vector<Candidate> candidates = farFromRims(maps, mode);
  context.checkpoint(0.1);
  if (mode == DartMode::Local)
  {
    keepClearOf(lines, maps.frame, candidates, context);
  }
  std::mt19937 random(seed);
  while (!candidates.empty())
  {
    context.checkpoint(0.5);
    // No distribution of the library's: those differ from one to another.
    const Candidate dart = candidates[random() % candidates.size()];
    darts.push_back(maps.frame.toWorld(Vector2(dart.x, dart.y)));
    candidates.erase(std::remove_if(candidates.begin(),
                       candidates.end(),
                       [&](const Candidate& c)
                       {
                         const double x = c.x - dart.x, y = c.y - dart.y;
                         const double apart = std::max(c.radius, dart.radius);
                         return c.object == dart.object && x * x + y * y < apart * apart;
                       }),
      candidates.end());
  }
  return darts;
}

} // namespace oversketch
