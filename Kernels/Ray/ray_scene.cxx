#include "Ray/curve.h"
#include "Ray/ray_caster.h"

#include <algorithm>
#include <numeric>

namespace oversketch
{

void RayScene::findPlaces()
{
  std::iota(this->places.begin(), this->places.end(), 0);
  // Vertices at one place lie in one cell of the curve.
  const auto sameCell = [this](int a, int b)
  { return curveCell(this->points[a]) == curveCell(this->points[b]); };
  std::vector<int> cell;
  for (auto begin = this->order.begin(); begin != this->order.end();)
  {
    const auto end =
      std::find_if_not(begin + 1, this->order.end(), [&](int v) { return sameCell(*begin, v); });
    if (end - begin > 1)
    {
      cell.assign(begin, end);
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
    begin = end;
  }
}

RayScene::RayScene(const Mesh& mesh, const Context& context)
  : points(mesh.points.size())
  , places(mesh.points.size())
  , facets(mesh.triangles.size())
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
  this->centre = 0.5 * low + 0.5 * high;
  this->scale = (0.5 * high - 0.5 * low).maxCoeff();
  if (!(this->scale > 0.0))
  {
    this->scale = 1.0;
  }
  context.parallelFor(mesh.vertexCount(),
    [&](int begin, int end)
    {
      for (int v = begin; v < end; ++v)
      {
        const Eigen::Vector3f q = this->inScene(mesh.points[v]).cast<float>();
        this->points[v] = { q[0], q[1], q[2], 0.0f };
      }
    });
  this->order = curveOrder(this->points, context);
  this->findPlaces();
  context.parallelFor(mesh.triangleCount(),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Triangle& t = mesh.triangles[i];
        RayFacet& facet = this->facets[i];
        const Vector3 a = this->inScene(mesh.points[t[0]]);
        // In the unit of the scene: the cross product of tiny edges would otherwise underflow.
        facet.plane = ((mesh.points[t[1]] - mesh.points[t[0]]) / this->scale)
                        .cross((mesh.points[t[2]] - mesh.points[t[0]]) / this->scale);
        facet.offset = facet.plane.dot(a);
        const Eigen::Vector3f n = facet.plane.stableNormalized().cast<float>();
        facet.normal = { n[0], n[1], n[2] };
        facet.places = { this->places[t[0]], this->places[t[1]], this->places[t[2]] };
      }
    });
}

} // namespace oversketch
