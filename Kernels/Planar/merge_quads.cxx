#include "Planar/merge_quads.h"

#include "Planar/face_order.h"
#include "Planar/predicates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double leastQuality = 0.1;
constexpr double rightAngle = 1.5707963267948966;

struct Pair
{
  double quality;
  std::array<int, 2> edge; // ascending
  std::array<int, 2> faces;
  std::array<int, 4> corners;

  bool operator<(const Pair& other) const
  {
    return this->quality != other.quality ? this->quality > other.quality : this->edge < other.edge;
  }
};

} // namespace

double quadQuality(const std::array<Vector2, 4>& corners)
{
  double worst = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const Vector2 to = corners[(k + 1) % 4] - corners[k], from = corners[(k + 3) % 4] - corners[k];
    const double angle = std::atan2(to[0] * from[1] - to[1] * from[0], to.dot(from));
    worst = std::max(worst, std::abs(rightAngle - angle));
  }
  return std::max(0.0, 1.0 - worst / rightAngle);
}

PlanarMesh mergeQuads(const PlanarMesh& mesh)
{
  std::set<std::array<int, 2>> onStrokes;
  for (const StrokeEdge& edge : mesh.edges)
  {
    onStrokes.insert({ std::min(edge.from, edge.to), std::max(edge.from, edge.to) });
  }
  const auto place = [&](int point) { return mesh.points[point].place; };
  struct Half
  {
    int face, corner; // the corner that the edge starts at
  };
  std::map<std::array<int, 2>, int> facesAt; // of an edge, how many; the border's have one
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      const auto edge = std::minmax(face.corners[k], face.corners[(k + 1) % face.count()]);
      ++facesAt[{ edge.first, edge.second }];
    }
  }
  const auto isBorder = [&](int a, int b) { return facesAt.at({ std::min(a, b), std::max(a, b) }) == 1; };
  std::map<std::array<int, 2>, Half> halves;
  std::vector<Pair> pairs;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int k = 0; k < 3 && face.count() == 3; ++k)
    {
      const int b = face.corners[k], c = face.corners[(k + 1) % 3], a = face.corners[(k + 2) % 3];
      const std::array<int, 2> edge{ std::min(b, c), std::max(b, c) };
      const auto [other, first] = halves.insert({ edge, { static_cast<int>(f), k } });
      if (first || onStrokes.count(edge))
      {
        continue;
      }
      const PlanarFace& across = mesh.faces[other->second.face];
      const int d = across.corners[(other->second.corner + 2) % 3];
      const std::array<int, 4> quad{ a, b, d, c };
      const std::array<Vector2, 4> places{ place(a), place(b), place(d), place(c) };
      const double quality = quadQuality(places);
      const bool convex =
        orientation(places[0], places[1], places[2]) > 0 && orientation(places[2], places[3], places[0]) > 0;
      const bool ear = (isBorder(a, b) && isBorder(b, d)) || (isBorder(a, c) && isBorder(c, d));
      if (convex && !ear && quality > leastQuality)
      {
        pairs.push_back({ quality, edge, { other->second.face, static_cast<int>(f) }, quad });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  PlanarMesh result = mesh;
  std::vector<bool> gone(mesh.faces.size(), false), merged(mesh.faces.size(), false);
  for (const Pair& pair : pairs)
  {
    const auto [f, g] = pair.faces;
    if (!merged[f] && !merged[g])
    {
      merged[f] = merged[g] = gone[g] = true;
      result.faces[f].corners = pair.corners;
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < gone.size(); ++f)
  {
    if (!gone[f])
    {
      result.faces[kept++] = result.faces[f];
    }
  }
  result.faces.resize(kept);
  orderFaces(result);
  return result;
}

} // namespace oversketch
