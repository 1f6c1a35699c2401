// Drawings' meshes with known answers, for tests of what is made of them. Header-only.
#ifndef oversketch_testing_harness_drawn_meshes_h
#define oversketch_testing_harness_drawn_meshes_h

#include "Harness/drawing_shapes.h"
#include "Planar/planar_mesh.h"

#include <functional>
#include <map>

namespace oversketch_test
{
using oversketch::BoundaryKind;
using oversketch::PlanarFace;
using oversketch::PlanarMesh;
using oversketch::PlanarPoint;
using oversketch::Rim;
using oversketch::StrokeEdge;
using oversketch::Vector2;

using Snap = std::function<Vector2(int stroke, const Vector2& place)>;

// Each triangle and quad in four, `levels` times. New points are midpoints; those of stroke edges are put on
// the stroke and are of their ends' kind.
inline PlanarMesh refined(PlanarMesh mesh, int levels, const Snap& snap = nullptr)
{
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<int, int>, const StrokeEdge*> strokes;
    for (const StrokeEdge& edge : mesh.edges)
    {
      strokes[std::minmax(edge.from, edge.to)] = &edge;
    }
    PlanarMesh finer;
    finer.points = mesh.points;
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto added = middles.emplace(std::minmax(a, b), static_cast<int>(finer.points.size()));
      if (added.second)
      {
        PlanarPoint point;
        point.place = 0.5 * (mesh.points[a].place + mesh.points[b].place);
        const auto edge = strokes.find(std::minmax(a, b));
        if (edge != strokes.end())
        {
          point.stroke = edge->second->stroke;
          point.kind = mesh.points[a].kind;
          point.place = snap ? snap(point.stroke, point.place) : point.place;
        }
        finer.points.push_back(point);
      }
      return added.first->second;
    };
    for (const PlanarFace& face : mesh.faces)
    {
      const int count = face.count();
      std::array<int, 4> middlesOf{};
      for (int k = 0; k < count; ++k)
      {
        middlesOf[k] = middle(face.corners[k], face.corners[(k + 1) % count]);
      }
      PlanarFace child = face;
      int centre = -1;
      if (count == 4)
      {
        centre = static_cast<int>(finer.points.size());
        PlanarPoint point;
        for (const int corner : face.corners)
        {
          point.place += 0.25 * mesh.points[corner].place;
        }
        finer.points.push_back(point);
      }
      else
      {
        child.corners = { middlesOf[0], middlesOf[1], middlesOf[2], -1 };
        finer.faces.push_back(child);
      }
      for (int k = 0; k < count; ++k)
      {
        child.corners = { face.corners[k], middlesOf[k], middlesOf[(k + count - 1) % count], -1 };
        if (count == 4)
        {
          child.corners = { face.corners[k], middlesOf[k], centre, middlesOf[(k + 3) % 4] };
        }
        finer.faces.push_back(child);
      }
    }
    for (const StrokeEdge& edge : mesh.edges)
    {
      const int m = middle(edge.from, edge.to);
      finer.edges.push_back({ edge.from, m, edge.stroke, 0.0, 0.0 });
      finer.edges.push_back({ m, edge.to, edge.stroke, 0.0, 0.0 });
    }
    mesh = std::move(finer);
  }
  return mesh;
}

inline int addPoint(PlanarMesh& mesh, const Vector2& place, BoundaryKind kind, int stroke)
{
  PlanarPoint point;
  point.place = place;
  point.kind = kind;
  point.stroke = stroke;
  point.isBase = true;
  mesh.points.push_back(point);
  return static_cast<int>(mesh.points.size()) - 1;
}

inline void addFace(PlanarMesh& mesh, const std::array<int, 4>& corners, int region = 0)
{
  PlanarFace face;
  face.corners = corners;
  face.region = region;
  face.object = 0;
  face.base = static_cast<int>(mesh.faces.size());
  mesh.faces.push_back(face);
}

// A circle of a drawing of concentric ones, stroke number = place in the list, outermost first.
struct Circle
{
  double radius;
  BoundaryKind kind; // Interior: a ring of the mesh, no stroke
};

