// Drawings with coarse meshes made by hand, for tests of their refinement. Header-only.
#ifndef oversketch_testing_harness_refine_shapes_h
#define oversketch_testing_harness_refine_shapes_h

#include "Harness/drawing_shapes.h"
#include "Mesh/shape.h"
#include "Planar/face_edges.h"
#include "Planar/refine.h"

#include <array>
#include <random>

namespace oversketch_test
{

struct CoarseDrawing
{
  std::vector<oversketch::DrawnStroke> strokes;
  oversketch::PlanarMesh mesh;

  int addPoint(const oversketch::Vector2& place)
  {
    oversketch::PlanarPoint point;
    point.place = place;
    point.isBase = true;
    this->mesh.points.push_back(point);
    return static_cast<int>(this->mesh.points.size()) - 1;
  }

  void addFace(std::array<int, 4> corners)
  {
    oversketch::PlanarFace face;
    face.corners = corners;
    face.region = face.object = 0;
    face.base = static_cast<int>(this->mesh.faces.size());
    this->mesh.faces.push_back(face);
  }

  // The last stroke's samples of these numbers, as points and edges on it, for those that are no points yet.
  std::vector<int> tie(const std::vector<int>& samples, oversketch::BoundaryKind kind)
  {
    std::vector<int> points;
    points.reserve(samples.size());
    for (const int s : samples)
    {
      points.push_back(this->addPoint(this->strokes.back().points[s]));
    }
    this->tieTo(points, samples, kind);
    return points;
  }

  // Makes the points lie on the last stroke.
  void tieTo(const std::vector<int>& points, const std::vector<int>& samples, oversketch::BoundaryKind kind)
  {
    const oversketch::DrawnStroke& stroke = this->strokes.back();
    const std::vector<double> lengths = oversketch::arcLengths(stroke.points, stroke.closed);
    const int number = static_cast<int>(this->strokes.size()) - 1, count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i)
    {
      oversketch::PlanarPoint& point = this->mesh.points[points[i]];
      point.stroke = number;
      point.kind = kind;
      point.param = lengths[samples[i]];
      if (i + 1 < count)
      {
        this->mesh.edges.push_back(
          { points[i], points[i + 1], number, lengths[samples[i]], lengths[samples[i + 1]] });
      }
      else if (stroke.closed)
      {
        this->mesh.edges.push_back(
          { points[i], points[0], number, lengths[samples[i]], lengths.back() + lengths[samples[0]] });
      }
    }
  }
};

inline double areaOf(const oversketch::PlanarMesh& mesh)
{
  double area = 0.0;
  for (const oversketch::PlanarFace& face : mesh.faces)
  {
    for (int i = 1; i + 1 < face.count(); ++i)
    {
      area += oversketch::signedArea(mesh.points[face.corners[0]].place,
        mesh.points[face.corners[i]].place,
        mesh.points[face.corners[i + 1]].place);
    }
  }
  return area;
}

// A closed stroke through these points, `steps` samples from each to the next.
inline oversketch::DrawnStroke outlineThrough(const oversketch::Polyline& corners, int steps)
{
  oversketch::Polyline points;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (int s = 0; s < steps; ++s)
    {
      points.push_back(
        corners[i] + static_cast<double>(s) / steps * (corners[(i + 1) % corners.size()] - corners[i]));
    }
  }
  return closedStroke(points);
}

// A square of side 0.5 round its middle, as the triangulation has it.
inline CoarseDrawing squareDrawing()
{
  CoarseDrawing made;
  made.strokes.push_back(
    outlineThrough({ { 0.25, 0.25 }, { 0.75, 0.25 }, { 0.75, 0.75 }, { 0.25, 0.75 } }, 64));
  const std::vector<int> rim = made.tie({ 0, 64, 128, 192 }, oversketch::BoundaryKind::Object);
  const int centre = made.addPoint({ 0.5, 0.5 });
  for (int i = 0; i < 4; ++i)
  {
    made.addFace({ rim[i], rim[(i + 1) % 4], centre, -1 });
  }
  return made;
}

