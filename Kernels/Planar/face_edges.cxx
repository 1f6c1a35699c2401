#include "Planar/face_edges.h"

#include "Mesh/context.h"

#include <algorithm>
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
  return Lists::gathered(points,
    [&](const auto& visit)
    {
      for (int i = 0; i < static_cast<int>(items.size()); ++i)
      {
        pointsOf(items[i], [&](int point) { visit(point, i); });
      }
    });
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

FaceEdges dividedEdges(const PlanarMesh& whole, const FaceEdges& links, const PlanarMesh& divided)
{
  const int points = static_cast<int>(whole.points.size()), edges = static_cast<int>(links.edges.size());
  FaceEdges made;
  made.edges.reserve(2 * static_cast<std::size_t>(edges) + 3 * whole.faces.size());
  made.ofFace.assign(divided.faces.size(), { -1, -1, -1, -1 });
  // Where in `ofFace` the edge is of the one or the other face.
  const auto cornerOf = [&](int f, int e)
  {
    return static_cast<int>(
      std::find(links.ofFace[f].begin(), links.ofFace[f].end(), e) - links.ofFace[f].begin());
  };

  // Halves: one for each edge at each point, in the order of these.
  std::vector<std::array<int, 2>> halves(edges);
  for (int p = 0; p < points; ++p)
  {
    for (const int at : links.atPoint[p])
    {
      const int e = at, number = static_cast<int>(made.edges.size());
      const FaceEdge& edge = links.edges[e];
      const bool first = edge.from == p;
      halves[e][first ? 0 : 1] = number;
      FaceEdge half{ p, points + e, { -1, -1 }, -1 };
      for (int side = 0; side < 2 && edge.faces[side] >= 0; ++side)
      {
        const int f = edge.faces[side], i = cornerOf(f, e);
        const bool begins = whole.faces[f].corners[i] == p; // the face's edge i goes from its corner i
        const int corner = begins ? i : (i + 1) % 3;
        half.faces[side] = 4 * f + corner;
        made.ofFace[half.faces[side]][begins ? 0 : 2] = number;
      }
      if (edge.stroke >= 0)
      {
        half.stroke = 2 * edge.stroke + (whole.edges[edge.stroke].from == p ? 0 : 1);
      }
      made.edges.push_back(half);
    }
  }
  // Between the middles of two edges of a face, by the lower one's number and the other's.
  struct Inner
  {
    int other, face, corner;
  };
  for (int e = 0; e < edges; ++e)
  {
    std::array<Inner, 4> inner{};
    int count = 0;
    for (const int f : links.edges[e].faces)
    {
      for (int step = 1; f >= 0 && step < 3; ++step)
      {
        const int i = cornerOf(f, e), j = (i + step) % 3, other = links.ofFace[f][j];
        if (other > e)
        {
          // Edges i and i + 1 meet at corner i + 1.
          const Inner next{ other, f, step == 1 ? j : i };
          insertAscending(
            inner, count, next, [](const Inner& one, const Inner& two) { return one.other < two.other; });
        }
      }
    }
    for (int k = 0; k < count; ++k)
    {
      if (k > 0 && inner[k].other == inner[k - 1].other)
      {
        return faceEdges(divided); // two faces share two edges: it says that this is not sound
      }
      const auto [other, f, corner] = inner[k];
      const int number = static_cast<int>(made.edges.size());
      made.edges.push_back({ points + e, points + other, { 4 * f + corner, 4 * f + 3 }, -1 });
      made.ofFace[4 * f + corner][1] = number;
      // The inner face's edge i goes from the middle of the face's edge i to that of the next, round corner i
      // + 1.
      made.ofFace[4 * f + 3][(corner + 2) % 3] = number;
    }
  }

  // At a point of the whole mesh its halves; at a middle two halves and what goes round the faces' corners.
  made.atPoint.offsets = links.atPoint.offsets;
  made.atPoint.values.reserve(2 * made.edges.size());
  for (int number = 0; number < 2 * edges; ++number)
  {
    made.atPoint.values.push_back(number);
  }
  for (int e = 0; e < edges; ++e)
  {
    const auto [low, high] = std::minmax(halves[e][0], halves[e][1]);
    made.atPoint.values.push_back(low);
    made.atPoint.values.push_back(high);
    std::array<int, 4> round{};
    int count = 0;
    for (const int f : links.edges[e].faces)
    {
      if (f >= 0)
      {
        const int i = cornerOf(f, e);
        insertAscending(round, count, made.ofFace[4 * f + 3][i], std::less<>());
        insertAscending(round, count, made.ofFace[4 * f + 3][(i + 2) % 3], std::less<>());
      }
    }
    made.atPoint.values.insert(made.atPoint.values.end(), round.begin(), round.begin() + count);
    made.atPoint.offsets.push_back(static_cast<int>(made.atPoint.values.size()));
  }
  return made;
}

} // namespace oversketch
