#include "Inflate/inflate.h"

#include "Inflate/sheet.h"
#include "Mesh/context.h"

#include <string>

namespace oversketch
{
namespace
{

[[noreturn]] void unsealable(const Message& message)
{
  throw Error(Failure::BadMesh, message);
}

// Front and back must meet at the rims and nowhere else.
void requireSealable(const PlanarMesh& mesh)
{
  const int count = static_cast<int>(mesh.points.size());
  const std::vector<BorderEdge> border = borderOf(cornersOf(mesh.faces), count);
  std::vector<int> next(count, -1);
  for (const BorderEdge& edge : border)
  {
    next[edge.from] = edge.to;
    if (!isRim(mesh.points[edge.from].kind))
    {
      unsealable(
        { "Point %1 lies on a border of the planar mesh but on no rim (BoundaryKind 1 or 2); a tunnel is "
          "cut out of the surface, not of this mesh.",
          edge.from });
    }
  }
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      const int a = face.corners[k], b = face.corners[(k + 1) % face.count()];
      if (!isRim(mesh.points[a].kind))
      {
        continue;
      }
      if (next[a] < 0)
      {
        unsealable(
          { "Point %1 is of a rim (BoundaryKind 1 or 2) but inside the planar mesh; trim the holes first.",
            a });
      }
      if (isRim(mesh.points[b].kind) && next[a] != b)
      {
        unsealable(
          { "The edge between points %1 and %2 joins two points of rims inside the planar mesh: front and "
            "back would coincide there; refine the mesh once more.",
            a,
            b });
      }
    }
    for (int k = 0; k < 2 && face.count() == 4; ++k)
    {
      const int a = face.corners[k], b = face.corners[k + 2];
      if (isRim(mesh.points[a].kind) && isRim(mesh.points[b].kind))
      {
        unsealable(
          { "A quad has points %1 and %2 of rims at opposite corners: cut there into triangles, front and "
            "back would coincide; divide the base face there.",
            a,
            b });
      }
    }
  }
}

} // namespace

Solid inflate(const PlanarMesh& mesh, const std::vector<double>& heights)
{
  requireSealable(mesh);
  std::vector<char> used(mesh.points.size(), 0);
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      used[face.corners[k]] = 1;
    }
  }
  Solid solid;
  std::vector<int> front(mesh.points.size(), -1), back(mesh.points.size(), -1);
  for (const int side : { 1, -1 })
  {
    std::vector<int>& numbers = side > 0 ? front : back;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const PlanarPoint& point = mesh.points[i];
      const int planar = static_cast<int>(i);
      const bool rim = isRim(point.kind);
      if (!used[i] || (rim && side < 0))
      {
        numbers[i] = front[i];
        continue;
      }
      numbers[i] = static_cast<int>(solid.points.size());
      const double z = rim ? 0.0 : side * heights[i];
      solid.points.push_back(
        { Vector3(point.place[0], point.place[1], z), rim ? 0 : side, planar, point.isBase, planar });
    }
  }
  for (const int side : { 1, -1 })
  {
    const std::vector<int>& numbers = side > 0 ? front : back;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      const PlanarFace& face = mesh.faces[f];
      SolidFace made;
      made.side = side;
      made.source = static_cast<int>(f);
      const int count = face.count();
      for (int k = 0; k < count; ++k)
      {
        made.corners[k] = numbers[face.corners[side > 0 ? k : (count - k) % count]];
      }
      solid.faces.push_back(made);
    }
  }
  return solid;
}

} // namespace oversketch
