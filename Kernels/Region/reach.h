// The region reaches as far as the stroke leaves the section: an amendment of ours to the region of interest.
#ifndef oversketch_reach_h
#define oversketch_reach_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

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

} // namespace oversketch
#endif
