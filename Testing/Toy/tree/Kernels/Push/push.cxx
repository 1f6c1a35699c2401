#include "Push/push.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// Even and odd crossings of the line to the right.
bool inside(const std::vector<Vector2>& polygon, const Vector2& p)
{
  bool in = false;
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++)
  {
    const Vector2 &a = polygon[i], &b = polygon[k];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
    {
      in = !in;
    }
  }
  return in;
}

} // namespace

double Brightness::at(const Vector2& place, int ofWidth, int ofHeight) const
{
  const auto index = [](double share, int count) { return std::clamp(int(share * count), 0, count - 1); };
  const int x = index(place.x() / ofWidth, this->width), y = index(place.y() / ofHeight, this->height);
  return this->values[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->width) +
                      static_cast<std::size_t>(x)];
}

std::vector<Vector3> pushBetween(const Mesh& mesh,
  const View& view,
  const std::vector<Vector2>& first,
  const std::vector<Vector2>& second,
  const Brightness& brightness,
  double length,
  const Context& context)
{
  std::vector<Vector2> polygon = first;
  polygon.insert(polygon.end(), second.rbegin(), second.rend());
  const std::vector<Vector3> normals = vertexNormals(mesh);
  std::vector<Vector3> points = mesh.points;
  context.checkpoint(0.2);
  context.parallelFor(mesh.vertexCount(),
    [&](int begin, int end)
    {
      for (int i = begin; i < end && !context.cancelled(); ++i)
      {
        Vector3& p = points[static_cast<std::size_t>(i)];
        const Vector2 place = view.toDisplay(p).head<2>();
        if (view.inFront(p) && inside(polygon, place))
        {
          p +=
            length * brightness.at(place, view.width(), view.height()) * normals[static_cast<std::size_t>(i)];
        }
      }
    });
  context.checkpoint(1.0);
  if (points == mesh.points)
  {
    throw Error(
      Failure::BadStroke, "No point of the mesh lies between the two strokes; draw them round a part of it.");
  }
  return points;
}

} // namespace oversketch
