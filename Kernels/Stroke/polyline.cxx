#include "Stroke/polyline.h"

#include "Mesh/nearest.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// `next` is the first entry of lengths that is greater.
Blend placeBefore(std::vector<double>::const_iterator next,
  const std::vector<double>& lengths,
  int pointCount,
  double length)
{
  if (next == lengths.begin())
  {
    return Blend::point(0);
  }
  if (next == lengths.end())
  {
    return Blend::point(static_cast<int>(lengths.size() - 1) % pointCount);
  }
  const int segment = static_cast<int>(next - lengths.begin()) - 1;
  // The segment's length is positive: coincident points are passed over.
  const double t = (length - lengths[segment]) / (lengths[segment + 1] - lengths[segment]);
  return { segment, (segment + 1) % pointCount, t };
}

} // namespace

bool allFinite(const Polyline& points)
{
  return std::all_of(points.begin(), points.end(), [](const Vector2& p) { return p.allFinite(); });
}

bool differs(const Polyline& points)
{
  return std::any_of(points.begin(), points.end(), [&](const Vector2& p) { return p != points.front(); });
}

Blend placeAt(const std::vector<double>& lengths, int pointCount, double length)
{
  return placeBefore(std::upper_bound(lengths.begin(), lengths.end(), length), lengths, pointCount, length);
}

std::vector<Blend> evenPlaces(const std::vector<double>& lengths, int pointCount, int steps)
{
  std::vector<Blend> places;
  places.reserve(steps + 1);
  auto next = lengths.begin();
  for (int i = 0; i <= steps; ++i)
  {
    const double length = lengths.back() * i / steps;
    while (next != lengths.end() && *next <= length)
    {
      ++next;
    }
    places.push_back(placeBefore(next, lengths, pointCount, length));
  }
  return places;
}

std::vector<Blend> uniformPlaces(const Polyline& points, double spacing)
{
  const std::vector<double> lengths = arcLengths(points);
  const int count = static_cast<int>(points.size());
  const int steps = std::max(1, static_cast<int>(std::lround(lengths.back() / spacing)));
  std::vector<Blend> places = evenPlaces(lengths, count, steps);
  places.front() = Blend::point(0);
  places.back() = Blend::point(count - 1);
  return places;
}

Polyline uniformPolyline(const Polyline& points, double spacing)
{
  Polyline samples;
  for (const Blend& place : uniformPlaces(points, spacing))
  {
    samples.push_back(place.of(points));
  }
  return samples;
}

NearestPlace::NearestPlace(const Polyline& points, bool closed)
{
  const int count = static_cast<int>(points.size());
  // A single point is a polyline of one segment without length.
  const int segments = closed || count == 1 ? count : count - 1;
  constexpr int blockSize = 16;
  for (int i = 0; i < segments; ++i)
  {
    const Vector2& start = points[i];
    const Vector2& end = points[(i + 1) % count];
    if (i % blockSize == 0)
    {
      this->Blocks.push_back({ Eigen::AlignedBox2d(), i, i });
    }
    this->Starts.push_back(start);
    this->Steps.push_back(end - start);
    Block& block = this->Blocks.back();
    block.box.extend(start);
    block.box.extend(end);
    block.end = i + 1;
  }
}

NearestPlace::Answer NearestPlace::operator()(const Vector2& point, double limit) const
{
  Answer answer;
  double best = limit * limit;
  for (const Block& block : this->Blocks)
  {
    if (block.box.squaredExteriorDistance(point) > best)
    {
      continue;
    }
    for (int i = block.begin; i < block.end; ++i)
    {
      const Vector2 offset = point - this->Starts[i];
      const double t = nearestShare(offset, this->Steps[i]);
      const double squared = (offset - t * this->Steps[i]).squaredNorm();
      if (squared < best || (squared == best && answer.segment < 0))
      {
        best = squared;
        answer.segment = i;
        answer.t = t;
      }
    }
  }
  answer.distance = answer.segment < 0 ? std::numeric_limits<double>::infinity() : std::sqrt(best);
  if (answer.segment >= 0)
  {
    answer.place = this->Starts[answer.segment] + answer.t * this->Steps[answer.segment];
  }
  return answer;
}

double NearestPlace::meanDistance(const Polyline& points) const
{
  // A place is no farther than that of the point before, and the way from it: most blocks are out of reach.
  constexpr double rounding = 1.0 + 1e-9;
  double sum = 0.0, last = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double reach = i > 0 ? rounding * (last + (points[i] - points[i - 1]).norm()) : last;
    last = (*this)(points[i], reach).distance;
    if (std::isinf(last)) // rounding, far from the origin
    {
      last = (*this)(points[i]).distance;
    }
    sum += last;
  }
  return sum / static_cast<double>(points.size());
}

} // namespace oversketch
