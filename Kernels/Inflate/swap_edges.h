// Edges that cut off a steep surface give way to the other diagonals.
#ifndef oversketch_kernels_inflate_swap_edges_h
#define oversketch_kernels_inflate_swap_edges_h

#include "Inflate/heights.h"

namespace oversketch
{

// Source: N. Dyn, D. Levin and S. Rippa, Data dependent triangulations for piecewise linear interpolation
// (1990): an edge between two triangles becomes their other diagonal where that lies nearer to the surface;
// ours: by more than 1 px in the middle of the edges. A long edge from a rim's first row inward is a chord
// deep under a round surface, and shows as a pit. Edges of strokes, of quads and between regions stay, and so
// do those whose swap would turn a face over in the plane or leave an angle on the surface below both 30
// degrees and the least before it. No edge joins rim to rim, as front and back share these.
//
// heights: of heightsOf with the same maps, section and factor. Returns how many edges were swapped.
int swapEdges(PlanarMesh& mesh,
  const std::vector<double>& heights,
  const HeightMaps& maps,
  const CrossSection& section,
  double factor,
  const Context& context);

} // namespace oversketch
#endif
