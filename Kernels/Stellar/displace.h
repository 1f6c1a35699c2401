// Feature creation: vertices near feature curves rise along their normals, or follow a silhouette sketch
// (section III-C.2 of "Sketch-based Adaptive Mesh Augmentation using Stellar Operators").
// As published: Current, Sum, connectedOnly and holdBack off.
#ifndef oversketch_kernels_stellar_displace_h
#define oversketch_kernels_stellar_displace_h

#include "Mesh/place.h"
#include "Stellar/distance.h"
#include "Stellar/profile.h"
#include "Stellar/vertices_to_keep.h"

#include <optional>

namespace oversketch
{

struct Context;

// Along which normals vertices rise.
enum class RiseAlong
{
  Base,   // baseNormal: those of the mesh as it was before the stroke (A3)
  Current // of the leaves: they turn where snapping left uneven triangles
};

// The rule where several curves reach a vertex.
enum class Combine
{
  Nearest, // the curve with the least distance / radius, the lowest of equal ones, alone (A5)
  Sum      // all of them: crossings stand twice as high
};

struct DisplaceOptions
{
  double radius = 0.0; // r [model length], above 0; the curves' own go before it
  CurveDistance distance = CurveDistance::Straight;
  bool connectedOnly = true;      // see ReachOptions
  double height = 0.0;            // h [model length], below 0 inward; the curves' own go before it
  double sharpness = 1.5;         // s of Eq. 1, not negative; the curves' own go before it
  std::optional<Profile> profile; // in place of Eq. 1, for all curves
  bool usePressure = false;       // h times the pen's pressure at the nearest point
  double taper = 0.0;             // [model length], see FeatureCurve::taperAt; 0: ends are round
  bool holdBack = true;           // heights end within the curves' room, see FeatureCurve::limits
  RiseAlong along = RiseAlong::Base;
  bool keepBaseNormals = false; // for the next stroke: what rises on a steep flank goes as that one went
  Combine combine = Combine::Nearest;
  // A point for each point of each curve: vertices move by sketch - curve there, in place of h times a
  // normal.
  const std::vector<std::vector<Vector3>>* sketch = nullptr;
  // Of each vertex, what its way is lessened by, 1: it stays, and is no part of a crest; empty: nothing.
  std::vector<double> mask = {};
};

struct DisplaceReport
{
  int moved = 0; // vertices with a feature value other than zero
  // Faces whose normals turned over 90 degrees (A10) and look to the other side of the way they rose. Ours:
  // a steep flank over relief that falls the other way turns by more than 90 degrees and is sound.
  int flipped = 0;
  double peak = 0.0; // the greatest feature value
  // Points of curves where the room is less than the height, and the least of that, in shares of the height.
  int heldBack = 0;
  double leastShare = 1.0;
  // Feature values at places along the crests, 1 where the mesh holds them. `crests`: how many.
  double crestSum = 0.0, crestMinimum = 0.0;
  int crests = 0;
};

// All that is costly, and what stays as it is while only heights and profiles change. Throws Error(BadStroke)
// for radii out of their range.
struct CurvesReached
{
  std::vector<std::vector<Reached>> vertices; // per curve
  std::vector<Binding> crest;                 // places along the crests
  VerticesToKeep needed;                      // to keep where the mesh is simplified
  std::vector<int> changing;                  // vertices that a displacement writes: reached or snapped ones
  std::vector<int> faces;                     // round those, and their normals
  std::vector<Vector3> normals;
};
CurvesReached reachedBy(const Forest& forest,
  const FeatureCurves& curves,
  const DisplaceOptions& options,
  const Context& context);

// Moves each vertex by its feature value, the profile of distance / radius, times h and its normal or the
// vector to the sketch, all from where they were. A vertex that is snapped to a curve is at distance 0 of it,
// at its own parameter. Fills displacement and feature, and ends the stroke: snapped vertices become crests
// of an earlier one, base normals are no longer known unless they are kept. Throws Error(BadStroke) for
// options out of their range and a sketch that does not fit the curves, Error(Cancelled).
DisplaceReport displace(Forest& forest,
  const FeatureCurves& curves,
  const DisplaceOptions& options,
  const Context& context);
// Displaces by what reachedBy gave for this forest, these curves and radii; `before` stays as it is.
// `after`: empty, or what this made of the same before: then only what is reached is written.
DisplaceReport displace(const Forest& before,
  const FeatureCurves& curves,
  const CurvesReached& reached,
  const DisplaceOptions& options,
  const Context& context,
  Forest& after);

} // namespace oversketch
#endif
