// Strokes as paths from place to place, with common places wherever they cross or touch, and with ends that
// go on to what they were drawn up to. The first half of arrange.h; not installed.
#ifndef oversketch_kernels_planar_common_places_h
#define oversketch_kernels_planar_common_places_h

#include "Planar/arrange.h"
#include "Planar/line_graph.h"

namespace oversketch
{

// Share of a stroke's length: how far its ends go on or are cut off, at most.
constexpr double arrangeShare = 0.25;

struct CommonPlaces
{
  std::vector<GridPlace> places;
  Polyline world; // of each
  std::vector<PlacePath> paths;
  std::vector<int> pathOf; // of each stroke; -1 of one of too few places or not on the canvas
};

// reach [px] as arrange has it, and its errors.
CommonPlaces commonPlaces(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double reach,
  const Context& context);

} // namespace oversketch
#endif
