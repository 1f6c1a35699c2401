// A canvas stroke at samples of nearly uniform distance.
#ifndef oversketch_kernels_stroke_resample_h
#define oversketch_kernels_stroke_resample_h

#include "Stroke/polyline.h"

namespace oversketch
{

// Source: image-assisted modelling, section 4: samples closer than spacing / 2 to the last one kept are
// dropped, both ends kept (the last replaces those closer than that); in a gap longer than `spacing` equally
// spaced places are put, in straight line. Kept samples stay as they are, so corners do; a second run changes
// nothing. Distances are straight ones. On a closed stroke (its first point not repeated) the gap from the
// last to the first is one as well, and the first sample stays. The usual
// spacing is 0.005 of the canvas's longest side.
//
// Returns where the result's samples lie on the given ones. Throws Error(Failure::BadStroke) for a stroke of
// fewer than two distinct points, one that is not finite, or a spacing that is not positive or so small that
// more than ten million samples would come of it.
std::vector<Blend> resampled(const Polyline& points, double spacing, bool closed = false);

// The second half of it: places at the samples that are kept, ascending, and even ones in their gaps.
std::vector<Blend> evenPlaces(const Polyline& points, std::vector<int> kept, double spacing, bool closed);

} // namespace oversketch
#endif
