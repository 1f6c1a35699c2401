#include "Planar/darts.h"

#include <algorithm>
#include <map>
#include <random>

namespace oversketch
{
namespace
{

constexpr double dartShare = 0.7;
constexpr double leastRadius = 6.0;   // px
constexpr double besideCorner = 0.05; // of the raster's longer side: r beside a corner that points inwards
constexpr double sharp = 0.70710678118654752; // cosine of 45 degrees

// A pixel where a dart may lie, and its distance r [px].
struct Candidate
{
  int x, y, object;
  double radius;
};

// Corners of rims that point into their object [px].
std::vector<Vector2> inwardCorners(const std::vector<StrokeLine>& lines, const Frame& frame)
{
  std::vector<Vector2> found;
  for (const StrokeLine& line : lines)
  {
    const bool hole = line.role == Role::ClosedFeature && line.treatment == Treatment::Hole;
    const std::size_t count = line.places.size();
    if (!line.closed || count < 3 || !(line.role == Role::Boundary || hole))
    {
      continue;
    }
    const auto cross = [](const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; };
    double area = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      area += cross(line.places[i] - line.places[0], line.places[(i + 1) % count] - line.places[0]);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector2 before = line.places[i] - line.places[(i + count - 1) % count];
      const Vector2 after = line.places[(i + 1) % count] - line.places[i];
      const bool inwards = (cross(before, after) * area < 0.0) != hole;
      if (inwards && before.dot(after) < sharp * before.norm() * after.norm())
      {
        found.push_back(frame.toPixels(line.places[i]));
      }
    }
  }
  return found;
}

// Of each pixel how far the nearest of these is, where that is less than `most` px; `most` elsewhere.
std::vector<float> distancesTo(const std::vector<Vector2>& corners, const Frame& frame, double most)
{
  std::vector<float> distances(frame.count(), static_cast<float>(most));
  for (const Vector2& corner : corners)
  {
    const int x0 = std::max(0, static_cast<int>(corner[0] - most));
    const int y0 = std::max(0, static_cast<int>(corner[1] - most));
    const int x1 = std::min(frame.width - 1, static_cast<int>(corner[0] + most) + 1);
    const int y1 = std::min(frame.height - 1, static_cast<int>(corner[1] + most) + 1);
    for (int y = y0; y <= y1; ++y)
    {
      for (int x = x0; x <= x1; ++x)
      {
        float& least = distances[frame.index(x, y)];
        least = std::min(least, static_cast<float>((Vector2(x, y) - corner).norm()));
      }
    }
  }
  return distances;
}

std::vector<Candidate> farFromRims(const DistanceMaps& maps,
  const std::vector<StrokeLine>& lines,
  DartMode mode)
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
  std::vector<float> toCorner;
  const double least = besideCorner * std::max(maps.frame.width, maps.frame.height);
  if (mode == DartMode::Local)
  {
    const float thickest = *std::max_element(maps.thickness.begin(), maps.thickness.end());
    toCorner = distancesTo(inwardCorners(lines, maps.frame), maps.frame, dartShare * thickest);
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
      const double radius =
        mode == DartMode::Published
          ? 0.5 * greatest[object]
          : std::max(leastRadius,
              std::min<double>(dartShare * maps.thickness[i], std::max<double>(least, toCorner[i])));
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
  std::vector<Candidate> candidates = farFromRims(maps, lines, mode);
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
