// The edges of a planar mesh's faces, triangles and quads, and what meets at each point. Why not the
// adjacency of Mesh/mesh.h: that is of triangles alone, and knows no strokes.
#ifndef oversketch_kernels_planar_face_edges_h
#define oversketch_kernels_planar_face_edges_h

#include "Planar/planar_mesh.h"

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
  Lists facesAtPoint;                     // ascending; empty where nobody asks for them (divided_edges.h)
};

// Throws Error(Failure::BadMesh), naming the place, where the mesh is not sound: a corner out of range or
// there twice, a point that is not finite, an edge with more than two faces or with two that turn different
// ways, an edge of a stroke that no face has or that is there twice, a border edge that lies on no stroke.
FaceEdges faceEdges(const PlanarMesh& mesh);

// Of each point the faces there, ascending.
Lists facesAtPoints(const PlanarMesh& mesh);

// Throws as faceEdges does where a point is not finite.
void requireFinite(const PlanarMesh& mesh);

// What the counter-clockwise triangle a, b, c covers; negative for a clockwise one.
inline double signedArea(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const Vector2 u = b - a, v = c - a;
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

} // namespace oversketch
#endif
