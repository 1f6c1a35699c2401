// Cuts that keep the region on its own limb: amendments of ours to the region of interest.
#ifndef oversketch_kernels_region_cut_h
#define oversketch_kernels_region_cut_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Region/grow.h"

#include <vector>

namespace oversketch
{

// Lengths in units of the part's thickness: the median diameter of the region's border vertices.
struct CutOptions
{
  double band = 1.25;    // how far from its border the region may be moved
  double keep = 0.25;    // region nearer to a seed than this stays
  double faithful = 0.3; // cost of moving the border by the whole band, as a share of its length
};

// Moves the region's border to the nearest good place to cut. Within a band around the border the triangles
// are divided anew by a minimum cut: an edge on the new border costs its length, less in a concave valley (by
// 1 + band x curvature), and a triangle that changes sides costs in proportion to its area. The region
// returned is the vertices of the triangles inside, so that border triangles' edges run in the valley itself.
// The cut is the least one of the band where that has up to 20,000 triangles. A larger band is cut in clumps
// of triangles first, and then exactly within some rings of that cut, so it may miss a less costly cut
// elsewhere in the band: the flow's time grows faster than the band. Not less than half of the region's area
// survives, or the region is returned as it was: there was no place to cut, only a patch to shrink.
std::vector<char> cutAtJunction(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const MeshParts& parts,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  const CutOptions& options = {},
  const Context& context = {});

// Takes from the region the limbs that it reached over narrow bridges: similar fingers beyond a web of skin.
// What remains of the region when a strip along its border is taken off falls into pieces; where some hold a
// seed and others none, each vertex of the region goes with the nearest piece, and those that go with a
// seedless one are deselected. The region is returned as it was where there are no such pieces or they are
// patches, together smaller than a tube as long as thick. The strip is `share` of the seeds' median diameter
// wide.
std::vector<char> cutBridges(const Mesh& mesh,
  const Adjacency& adjacency,
  const MeshParts& parts,
  const std::vector<double>& diameter,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  double share = 0.5);

// On a mesh with handles a limb may fork and both branches lead back to the body: a leg that another one
// touches. They are as thick, so the region takes both, and a stroke over the foot moves the other leg too.
// Such a region has several closed borders though what is left is in one piece. It is confined to what lies
// within the farthest edge path from the seeds whose border is a single loop, no longer than one and a half
// times the longest that the region has; islands of it are filled. A region with one border, one that reaches
// an open border of the mesh, and one round which no such loop lies, as a cup's handle that is meant as a
// whole, are returned as they were.
std::vector<char> cutAtFork(const Mesh& mesh,
  const Adjacency& adjacency,
  const MeshParts& parts,
  const std::vector<int>& seeds,
  const std::vector<char>& region);

} // namespace oversketch
#endif
