// Patches with known answers, for tests. Header-only.
#ifndef oversketch_testing_harness_patches_h
#define oversketch_testing_harness_patches_h

#include "Harness/shapes.h"

#include <algorithm>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace oversketch_test
{

// The triangles whose corners all are where `inside` says, with their vertices numbered anew.
inline Mesh patchOf(const Mesh& mesh, const std::function<bool(const Vector3&)>& inside)
{
  Mesh patch;
  std::vector<int> number(mesh.points.size(), -1);
  for (const Triangle& t : mesh.triangles)
  {
    if (inside(mesh.points[t[0]]) && inside(mesh.points[t[1]]) && inside(mesh.points[t[2]]))
    {
      Triangle& mine = patch.triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        if (number[t[k]] < 0)
        {
          number[t[k]] = patch.vertexCount();
          patch.points.push_back(mesh.points[t[k]]);
        }
        mine[k] = number[t[k]];
      }
    }
  }
  return patch;
}

inline Mesh cap(int levels, double height = 0.5)
{
  return patchOf(icosphere(levels), [=](const Vector3& p) { return p[2] > height; });
}

// A limb's tip: a sphere drawn out, above its middle.
inline Mesh limb(int levels, double length)
{
  Mesh mesh = patchOf(icosphere(levels), [](const Vector3& p) { return p[2] > -0.2; });
  for (Vector3& p : mesh.points)
  {
    p[2] *= p[2] > 0.0 ? length : 1.0;
  }
  return mesh;
}

// A patch with its reference curve.
struct Drawn
{
  Mesh patch;
  std::vector<int> reference;
};

// |x| <= 10, |y| <= 1, the curve on y = 0, |x| <= 8.
inline Drawn strip(int along, int across)
{
  Drawn drawn{ gridSurface(along,
                 across,
                 false,
                 false,
                 [](double u, double v) { return Vector3(20.0 * u - 10.0, 2.0 * v - 1.0, 0.0); }),
    {} };
  for (int i = along / 10; i <= along - along / 10; ++i)
  {
    drawn.reference.push_back(across / 2 * (along + 1) + i);
  }
  return drawn;
}

// A hill of side x side quads with uneven triangles, an S over its top.
inline Drawn hill(int side)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-0.25, 0.25);
  Drawn drawn;
  drawn.patch = gridSurface(side,
    side,
    false,
    false,
    [&](double u, double v)
    {
      const double x = 2.0 * u - 1.0 + 2.0 * value(random) / side,
                   y = 2.0 * v - 1.0 + 2.0 * value(random) / side;
      return Vector3(x, y, 0.8 * std::exp(-2.0 * (x * x + y * y)));
    });
  const int margin = side / 4;
  for (int i = margin; i <= side - margin; ++i)
  {
    drawn.reference.push_back(side / 2 * (side + 1) + i);
  }
  return drawn;
}

// Three quarters of a circle on a sphere of 20,000 triangles, down to 100 degrees from the pole.
inline Drawn hook()
{
  const int rings = 50, sectors = 200;
  Drawn drawn;
  drawn.patch.points.emplace_back(0, 0, 1);
  for (int r = 1; r <= rings; ++r)
  {
    const double down = r * 100.0 / rings * pi / 180.0;
    for (int s = 0; s < sectors; ++s)
    {
      const double round = 2.0 * pi * s / sectors;
      drawn.patch.points.emplace_back(
        std::sin(down) * std::cos(round), std::sin(down) * std::sin(round), std::cos(down));
    }
  }
  const auto id = [=](int r, int s) { return r == 0 ? 0 : 1 + (r - 1) * sectors + s % sectors; };
  for (int r = 0; r < rings; ++r)
  {
    for (int s = 0; s < sectors; ++s)
    {
      drawn.patch.triangles.push_back({ id(r, s), id(r + 1, s), id(r + 1, s + 1) });
      if (r > 0)
      {
        drawn.patch.triangles.push_back({ id(r, s), id(r + 1, s + 1), id(r, s + 1) });
      }
    }
  }
  for (int s = 0; s <= 3 * sectors / 4; ++s)
  {
    drawn.reference.push_back(id(rings / 2, s));
  }
  return drawn;
}

// Of a value, how steeply it rises from an edge into a triangle; and its gradient.
inline Vector3 gradient(const Mesh& mesh, const Triangle& t, const std::vector<double>& w)
{
  const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  const Vector3 n = (b - a).cross(c - a);
  return (w[t[0]] * n.cross(c - b) + w[t[1]] * n.cross(a - c) + w[t[2]] * n.cross(b - a)) / n.squaredNorm();
}

// Medians of the slope's jump over the edges of both curves, over the mean slope of the patch.
inline std::pair<double, double> slopeJumps(const Drawn& drawn, const std::vector<double>& w)
{
  const Adjacency adjacency = buildAdjacency(drawn.patch);
  double slope = 0.0, area = 0.0;
  for (const Triangle& t : drawn.patch.triangles)
  {
    const std::vector<Vector3>& p = drawn.patch.points;
    const double a = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
    slope += a * gradient(drawn.patch, t, w).norm();
    area += a;
  }
  const auto jump = [&](int edge)
  {
    const MeshEdge& e = adjacency.edges[edge];
    double sum = 0.0;
    for (const int* t = adjacency.trianglesBegin(edge); t != adjacency.trianglesEnd(edge); ++t)
    {
      const Triangle& c = drawn.patch.triangles[*t];
      const int v = c[0] != e.v0 && c[0] != e.v1 ? c[0] : c[1] != e.v0 && c[1] != e.v1 ? c[1] : c[2];
      const Vector3 along = (drawn.patch.points[e.v1] - drawn.patch.points[e.v0]).normalized();
      const Vector3 away = drawn.patch.points[v] - drawn.patch.points[e.v0];
      sum += gradient(drawn.patch, c, w).dot((away - away.dot(along) * along).normalized());
    }
    return std::abs(sum) / (slope / area);
  };
  std::vector<double> inner, outer;
  for (std::size_t i = 1; i < drawn.reference.size(); ++i)
  {
    inner.push_back(jump(adjacency.findEdge(drawn.reference[i - 1], drawn.reference[i])));
  }
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    if (adjacency.edges[e].triangleCount == 1)
    {
      outer.push_back(jump(e));
    }
  }
  std::sort(inner.begin(), inner.end());
  std::sort(outer.begin(), outer.end());
  return { inner[inner.size() / 2], outer[outer.size() / 2] };
}

inline double largestStep(const Drawn& drawn, const std::vector<double>& values)
{
  double largest = 0.0;
  for (const MeshEdge& e : buildAdjacency(drawn.patch).edges)
  {
    largest = std::max(largest, std::abs(values[e.v0] - values[e.v1]));
  }
  return largest;
}

} // namespace oversketch_test
#endif
