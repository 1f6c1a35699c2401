#include "Planar/divided_edges.h"

#include <algorithm>

namespace oversketch
{

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
    for (const int* at = links.atPoint.begin(p); at != links.atPoint.end(p); ++at)
    {
      const int e = *at, number = static_cast<int>(made.edges.size());
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
