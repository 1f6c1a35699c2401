// Fewer samples: what a hand or a tablet sends too densely.
#ifndef oversketch_kernels_stroke_thinning_h
#define oversketch_kernels_stroke_thinning_h

#include "Stroke/polyline.h"

namespace oversketch
{

// The samples that stay, ascending: the first, each that is at least `spacing` [px] from the last one kept,
// and the last, where the pen was lifted, however near it is. Only the last one kept counts, so a stroke that
// crosses itself loses nothing there. Of a closed stroke (its first sample not repeated) the last has no such
// right.
std::vector<int> thinStroke(const Polyline& samples, double spacing, bool closed = false);

// The same with none nearer to its neighbour than that but the ends of a short stroke: an open stroke's last
// sample replaces the last one kept, and of a closed one those that are nearer to the first than `spacing`
// go, so that it closes with an even gap. Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation
// and Editing", Sec. 4.1, where the usual spacing is 10.
std::vector<int> thinEvenly(const Polyline& samples, double spacing, bool closed = false);

} // namespace oversketch
#endif
