// Meshes with known answers, and views of them, for tests of kernels and filters. Header-only.
#ifndef oversketch_testing_harness_shapes_h
#define oversketch_testing_harness_shapes_h

#include "Mesh/mesh.h"
#include "Mesh/view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <string>

namespace oversketch_test
{
using namespace oversketch;

constexpr double pi = 3.14159265358979323846;

// Reports the figure that a fact's test reached: one line "FACT A3_2 | text" that Testing/facts.py collects.
inline void fact(const std::string& name, const std::string& figure)
{
  std::cout << "FACT " << name << " | " << figure << std::endl;
}

// Sphere of 20 * 4^levels triangles (levels 4: 2562 vertices), outward orientation.
inline Mesh icosphere(int levels, double radius = 1.0)
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  // clang-format off
  Mesh m{ { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
            { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } },
    { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
      { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 },
      { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } } };
  // clang-format on
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<int, int>, int> middle;
    const auto mid = [&](int a, int b)
    {
      const auto it = middle.emplace(std::minmax(a, b), m.vertexCount());
      if (it.second)
      {
        m.points.push_back((m.points[a] + m.points[b]) / 2.0);
      }
      return it.first->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : m.triangles)
    {
      const int a = mid(t[0], t[1]), b = mid(t[1], t[2]), c = mid(t[2], t[0]);
      finer.insert(finer.end(), { { t[0], a, c }, { t[1], b, a }, { t[2], c, b }, { a, b, c } });
    }
    m.triangles = finer;
    for (Vector3& p : m.points)
    {
      p.normalize();
    }
  }
  for (Vector3& p : m.points)
  {
    p *= radius / p.norm();
  }
  return m;
}

// Box from one corner to another, twelve faces.
inline Mesh box(const Vector3& low, const Vector3& high)
{
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.points.emplace_back(
      (corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1], (corner & 4 ? high : low)[2]);
  }
  // clang-format off
  mesh.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  // clang-format on
  return mesh;
}

// Grid of nu x nv quads mapped by position(u, v), u and v in [0, 1), each quad two triangles; wraps where
// asked.
inline Mesh gridSurface(int nu,
  int nv,
  bool wrapU,
  bool wrapV,
  const std::function<Vector3(double, double)>& position)
{
  Mesh m;
  const int cu = wrapU ? nu : nu + 1, cv = wrapV ? nv : nv + 1;
  for (int j = 0; j < cv; ++j)
    for (int i = 0; i < cu; ++i)
      m.points.push_back(position(double(i) / nu, double(j) / nv));
  const auto id = [&](int i, int j) { return (j % cv) * cu + i % cu; };
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i)
    {
      m.triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      m.triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  return m;
}

// Torus around the z axis: main radius R, tube radius r; u around the axis, v around the tube.
inline Mesh torus(double R, double r, int nu, int nv)
{
  return gridSurface(nu,
    nv,
    true,
    true,
    [=](double u, double v)
    {
      const double a = 2 * pi * u, b = 2 * pi * v;
      return Vector3(
        (R + r * std::cos(b)) * std::cos(a), (R + r * std::cos(b)) * std::sin(a), r * std::sin(b));
    });
}

// Open cylinder around the z axis from z = 0 to length.
inline Mesh cylinder(double radius, double length, int around, int along)
{
  return gridSurface(around,
    along,
    true,
    false,
    [=](double u, double v)
    { return Vector3(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), length * v); });
}

// Capsule round the x axis, its straight part from -half to half: `along` quads long, with one point at each
// end.
inline Mesh capsule(double radius, double half, int around, int along)
{
  const int cap = around / 4;
  std::vector<Vector2> outline; // x, distance from the axis
  for (int i = 1; i < cap; ++i)
    outline.emplace_back(
      -half - radius * std::cos(0.5 * pi * i / cap), radius * std::sin(0.5 * pi * i / cap));
  for (int i = 0; i <= along; ++i)
    outline.emplace_back(half * (2.0 * i / along - 1.0), radius);
  for (int i = cap - 1; i > 0; --i)
    outline.emplace_back(half + radius * std::cos(0.5 * pi * i / cap), radius * std::sin(0.5 * pi * i / cap));
  const int rings = static_cast<int>(outline.size());
  Mesh m = gridSurface(around,
    rings - 1,
    true,
    false,
    [&](double u, double v)
    {
      const Vector2& p = outline[static_cast<std::size_t>(std::lround(v * (rings - 1)))];
      return Vector3(p[0], p[1] * std::cos(2 * pi * u), p[1] * std::sin(2 * pi * u));
    });
  const int first = m.vertexCount(), last = first + 1, end = around * (rings - 1);
  m.points.emplace_back(-half - radius, 0, 0);
  m.points.emplace_back(half + radius, 0, 0);
  for (int i = 0; i < around; ++i)
  {
    m.triangles.push_back({ first, (i + 1) % around, i });
    m.triangles.push_back({ last, end + i, end + (i + 1) % around });
  }
  return m;
}

// Orthographic view from direction `from` (the viewer is at +infinity * from), `up` on screen, `pixels` per
// unit of length, the world origin at the middle of the picture.
inline View orthographicView(const Vector3& from,
  const Vector3& up,
  double pixels,
  int width = 800,
  int height = 600)
{
  const Vector3 z = from.normalized(), x = up.cross(z).normalized(), y = z.cross(x);
  Eigen::Matrix4d v = Eigen::Matrix4d::Identity();
  v.row(0).head<3>() = x;
  v.row(1).head<3>() = y;
  v.row(2).head<3>() = z;
  v(2, 3) = -100.0;
  Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
  p(0, 0) = 2.0 * pixels / width;
  p(1, 1) = 2.0 * pixels / height;
  p(2, 2) = -0.01;
  return View(v, p, width, height);
}

// Perspective view from `eye` towards the origin; vertical view angle in degrees.
inline View perspectiveView(const Vector3& eye,
  const Vector3& up,
  double angle,
  int width = 800,
  int height = 600)
{
  const Vector3 z = eye.normalized(), x = up.cross(z).normalized(), y = z.cross(x);
  Eigen::Matrix4d v = Eigen::Matrix4d::Identity();
  v.row(0) << x.transpose(), -x.dot(eye);
  v.row(1) << y.transpose(), -y.dot(eye);
  v.row(2) << z.transpose(), -z.dot(eye);
  const double f = 1.0 / std::tan(angle * pi / 360.0), n = 0.1, far = 1000.0;
  Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
  p(0, 0) = f * height / width;
  p(1, 1) = f;
  p(2, 2) = -(far + n) / (far - n);
  p(2, 3) = -2.0 * far * n / (far - n);
  p(3, 2) = -1.0;
  return View(v, p, width, height);
}

// Two meshes side by side.
inline Mesh joined(const Mesh& a, const Mesh& b, const Vector3& shift)
{
  Mesh m = a;
  for (const Vector3& p : b.points)
    m.points.push_back(p + shift);
  for (const Triangle& t : b.triangles)
    m.triangles.push_back({ t[0] + a.vertexCount(), t[1] + a.vertexCount(), t[2] + a.vertexCount() });
  return m;
}

// Of a triangle, and of all of a mesh [degrees].
inline double smallestAngle(const Mesh& mesh, const Triangle& t)
{
  double smallest = pi;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
    const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
    smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return smallest * 180.0 / pi;
}

inline double smallestAngle(const Mesh& mesh)
{
  double smallest = 60.0;
  for (const Triangle& t : mesh.triangles)
  {
    smallest = std::min(smallest, smallestAngle(mesh, t));
  }
  return smallest;
}

} // namespace oversketch_test
#endif
