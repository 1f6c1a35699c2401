// A drawn stroke moves to the edges of the picture under it: intelligent scissors in a corridor.
#ifndef oversketch_kernels_stroke_livewire_h
#define oversketch_kernels_stroke_livewire_h

#include "Mesh/context.h"
#include "Stroke/path_field.h"
#include "Stroke/polyline.h"

#include <cstdint>
#include <vector>

namespace oversketch
{

struct LivewireRules
{
  double radius = 10.0; // rho [image px]: half the corridor's width; less than 3 counts as 3
  // rad: an edge whose tangent differs by more from the stroke's, its chord over four samples to either side,
  // does not count. pi as published.
  double edgeAngle = 0.78539816339744831;
  double sigma = 1.0;  // px along a snapped run: it is smoothed with it. 0 as published
  int shortestRun = 5; // path pixels: fewer strong ones in a row do not replace what was drawn
  // The cheapest way along all parts together, near the stroke and along what is strong beside it. Off, as
  // published: part by part, between the strongest edges beside the seeds.
  bool together = true;
};

struct SnappedStroke
{
  Polyline points;
  std::vector<std::uint8_t> snapped; // of each point: 1 where it lies on an edge found, 0 where as drawn
  std::vector<Blend> origins;        // where on the drawn stroke its other values (pressure, time) are from
};

// Source: image-assisted modelling, section 3, steps 2 to 6. The stroke is in image px, the centre of sample
// (i, j) at (i, j). `seeds` are numbers of its samples, ascending, those of its polyline approximation with a
// fixed tolerance; the ends of the stroke are seeds in any case, the first sample of a closed one (not
// repeated at its end). Each seed moves to the strongest edge within `radius` that counts; a path is looked
// for in the corridor of each part between two seeds alone, so that it does not jump to another arm; runs of
// strong pixels, those beside an edge that counts, replace what was drawn there. Everything else stays as it
// is to the bit, and no point is farther than `radius` from the stroke. The order of the stroke's samples
// matters only by ties.
//
// Departures, with `together`: seeds do not move. A path may pass anywhere across the stroke at a seed, and
// those of all parts together are the cheapest. A px of way costs (d / radius)^2 more, d its distance from
// the stroke, and 0.4 (1 - g / g0) more, but no less than nothing, g0 the upper quartile of g on the part's
// edges that count. Why: the strongest edge within reach is often another one, a petal's or one inside the
// figure, and a seed on it draws the path there and back; and g_max of the whole picture makes all edges of a
// dull part alike. With this and edges of colours the mean distance from the edge falls by 55 to 85 % on the
// five cases of Testing/Acceptance/pen, without by 19 to 68 %. Training on the colours beside a first path
// (Mortensen and Barrett) gained nothing more.
//
// Throws Error(Failure::BadStroke) for a sample that is not finite or seeds that are
// not samples in ascending order.
SnappedStroke snapped(const EdgeFeatures& features,
  const Polyline& stroke,
  bool closed,
  const std::vector<int>& seeds,
  const LivewireRules& rules,
  const Context& context);

} // namespace oversketch
#endif