// A disc, a fan of 8; its first sample, `first` of 8 * 32, is no base vertex unless that is a multiple of 32.
inline CoarseDrawing discDrawing(double radius, int first = 0)
{
  CoarseDrawing made;
  made.strokes.push_back(closedStroke(ringAt(0.5, 0.5, radius, 256)));
  std::vector<int> samples(8);
  for (int i = 0; i < 8; ++i)
  {
    samples[i] = first + 32 * i;
  }
  const std::vector<int> rim = made.tie(samples, oversketch::BoundaryKind::Object);
  const int centre = made.addPoint({ 0.5, 0.5 });
  for (int i = 0; i < 8; ++i)
  {
    made.addFace({ rim[i], rim[(i + 1) % 8], centre, -1 });
  }
  return made;
}

// A square with a bow in it, off its centre, as an open feature of two edges that it leaves by up to 0.8
// waves.
inline CoarseDrawing bowDrawing(double wave = 0.015)
{
  CoarseDrawing made;
  made.strokes.push_back(outlineThrough({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, 50));
  const std::vector<int> rim = made.tie({ 0, 50, 100, 150 }, oversketch::BoundaryKind::Object);
  oversketch::Polyline bow;
  for (int i = 0; i <= 40; ++i)
  {
    const double t = i / 40.0;
    bow.emplace_back(0.3 + 0.4 * t, 0.4 + wave * std::sin(turn * t) + 0.03 * std::sin(0.5 * turn * t));
  }
  made.strokes.push_back(openStroke(bow));
  const std::vector<int> feature = made.tie({ 0, 20, 40 }, oversketch::BoundaryKind::Feature);
  const int a = rim[0], b = rim[1], c = rim[2], d = rim[3], p = feature[0], q = feature[1], r = feature[2];
  for (const std::array<int, 3>& t : std::vector<std::array<int, 3>>{ { a, q, p },
         { a, b, q },
         { b, r, q },
         { a, p, d },
         { b, c, r },
         { p, q, d },
         { q, c, d },
         { q, r, c } })
  {
    made.addFace({ t[0], t[1], t[2], -1 });
  }
  return made;
}

enum class Cells
{
  Triangles,
  Quads,
  Mixed
};

// A square of n x n cells, shaken, with its outline a stroke, and a row of its grid another when asked for.
inline CoarseDrawing gridDrawing(int n, Cells cells, bool feature, unsigned seed)
{
  CoarseDrawing made;
  std::mt19937 random(seed);
  const auto shake = [&] { return (static_cast<double>(random()) / 4294967296.0 - 0.5) * 0.4 / n; };
  std::vector<int> outline, row;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const bool rim = i == 0 || j == 0 || i == n || j == n;
      const oversketch::Vector2 off = rim ? oversketch::Vector2(0, 0) : oversketch::Vector2(shake(), shake());
      made.addPoint(oversketch::Vector2(i, j) / n + off);
    }
  }
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  for (int i = 0; i < n; ++i)
    outline.push_back(at(i, 0));
  for (int j = 0; j < n; ++j)
    outline.push_back(at(n, j));
  for (int i = n; i > 0; --i)
    outline.push_back(at(i, n));
  for (int j = n; j > 0; --j)
    outline.push_back(at(0, j));
  const auto addStroke = [&](const std::vector<int>& points, bool closed, oversketch::BoundaryKind kind)
  {
    oversketch::DrawnStroke stroke;
    stroke.closed = closed;
    std::vector<int> samples;
    for (const int p : points)
    {
      samples.push_back(static_cast<int>(stroke.points.size()));
      stroke.points.push_back(made.mesh.points[p].place);
    }
    made.strokes.push_back(stroke);
    made.tieTo(points, samples, kind);
  };
  addStroke(outline, true, oversketch::BoundaryKind::Object);
  for (int i = 1; i < n && feature; ++i)
    row.push_back(at(i, n / 2));
  if (feature)
  {
    addStroke(row, false, oversketch::BoundaryKind::Feature);
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (cells == Cells::Quads || (cells == Cells::Mixed && random() % 2 == 0))
      {
        made.addFace({ a, b, c, d });
      }
      else if (random() % 2 == 0)
      {
        made.addFace({ a, b, c, -1 });
        made.addFace({ a, c, d, -1 });
      }
      else
      {
        made.addFace({ a, b, d, -1 });
        made.addFace({ b, c, d, -1 });
      }
    }
  }
  return made;
}

} // namespace oversketch_test
#endif
