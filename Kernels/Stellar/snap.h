// Snapping: vertices go to where feature curves cross their edges, so that edges follow the curves (section
// III-C.1 of "Sketch-based Adaptive Mesh Augmentation using Stellar Operators").
#ifndef oversketch_kernels_stellar_snap_h
#define oversketch_kernels_stellar_snap_h

#include "Stellar/staying.h"

#include <vector>

namespace oversketch
{

struct Context;

enum class SnapOrder
{
  // The nearest crossing of all first; crossings that a snapped vertex explains are left alone, moves that
  // would spoil a triangle are refused, edges that are crossed still get a vertex along the curve or are
  // split.
  Nearest,
  // As the paper has it: crossings are found once and every vertex goes to its nearest. Both ends of an edge
  // then meet in one point: triangles collapse and turn over.
  AllAtOnce
};

struct SnapOptions
{
  SnapOrder order = SnapOrder::Nearest;
  double minimumAngle = 5.0;     // [degrees, 0 to 60] of A2, see mayMove; with Nearest
  int maximumResidualRounds = 2; // 0: vertices go along their edges and nowhere else
  std::vector<int> parts;        // of each root; where they differ is a seam. Empty: there is none
  Staying staying = {};          // these do not go to curves; edges between two of them may be crossed
};

struct SnapReport
{
  int crossings = 0;  // of edges and curves, before the first move
  int residual = 0;   // after the last; with AllAtOnce nobody looks
  int snapped = 0;    // vertices that are on a curve now and were not before
  int refused = 0;    // moves that would have spoilt a triangle
  int facesAdded = 0; // by residual rounds
  bool split = false; // whether there was such a round, kept or not; a canonical forest stays one without
};

// Snaps vertices to curves and fills their curveId (the index in `curves`), curveParam, moved and baseNormal.
// Vertices that are snapped already stay where they are. `source` places the middles of edges that residual
// rounds split. Departures of Nearest from the paper, all from what its rule does to real meshes:
// - Crossings are taken one by one. A crossing of curve k at t is ignored (A1) if an end of its edge, of
// length
//   L, is snapped to k within L / 2 of t, or both ends are within 2 L of each other, or an end that is
//   snapped to anything lies within L / 4 of it. A vertex within a billionth of an edge of a curve counts as
//   snapped.
// - A vertex on the boundary or on a seam moves along that only, and not at all where it turns by over 45
//   degrees, ends or branches.
// - Where edges are crossed in the end, an end goes along a curve (ours): one that is on another curve to
//   where the two meet, any other to a place near the crossing, if fewer of its edges are crossed then. So
//   where curves meet there is a vertex on both, and fewer edges need to be split.
// - Edges that are crossed still are split in rounds, down to generation 24, the new vertices put on the
//   curve; a round that does not make such crossings fewer is taken back, and is the last.
// Throws Error(BadStroke) for curves that checkCurves refuses and options out of their range (parts of
// another number of roots are), Error(Cancelled) with the forest half done.
SnapReport snap(Forest& forest,
  const FeatureCurves& curves,
  const SnapOptions& options,
  const MidpointRule& source,
  const Context& context);

} // namespace oversketch
#endif
