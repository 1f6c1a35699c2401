// Points thrown into a drawing's inside, for rounder triangles.
#ifndef oversketch_darts_h
#define oversketch_darts_h

#include "Mesh/context.h"
#include "Planar/stroke_line.h"

namespace oversketch
{

enum class DartMode
{
  Local,     // a pixel's distance is r = max(0.7 D, 6 px)
  Published, // r = half of its object's greatest T
  Off
};

// Source: image-assisted modelling, section 8. Darts lie at pixels that are at least r inside the rim (T >=
// r) and, in mode Local, at least 0.7 r from every line of their object; two darts of one object are at least
// the larger r of the two apart. Each is drawn at random from the pixels where one may still lie, until there
// are none. Why Local: by the published rule limbs that are thinner than the body have none.
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
