// The foot of a feature: vertices go to where it ends, so that edges follow it there as they follow curves.
// Ours: where the sharpness s is below 1 the profile (1 - distance / radius)^s of section III-C.2 of
// "Sketch-based Adaptive Mesh Augmentation using Stellar Operators" has a slope without bound at its foot,
// and vertices that happen to lie a little inside of it stand out as saw-teeth.
#ifndef oversketch_stellar_foot_h
#define oversketch_stellar_foot_h

#include "Stellar/forest.h"

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
};

struct FootReport
{
  int crossings = 0;  // edges that cross a foot or a rim
  int moved = 0;      // vertices that went there
  int refused = 0;    // moves that would have spoilt a triangle
  int facesAdded = 0; // by splits; a canonical forest stays one without
};

// Where the nearest curve, by share of its radius, has a sharpness below 1: along the foot, at the radius,
// and along the rim, a little inside, vertices go to where their edges cross it, the least moves first. A
// move that A2 refuses is left to the edge's other end; at the rim an edge that is crossed in the end is
// split there, down to generation 24. Vertices on curves and crests of earlier strokes stay, those on the
// boundary and on seams keep to them. There is no rim where edges are longer than a sixteenth of the radius.
// Distances are those through space. `source` places what splits make. Throws Error(BadStroke) for curves
// that checkCurves refuses, options out of their range, Error(Cancelled) with the forest half done.
FootReport snapFoot(Forest& forest,
  const FeatureCurves& curves,
  const FootOptions& options,
  const MidpointRule& source,
  const Context& context);

} // namespace oversketch
#endif
