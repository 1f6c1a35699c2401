// A thing in a picture becomes the lines that a hand would draw round it and round its holes.
#ifndef oversketch_kernels_raster_trace_h
#define oversketch_kernels_raster_trace_h

#include "Mesh/context.h"
#include "Raster/skin.h"
#include "Stroke/polyline.h"

#include <optional>
#include <vector>

namespace oversketch
{

// Closed, the first point not repeated [px], the middle of sample (i, j) at (i, j).
struct TracedRim
{
  Polyline points;
  bool isHole = false;
};

// The outer rim of a thing first, then those of its holes. The picture decides which thing is meant:
//
// - Where alpha is below one half in a hundredth of it, and more elsewhere: what is connected under the place
//   and has at least one half.
// - Where its border is evenly coloured: what is connected under the place and differs from that ground by
//   Otsu's threshold, at most 25 of CIE Lab. What is shut in is ground where most of it is within 8; a place
//   in it means that ground. A drawing of lines alone is taken with all that it encloses.
// - Elsewhere, under a place: what is connected and coloured evenly, where its area stays nearly the same
//   while the tolerance grows by 8 of Lab (Matas et al., "Robust wide baseline stereo from maximally
//   stable extremal regions", 2002).
// - Else what OpenCV's GrabCut finds on a copy of 256 px, seeded by the place and the picture's border.
//
// A place on nothing, and no place, mean the largest thing, if that is a thousandth of the picture at least.
// A rim lies where coverage crosses one half: alpha, or the share of a pixel's colour on the way from those
// outside to those inside near by.
//
// What is narrower than 0.006 of the longer side, at least 3 px, and goes farther than 1.5 times that from
// the rest is a whisker and left out; corners of 30 degrees and more stay. So are holes of a smaller mean
// width, and all that hangs on the thing by a whisker. Rims are smoothed by 1.5 px along them; Gaussian
// smoothing twice over its remainder keeps corners. Where they would meet, slits and necks of 3 px are closed
// and cut, then those of up to 9 px. Samples are 4 px apart, at bends 2.
//
// Deterministic, for any number of threads. Throws Error(Failure::BadStroke) where there is nothing to trace.
std::vector<TracedRim> traced(const PictureSamples& picture,
  const std::optional<Vector2>& place,
  const Context& context);

} // namespace oversketch
#endif
