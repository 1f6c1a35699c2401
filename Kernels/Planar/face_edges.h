// The edges of a planar mesh's faces, triangles and quads, and what meets at each point. Why not the
// adjacency of Mesh/mesh.h: that is of triangles alone, and knows no strokes.
#ifndef oversketch_kernels_planar_face_edges_h
#define oversketch_kernels_planar_face_edges_h

#include "Planar/planar_mesh.h"

#include <functional>

namespace oversketch
{

struct FaceEdge
{
  int from = -1, to = -1;             // from < to
  std::array<int, 2> faces{ -1, -1 }; // ascending; the second -1 on the mesh's border
  int stroke = -1;                    // the edge of PlanarMesh::edges that it is, -1 for none

  int other(int point) const { return point == this->from ? this->to : this->from; }
};

struct FaceEdges
{
  std::vector<FaceEdge> edges;            // ascending by (from, to)
  std::vector<std::array<int, 4>> ofFace; // from each corner to the next; the fourth of a triangle is -1
  Lists atPoint;                          // edges, ascending
  Lists facesAtPoint;                     // ascending; empty where nobody asks for them (dividedEdges)
};

// Throws Error(Failure::BadMesh), naming the place, where the mesh is not sound: a corner out of range or
// there twice, a point that is not finite, an edge with more than two faces or with two that turn different
// ways, an edge of a stroke that no face has or that is there twice, a border edge that lies on no stroke.
FaceEdges faceEdges(const PlanarMesh& mesh);

// Faces at each point, ascending.
Lists facesAtPoints(const PlanarMesh& mesh);

// Throws as faceEdges does where a point is not finite.
void requireFinite(const PlanarMesh& mesh);

// Finds what faceEdges does in `divided`, whose points and faces are numbered as subdivide.h says, but for
// the faces at its points: nothing is looked for, so it takes a small part of the time. `links` are those of
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
    for (const int at : links.atPoint[point])
    {
      what(wholePoints + at);
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
