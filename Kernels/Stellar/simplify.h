// Welds what a 4-8 mesh does not need.
#ifndef oversketch_kernels_stellar_simplify_h
#define oversketch_kernels_stellar_simplify_h

#include "Stellar/displace.h"
#include "Stellar/staying.h"

#include <optional>

namespace oversketch
{

// Lengths are model lengths.
struct SimplifyOptions
{
  // A vertex goes if it is nearer than this to the two triangles that it split. Errors of several levels add
  // up. At most half of what a refinement was asked to keep.
  double tolerance = 0.0;
  bool weldSnapped = false; // vertices on a curve, and on crests of earlier strokes, may go too
  // Near curves nothing goes that a displacement of this radius moves. A curve's own radius goes before it.
  double radius = 0.0;
  CurveDistance distance = CurveDistance::Straight;
  bool connectedOnly = true;
  Staying staying = {}; // these do not go
};

// A forest before the last displacement, and what curves reached of it.
struct DisplacedFrom
{
  const Forest& before;
  const CurvesReached& reached; // of the same curves, radii and kind of distance
};

// The canonical forest after welding, from the finest level to the coarsest, what may go; none where nothing
// may. Distances from
// curves are those before the last displacement. Besides what is itself within a curve's radius, what keeps a
// curve's triangles small stays: a vertex whose triangles a curve passes through, or one of whose coarser
// neighbours is within the radius; a refinement for these curves would only make it again.
// `from` spares the search of the curves, which it does not change; null: it is not known.
std::optional<Forest> simplify(const Forest& forest,
  const FeatureCurves& curves,
  const SimplifyOptions& options,
  const Context& context,
  int* welded = nullptr,
  const DisplacedFrom* from = nullptr);

} // namespace oversketch
#endif
