// Which triangles of a mesh another one has as well, where a change here and there has made the one of the
// other. Not installed.
#ifndef oversketch_facet_match_h
#define oversketch_facet_match_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// numbers: per triangle of the mesh before, the triangle of the mesh now that has its corners at the same
// places, in the same order; -1: none. others: triangles of the mesh now that are in no number. What has
// stayed is to follow in the same order in both. False, with neither told, where more than an eighth of either
// has no match.
bool matchFacets(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others);

} // namespace oversketch
#endif
