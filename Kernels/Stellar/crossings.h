// Where feature curves cross edges of a 4-8 mesh.
#ifndef oversketch_kernels_stellar_crossings_h
#define oversketch_kernels_stellar_crossings_h

#include "Stellar/forest.h"

namespace oversketch
{

struct Context;

// A curve passes over the edge from ends[0] to ends[1] at ends[0] + u (ends[1] - ends[0]).
struct EdgeCrossing
{
  int ends[2];
  int curve;
  double u;         // above 0, below 1
  double parameter; // of the curve [its arc length]
};

// Finds crossings. Curve and edge are projected along the mean normal of the edge's faces; they cross where
// the projections do and the two are not farther apart than half the edge. An edge whose normal points away
// from the curve's own (where it has normals) is on the other side of a thin part, and is not crossed (ours).
// A curve's sample that lies exactly over an edge counts for one of its two segments.
class CrossingFinder
{
public:
  CrossingFinder(const Forest& forest, const CurveSearch& search)
    : Mesh(forest)
    , Search(search)
  {
  }

  // Crossings of the edge of face f opposite its corner i are added to `found`, ascending by curve and
  // segment.
  void add(int f, int i, std::vector<EdgeCrossing>& found) const;

  // Whether a curve comes so near to a face that it may cross one of its edges.
  bool near(int f) const;

private:
  const Forest& Mesh;
  const CurveSearch& Search;
};

} // namespace oversketch
#endif
