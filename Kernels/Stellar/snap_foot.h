// The foot of a feature: vertices go to where it ends, so that edges follow it there as they follow curves.
// Ours: where the sharpness s is below 1 the profile (1 - distance / radius)^s of section III-C.2 of
// "Sketch-based Adaptive Mesh Augmentation using Stellar Operators" has a slope without bound at its foot,
// and vertices that happen to lie a little inside of it stand out as saw-teeth.
#ifndef oversketch_kernels_stellar_snap_foot_h
#define oversketch_kernels_stellar_snap_foot_h

#include "Stellar/staying.h"

#include <vector>

namespace oversketch
{

struct Context;

struct FootOptions
{
  double radius = 0.0; // [model length], above 0; the curves' own go before it
  double sharpness = 1.5;
  bool connectedOnly = true; // see ReachOptions
  double minimumAngle = 5.0; // [degrees, 0 to 60] of A2, see mayMove
  std::vector<int> parts;    // of each root, see SnapOptions
  Staying staying = {};      // these do not go
};

struct FootReport
{
  int crossings = 0; // edges that cross a foot or a rim
  int moved = 0;     // vertices that went there or towards it
  int refused = 0;   // moves all the way that would have spoilt a triangle
};

// Where the nearest curve, by share of its radius, has a sharpness below 1: along the foot, at the radius,
// and along the rim, a little inside, vertices go to where their edges cross it, the least moves first. A
// move that A2 refuses is left to the edge's other end; where that may not go either, the end that is beyond
// the foot, or within the rim, goes as far as it may. Nothing is split. Vertices on curves and crests of
// earlier strokes stay, those on the boundary and on seams keep to them. There is no rim where edges are
// longer than a sixteenth of the radius. Distances are those through space. Throws Error(BadStroke) for
// curves that checkCurves refuses, options out of their range, Error(Cancelled) with the forest half done.
FootReport snapFoot(Forest& forest,
  const FeatureCurves& curves,
  const FootOptions& options,
  const Context& context);

} // namespace oversketch
#endif
