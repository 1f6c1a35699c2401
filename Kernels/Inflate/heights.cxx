#include "Inflate/heights.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double leastDistance = 0.25, leastRatio = 1e-4;
constexpr int farthest = 16; // samples that the rim's drawn line and the mesh's may lie apart

// The highest of parabolas of curvature -2 along a line of samples, one over each that is above 0: their
// upper envelope, after Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions".
class Caps
{
public:
  // Samples `stride` apart; those at 0 stay there.
  void raise(float* first, int count, std::size_t stride)
  {
    this->Hull.clear();
    for (int x = 0; x < count; ++x)
    {
      const double top = first[x * stride];
      if (!(top > 0.0))
      {
        continue;
      }
      double from = -1.0; // where this one comes to be the highest
      while (!this->Hull.empty())
      {
        const Cap& last = this->Hull.back();
        from = 0.5 * ((last.top - top) / (x - last.at) + x + last.at);
        if (from > last.from)
        {
          break;
        }
        this->Hull.pop_back();
        from = -1.0;
      }
      this->Hull.push_back({ x, top, from });
    }
    std::size_t k = 0;
    for (int x = 0; x < count; ++x)
    {
      float& value = first[x * stride];
      if (value > 0.0f)
      {
        while (k + 1 < this->Hull.size() && this->Hull[k + 1].from <= x)
        {
          ++k;
        }
        const double off = x - this->Hull[k].at;
        value = static_cast<float>(this->Hull[k].top - off * off);
      }
    }
  }

private:
  struct Cap
  {
    int at;
    double top, from;
  };
  std::vector<Cap> Hull;
};

} // namespace

std::vector<float> sectionSquares(const DistanceMaps& maps,
  const std::vector<float>& thickness,
  const CrossSection& section,
  const Context& context)
{
  std::vector<float> squares(maps.frame.count(), 0.0f);
  context.each(static_cast<int>(squares.size()),
    [&](int i)
    {
      if (maps.distance[i] > 0.0f)
      {
        const double whole = thickness[i];
        const double height = whole * section(std::min<double>(maps.distance[i], whole) / whole);
        squares[i] = static_cast<float>(height * height);
      }
    });
  return squares;
}

std::vector<float> roundSquares(const DistanceMaps& maps, const Context& context)
{
  const Frame& frame = maps.frame;
  std::vector<float> squares(frame.count(), 0.0f);
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    squares[i] = maps.distance[i] * maps.distance[i];
  }
  context.parallelFor(frame.height,
    [&](int begin, int end)
    {
      Caps caps;
      for (int y = begin; y < end && !context.cancelled(); ++y)
      {
        caps.raise(squares.data() + frame.index(0, y), frame.width, 1);
      }
    });
  context.parallelFor(frame.width,
    [&](int begin, int end)
    {
      Caps caps;
      for (int x = begin; x < end && !context.cancelled(); ++x)
      {
        caps.raise(squares.data() + x, frame.height, frame.width);
      }
    });
  context.checkpoint(1.0);
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const float t = maps.distance[i];
    squares[i] = std::max(squares[i], t * (2.0f * maps.thickness[i] - t));
  }
  return squares;
}

std::vector<float> roundThickness(const DistanceMaps& maps, const std::vector<float>& ratio)
{
  std::vector<float> thickness(ratio.size(), 0.0f);
  for (std::size_t i = 0; i < ratio.size(); ++i)
  {
    const float t = maps.distance[i];
    thickness[i] = t > 0.0f ? 0.5f * (ratio[i] + t) : 0.0f;
  }
  return thickness;
}

// The four samples round a place: that of the lower left, and the shares of the next column and row.
struct MapReader::Cell
{
  int x, y;
  double u, v;
};

MapReader::Cell MapReader::cellOf(const Vector2& place) const
{
  const Frame& frame = this->Maps.distance.frame;
  const int x = std::clamp(static_cast<int>(std::floor(place[0])), 0, frame.width - 2);
  const int y = std::clamp(static_cast<int>(std::floor(place[1])), 0, frame.height - 2);
  return { x, y, place[0] - x, place[1] - y };
}

