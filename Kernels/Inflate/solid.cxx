#include "Inflate/solid.h"

#include "Mesh/context.h"

#include <cmath>
#include <numeric>

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

// The mesh on both sides of its plane, as far off as `heights` say, the points of rims shared where it is
// sealed. front: of each point of the mesh that of the front, -1 for one without a face.
Solid bothSides(const PlanarMesh& mesh,
  const std::vector<double>& heights,
  bool isSealed,
  std::vector<int>& front)
{
  std::vector<char> used(mesh.points.size(), 0);
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      used[face.corners[k]] = 1;
    }
  }
  Solid solid;
  std::vector<int> numbers(mesh.points.size(), -1);
  for (const int side : { 1, -1 })
  {
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const PlanarPoint& point = mesh.points[i];
      const int planar = static_cast<int>(i);
      const bool seam = isSealed && isRim(point.kind);
      if (!used[i] || (seam && side < 0))
      {
        continue;
      }
      numbers[i] = static_cast<int>(solid.points.size());
      const double z = seam ? 0.0 : side * heights[i];
      solid.points.push_back(
        { Vector3(point.place[0], point.place[1], z), seam ? 0 : side, planar, point.isBase, planar });
    }
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
    if (side > 0)
    {
      front = numbers;
    }
  }
  return solid;
}

} // namespace

void addWall(Solid& solid, const std::vector<BorderEdge>& border, const std::vector<int>& twins, int rows)
{
  // A column of points under each point of the front's border.
  std::vector<int> firstBelow(twins.size(), -1);
  for (const BorderEdge& edge : border)
  {
    firstBelow[edge.from] = static_cast<int>(solid.points.size());
    const Vector3 top = solid.points[edge.from].place;
    for (int r = 1; r < rows; ++r)
    {
      SolidPoint point = solid.points[edge.from];
      point.place = Vector3(top[0], top[1], top[2] * (rows - 2 * r) / rows); // z mirrored to the bit
      point.side = 0;
      solid.points.push_back(point);
    }
  }
  const auto at = [&](int top, int r) {
    return r == 0 ? top : r == rows ? twins[top] : firstBelow[top] + r - 1;
  };
  for (const BorderEdge& edge : border)
  {
    const bool quads = solid.faces[edge.face].count() == 4;
    const int source = solid.faces[edge.face].source;
    for (int r = 0; r < rows; ++r)
    {
      const int a = at(edge.to, r), b = at(edge.from, r), c = at(edge.from, r + 1), d = at(edge.to, r + 1);
      if (quads)
      {
        solid.faces.push_back({ { a, b, c, d }, 0, source });
      }
      else
      {
        solid.faces.push_back({ { a, b, c, -1 }, 0, source });
        solid.faces.push_back({ { a, c, d, -1 }, 0, source });
      }
    }
  }
}

Solid inflate(const PlanarMesh& mesh, const std::vector<double>& heights)
{
  requireSealable(mesh);
  std::vector<int> front;
  return bothSides(mesh, heights, true, front);
}

Solid extrude(const PlanarMesh& mesh, double depth, WallRows rows)
{
  if (!(depth > 0.0) || !std::isfinite(depth))
  {
    throw Error(Failure::BadStroke, "The depth of the extrusion must be a number above 0.");
  }
  const int count = static_cast<int>(mesh.points.size());
  std::vector<BorderEdge> rim = borderOf(cornersOf(mesh.faces), count);
  std::vector<char> isBase;
  for (const PlanarPoint& point : mesh.points)
  {
    isBase.push_back(point.isBase);
  }
  const int between = rows == WallRows::One || rim.empty() ? 1 : edgesBetweenBasePoints(rim, isBase);
  std::vector<int> front;
  Solid solid = bothSides(mesh, std::vector<double>(mesh.points.size(), depth), false, front);
  for (BorderEdge& edge : rim)
  {
    edge.from = front[edge.from];
    edge.to = front[edge.to];
  }
  std::vector<int> twins(solid.points.size() / 2);
  std::iota(twins.begin(), twins.end(), static_cast<int>(twins.size()));
  addWall(solid, rim, twins, between);
  return solid;
}

} // namespace oversketch
