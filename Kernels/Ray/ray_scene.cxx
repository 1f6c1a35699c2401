#include "Ray/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int bits = 10; // per axis

// Two zeros before each bit.
std::uint32_t spread(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  return (x | x << 2) & 0x09249249u;
}

// Where the curve reaches a cell (Skilling, "Programming the Hilbert curve", 2004: undo the excess work of
// the Gray code, axis by axis).
std::uint32_t curveKey(std::array<std::uint32_t, 3> x)
{
  for (int bit = bits - 1; bit > 0; --bit)
  {
    const std::uint32_t lower = (1u << bit) - 1;
    for (std::uint32_t& axis : x)
    {
      // The lower bits of the first axis are inverted where the bit is set, else exchanged with this one's.
      const std::uint32_t inverted = axis >> bit & 1u ? lower : 0u;
      const std::uint32_t exchanged = (x[0] ^ axis) & (inverted ^ lower);
      x[0] ^= exchanged ^ inverted;
      axis ^= exchanged;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flips = 0;
  for (int bit = bits - 1; bit > 0; --bit)
  {
    flips ^= x[2] >> bit & 1u ? (1u << bit) - 1 : 0u;
  }
  std::uint32_t key = 0;
  for (const std::uint32_t axis : x)
  {
    key = key << 1 | spread(axis ^ flips);
  }
  return key;
}

// The cell of a place along one axis.
std::uint32_t cellOf(float x)
{
  return static_cast<std::uint32_t>(std::clamp(512.0f * (x + 1.0f), 0.0f, 1023.0f));
}

} // namespace

CurveOrder curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context)
{
  struct Entry
  {
    std::uint32_t key;
    int index;
  };
  const int count = static_cast<int>(points.size());
  std::vector<Entry> entries(points.size()), sorted(points.size());
  context.each(count,
    [&](int i)
    {
      const std::array<float, 4>& p = points[i];
      entries[i] = { curveKey({ cellOf(p[0]), cellOf(p[1]), cellOf(p[2]) }), i };
    });
  // Stable, digit by digit: serial, yet a small part of what the order saves.
  for (int shift = 0; shift < 3 * bits; shift += bits)
  {
    std::array<int, (1 << bits) + 1> starts{};
    const auto digit = [shift](const Entry& e) { return (e.key >> shift) & ((1u << bits) - 1); };
    for (const Entry& entry : entries)
    {
      ++starts[digit(entry) + 1];
    }
    for (int i = 0; i < 1 << bits; ++i)
    {
      starts[i + 1] += starts[i];
    }
    for (const Entry& entry : entries)
    {
      sorted[starts[digit(entry)]++] = entry;
    }
    entries.swap(sorted);
  }
  CurveOrder order{ std::vector<int>(points.size()), std::vector<std::uint32_t>(points.size()) };
  for (int i = 0; i < count; ++i)
  {
    order.indices[i] = entries[i].index;
    order.cells[i] = entries[i].key;
  }
  return order;
}

void RayScene::findPlaces(const std::vector<std::uint32_t>& cells)
{
  std::iota(this->places.begin(), this->places.end(), 0);
  // Vertices at one place lie in one cell of the curve.
  std::vector<int> cell;
  for (std::size_t first = 0, last = 0; first < cells.size(); first = last)
  {
    while (last < cells.size() && cells[last] == cells[first])
    {
      ++last;
    }
    if (last - first > 1)
    {
      cell.assign(this->order.begin() + static_cast<std::ptrdiff_t>(first),
        this->order.begin() + static_cast<std::ptrdiff_t>(last));
      std::sort(cell.begin(),
        cell.end(),
        [this](int a, int b)
        { return this->points[a] != this->points[b] ? this->points[a] < this->points[b] : a < b; });
      for (std::size_t i = 1; i < cell.size(); ++i)
      {
        if (this->points[cell[i]] == this->points[cell[i - 1]])
        {
          this->places[cell[i]] = this->places[cell[i - 1]];
        }
      }
    }
  }
}

namespace
{

// The roundest number within [low, high], which holds a multiple of `step`, a power of two: zero, or a
// multiple of the largest power of two.
double roundest(double low, double high, double step)
{
  if (low <= 0.0 && high >= 0.0)
  {
    return 0.0;
  }
  int exponent;
  std::frexp(low > 0.0 ? high : -low, &exponent);
  for (double coarse = std::ldexp(1.0, exponent - 1); coarse > step; coarse *= 0.5)
  {
    if (std::ceil(low / coarse) * coarse <= high)
    {
      return std::ceil(low / coarse) * coarse;
    }
  }
  return std::ceil(low / step) * step;
}

} // namespace

RayFrame::RayFrame(const Mesh& mesh)
{
  if (mesh.points.empty())
  {
    return;
  }
  const Eigen::AlignedBox3d box = boxRound(mesh.points);
  const Vector3 &low = box.min(), &high = box.max();
  const double half = (0.5 * high - 0.5 * low).maxCoeff();
  if (half > 0.0)
  {
    int exponent; // with room for a round centre
    std::frexp(1.125 * half, &exponent);
    this->scale = std::ldexp(1.0, std::min(exponent, std::numeric_limits<double>::max_exponent - 1));
  }
  for (int k = 0; k < 3; ++k)
  {
    this->centre[k] = roundest(high[k] - this->scale, low[k] + this->scale, 0.125 * this->scale);
  }
}

RayScene::RayScene(const Mesh& mesh, const RayFrame& within, const Context& context)
  : points(mesh.points.size())
  , places(mesh.points.size())
  , facets(mesh.triangles.size())
  , frame(within)
{
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      const Eigen::Vector3f q = within.inScene(mesh.points[v]).cast<float>();
      this->points[v] = { q[0], q[1], q[2], 0.0f };
    });
  CurveOrder along = curveOrder(this->points, context);
  this->order = std::move(along.indices);
  this->findPlaces(along.cells);
  context.each(mesh.triangleCount(),
    [&](int i)
    {
      const Triangle& t = mesh.triangles[i];
      RayFacet& facet = this->facets[i];
      const Vector3 a = within.inScene(mesh.points[t[0]]);
      // In the unit of the scene: the cross product of tiny edges would otherwise underflow.
      facet.plane = ((mesh.points[t[1]] - mesh.points[t[0]]) / within.scale)
                      .cross((mesh.points[t[2]] - mesh.points[t[0]]) / within.scale);
      facet.offset = facet.plane.dot(a);
      const Eigen::Vector3f n = facet.plane.stableNormalized().cast<float>();
      facet.normal = { n[0], n[1], n[2] };
      facet.places = { this->places[t[0]], this->places[t[1]], this->places[t[2]] };
    });
}

} // namespace oversketch
