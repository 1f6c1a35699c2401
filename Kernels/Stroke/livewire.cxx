#include "Stroke/livewire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double least = 3.0; // px: the narrowest corridor
constexpr int chordReach = 4; // samples to either side that the stroke's direction is taken from
// The angle between two lines without direction, in [0, pi / 2].
double between(double a, double b)
{
  const double difference = std::abs(std::remainder(a - b, pi));
  return std::min(difference, pi - difference);
}

// A stroke as the livewire walks it: opened at its start where it is closed.
struct Drawn
{
  const EdgeFeatures& features;
  const LivewireRules& rules;
  Polyline points;
  bool closed;
  double radius;

  int count() const { return static_cast<int>(this->points.size()); }
  // Angle of the stroke at a sample.
  double chord(int sample) const
  {
    int from = sample - chordReach, to = sample + chordReach;
    if (this->closed) // the last point is the first one
    {
      const int period = this->count() - 1;
      from = (from % period + period) % period;
      to = to % period;
    }
    else
    {
      from = std::max(from, 0);
      to = std::min(to, this->count() - 1);
    }
    const Vector2 way = this->points[to] - this->points[from];
    return way == Vector2::Zero() ? std::numeric_limits<double>::quiet_NaN() : std::atan2(way[1], way[0]);
  }
  // Whether the edge pixel at (x, y) runs along the stroke, whose angle is given.
  bool counts(int x, int y, double angle) const
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * this->features.width + x;
    // A stroke without a direction has no wrong one.
    return this->features.edges[pixel] != 0 &&
           !(between(tangentOf(this->features, pixel), angle) > this->rules.edgeAngle + 1e-9);
  }
  Pixel nearestPixel(const Vector2& p) const
  {
    return { std::clamp(static_cast<int>(std::lround(p[0])), 0, this->features.width - 1),
      std::clamp(static_cast<int>(std::lround(p[1])), 0, this->features.height - 1) };
  }
  Pixel seedPixel(int sample) const;
  PathField corridor(int from, int to) const;
};

// The strongest edge that counts within the radius of a seed, of equally strong ones the nearest; else the
// pixel it lies on.
Pixel Drawn::seedPixel(int sample) const
{
  const Vector2 seed = this->points[sample];
  // The stroke passes here once: samples in a row that stay near.
  const double reach = 2.0 * this->radius;
  int begin = sample, end = sample;
  while (begin > 0 && (this->points[begin - 1] - seed).norm() <= reach)
  {
    --begin;
  }
  while (end + 1 < this->count() && (this->points[end + 1] - seed).norm() <= reach)
  {
    ++end;
  }
  Pixel best = this->nearestPixel(seed);
  double strongest = 0.0, nearest = 0.0;
  const int y1 = std::min(this->features.height - 1, static_cast<int>(std::floor(seed[1] + this->radius)));
  const int x1 = std::min(this->features.width - 1, static_cast<int>(std::floor(seed[0] + this->radius)));
  for (int y = std::max(0, static_cast<int>(std::ceil(seed[1] - this->radius))); y <= y1; ++y)
  {
    for (int x = std::max(0, static_cast<int>(std::ceil(seed[0] - this->radius))); x <= x1; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * this->features.width + x;
      if (!this->features.edges[pixel])
      {
        continue;
      }
      const Vector2 place(x, y);
      const double distance = (place - seed).norm();
      const double g = this->features.magnitude[pixel];
      if (distance > this->radius || g < strongest || (g == strongest && distance >= nearest))
      {
        continue;
      }
      int at = sample;
      for (int i = begin; i <= end; ++i)
      {
        at = (this->points[i] - place).squaredNorm() < (this->points[at] - place).squaredNorm() ? i : at;
      }
      if (this->counts(x, y, this->chord(at)))
      {
        strongest = g;
        nearest = distance;
        best = { x, y };
      }
    }
  }
  return best;
}

