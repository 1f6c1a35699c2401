// Other samples for a stroke: at nearly uniform distance, fewer, round its corners.
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

// The samples that stay, ascending: the first, each that is at least `spacing` [px] from the last one kept,
// and the last, where the pen was lifted, however near it is. Only the last one kept counts, so a stroke that
// crosses itself loses nothing there. Of a closed stroke (its first sample not repeated) the last has no such
// right.
std::vector<int> thinStroke(const Polyline& samples, double spacing, bool closed = false);

// Samples with none nearer to its neighbour than that but the ends of a short stroke: an open stroke's last
// sample replaces the last one kept, and of a closed one those that are nearer to the first than `spacing`
// go, so that it closes with an even gap. Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation
// and Editing", Sec. 4.1, where the usual spacing is 10.
std::vector<int> thinEvenly(const Polyline& samples, double spacing, bool closed = false);

// One pass of Chaikin's scheme over `count` points: where the points of the result lie on those given, a
// quarter and three quarters along each segment. An open polyline keeps its ends and gets 2 (count - 1)
// points, a closed one (its first point not repeated) 2 count. Fewer than two points stay as they are.
std::vector<Blend> chaikinPass(int count, bool closed);

} // namespace oversketch
#endif