double MapReader::distance(const Vector2& place) const
{
  const Cell cell = this->cellOf(place);
  const float* low = this->Maps.distance.distance.data() + this->Maps.distance.frame.index(cell.x, cell.y);
  const float* high = low + this->Maps.distance.frame.width;
  return (1.0 - cell.v) * ((1.0 - cell.u) * low[0] + cell.u * low[1]) +
         cell.v * ((1.0 - cell.u) * high[0] + cell.u * high[1]);
}

Vector2 MapReader::slope(const Vector2& place) const
{
  const Cell cell = this->cellOf(place);
  const float* low = this->Maps.distance.distance.data() + this->Maps.distance.frame.index(cell.x, cell.y);
  const float* high = low + this->Maps.distance.frame.width;
  return { (1.0 - cell.v) * (low[1] - low[0]) + cell.v * (high[1] - high[0]),
    (1.0 - cell.u) * (high[0] - low[0]) + cell.u * (high[1] - low[1]) };
}

float MapReader::valueAt(const std::vector<float>& values, int x, int y, int object) const
{
  const DistanceMaps& maps = this->Maps.distance;
  const Frame& frame = maps.frame;
  const auto isInner = [&](std::size_t at)
  { return maps.distance[at] > 0.0f && (object < 0 || maps.object[at] == object); };
  if (isInner(frame.index(x, y)))
  {
    return values[frame.index(x, y)];
  }
  // Squares round it, until none that follows can hold a nearer one.
  int least = farthest * farthest + 1;
  float value = 0.0f;
  for (int r = 1; r <= farthest && r * r < least; ++r)
  {
    for (int j = std::max(0, y - r); j <= std::min(frame.height - 1, y + r); ++j)
    {
      const int step = std::abs(j - y) == r ? 1 : 2 * r;
      for (int i = x - r; i <= x + r; i += step)
      {
        const int square = (i - x) * (i - x) + (j - y) * (j - y);
        if (i >= 0 && i < frame.width && square < least && isInner(frame.index(i, j)))
        {
          least = square;
          value = values[frame.index(i, j)];
        }
      }
    }
  }
  return value;
}

double MapReader::inner(const std::vector<float>& values, const Vector2& place, int object) const
{
  const Cell cell = this->cellOf(place);
  const auto at = [&](int dx, int dy)
  { return static_cast<double>(this->valueAt(values, cell.x + dx, cell.y + dy, object)); };
  return (1.0 - cell.v) * ((1.0 - cell.u) * at(0, 0) + cell.u * at(1, 0)) +
         cell.v * ((1.0 - cell.u) * at(0, 1) + cell.u * at(1, 1));
}

double MapReader::height(const Vector2& place, int object, const CrossSection& section) const
{
  const double distance = std::max(leastDistance, this->distance(place));
  if (this->Maps.mode == Inflation::Ratio)
  {
    return std::sqrt(std::max(leastRatio, this->inner(this->Maps.ratio, place, object)) * distance);
  }
  const double thickness = std::max(leastDistance, this->inner(this->Maps.thickness, place, object));
  return thickness * section(std::min(distance, thickness) / thickness);
}

std::vector<int> objectsOf(const PlanarMesh& mesh)
{
  std::vector<int> objects(mesh.points.size(), -1);
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      objects[face.corners[k]] = face.object;
    }
  }
  return objects;
}

std::vector<double> heightsOf(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const CrossSection& section,
  double factor,
  const Context& context)
{
  if (!(factor > 0.0) || !std::isfinite(factor))
  {
    throw Error(Failure::BadStroke, "The height factor must be a number above 0.");
  }
  const Frame& frame = maps.distance.frame;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Vector2 at = frame.toPixels(mesh.points[i].place);
    if (!(at.minCoeff() >= 0.0 && at[0] <= frame.width - 1 && at[1] <= frame.height - 1))
    {
      throw Error(Failure::BadMesh,
        "Point %1 of the planar mesh lies outside the distance image; take that of the same drawing.",
        i);
    }
  }
  const MapReader reader(maps);
  const std::vector<int> objects = objectsOf(mesh);
  std::vector<double> heights(mesh.points.size(), 0.0);
  context.eachUntilCancelled(static_cast<int>(heights.size()),
    [&](int i)
    {
      if (isRim(mesh.points[i].kind))
      {
        return;
      }
      const Vector2 at = frame.toPixels(mesh.points[i].place);
      heights[i] = frame.spacing * factor * reader.height(at, objects[i], section);
    });
  context.checkpoint(1.0);
  return heights;
}

} // namespace oversketch
