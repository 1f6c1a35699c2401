// Strokes become polylines of few vertices, from which the coarse mesh is made.
#ifndef oversketch_kernels_planar_approximate_h
#define oversketch_kernels_planar_approximate_h

#include "Mesh/context.h"
#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

namespace oversketch
{

enum class DeltaMode
{
  Adaptive, // clamp(D / 4, h / 2, 0.05 L), D the object's least thickness along the piece
  Fixed     // 0.05 L, as published
};

struct ApproximationRules
{
  DeltaMode mode = DeltaMode::Adaptive;
  double cornerAngle = 0.78539816339744831; // rad, see pieces.h
  double tolerance = 0.05;                  // of L: delta where it is fixed, and its upper bound
  double joinDistance = 0.01;               // of L: open ends so near a rim join it; 0: none does
};

// Source: image-assisted modelling, section 6, on strokes resampled to h = 0.005 L, L the canvas's longest
// side. Corners are vertices; between two of them the sample farthest from the segment becomes one until
// none is farther than delta or the arc is shorter than 2 h. Closed strokes without corners begin at the
// sample farthest from the mean of all and the one farthest from that, those with one corner at it and the
// sample farthest from it; they get three vertices whatever delta is.
//
// D is the greatest of maps.thickness in the 3 x 3 samples round a stroke's sample, of these the median of
// nine along the stroke. Where `splits` name a part of a stroke, delta is halved so many times (of several
// the most), and arcs shorter than 2 h are split once delta is at most 0.3 h.
//
// A piece of an open feature is no longer than D at the middle of its arc, or 8 h where that is more (not in
// mode Fixed): it is split there. Darts lie 0.5 D to D apart beside it, and a long straight
// piece would be joined to all of them by needles. The paper has no such bound.
//
// A piece of a rim that is longer than 0.02 L is halved while a free end of an open feature of its region is
// nearer to it than 0.03 of its length (not in mode Fixed): the coarse mesh joins them by one triangle so
// flat that its parts, inflated, fold over. Neither the paper nor the specification has such a bound.
//
// Polylines that meet though their strokes do not, and a stroke that a polyline leaves on the wrong side,
// which the paper does not speak of, are made finer likewise, by half of delta at a time, in the pieces
// concerned. Where that comes to its end Error(Failure::BadStroke) names both strokes.
//
// An open feature's end within joinDistance of the rim of its region (the object's boundary or a hole's)
// joins it: the nearest sample of that becomes a vertex of both. Two ends of one stroke do not join the same
// sample. The paper names it, "feature ends joined to the boundary", as future work.
//
// Nodes of arranged strokes (arrange.h) are vertices, and an end at one joins nothing else. An open stroke
// whose ends are both nodes or joined has a vertex between them.
//
// Rejected strokes have no polyline, nor has what lies in a hole, but for islands. The result does not depend
// on the strokes' order, up to numbers; maps are not read in mode Fixed.
std::vector<StrokePolyline> approximate(const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments,
  const DistanceMaps& maps,
  const std::vector<StrokeSplit>& splits,
  double longest,
  const ApproximationRules& rules,
  const Context& context);

// Approximates one stroke alone with a fixed delta of 0.05 L, L in the stroke's own units; it may be of any
// kind. Seeds of the livewire, section 3, step 2.
std::vector<int> approximateAlone(const Polyline& stroke, bool closed, double longest);

} // namespace oversketch
#endif
