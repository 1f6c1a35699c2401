#include "Remesh/motion.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

using Matrix3 = Eigen::Matrix3d;

// How the displacement changes from a vertex on along the surface.
Matrix3 slopeAt(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Vector3& normal,
  int v)
{
  Matrix3 squares = Matrix3::Zero(), products = Matrix3::Zero();
  const Vector3 own = moved[v] - rest.points[v];
  for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
  {
    const Vector3 edge = rest.points[*n] - rest.points[v];
    const Vector3 along = edge - normal * normal.dot(edge);
    const Vector3 change = moved[*n] - rest.points[*n] - own;
    squares += along * along.transpose();
    products += change * along.transpose();
  }
  // Across the surface nothing is known, and nothing changes.
  squares += 0.5 * squares.trace() * normal * normal.transpose();
  Matrix3 inverse;
  bool isInvertible = false;
  squares.computeInverseWithCheck(inverse, isInvertible, 1e-12 * std::pow(squares.trace(), 3));
  return isInvertible ? Matrix3(products * inverse) : Matrix3::Zero();
}

} // namespace

Motion motionBetween(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Context& context)
{
  constexpr std::size_t channels = 15;
  Motion motion;
  motion.channels = channels;
  motion.values.resize(channels * rest.points.size(), 0.0);
  // Elsewhere there is no displacement, and no slope of it.
  std::vector<char> concerned(rest.points.size(), 0);
  for (int v = 0; v < rest.vertexCount(); ++v)
  {
    if (moved[v] != rest.points[v])
    {
      concerned[v] = 1;
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        concerned[*n] = 1;
      }
    }
  }
  context.parallelFor(rest.vertexCount(),
    [&](int begin, int end)
    {
      for (int v = begin; v < end; ++v)
      {
        if (!concerned[v])
        {
          continue;
        }
        double* values = motion.values.data() + channels * static_cast<std::size_t>(v);
        const Vector3 own = moved[v] - rest.points[v];
        const Matrix3 slope =
          slopeAt(rest, adjacency, moved, vertexNormal(rest, adjacency.vertexTriangles, v), v);
        const Vector3 atOrigin = own - slope * rest.points[v];
        std::copy_n(own.data(), 3, values);
        std::copy_n(atOrigin.data(), 3, values + 3);
        std::copy_n(slope.data(), 9, values + 6);
      }
    });
  motion.movement = [](const std::vector<Vector3>& points, const std::vector<double>& values)
  {
    std::vector<Vector3> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double* at = values.data() + channels * i;
      const Eigen::Map<const Vector3> flat(at), atOrigin(at + 3);
      const Eigen::Map<const Matrix3> slope(at + 6);
      const Vector3 expected = atOrigin + slope * points[i];
      result.emplace_back(points[i] + 0.5 * flat + 0.5 * expected);
    }
    return result;
  };
  return motion;
}

} // namespace oversketch
