#include "Inflate/solid.h"

#include "Mesh/context.h"
#include "Planar/trim.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

using Edge = std::pair<int, int>;

// Edges that the removal opens, of both sides.
std::vector<BorderEdge> openedBy(const Solid& before, const Solid& after)
{
  const int count = static_cast<int>(before.points.size());
  std::vector<Edge> known = mapped(borderOf(cornersOf(before.faces), count),
    [](const BorderEdge& edge) { return Edge(edge.from, edge.to); });
  std::vector<BorderEdge> opened;
  for (const BorderEdge& edge : borderOf(cornersOf(after.faces), count))
  {
    if (!std::binary_search(known.begin(), known.end(), Edge(edge.from, edge.to)))
    {
      opened.push_back(edge);
    }
  }
  return opened;
}

// Points of the back, one for each of the front, over the same point of the drawing's mesh.
std::vector<int> twinsOf(const Solid& solid)
{
  int planar = -1;
  for (const SolidPoint& point : solid.points)
  {
    planar = std::max(planar, point.planar);
  }
  std::vector<int> back(planar + 1, -1), twins(solid.points.size(), -1);
  for (std::size_t i = 0; i < solid.points.size(); ++i)
  {
    const SolidPoint& point = solid.points[i];
    if (point.planar < 0)
    {
      throw Error(Failure::BadMesh, "Point %1 is of no point of the planar mesh (PlanarId).", i);
    }
    if (point.side < 0)
    {
      back[point.planar] = static_cast<int>(i);
    }
  }
  for (std::size_t i = 0; i < solid.points.size(); ++i)
  {
    twins[i] = solid.points[i].side > 0 ? back[solid.points[i].planar] : -1;
  }
  return twins;
}

// The front's part of what was opened, when the back's is the same.
std::vector<BorderEdge> frontOf(const Solid& solid,
  const std::vector<BorderEdge>& opened,
  const std::vector<int>& twins)
{
  std::vector<BorderEdge> front;
  std::vector<Edge> back, expected;
  for (const BorderEdge& edge : opened)
  {
    if (solid.faces[edge.face].side < 0)
    {
      back.emplace_back(edge.from, edge.to);
      continue;
    }
    if (twins[edge.from] < 0 || twins[edge.to] < 0)
    {
      throw Error(Failure::BadMesh,
        "The tunnel reaches a rim at point %1; its stroke must stay inside the object.",
        edge.from);
    }
    front.push_back(edge);
    expected.emplace_back(twins[edge.to], twins[edge.from]);
  }
  std::sort(expected.begin(), expected.end());
  std::sort(back.begin(), back.end());
  if (back != expected)
  {
    throw Error(Failure::BadMesh,
      "The tunnel takes other faces of the front than of the back; PlanarId, Side and RegionId must be those "
      "of the step that made the surface.");
  }
  return front;
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
  const auto isBase = mapped(mesh.points, [](const PlanarPoint& point) { return char(point.isBase); });
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

std::vector<char> regionsInTunnels(const Classification& classification,
  const std::vector<Treatment>& treatments)
{
  // What lies in one goes with it: it would hang on nothing.
  const std::vector<Region>& regions = classification.regions;
  std::vector<char> gone(regions.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    for (int around = static_cast<int>(r); regions[around].parent >= 0; around = regions[around].parent)
    {
      gone[r] = gone[r] || treatments[regions[around].stroke] == Treatment::Tunnel;
    }
  }
  return gone;
}

Solid tunnel(const Solid& solid, const std::vector<char>& removed, bool wall)
{
  Solid result;
  result.points = solid.points;
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
  {
    if (!removed[f])
    {
      result.faces.push_back(solid.faces[f]);
    }
  }
  if (result.faces.empty() && !solid.faces.empty())
  {
    throw Error(Failure::BadMesh, "The tunnels take the whole surface; choose strokes inside its boundary.");
  }
  const std::vector<int> twins = twinsOf(result);
  const std::vector<BorderEdge> front = frontOf(result, openedBy(solid, result), twins);
  if (wall && !front.empty())
  {
    const auto isBase = mapped(result.points, [](const SolidPoint& point) { return char(point.isBase); });
    addWall(result, front, twins, edgesBetweenBasePoints(front, isBase));
  }
  dropUnusedPoints(result);
  return result;
}

} // namespace oversketch
