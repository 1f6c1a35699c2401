// The region's border: smoothed (SEED, Sec. 4.4, Fig. 10); and, amendments of ours, as far off as the stroke
// leaves the section, and as is asked for.
#ifndef oversketch_kernels_region_border_h
#define oversketch_kernels_region_border_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

// The vertices of the region, or of the rest, next to the other, ascending.
std::vector<int> borderOf(const Adjacency& adjacency, const std::vector<char>& region, bool inside);

// The vertices within so many rings round some, a byte for each of the mesh.
std::vector<char> withinRings(const Adjacency& adjacency, std::vector<int> vertices, int rings);

// Smooths the border by rules for region vertices: convex, at most two neighbours in the region: deselect.
// Concave, exactly one neighbour outside it: select that one. Convex before concave, then by vertex id; when
// both hold, convex wins. A vertex changes sides at most twice, which ends the rules' disputes on open
// meshes; vertices on the mesh's own border are never deselected, nor are seeds. rings > 0 confines changes
// to that many rings of vertices on either side of the border as given, 0 does not. At the end pieces of the
// region without a seed are dropped, if there are seeds at all.
std::vector<char> smoothBorder(const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  int rings);

// Extends the region towards either end of the section. ends[k] are section vertices near that end that are
// to move: those outside the region tell how far it has to be extended there, by the longest of their edge
// paths to it (none longer than `limit` is heeded). Every other vertex joins when its own path to the region
// is no longer than that; between the two ends the length is blended by the edge paths to them, so that on a
// limb the border moves up all round. Returned as it was where no end lies outside.
std::vector<char> reachEnds(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::array<std::vector<int>, 2>& ends,
  double limit,
  const std::vector<char>& region);

// The part of the region that is no farther from a seed than `reach` along edges.
std::vector<char> confineRegion(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& seeds,
  double reach,
  const std::vector<char>& region);

// Moves the region's border by a length along edges: vertices outside that are no farther from it join where
// the length is positive, those inside that are no farther from the rest leave where it is negative, but for
// seeds.
std::vector<char> shiftBorder(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  double length,
  const std::vector<char>& region);

} // namespace oversketch
#endif
