#include "Mesh/roughness.h"

#include <cmath>

namespace oversketch
{

namespace
{

constexpr double degrees = 180.0 / 3.14159265358979323846;

} // namespace

bool rougher(const Roughness& one, const Roughness& other)
{
  return one.meanAngle > 1.25 * other.meanAngle + 1.0 || one.sharpShare > other.sharpShare + 0.01;
}

Roughness roughness(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& region,
  const Context& context)
{
  std::vector<int> edges;
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    if (edge.triangleCount == 2 && (region[edge.v0] || region[edge.v1]))
    {
      edges.push_back(e);
    }
  }
  struct Fold
  {
    double angle = -1.0; // degrees, -1: a triangle has no area
    double length = 0.0;
  };
  std::vector<Vector3> normals(mesh.triangles.size());
  context.each(mesh.triangleCount(), [&](int t) { normals[t] = facetNormal(mesh, t); });
  std::vector<Fold> folds(edges.size());
  context.each(static_cast<int>(edges.size()),
    [&](int i)
    {
      const MeshEdge& edge = adjacency.edges[edges[i]];
      const int* sides = adjacency.trianglesBegin(edges[i]);
      const Vector3& first = normals[sides[0]];
      Vector3 second = normals[sides[1]];
      if (first.isZero(0.0) || second.isZero(0.0))
      {
        return;
      }
      if (runsAlong(mesh.triangles[sides[0]], edge.v0, edge.v1) ==
          runsAlong(mesh.triangles[sides[1]], edge.v0, edge.v1))
      {
        second = -second;
      }
      // Exact for small angles too, where the arc cosine is not.
      folds[i] = { degrees * std::atan2(first.cross(second).norm(), first.dot(second)),
        (mesh.points[edge.v1] - mesh.points[edge.v0]).norm() };
    });
  double angles = 0.0, lengths = 0.0, sharp = 0.0;
  int count = 0;
  for (const Fold& fold : folds)
  {
    if (fold.angle >= 0.0)
    {
      angles += fold.angle;
      lengths += fold.length;
      sharp += fold.angle > sharpAngle ? fold.length : 0.0;
      ++count;
    }
  }
  return { count > 0 ? angles / count : 0.0, lengths > 0.0 ? sharp / lengths : 0.0 };
}

} // namespace oversketch
