// Tunnels: regions cut out of a surface, front and back.
#ifndef oversketch_kernels_inflate_tunnel_h
#define oversketch_kernels_inflate_tunnel_h

#include "Inflate/solid.h"
#include "Raster/distance_maps.h"

#include <vector>

namespace oversketch
{

// Regions, each with 1 where its stroke is a tunnel, or that of a region round it.
std::vector<char> regionsInTunnels(const Classification& classification,
  const std::vector<Treatment>& treatments);

// Source: image-assisted modelling, section 14: the faces are removed after the surface has been made, so the
// tunnel's rim stands where it would without. That leaves two open loops, which the paper does not close;
// with `wall` they are joined as section 13 does, by 2^k rows. removed: 1 for faces to go, walls that hang on
// them among these. Points without a face go too; walls' points come last.
//
// Throws Error(Failure::BadMesh) for a tunnel that reaches a rim, takes other faces of the front than of the
// back, or leaves none.
Solid tunnel(const Solid& solid, const std::vector<char>& removed, bool wall);

} // namespace oversketch
#endif
