// The constrained Delaunay triangulation of points in the plane.
#ifndef oversketch_kernels_planar_delaunay_h
#define oversketch_kernels_planar_delaunay_h

#include "Mesh/context.h"
#include "Stroke/polyline.h"

#include <array>

namespace oversketch
{

// An edge that the triangulation must have.
struct Constraint
{
  int from = -1, to = -1; // points
  int stroke = -1;        // that it belongs to: for errors, and for who reads the triangulation
};

struct DelaunayFace
{
  std::array<int, 3> corners; // counter-clockwise, the least first
  // Across the edge opposite each corner: the face, -1 outside the hull; the constraint that the edge is, -1
  // for none.
  std::array<int, 3> across{ -1, -1, -1 };
  std::array<int, 3> constraints{ -1, -1, -1 };
};

// Points ascending by (x, y), all different. No point lies in the circle of a triangle that sees it past the
// constraints; of four on one circle, whose edges are no constraints, the diagonal holds the least point: as
// if that were moved by next to nothing. So there is one such triangulation, whatever the order of insertion.
// Faces are ascending by their corners; none where all points lie on one line.
//
// Why ours: CGAL's Triangulation_2 is under the GPL. Points are inserted in narrow strips, up and down
// (Bowyer and Watson: the triangles whose circles hold the point make room for a fan), constraints by flips
// of the edges they cross (Sloan), then Lawson's flips beside them; every decision by CGAL's exact
// predicates.
//
// Throws Error(Failure::BadStroke), naming both strokes and the place, where a constraint crosses another
// one, is another one, or goes through a point.
std::vector<DelaunayFace> constrainedDelaunay(const Polyline& points,
  const std::vector<Constraint>& constraints,
  const Context& context);

} // namespace oversketch
#endif
