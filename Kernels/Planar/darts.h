// Points thrown into a drawing's inside, for rounder triangles.
#ifndef oversketch_kernels_planar_darts_h
#define oversketch_kernels_planar_darts_h

#include "Mesh/context.h"
#include "Planar/stroke_line.h"

namespace oversketch
{

enum class DartMode
{
  Local,     // a pixel's distance r is 0.7 D, at least 6 px, less beside corners that point inwards
  Published, // r = half of its object's greatest T
  Off
};

// Source: image-assisted modelling, section 8. Darts lie at pixels that are at least r inside the rim (T >=
// r) and, in mode Local, at least 0.7 r from every line of their object; two darts of one object are at least
// the larger r of the two apart. Each is drawn at random from the pixels where one may still lie, until there
// are none. Why Local: by the published rule limbs that are thinner than the body have none.
//
// In mode Local r is no more than the distance to the nearest vertex of a rim's line that points into the
// object and turns by over 45 degrees there, but at least 0.05 of the raster's longer side. Departure:
// triangles as long as a body is thick meet such a corner in a fan of few steps round which the surface is
// steep, and refinement does not add to them; on four of five drawings of a mushroom, which is cap and stem,
// the 95th percentile of the angles between faces was over 12 degrees. A bound of 60 degrees, which round
// holes of few vertices would not meet, made one of 70 drawings hold all its bounds and two miss one.
//
// Nor is it more than the size of the line's pieces at a vertex (the mean of those that end there, at least
// 0.03 of the raster's longer side) and 0.35 of the distance to it. Departure: a lone dart in a thick body
// beside a line of short pieces, round an ear or along a feature beside the rim, is the tip of a fan of
// needles, from which every triangle there descends.
//
// World coordinates, in the order they were drawn in. The same for a seed on every machine, in any order of
// the strokes and for any number of threads.
std::vector<Vector2> throwDarts(const DistanceMaps& maps,
  const std::vector<StrokeLine>& lines,
  DartMode mode,
  unsigned int seed,
  const Context& context);

} // namespace oversketch
#endif
