#include "Ray/ray_caster.h"

#include <algorithm>
#include <numeric>

namespace oversketch
{

RayScene::RayScene(const Mesh& mesh)
  : places(mesh.points.size())
  , triangles(mesh.triangles)
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
  const Vector3 centre = 0.5 * low + 0.5 * high;
  this->scale = (0.5 * high - 0.5 * low).maxCoeff();
  if (!(this->scale > 0.0))
  {
    this->scale = 1.0;
  }
  this->points.reserve(mesh.points.size());
  for (const Vector3& p : mesh.points)
  {
    const Eigen::Vector3f q = ((p - centre) / this->scale).cast<float>();
    this->points.push_back({ q[0], q[1], q[2], 0.0f });
  }
  std::iota(this->places.begin(), this->places.end(), 0);
  std::vector<int> order = this->places;
  std::sort(order.begin(),
    order.end(),
    [this](int a, int b)
    { return this->points[a] != this->points[b] ? this->points[a] < this->points[b] : a < b; });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (this->points[order[i]] == this->points[order[i - 1]])
    {
      this->places[order[i]] = this->places[order[i - 1]];
    }
  }
  for (Triangle& t : this->triangles)
  {
    t = { this->places[t[0]], this->places[t[1]], this->places[t[2]] };
  }
  this->normals.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
  {
    // In the unit of the scene: the cross product of tiny edges would otherwise underflow.
    const Vector3 a = (mesh.points[t[1]] - mesh.points[t[0]]) / this->scale;
    const Vector3 b = (mesh.points[t[2]] - mesh.points[t[0]]) / this->scale;
    const Eigen::Vector3f n = a.cross(b).stableNormalized().cast<float>();
    this->normals.push_back({ n[0], n[1], n[2], 0.0f });
  }
}

} // namespace oversketch
