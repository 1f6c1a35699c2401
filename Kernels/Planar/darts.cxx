#include "Planar/darts.h"

#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double dartShare = 0.7;
constexpr double leastRadius = 6.0;   // px
constexpr double besideCorner = 0.05; // of the raster's longer side: r beside a corner that points inwards
constexpr double sharp = 0.70710678118654752; // cosine of 45 degrees
constexpr double growth = 0.35;               // of r with the distance from a line's vertex
constexpr double leastSize = 0.03;            // of the raster's longer side: r beside short pieces

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

// By rows, in a row by columns.
using Rows = std::vector<std::vector<Candidate>>;

// Bound of r about a place: `atLeast`, and farther off the size there and a share of the distance.
struct Bound
{
  Vector2 place; // px
  double size, growth, atLeast;
};

// Adds a bound for each line's vertices, the mean of the pieces that end there; none that others imply.
void addSizes(const std::vector<StrokeLine>& lines, const Frame& frame, std::vector<Bound>& bounds)
{
  const double least = leastSize * std::max(frame.width, frame.height);
  std::vector<Bound> sizes;
  for (const StrokeLine& line : lines)
  {
    const std::size_t count = line.places.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      double sum = 0.0;
      int pieces = 0;
      for (const std::size_t j : { i, (i + count - 1) % count }) // the pieces that begin there
      {
        if (line.closed || j + 1 < count)
        {
          sum += (line.places[(j + 1) % count] - line.places[j]).norm() / frame.spacing;
          ++pieces;
        }
      }
      if (pieces > 0)
      {
        const double size = std::max(least, sum / pieces);
        sizes.push_back({ frame.toPixels(line.places[i]), size, growth, size });
      }
    }
  }
  std::stable_sort(
    sizes.begin(), sizes.end(), [](const Bound& a, const Bound& b) { return a.size < b.size; });
  const std::size_t first = bounds.size();
  for (const Bound& bound : sizes)
  {
    const auto implies = [&](const Bound& other)
    { return other.size + growth * (other.place - bound.place).norm() <= bound.size; };
    if (std::none_of(bounds.begin() + static_cast<std::ptrdiff_t>(first), bounds.end(), implies))
    {
      bounds.push_back(bound);
    }
  }
}

// Finds for each pixel of a row the largest r that all bounds allow, `most` at most.
void allowed(const std::vector<Bound>& bounds, double most, int y, std::vector<double>& radii)
{
  std::fill(radii.begin(), radii.end(), most);
  const int width = static_cast<int>(radii.size());
  for (const Bound& bound : bounds)
  {
    const double dy = y - bound.place[1], reach = (most - bound.size) / bound.growth;
    if (!(std::abs(dy) < reach))
    {
      continue;
    }
    const int last = std::min(width - 1, static_cast<int>(bound.place[0] + reach) + 1);
    for (int x = std::max(0, static_cast<int>(bound.place[0] - reach)); x <= last; ++x)
    {
      const double dx = x - bound.place[0];
      const double radius = bound.size + bound.growth * std::sqrt(dx * dx + dy * dy);
      radii[x] = std::min(radii[x], std::max(bound.atLeast, radius));
    }
  }
}

Rows farFromRims(const DistanceMaps& maps,
  const std::vector<StrokeLine>& lines,
  DartMode mode,
  const Context& context)
{
  const bool local = mode == DartMode::Local;
  const std::vector<float> greatest = local ? std::vector<float>() : greatestDistances(maps);
  std::vector<Bound> bounds;
  if (local)
  {
    const double least = besideCorner * std::max(maps.frame.width, maps.frame.height);
    for (const Vector2& corner : inwardCorners(lines, maps.frame))
    {
      bounds.push_back({ corner, 0.0, 1.0, least });
    }
    addSizes(lines, maps.frame, bounds);
  }
  const double most =
    local ? dartShare * *std::max_element(maps.thickness.begin(), maps.thickness.end()) : 0.0;
  Rows rows(maps.frame.height);
  const auto radiusAt = [&](std::size_t i, double allowed)
  {
    return local ? std::max(leastRadius, std::min<double>(dartShare * maps.thickness[i], allowed))
                 : 0.5 * greatest[maps.object[i]];
  };
  context.parallelFor(maps.frame.height,
    [&](int begin, int end)
    {
      std::vector<double> radii(maps.frame.width);
      for (int y = begin; y < end && !context.cancelled(); ++y)
      {
        allowed(bounds, most, y, radii);
        for (int x = 0; x < maps.frame.width; ++x)
        {
          const std::size_t i = maps.frame.index(x, y);
          if (maps.object[i] < 0 || !(maps.distance[i] > 0.0f) || (local && maps.distance[i] < leastRadius))
          {
            continue;
          }
          const double radius = radiusAt(i, radii[x]);
          if (maps.distance[i] >= radius)
          {
            rows[y].push_back({ x, y, maps.object[i], radius });
          }
        }
      }
    });
  return rows;
}

