// Measures of a surface of triangles and quads, for tests. Header-only.
#ifndef oversketch_testing_harness_solid_shape_h
#define oversketch_testing_harness_solid_shape_h

#include "Inflate/sheet.h"
#include "Inflate/solid.h"

#include <algorithm>
#include <map>
#include <set>

namespace oversketch_test
{

struct Shape
{
  int triangles = 0, quads = 0, points = 0;
  int loops = 0;              // of edges with one face
  int odd = 0;                // edges with more than two faces or two turned differently
  int pinched = 0;            // points whose faces are no single cycle, nor one fan at a border
  int chi = 0;                // of the points that faces have
  double volume = 0.0;        // of quads the two triangles of one diagonal
  std::map<int, int> valence; // of each point
};

inline Shape shapeOf(const std::vector<oversketch::Vector3>& points,
  const std::vector<oversketch::Corners>& faces)
{
  Shape shape;
  std::map<std::pair<int, int>, int> directed; // edges, by their faces
  std::map<int, std::map<int, int>> links;     // of a point: from neighbour to neighbour
  std::map<int, std::set<int>> neighbours;
  for (const oversketch::Corners& face : faces)
  {
    const int count = face[3] < 0 ? 3 : 4;
    ++(count == 3 ? shape.triangles : shape.quads);
    for (int k = 0; k < count; ++k)
    {
      const int a = face[k], b = face[(k + 1) % count], before = face[(k + count - 1) % count];
      shape.odd += ++directed[{ a, b }] > 1;
      links[a][b] = before;
      neighbours[a].insert(b);
      neighbours[b].insert(a);
    }
    for (int k = 1; k + 1 < count; ++k)
    {
      shape.volume += points[face[0]].dot(points[face[k]].cross(points[face[k + 1]])) / 6.0;
    }
  }
  std::map<int, int> border;
  std::set<std::pair<int, int>> edges;
  for (const auto& [edge, count] : directed)
  {
    edges.insert(std::minmax(edge.first, edge.second));
    if (directed.count({ edge.second, edge.first }) == 0)
    {
      border[edge.first] = edge.second;
    }
  }
  for (const auto& [point, link] : links)
  {
    // Along the faces round it, from where a border begins or anywhere.
    int start = link.begin()->first;
    for (const auto& [from, to] : link)
    {
      const bool led = std::any_of(
        link.begin(), link.end(), [place = from](const auto& other) { return other.second == place; });
      start = led ? start : from;
    }
    std::size_t steps = 0;
    int at = start;
    while (link.count(at) != 0 && steps < link.size())
    {
      at = link.at(at);
      ++steps;
    }
    shape.pinched += steps != link.size();
    shape.valence[point] = static_cast<int>(neighbours[point].size());
  }
  shape.points = static_cast<int>(links.size());
  shape.chi = shape.points - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
  while (!border.empty())
  {
    ++shape.loops;
    for (auto at = border.begin(); at != border.end();)
    {
      const int next = at->second;
      border.erase(at);
      at = border.find(next);
    }
  }
  return shape;
}

inline std::vector<oversketch::Vector3> placesOf(const oversketch::Solid& solid)
{
  std::vector<oversketch::Vector3> places;
  for (const oversketch::SolidPoint& point : solid.points)
  {
    places.push_back(point.place);
  }
  return places;
}

inline Shape shapeOf(const oversketch::Solid& solid)
{
  return shapeOf(placesOf(solid), oversketch::cornersOf(solid.faces));
}

} // namespace oversketch_test
#endif
