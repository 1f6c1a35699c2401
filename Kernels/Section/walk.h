// A surface's cross-section by a plane, from one side of a region to the other.
#ifndef oversketch_kernels_section_walk_h
#define oversketch_kernels_section_walk_h

#include "Matrix/frames.h"
#include "Mesh/place.h"

#include <array>
#include <vector>

namespace oversketch
{

struct SectionRules
{
  enum class Ends
  {
    Nearest,  // where the plane first meets the boundary on either side of the reference curve
    Outermost // as published: the leftmost and the rightmost of all places where it meets the boundary
  };
  enum class Plane
  {
    Across, // the frame's: perpendicular to the curve
    Centre  // as published: through both ends and the mesh's centre
  };
  Ends ends = Ends::Nearest;
  Plane plane = Plane::Across;
  Vector3 right = Vector3::Zero(); // which way it runs, roughly; zero: to the frame's side
  double halfSize = 0.0;           // of the drawn plane, by which Outermost tells left from right
  Vector3 centre = Vector3::Zero();
};

struct Section
{
  std::vector<Vector3> points;      // one on each edge that is crossed, on both ends too; none twice in a row
  std::vector<Binding> places;      // where they hang on the mesh
  Vector3 normal = Vector3::Zero(); // of the plane that was walked in
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.2: from face to face
// across the edges that the plane crosses, from where it meets the boundary to where it meets it again.
//
// Departures. The thesis keeps the leftmost and the rightmost meeting; on curves like S and C those span
// several arms, so here the way leads from the reference curve to either side. It walks in the plane through
// both ends and the mesh's centre, which is not the one that was drawn. What it says nothing of: a vertex on
// the plane counts as above it, so that every face that is met is entered and left across one edge each; ways
// through vertices and along edges follow from that, one after the other in the vertex. A way that meets the
// mesh's border or an edge of three faces is at its end: then the other direction is tried where there is
// one.
//
// As the plane slides, mesh and boundary stay: what a way asks of them at each face is laid out once, linear
// in the mesh, in one place for each face, since ways of a large mesh wait for memory. Mesh and adjacency
// must live as long.
class Sectioner
{
public:
  // boundary: closed chain of vertices joined by edges, its first not repeated. Throws
  // Error(Failure::BadStroke) for one that is no chain of edges.
  Sectioner(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& boundary);

  // start: the curve's place in the frame's origin. Empty where the plane meets the boundary fewer than
  // twice. Throws Error(Failure::BadStroke) for a plane that does not cut the faces at the start, ends and
  // centre in one line; Error(Failure::BadMesh) naming the edge where the way ends.
  Section at(const CurveFrame& frame, const Binding& start, const SectionRules& rules = {}) const;

  // Beyond edge k, which joins corners k and (k + 1) % 3: a face, or one of the two below; and whether it
  // is the boundary's.
  static constexpr int border = -1, branch = -2; // no face; several
  struct alignas(32) Face
  {
    Triangle corners;
    std::array<int, 3> beyond;
    std::array<bool, 3> isBoundary;
  };

private:
  const Mesh& Surface;
  const Adjacency& Links;
  std::vector<int> Boundary; // edges
  std::vector<Face> Faces;
};

} // namespace oversketch
#endif