// Leaves out what is nearer than 0.7 r to a line of its object.
void keepClearOf(const std::vector<StrokeLine>& lines, const Frame& frame, Rows& rows, const Context& context)
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
  const auto isNear = [&](const Candidate& c)
  {
    const auto found = ofObject.find(c.object);
    const double limit = dartShare * c.radius;
    return found != ofObject.end() &&
           std::any_of(found->second.begin(),
             found->second.end(),
             [&](const NearestPlace& nearest) { return nearest(Vector2(c.x, c.y), limit).distance < limit; });
  };
  context.eachUntilCancelled(static_cast<int>(rows.size()),
    [&](int y) { rows[y].erase(std::remove_if(rows[y].begin(), rows[y].end(), isNear), rows[y].end()); });
  context.checkpoint(0.3);
}

// The pixels where a dart may still lie: one clears only the rows that it can reach.
class Remaining
{
public:
  explicit Remaining(Rows rows)
    : OfRows(std::move(rows))
  {
    for (const std::vector<Candidate>& row : this->OfRows)
    {
      this->Count += row.size();
      for (const Candidate& c : row)
      {
        this->Reach = std::max(this->Reach, c.radius);
      }
    }
  }
  std::size_t count() const { return this->Count; }
  const Candidate& at(std::size_t number) const
  {
    auto row = this->OfRows.begin();
    for (; number >= row->size(); ++row)
    {
      number -= row->size();
    }
    return (*row)[number];
  }
  void clearRound(const Candidate& dart)
  {
    const int reach = static_cast<int>(this->Reach) + 1;
    const int last = std::min(static_cast<int>(this->OfRows.size()) - 1, dart.y + reach);
    for (int y = std::max(0, dart.y - reach); y <= last; ++y)
    {
      std::vector<Candidate>& row = this->OfRows[y];
      const auto isBefore = [](const Candidate& c, int x) { return c.x < x; };
      const auto from = std::lower_bound(row.begin(), row.end(), dart.x - reach, isBefore);
      const auto to = std::lower_bound(from, row.end(), dart.x + reach + 1, isBefore);
      const auto kept = std::remove_if(from,
        to,
        [&](const Candidate& c)
        {
          const double dx = c.x - dart.x, dy = c.y - dart.y;
          const double apart = std::max(c.radius, dart.radius);
          return c.object == dart.object && dx * dx + dy * dy < apart * apart;
        });
      this->Count -= static_cast<std::size_t>(to - kept);
      row.erase(kept, to);
    }
  }

private:
  Rows OfRows;
  std::size_t Count = 0;
  double Reach = 0.0; // the largest r
};

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
  Rows candidates = farFromRims(maps, lines, mode, context);
  context.checkpoint(0.1);
  if (mode == DartMode::Local)
  {
    keepClearOf(lines, maps.frame, candidates, context);
  }
  Remaining remaining(std::move(candidates));
  std::mt19937 random(seed);
  while (remaining.count() > 0)
  {
    context.checkpoint(0.5);
    // No distribution of the library's: those differ from one to another.
    const Candidate dart = remaining.at(random() % remaining.count());
    darts.push_back(maps.frame.toWorld(Vector2(dart.x, dart.y)));
    remaining.clearRound(dart);
  }
  return darts;
}

} // namespace oversketch
