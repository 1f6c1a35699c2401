#include "Inflate/wall.h"

namespace oversketch
{

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

} // namespace oversketch
