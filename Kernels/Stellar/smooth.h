// Tangential smoothing: evens out the triangles that snapping has squeezed (section III-C.1 of "Sketch-based
// Adaptive Mesh Augmentation using Stellar Operators", after Botsch and Kobbelt 2004).
#ifndef oversketch_kernels_stellar_smooth_h
#define oversketch_kernels_stellar_smooth_h

#include "Stellar/staying.h"

#include <vector>

namespace oversketch
{

struct Context;

struct SmoothOptions
{
  int rings = 2;             // of edges around snapped vertices; -1: all vertices, as the paper prints it
  double relaxation = 1.0;   // share of the way to the mean of the link, above 0, at most 1
  int iterations = 1;        // at least 0
  double minimumAngle = 5.0; // [degrees] of A2, see mayMove
  std::vector<int> parts;    // of each root, see SnapOptions
  Staying staying = {};      // these are not moved
};

struct SmoothReport
{
  int moved = 0;   // moves of vertices, in all iterations
  int refused = 0; // moves that would have spoilt a triangle
};

// Moves vertices within their tangent planes towards the mean of their links, all from where they were
// before. Snapped vertices, crests of earlier strokes, the boundary and seams stay. Departures: a move that
// A2 refuses, seen with the moves of lower vertices done, is left out. With a source a vertex that was on it
// goes back to it, from its new place within the triangles around it. Throws Error(BadStroke) for options out
// of their range, Error(Cancelled).
SmoothReport smooth(Forest& forest,
  const SmoothOptions& options,
  const MidpointRule& source,
  const Context& context);

} // namespace oversketch
#endif
