// A bounding volume tree for devices that Embree does not reach, in the flat form that cast_rays.cl walks.
#ifndef oversketch_kernels_ray_bvh_h
#define oversketch_kernels_ray_bvh_h

#include "Ray/ray_caster.h"

#include <cstdint>

namespace oversketch
{

// Eight children a node, up to eight triangles a leaf, so that they are tested side by side.
struct Bvh
{
  static constexpr int width = 8;

  // Child by child along the last index.
  struct alignas(32) Node
  {
    float lower[3][width], upper[3][width]; // an absent child has lower above upper
    std::int32_t child[width];              // a node's index; or, for a leaf, -2 - its pack's; or -1: absent
    // Bounds of the unit normals of all facets below, times normalScale: no ray leaves through any of them
    // whose direction has a negative product with all that they allow.
    std::int8_t normalLower[3][width], normalUpper[3][width];
    std::int8_t padding[16];
  };
  struct alignas(32) Pack
  {
    float corner[3][3][width];    // corner, axis, triangle
    std::int32_t triangle[width]; // -1: none; its corners are then all at the origin

    // Nothing is written: most of the time that many of them take is the first touch of their memory, which
    // the threads that fill them in share.
    Pack() {} // "= default" would fill in zeros
  };
  // A power of two, so that scaling does not round.
  static constexpr float normalScale = 64.0f;

  std::vector<Node> nodes; // a parent before its children; the first is the root
  std::vector<Pack> packs;
  int stackSize = 1; // entries that a depth-first walk may have waiting at one time
};

// Binned surface-area heuristic, the same tree for any number of threads. Throws Error(Cancelled).
Bvh buildBvh(const RayScene& scene, const Context& context);

} // namespace oversketch
#endif
