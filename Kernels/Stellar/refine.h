// Refines a 4-8 mesh where feature curves are near.
#ifndef oversketch_kernels_stellar_refine_h
#define oversketch_kernels_stellar_refine_h

#include "Stellar/distance.h"
#include "Stellar/staying.h"

namespace oversketch
{

// Lengths are model lengths; what a curve says itself goes before them.
// As published fineFoot, connectedOnly and seedCurveFaces are off.
struct RefineOptions
{
  double radius = 0.0; // above 0; faces with a vertex nearer than this to a curve are refined
  double sharpness = 1.5;
  // Faces whose refinement edge is longer are split. 0: a quarter of the radius. Where the sharpness is below
  // 1, and the feature's slope without bound at its foot, an eighth, and in faces at the foot
  // a thirty-second (ours), which else show saw-teeth; where one curve ends within another's reach
  // there is no foot, since the nearest curve counts alone. Where the sharpness is above 2 an eighth (ours):
  // on a quarter more than half of the height is lost beside the crest, whose flanks look torn. fineFoot off:
  // a quarter everywhere.
  double targetEdgeLength = 0.0;
  bool fineFoot = true;
  CurveDistance distance = CurveDistance::Straight;
  bool connectedOnly = true;  // see ReachOptions
  bool seedCurveFaces = true; // refine also faces that a curve passes through
  int maximumGeneration = 16; // 0 to 62; no leaf exceeds it
  // Faces that may be added, each of which takes some 900 bytes on the way (ours; 16 million in all would
  // take 14 GB). What needs twice as many or more is foreseen.
  int maximumFaces = 4000000;
  Staying staying = {}; // what is split between these stays flat
};

// The canonical forest after sweeps that split every face whose mark holds, until none does. New vertices
// follow the curves where their parents are snapped, else the source. Throws Error(BadStroke) for a curve or
// radius that is none, for snapped vertices that are not where these curves have them; Error(BadRegion) where
// more faces than allowed would be needed, as soon as that can be foreseen. Quickest with a roomyCopy() that
// is moved in.
Forest refine(Forest forest,
  const FeatureCurves& curves,
  const RefineOptions& options,
  const Source& source,
  const Context& context,
  int* sweeps = nullptr);

// The canonical forest, its vertices on the source, split until for no leaf the place on the source of its
// middle, or of that of its refinement edge, is farther than the tolerance [model length] from the leaf and
// its neighbours. For a base that was simplified. Where the way back leads far aside, a split would make
// needles: one that leaves an angle under 2.5 degrees of wider ones is left out, and the deviation stays.
struct SourceOptions
{
  double tolerance = 0.0;     // above 0; the spec has 1e-3 diagonals
  int maximumGeneration = 16; // 0 to 62
  int maximumFaces = 4000000; // that may be added
};
Forest refineToSource(const Forest& forest,
  const Source& source,
  const SourceOptions& options,
  const Context& context);

// The rule of new vertices of a forest, with a source that may be empty.
MidpointRule midpointRule(const Forest& forest, const FeatureCurves* curves, const Source& source);

// Throws Error(BadStroke) unless every snapped vertex is on the curve and at the arc length that it names.
void checkSnapped(const Forest& forest, const FeatureCurves& curves);

} // namespace oversketch
#endif