// Concentric circles about a centre, `spokes` base points on each, and a fan in the middle unless the
// innermost is a hole's; region 0 outside the first circle of a feature or tunnel, 1 inside.
inline PlanarMesh disc(const Vector2& centre, const std::vector<Circle>& circles, int spokes, int levels)
{
  PlanarMesh mesh;
  const auto at = [&](double radius, int i)
  { return Vector2(centre + radius * Vector2(std::cos(turn * i / spokes), std::sin(turn * i / spokes))); };
  int region = 0;
  for (std::size_t c = 0; c < circles.size(); ++c)
  {
    const int first = static_cast<int>(mesh.points.size()), outer = first - spokes;
    const bool stroke = circles[c].kind != BoundaryKind::Interior;
    for (int i = 0; i < spokes; ++i)
    {
      addPoint(mesh, at(circles[c].radius, i), circles[c].kind, stroke ? static_cast<int>(c) : -1);
      if (stroke)
      {
        mesh.edges.push_back({ first + i, first + (i + 1) % spokes, static_cast<int>(c), 0.0, 0.0 });
      }
    }
    for (int i = 0; i < spokes && c > 0; ++i)
    {
      const int next = (i + 1) % spokes;
      addFace(mesh, { first + i, outer + i, outer + next, -1 }, region);
      addFace(mesh, { first + i, outer + next, first + next, -1 }, region);
    }
    region =
      circles[c].kind == BoundaryKind::Feature || circles[c].kind == BoundaryKind::TunnelRim ? 1 : region;
  }
  if (circles.back().kind != BoundaryKind::Hole)
  {
    const int first = static_cast<int>(mesh.points.size()) - spokes;
    const int middle = addPoint(mesh, centre, BoundaryKind::Interior, -1);
    for (int i = 0; i < spokes; ++i)
    {
      addFace(mesh, { middle, first + i, first + (i + 1) % spokes, -1 }, region);
    }
  }
  return refined(mesh,
    levels,
    [&](int stroke, const Vector2& place)
    { return Vector2(centre + circles[stroke].radius * (place - centre).normalized()); });
}

// columns x rows cells, each a quad or four triangles round its middle.
inline PlanarMesh rectangle(const Vector2& corner,
  const Vector2& size,
  int columns,
  int rows,
  bool quads,
  int levels)
{
  PlanarMesh mesh;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const bool rim = i == 0 || j == 0 || i == columns || j == rows;
      addPoint(mesh,
        corner + Vector2(size[0] * i / columns, size[1] * j / rows),
        rim ? BoundaryKind::Object : BoundaryKind::Interior,
        rim ? 0 : -1);
    }
  }
  const auto at = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const std::array<int, 4> around{ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      if (quads)
      {
        addFace(mesh, around);
        continue;
      }
      const Vector2 centre = corner + Vector2(size[0] * (i + 0.5) / columns, size[1] * (j + 0.5) / rows);
      const int middle = addPoint(mesh, centre, BoundaryKind::Interior, -1);
      for (int k = 0; k < 4; ++k)
      {
        addFace(mesh, { middle, around[k], around[(k + 1) % 4], -1 });
      }
    }
  }
  for (int i = 0; i < columns; ++i)
  {
    mesh.edges.push_back({ at(i, 0), at(i + 1, 0), 0, 0.0, 0.0 });
    mesh.edges.push_back({ at(i + 1, rows), at(i, rows), 0, 0.0, 0.0 });
  }
  for (int j = 0; j < rows; ++j)
  {
    mesh.edges.push_back({ at(0, j + 1), at(0, j), 0, 0.0, 0.0 });
    mesh.edges.push_back({ at(columns, j), at(columns, j + 1), 0, 0.0, 0.0 });
  }
  return refined(mesh, levels);
}

inline PlanarMesh square(double side, bool quads, int levels)
{
  return rectangle(Vector2::Zero(), Vector2(side, side), 1, 1, quads, levels);
}

inline std::vector<Rim> rimsOf(const Vector2& centre, const std::vector<Circle>& circles)
{
  std::vector<Rim> rims;
  for (const Circle& circle : circles)
  {
    if (oversketch::isRim(circle.kind))
    {
      rims.push_back({ ringAt(centre[0], centre[1], circle.radius), 0 });
    }
  }
  return rims;
}

inline Rim rectangleRim(const Vector2& corner, const Vector2& size)
{
  return { { corner, corner + Vector2(size[0], 0.0), corner + size, corner + Vector2(0.0, size[1]) }, 0 };
}

} // namespace oversketch_test
#endif
