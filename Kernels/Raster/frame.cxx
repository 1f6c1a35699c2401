#include "Raster/frame.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace oversketch
{
namespace
{

constexpr int margin = 2; // px
constexpr int coarsest = 16, finest = 16384;

// Adds a sample to a line; Bresenham's line before it where it is no neighbour of the last one, from the
// lesser end of the two, so that it is the same both ways.
void join(std::vector<Place>& pixels, const Place& next)
{
  const Place last = pixels.empty() ? next : pixels.back();
  const bool turned = next < last;
  const Place from = turned ? next : last, to = turned ? last : next;
  const int dx = std::abs(to[0] - from[0]), dy = -std::abs(to[1] - from[1]);
  if (dx > 1 || dy < -1)
  {
    const int sx = to[0] > from[0] ? 1 : -1, sy = to[1] > from[1] ? 1 : -1;
    std::vector<Place> between;
    int error = dx + dy;
    for (Place p = from;;)
    {
      const int twice = 2 * error;
      if (twice >= dy)
      {
        error += dy;
        p[0] += sx;
      }
      if (twice <= dx)
      {
        error += dx;
        p[1] += sy;
      }
      if (p == to)
      {
        break;
      }
      between.push_back(p);
    }
    if (turned)
    {
      std::reverse(between.begin(), between.end());
    }
    pixels.insert(pixels.end(), between.begin(), between.end());
  }
  if (pixels.empty() || pixels.back() != next)
  {
    pixels.push_back(next);
  }
}

} // namespace

Frame frameOf(const Canvas& canvas, int resolution)
{
  const double longest = canvas.longest();
  if (!canvas.corner.allFinite() || !canvas.size.allFinite() || canvas.size.minCoeff() <= 0.0)
  {
    throw Error(
      Failure::BadStroke, "the canvas has no extent or is not finite; give it a width and a height");
  }
  if (resolution < coarsest || resolution > finest)
  {
    throw Error(Failure::BadStroke, "the raster's resolution must be 16 to 16384 px along the longest side");
  }
  Frame frame;
  frame.spacing = longest / resolution;
  const auto samples = [&](double side)
  { return std::max(1, static_cast<int>(std::lround(side / frame.spacing))) + 2 * margin; };
  frame.width = samples(canvas.size[0]);
  frame.height = samples(canvas.size[1]);
  frame.origin = canvas.corner - (margin - 0.5) * frame.spacing * Vector2::Ones();
  return frame;
}

Polyline onRaster(const Frame& frame, const Polyline& points)
{
  Polyline result;
  result.reserve(points.size());
  for (const Vector2& point : points)
  {
    const Vector2 p = frame.toPixels(point);
    if (!(p[0] >= 0.5 && p[1] >= 0.5 && p[0] < frame.width - 1.5 && p[1] < frame.height - 1.5))
    {
      return {};
    }
    result.push_back(p);
  }
  return result;
}

std::vector<Place> linePixels(const Polyline& points, bool closed)
{
  std::vector<Place> pixels;
  if (points.empty())
  {
    return pixels;
  }
  const std::size_t segments = closed ? points.size() : points.size() - 1;
  for (std::size_t s = 0; s < segments; ++s)
  {
    const Vector2 &a = points[s], &b = points[(s + 1) % points.size()];
    const int along = std::abs(b[0] - a[0]) >= std::abs(b[1] - a[1]) ? 0 : 1, across = 1 - along;
    // From the lesser end, so that rounding is the same both ways.
    const bool turned = b[along] < a[along];
    const Vector2 from = turned ? b : a, to = turned ? a : b;
    const int first = static_cast<int>(std::ceil(from[along])),
              last = static_cast<int>(std::floor(to[along]));
    const double slope =
      to[along] > from[along] ? (to[across] - from[across]) / (to[along] - from[along]) : 0.0;
    for (int i = 0; i <= last - first; ++i)
    {
      const int step = turned ? last - i : first + i;
      Place p;
      p[along] = step;
      p[across] = static_cast<int>(std::floor(from[across] + slope * (step - from[along]) + 0.5));
      join(pixels, p);
    }
  }
  if (pixels.empty())
  {
    pixels.push_back(
      { static_cast<int>(std::floor(points[0][0] + 0.5)), static_cast<int>(std::floor(points[0][1] + 0.5)) });
  }
  else if (closed)
  {
    const Place first = pixels.front();
    join(pixels, first);
    if (pixels.size() > 1 && pixels.back() == first)
    {
      pixels.pop_back();
    }
  }
  return pixels;
}

void fillEvenOdd(const Frame& frame,
  const std::vector<Polyline>& polygons,
  int value,
  std::vector<int>& image)
{
  // Places where sides pass each row.
  std::vector<std::vector<double>> rows(frame.height);
  for (const Polyline& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      Vector2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a[1] > b[1])
      {
        std::swap(a, b);
      }
      for (int y = static_cast<int>(std::ceil(a[1])); y < b[1]; ++y)
      {
        rows[y].push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
      }
    }
  }
  for (int y = 0; y < frame.height; ++y)
  {
    std::vector<double>& passes = rows[y];
    std::sort(passes.begin(), passes.end());
    for (std::size_t i = 0; i + 1 < passes.size(); i += 2)
    {
      const int begin = static_cast<int>(std::ceil(passes[i]));
      const int end = static_cast<int>(std::ceil(passes[i + 1]));
      std::fill(image.begin() + frame.index(begin, y), image.begin() + frame.index(end, y), value);
    }
  }
}

} // namespace oversketch
