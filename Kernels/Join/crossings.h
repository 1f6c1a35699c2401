// Where two closed surfaces go through each other, exactly: as if the second one were moved by next to
// nothing, so that edges meet faces inside both or not at all.
#ifndef oversketch_kernels_join_crossings_h
#define oversketch_kernels_join_crossings_h

#include "Intersection/crossing_faces.h"
#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// An edge of one surface goes through a face of the other.
struct EdgeCrossing
{
  bool ofSecond = false; // whether the edge is the second surface's
  int edge = -1;         // of its surface's adjacency
  int face = -1;         // of the other surface
  bool entering = false; // whether the edge, from its lower vertex on, goes in behind the face
  double share = 0.0;    // of the edge, from its lower vertex
  Vector3 point = Vector3::Zero();
};

// The piece of curve in which two faces cut each other, in the direction of the first one's normal times the
// second one's: outside the other body is to its right on the first, to its left on the second.
struct CrossingPiece
{
  int first = -1, second = -1; // faces
  int from = -1, to = -1;      // crossings
};

struct Crossings
{
  std::vector<EdgeCrossing> points;
  std::vector<CrossingPiece> pieces; // ascending by faces
};

// The pairs of faces, one of either surface, whose boxes, larger by a distance [model length], meet, in
// ascending order.
std::vector<FacePair> nearFaces(const Mesh& first,
  const Mesh& second,
  double distance,
  const Context& context);

// The second surface is taken to be moved by (e, e^2, e^3) for an e as small as one likes (H. Edelsbrunner,
// E. Muecke, "Simulation of Simplicity", 1990): every question then has one answer, by CGAL's exact
// predicates, and all answers fit together. Both surfaces are closed;
// pairs are those of nearFaces. Throws Error(BadMesh) where a face
// without area is met, Error(Cancelled).
Crossings findCrossings(const Mesh& first,
  const Adjacency& firstEdges,
  const Mesh& second,
  const Adjacency& secondEdges,
  const std::vector<FacePair>& near,
  const Context& context);

// Tells whether a vertex of one surface lies inside the other, by the faces that a ray from it goes through.
bool isInside(const Vector3& point, bool ofSecond, const Mesh& other);

// Vertices of a mesh at most so far from a surface [model length], and those of faces that lie so near to the
// plane of a face near them; ascending. `own` is 0 where the mesh is the pairs' first one.
std::vector<int> touching(const Mesh& mesh,
  const Mesh& surface,
  const std::vector<FacePair>& near,
  int own,
  double distance);

} // namespace oversketch
#endif
