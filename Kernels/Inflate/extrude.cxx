#include "Inflate/extrude.h"

#include "Inflate/wall.h"
#include "Mesh/context.h"

#include <cmath>

namespace oversketch
{

Solid extrude(const PlanarMesh& mesh, double depth, WallRows rows)
{
  if (!(depth > 0.0) || !std::isfinite(depth))
  {
    throw Error(Failure::BadStroke, "The depth of the extrusion must be a number above 0.");
  }
  const int count = static_cast<int>(mesh.points.size());
  const std::vector<BorderEdge> border = borderOf(cornersOf(mesh.faces), count);
  std::vector<char> isBase, used(mesh.points.size(), 0);
  for (const PlanarPoint& point : mesh.points)
  {
    isBase.push_back(point.isBase);
  }
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      used[face.corners[k]] = 1;
    }
  }
  Solid solid;
  std::vector<int> front(mesh.points.size(), -1);
  for (int i = 0; i < count; ++i)
  {
    if (used[i])
    {
      const PlanarPoint& point = mesh.points[i];
      front[i] = static_cast<int>(solid.points.size());
      solid.points.push_back({ Vector3(point.place[0], point.place[1], depth), 1, i, point.isBase, i });
    }
  }
  const int half = static_cast<int>(solid.points.size());
  std::vector<int> twins;
  for (int i = 0; i < half; ++i)
  {
    SolidPoint point = solid.points[i];
    point.place[2] = -depth;
    point.side = -1;
    twins.push_back(half + i);
    solid.points.push_back(point);
  }
  for (const int side : { 1, -1 })
  {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      const PlanarFace& face = mesh.faces[f];
      SolidFace made;
      made.side = side;
      made.source = static_cast<int>(f);
      const int corners = face.count();
      for (int k = 0; k < corners; ++k)
      {
        made.corners[k] = front[face.corners[side > 0 ? k : (corners - k) % corners]] + (side > 0 ? 0 : half);
      }
      solid.faces.push_back(made);
    }
  }
  const int between = rows == WallRows::One || border.empty() ? 1 : edgesBetweenBasePoints(border, isBase);
  std::vector<BorderEdge> rim;
  rim.reserve(border.size());
  for (const BorderEdge& edge : border)
  {
    rim.push_back({ front[edge.from], front[edge.to], edge.face });
  }
  addWall(solid, rim, twins, between);
  return solid;
}

} // namespace oversketch
