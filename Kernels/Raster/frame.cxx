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

std::vector<Place> rounded(const Frame& frame, const Polyline& points)
{
  std::vector<Place> places;
  places.reserve(points.size());
  for (const Vector2& point : points)
  {
    const Vector2 p = frame.toPixels(point) + Vector2(0.5, 0.5);
    if (!(p[0] >= 1.0 && p[1] >= 1.0 && p[0] < frame.width - 1.0 && p[1] < frame.height - 1.0))
    {
      return {};
    }
    places.push_back({ static_cast<int>(p[0]), static_cast<int>(p[1]) });
  }
  return places;
}

std::vector<Place> linePixels(const std::vector<Place>& corners, bool closed)
{
  std::vector<Place> pixels;
  if (corners.empty())
  {
    return pixels;
  }
  pixels.push_back(corners[0]);
  const std::size_t segments = closed ? corners.size() : corners.size() - 1;
  for (std::size_t s = 0; s < segments; ++s)
  {
    const Place a = corners[s], b = corners[(s + 1) % corners.size()];
    if (a == b)
    {
      continue;
    }
    // Bresenham's line from the lesser end, so that it is the same both ways.
    const bool turned = b < a;
    const Place from = turned ? b : a, to = turned ? a : b;
    const int dx = std::abs(to[0] - from[0]), dy = -std::abs(to[1] - from[1]);
    const int sx = to[0] > from[0] ? 1 : -1, sy = to[1] > from[1] ? 1 : -1;
    const std::size_t begin = pixels.size();
    int error = dx + dy;
    Place p = from;
    while (true)
    {
      pixels.push_back(p);
      if (p == to)
      {
        break;
      }
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
    }
    if (turned)
    {
      std::reverse(pixels.begin() + begin, pixels.end());
    }
    pixels.erase(pixels.begin() + begin); // it is there already
  }
  if (closed && pixels.size() > 1 && pixels.back() == pixels.front())
  {
    pixels.pop_back();
  }
  return pixels;
}

void fillEvenOdd(const Frame& frame,
  const std::vector<std::vector<Place>>& polygons,
  int value,
  std::vector<int>& image)
{
  // Of each row, where sides pass it.
  std::vector<std::vector<double>> rows(frame.height);
  for (const std::vector<Place>& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      Place a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a[1] > b[1])
      {
        std::swap(a, b);
      }
      for (int y = a[1]; y < b[1]; ++y)
      {
        rows[y].push_back(a[0] + static_cast<double>(b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
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
