// Long thin triangles near feature curves: bisection keeps their shape, so that lines over them end in
// saw-teeth.
#ifndef oversketch_kernels_stellar_thin_triangles_h
#define oversketch_kernels_stellar_thin_triangles_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Stellar/curves.h"

#include <vector>

namespace oversketch
{

// Of the triangles that come nearer to the curves than their radii: how thin they are, and their vertices
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
