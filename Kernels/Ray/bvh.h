// A bounding volume tree for devices that Embree does not reach, in the flat form that cast_rays.cl walks.
#ifndef oversketch_bvh_h
#define oversketch_bvh_h

#include "Ray/ray_caster.h"

#include <cstdint>

namespace oversketch
{

// Four children a node, four triangles a pack, so that both are tested side by side.
struct Bvh
{
  struct Node
  {
    // Bounds of the children, child by child along the last index. An absent child has lower above upper.
    float lower[3][4], upper[3][4];
    // A node's index; or, for a leaf, -2 - (4 * first pack + packs - 1); or -1: absent.
    std::int32_t child[4];
    std::int32_t padding[4];
  };
  struct Pack
  {
    float corner[3][3][4];    // corner, axis, triangle
    std::int32_t triangle[4]; // -1: none; its corners are then all at the origin
  };

  std::vector<Node> nodes; // depth first; the first is the root
  std::vector<Pack> packs;
  int stackSize = 1; // entries that a depth-first walk may have waiting at one time

  static constexpr int leafSize = 16; // triangles
};

// Binned surface-area heuristic, serial, deterministic. Throws Error(Cancelled).
Bvh buildBvh(const RayScene& scene, const Context& context);

} // namespace oversketch
#endif
