#include "Planar/face_edges.h"

#include "Mesh/context.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace oversketch
{

namespace
{

[[noreturn]] void refuse(const Message& what)
{
  throw Error(Failure::BadMesh, "%1: take the mesh as the filters of the drawing's triangles make it", what);
}

Message edgeText(int from, int to)
{
  return { "the edge of points %1 and %2", from, to };
}

// For each point, the numbers of what has it.
template <typename Item, typename PointsOf>
Lists listsAt(std::size_t points, const std::vector<Item>& items, const PointsOf& pointsOf)
{
  Lists lists;
  lists.offsets.assign(points + 1, 0);
  for (const Item& item : items)
  {
    pointsOf(item, [&](int point) { ++lists.offsets[point + 1]; });
  }
  for (std::size_t p = 0; p < points; ++p)
  {
    lists.offsets[p + 1] += lists.offsets[p];
  }
  lists.values.resize(lists.offsets[points]);
  std::vector<int> next(lists.offsets.begin(), lists.offsets.end() - 1);
  for (int i = 0; i < static_cast<int>(items.size()); ++i)
  {
    pointsOf(items[i], [&](int point) { lists.values[next[point]++] = i; });
  }
  return lists;
}

// A face's edge from a corner to the next.
struct FaceSide
{
  int from, to; // from < to
  int face, corner;
  bool forward; // the face passes it from `from` to `to`
};

// Ascending by (from, to, face).
std::vector<FaceSide> faceSidesOf(const PlanarMesh& mesh)
{
  const int points = static_cast<int>(mesh.points.size()), faces = static_cast<int>(mesh.faces.size());
  std::vector<FaceSide> sides;
  sides.reserve(4 * mesh.faces.size());
  for (int f = 0; f < faces; ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int i = 0; i < face.count(); ++i)
    {
      const int a = face.corners[i], b = face.corners[(i + 1) % face.count()];
      const int across = face.corners[(i + 2) % face.count()];
      if (a < 0 || a >= points || a == b || a == across)
      {
        refuse({ "face %1 has a corner that is no point, or one twice", f });
      }
      sides.push_back({ std::min(a, b), std::max(a, b), f, i, a < b });
    }
  }
  // By the one end, and the few of each by the other.
  Lists at =
    listsAt(mesh.points.size(), sides, [](const FaceSide& side, const auto& take) { take(side.from); });
  std::vector<FaceSide> sorted;
  sorted.reserve(sides.size());
  for (int p = 0; p < points; ++p)
  {
    const auto begin = at.values.begin() + at.offsets[p], end = at.values.begin() + at.offsets[p + 1];
    std::sort(begin, end, [&](int a, int b) { return std::tie(sides[a].to, a) < std::tie(sides[b].to, b); });
    std::transform(begin, end, std::back_inserter(sorted), [&](int side) { return sides[side]; });
  }
  return sorted;
}

void tieToStrokes(const PlanarMesh& mesh, std::vector<FaceEdge>& edges)
{
  for (int i = 0; i < static_cast<int>(mesh.edges.size()); ++i)
  {
    const StrokeEdge& tie = mesh.edges[i];
    if (tie.stroke < 0)
    {
      refuse({ "%1 is said to lie on stroke %2", edgeText(tie.from, tie.to), tie.stroke });
    }
    const std::pair<int, int> key = std::minmax(tie.from, tie.to);
    const auto edge = std::lower_bound(edges.begin(),
      edges.end(),
      key,
      [](const FaceEdge& e, const std::pair<int, int>& k) { return std::make_pair(e.from, e.to) < k; });
    const bool found = edge != edges.end() && edge->from == key.first && edge->to == key.second;
    if (!found || edge->stroke >= 0)
    {
      refuse({ "%1, of stroke %2%3",
        edgeText(tie.from, tie.to),
        tie.stroke,
        (found ? ", is there twice" : ", is no face's") });
    }
    if (mesh.points[tie.from].stroke < 0 || mesh.points[tie.to].stroke < 0)
    {
      refuse({ "%1 lies on stroke %2, an end of it on none", edgeText(tie.from, tie.to), tie.stroke });
    }
    edge->stroke = i;
  }
  for (const FaceEdge& edge : edges)
  {
    if (edge.faces[1] < 0 && edge.stroke < 0)
    {
      refuse({ "%1 is on the border and on no stroke", edgeText(edge.from, edge.to) });
    }
  }
}

} // namespace

void requireFinite(const PlanarMesh& mesh)
{
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (!mesh.points[p].place.allFinite())
    {
      refuse({ "point %1 is not finite", p });
    }
  }
}

Lists facesAtPoints(const PlanarMesh& mesh)
{
  return listsAt(mesh.points.size(),
    mesh.faces,
    [](const PlanarFace& face, const auto& take)
    { std::for_each(face.corners.begin(), face.corners.begin() + face.count(), take); });
}

FaceEdges faceEdges(const PlanarMesh& mesh)
{
  requireFinite(mesh);
  FaceEdges made;
  made.ofFace.assign(mesh.faces.size(), { -1, -1, -1, -1 });
  const std::vector<FaceSide> sides = faceSidesOf(mesh);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const FaceSide& side = sides[i];
    const bool again = i > 0 && sides[i - 1].from == side.from && sides[i - 1].to == side.to;
    if (!again)
    {
      made.edges.push_back({ side.from, side.to, { side.face, -1 }, -1 });
    }
    else if (made.edges.back().faces[1] >= 0)
    {
      refuse({ "%1 has more than two faces", edgeText(side.from, side.to) });
    }
    else if (sides[i - 1].forward == side.forward)
    {
      refuse({ "faces %1 and %2 turn different ways at %3",
        sides[i - 1].face,
        side.face,
        edgeText(side.from, side.to) });
    }
    else
    {
      made.edges.back().faces[1] = side.face;
    }
    made.ofFace[side.face][side.corner] = static_cast<int>(made.edges.size()) - 1;
  }
  tieToStrokes(mesh, made.edges);
  made.atPoint = listsAt(mesh.points.size(),
    made.edges,
    [](const FaceEdge& edge, const auto& take)
    {
      take(edge.from);
      take(edge.to);
    });
  made.facesAtPoint = facesAtPoints(mesh);
  return made;
}

} // namespace oversketch
