// Where a stroke turns sharply.
#ifndef oversketch_kernels_planar_corners_h
#define oversketch_kernels_planar_corners_h

#include "Stroke/polyline.h"

namespace oversketch
{

// Source: image-assisted modelling, section 6, step 1, on a resampled stroke. A sample is near a corner where
// the chord of the four samples before it and that of the four after it differ by more than `angle` [rad];
// consecutive ones, and runs of them fewer than four samples apart, are one corner: the sample that turns
// most, of several the first. Round a closed stroke (its first point not repeated) everything is cyclic, and
// one that turns like that all along, a small circle, has no corners. The first and last four samples of an
// open stroke are none. Ascending numbers of samples.
std::vector<int> corners(const Polyline& stroke, bool closed, double angle = 0.78539816339744831);

} // namespace oversketch
#endif
