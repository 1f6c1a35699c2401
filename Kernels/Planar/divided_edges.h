// The edges of a planar mesh of triangles that are each cut in four, from those of the triangles.
#ifndef oversketch_kernels_planar_divided_edges_h
#define oversketch_kernels_planar_divided_edges_h

#include "Planar/face_edges.h"

#include <functional>

namespace oversketch
{

// What faceEdges finds in `divided`, whose points and faces are numbered as subdivide.h says, but for the
// faces at its points: nothing is looked for, so it takes a small part of the time. `links` are those of
// `whole`.
FaceEdges dividedEdges(const PlanarMesh& whole, const FaceEdges& links, const PlanarMesh& divided);

// Puts an item among a few that ascend.
template <typename Item, typename Less>
void insertAscending(std::array<Item, 4>& items, int& count, const Item& item, const Less& less)
{
  int at = count++;
  for (; at > 0 && less(item, items[at - 1]); --at)
  {
    items[at] = items[at - 1];
  }
  items[at] = item;
}

// Calls what with each neighbour of a point of the divided mesh, in the order of the edges to them.
template <typename What>
void forDividedNeighbours(const FaceEdges& links, int wholePoints, int point, const What& what)
{
  const int e = point - wholePoints; // the edge that it is the middle of
  if (e < 0)
  {
    for (const int* at = links.atPoint.begin(point); at != links.atPoint.end(point); ++at)
    {
      what(wholePoints + *at);
    }
    return;
  }
  const FaceEdge& edge = links.edges[e];
  what(edge.from);
  what(edge.to);
  std::array<int, 4> others{};
  int count = 0;
  for (const int f : edge.faces)
  {
    for (int i = 0; f >= 0 && i < 3; ++i)
    {
      const int other = links.ofFace[f][i];
      if (other != e)
      {
        insertAscending(others, count, other, std::less<>());
      }
    }
  }
  for (int i = 0; i < count; ++i)
  {
    what(wholePoints + others[i]);
  }
}

} // namespace oversketch
#endif
