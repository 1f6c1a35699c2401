// A stroke's samples on a surface, as the pieces that gaps leave of it. Not installed.
#ifndef oversketch_kernels_ray_surface_pieces_h
#define oversketch_kernels_ray_surface_pieces_h

#include "Ray/projection.h"

#include <vector>

namespace oversketch
{

// Row 0 is the first sample of the stroke, row i what follows sample i - 1 up to sample i; a sample without
// triangle is a gap. Of a closed stroke of strokeSize samples there is a row more, up to the first one again:
// the pieces that meet there are one. Pieces with fewer than two samples are left out.
std::vector<SurfaceCurve> piecesOf(const std::vector<std::vector<SurfaceSample>>& rows,
  bool closed,
  int strokeSize);

} // namespace oversketch
#endif
