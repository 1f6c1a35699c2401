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

// The paper names the triangles that inflation stretches near the rim as future work; section 17 of the
// specification of image-assisted modelling gives the rule: along -grad T from d to D (1 - cos(pi u / 2)), u
// = d / D, which puts points evenly on a circular cross-section. Only points that lie on no stroke move. D is
// the maps' thickness, d = min(T, D). Ours: no point moves where edges are shorter than D / 40, as the rim is
// smooth there, and from D / 10 on in full; and points that an edge joins to a rim go to 0.53 of the mean
// angle of the points beyond them where that is nearer, but for 4 % of the way, as the rim bends by the
// first row's angle and what is beside it by half of the second's. All move only so far that the least
// angles of the plane's triangles stay above 10.4 degrees, but for a twentieth of them, and half of them
// above 35, the inner rows giving way first: even triangles of a steep surface are narrow in the plane.
//
// Guarded as the refinement is, see guard.h: no face is turned over by it. One that was turned before stays
// so. The same for any number of threads.
PlanarMesh unstretch(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const Context& context,
  UnstretchReport* report = nullptr);

} // namespace oversketch
#endif
