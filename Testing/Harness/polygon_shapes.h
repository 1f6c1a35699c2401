// Drawings of one closed stroke whose coarse mesh is its polygon, for tests of refinement. Header-only.
#ifndef oversketch_testing_harness_polygon_shapes_h
#define oversketch_testing_harness_polygon_shapes_h

#include "Harness/refine_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace oversketch_test
{

// Triangles of a simple polygon, counter-clockwise, by cutting the best-shaped ear off again and again.
inline std::vector<std::array<int, 3>> earClipping(const oversketch::Polyline& polygon)
{
  using oversketch::signedArea;
  std::vector<int> left(polygon.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] = static_cast<int>(i);
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 2)
  {
    const int count = static_cast<int>(left.size());
    int best = -1;
    double quality = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const oversketch::Vector2 &a = polygon[left[(i + count - 1) % count]], &b = polygon[left[i]],
                                &c = polygon[left[(i + 1) % count]];
      const double area = signedArea(a, b, c);
      const double q = area / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
      const bool empty = std::none_of(left.begin(),
        left.end(),
        [&](int other)
        {
          const oversketch::Vector2& p = polygon[other];
          return p != a && p != b && p != c && signedArea(a, b, p) >= 0.0 && signedArea(b, c, p) >= 0.0 &&
                 signedArea(c, a, p) >= 0.0;
        });
      if (area > 0.0 && empty && q > quality)
      {
        best = i;
        quality = q;
      }
    }
    if (best < 0)
    {
      return {};
    }
    triangles.push_back({ left[(best + count - 1) % count], left[best], left[(best + 1) % count] });
    left.erase(left.begin() + best);
  }
  return triangles;
}

// r = 0.3 (1 + a cos(n theta)) round (0.5, 0.5), samples some 0.005 apart.
inline oversketch::DrawnStroke starStroke(double a, int n)
{
  oversketch::Polyline points;
  double theta = 0.0;
  while (theta < turn - 1e-3)
  {
    const double r = 0.3 * (1.0 + a * std::cos(n * theta));
    points.emplace_back(0.5 + r * std::cos(theta), 0.5 + r * std::sin(theta));
    theta += 0.005 / std::hypot(r, 0.3 * a * n * std::sin(n * theta));
  }
  return closedStroke(points);
}

// A drawing of one closed stroke with these samples for base vertices; without faces where they cross.
inline CoarseDrawing polygonDrawing(const oversketch::DrawnStroke& stroke, const std::vector<int>& samples)
{
  CoarseDrawing made;
  made.strokes.push_back(stroke);
  made.tie(samples, oversketch::BoundaryKind::Object);
  oversketch::Polyline polygon;
  for (const int s : samples)
    polygon.push_back(stroke.points[s]);
  for (const std::array<int, 3>& t : earClipping(polygon))
  {
    made.addFace({ t[0], t[1], t[2], -1 });
  }
  return made;
}

} // namespace oversketch_test
#endif