// The pixels within the radius of a part of the stroke.
PathField Drawn::corridor(int from, int to) const
{
  Eigen::AlignedBox2d box;
  for (int i = from; i <= to; ++i)
  {
    box.extend(this->points[i]);
  }
  PathField field;
  const auto low = [&](int axis) { return std::max(0.0, std::ceil(box.min()[axis] - this->radius)); };
  const auto high = [&](int axis, int size)
  { return std::min(size - 1.0, std::floor(box.max()[axis] + this->radius)); };
  const double x0 = low(0), y0 = low(1);
  const double x1 = high(0, this->features.width), y1 = high(1, this->features.height);
  if (x0 > x1 || y0 > y1)
  {
    return field; // beside the picture
  }
  field.x0 = static_cast<int>(x0);
  field.y0 = static_cast<int>(y0);
  field.width = static_cast<int>(x1 - x0) + 1;
  field.height = static_cast<int>(y1 - y0) + 1;
  const std::size_t size = static_cast<std::size_t>(field.width) * field.height;
  field.states.assign(size, PathField::Outside);
  // Of each pixel: the nearest sample and its distance's square.
  std::vector<float> nearest(size, std::numeric_limits<float>::max());
  std::vector<int> samples(size, -1);
  const Eigen::ArrayXd columns = Eigen::ArrayXd::LinSpaced(field.width, x0, x1);
  Eigen::ArrayXd along(field.width), squares(field.width); // of a row, and a segment
  const double limit = this->radius * this->radius;
  for (int i = from; i < to; ++i)
  {
    const Vector2 a = this->points[i], way = this->points[i + 1] - a;
    const double length = way.norm();
    const double divisor =
      length > 0.0 ? way.squaredNorm() : 1.0; // a segment without length is its first point
    const Vector2 lower = a.cwiseMin(a + way), upper = a.cwiseMax(a + way);
    const auto row = [&](double y) { return std::min(y1 + 1.0, std::max(y0 - 1.0, y)); };
    const auto column = [&](double x) { return std::min(field.width + 0.0, std::max(-1.0, x - field.x0)); };
    const int ya = std::max(field.y0, static_cast<int>(std::ceil(row(lower[1] - this->radius))));
    const int yb =
      std::min(field.y0 + field.height - 1, static_cast<int>(std::floor(row(upper[1] + this->radius))));
    for (int y = ya; y <= yb; ++y)
    {
      // Of the segment's box only what is near its ends' rows, and of a long one the strip beside it, is
      // looked at.
      const double off = std::max({ 0.0, lower[1] - y, y - upper[1] });
      const double beside = std::sqrt(std::max(0.0, limit - off * off)) + 1.0;
      double left = lower[0] - beside, right = upper[0] + beside;
      if (std::abs(way[1]) > 1e-9 * length)
      {
        const double middle = a[0] + way[0] * (y - a[1]) / way[1];
        const double half = this->radius * length / std::abs(way[1]) + 1.0;
        left = std::max(left, middle - half);
        right = std::min(right, middle + half);
      }
      const int xa = std::max(0, static_cast<int>(column(left)));
      const int xb = std::min(field.width - 1, static_cast<int>(column(right)));
      const int count = xb - xa + 1;
      if (count < 1)
      {
        continue;
      }
      auto t = along.head(count), square = squares.head(count); // several pixels at a time
      const auto x = columns.segment(xa, count);
      t = (((x - a[0]) * way[0] + (y - a[1]) * way[1]) / divisor).max(0.0).min(1.0);
      square = (t * way[0] + a[0] - x).square() + (t * way[1] + a[1] - y).square();
      const std::size_t first = static_cast<std::size_t>(y - field.y0) * field.width + xa;
      for (int k = 0; k < count; ++k)
      {
        const auto distance = static_cast<float>(square[k]);
        if (square[k] <= limit && distance < nearest[first + k])
        {
          nearest[first + k] = distance;
          samples[first + k] = t[k] < 0.5 ? i : i + 1;
        }
      }
    }
  }
  std::vector<double> chords;
  for (int i = from; i <= to; ++i)
  {
    chords.push_back(this->chord(i));
  }
  for (int y = 0; y < field.height; ++y)
  {
    for (int x = 0; x < field.width; ++x)
    {
      const std::size_t at = static_cast<std::size_t>(y) * field.width + x;
      if (samples[at] >= 0.0)
      {
        const double chord = chords[static_cast<std::size_t>(samples[at]) - from];
        field.states[at] =
          this->counts(field.x0 + x, field.y0 + y, chord) ? PathField::Edge : PathField::Plain;
      }
    }
  }
  return field;
}

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
      const Pixel a = first[first.size() - 1 - i], b = second[j];
      if ((a - b).cwiseAbs().maxCoeff() <= 1 && i + j > most[0] + most[1])
      {
        most = { i, j };
      }
    }
  }
  return most;
}

bool besideEdge(const PathField& field, const Pixel& pixel)
{
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      const int i = indexOf(field, pixel + Pixel(x, y));
      if (i >= 0 && field.states[i] == PathField::Edge)
      {
        return true;
      }
    }
  }
  return false;
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
  std::vector<double> bell;
  for (int k = 0; k <= window; ++k)
  {
    bell.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
  }
  for (int i = 1; i + 1 < count; ++i)
  {
    const int reach = std::min({ window, i, count - 1 - i });
    Vector2 sum = run[i];
    double weights = 1.0;
    for (int k = 1; k <= reach; ++k)
    {
      const double weight = bell[static_cast<std::size_t>(k)];
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
  if (!std::all_of(stroke.begin(), stroke.end(), [](const Vector2& p) { return p.allFinite(); }))
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
  Drawn drawn{ features, rules, stroke, closed, std::max(rules.radius, least) };
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
  std::vector<Pixel> places;
  for (const int end : ends)
  {
    places.push_back(closed && end == last ? places.front() : drawn.seedPixel(end));
  }
  const std::size_t partCount = ends.size() - 1;
  std::vector<std::vector<Pixel>> paths(partCount);
  std::vector<std::vector<std::uint8_t>> strong(partCount);
  PathSearch search;
  for (std::size_t part = 0; part < partCount; ++part)
  {
    context.checkpoint(static_cast<double>(part) / static_cast<double>(ends.size()));
    const PathField field = drawn.corridor(ends[part], ends[part + 1]);
    // A seed of a stroke that leaves the picture may have no pixel in the corridor: no path then.
    paths[part] = search(features, field, places[part], places[part + 1], context);
    for (const Pixel& pixel : paths[part])
    {
      strong[part].push_back(besideEdge(field, pixel));
    }
  }
  // What to leave out of each path's begin and end.
  const int reach = static_cast<int>(std::ceil(3.0 * drawn.radius));
  std::vector<int> fromBegin(partCount, 0), fromEnd(partCount, 0);
  for (std::size_t part = closed ? 0 : 1; part < partCount; ++part)
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
