// Rims without stretched triangles: points move towards the rim before they are pushed out.
#ifndef oversketch_kernels_inflate_unstretch_h
#define oversketch_kernels_inflate_unstretch_h

#include "Inflate/heights.h"

namespace oversketch
{

struct UnstretchReport
{
  int moved = 0; // points that moved
  int held = 0;  // points that moved less than wanted, or not at all
};

// The paper names the triangles that inflation stretches near the rim as future work. Points move along
// -grad T by m d (1 - d / D)^2, which spreads rows of triangles over an upright cross-section: m is 0 where
// edges are shorter than D / 40, so that the rim is smooth as it is, and grows to 0.9 for D / 8. Section 17
// of the specification of image-assisted modelling has rows of one height, d to D (1 - cos(pi d / (2 D))),
// which leaves the plane's triangles too thin to be worn and to be edited. Only points that lie on no stroke
// move. D is the maps' thickness, d = min(T, D).
//
// Guarded as the refinement is, see guard.h: no face is turned over by it. One that was turned before stays
// so. The same for any number of threads.
PlanarMesh unstretch(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const Context& context,
  UnstretchReport* report = nullptr);

} // namespace oversketch
#endif
