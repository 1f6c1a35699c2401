#include "Ray/curve.h"
#include "Ray/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace oversketch
{

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
  Vector3 low = mesh.points[0];
  Vector3 high = mesh.points[0];
  for (const Vector3& p : mesh.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
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
  context.parallelFor(mesh.vertexCount(),
    [&](int begin, int end)
    {
      for (int v = begin; v < end; ++v)
      {
        const Eigen::Vector3f q = this->inScene(mesh.points[v]).cast<float>();
        this->points[v] = { q[0], q[1], q[2], 0.0f };
      }
    });
  CurveOrder along = curveOrder(this->points, context);
  this->order = std::move(along.indices);
  this->findPlaces(along.cells);
  context.parallelFor(mesh.triangleCount(),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Triangle& t = mesh.triangles[i];
        RayFacet& facet = this->facets[i];
        const Vector3 a = this->inScene(mesh.points[t[0]]);
        // In the unit of the scene: the cross product of tiny edges would otherwise underflow.
        facet.plane = ((mesh.points[t[1]] - mesh.points[t[0]]) / within.scale)
                        .cross((mesh.points[t[2]] - mesh.points[t[0]]) / within.scale);
        facet.offset = facet.plane.dot(a);
        const Eigen::Vector3f n = facet.plane.stableNormalized().cast<float>();
        facet.normal = { n[0], n[1], n[2] };
        facet.places = { this->places[t[0]], this->places[t[1]], this->places[t[2]] };
      }
    });
}

} // namespace oversketch
