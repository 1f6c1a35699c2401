// Shapes of triangles: what a move may do to them, and how thin those near curves are.
#ifndef oversketch_kernels_stellar_quality_h
#define oversketch_kernels_stellar_quality_h

#include "Mesh/context.h"
#include "Mesh/shape.h"
#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

// The sine squared of an angle [degrees], to compare a narrowness with.
double squaredSine(double degrees);

// Amendment A2: whether a vertex may go to a place. Not if the normal of a face of its star would turn by 90
// degrees or more, nor if the star's smallest angle would be under a limit [degrees, at most 60] and smaller
// than it is. With places of the vertices before the first of several moves, faces turn from there: three
// moves of 40 degrees are one of 120.
bool mayMove(const Forest& forest,
  int v,
  const Vector3& to,
  double minimumAngle,
  const std::vector<Vector3>* first = nullptr);

// Whether a vertex keeps to the boundary and to seams, see SnapOptions, on its way along an edge: on one it
// goes along that only, and not at all where that turns by over 45 degrees, ends or branches.
bool keepsToLines(const Forest& forest, int v, int towards, const std::vector<int>& parts);

// The narrowest of the faces that splits left in their slots.
double narrowestOf(const Forest& forest, const std::vector<Forest::Birth>& births);
// Undoes splits that nothing was split after.
void weldBack(Forest& forest, const std::vector<Forest::Birth>& births);

// Triangles that come nearer to the curves than their radii: how thin they are, and their vertices
// with those of the triangles round them.
struct CurveNeighbourhood
{
  // The share of triangles with an angle under 15 degrees, each weighted by its longest edge. Those without
  // an edge over a quarter of the radius count for nothing: no bisection goes so far.
  double thinShare = 0.0;
  double meanEdge = 0.0;      // of the longest edges
  std::vector<char> vertices; // a byte for each of the mesh
};

// radius: of curves without their own. Throws Error(Cancelled).
CurveNeighbourhood neighbourhoodOf(const Mesh& mesh,
  const FeatureCurves& curves,
  double radius,
  const Context& context);

} // namespace oversketch
#endif
