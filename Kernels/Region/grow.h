// The region of interest: seeds, region growing and its amendments (SEED, Sec. 4.3, Eq. 8).
#ifndef oversketch_kernels_region_grow_h
#define oversketch_kernels_region_grow_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <array>
#include <functional>
#include <vector>

namespace oversketch
{

// Area of the mesh that belongs to each vertex: a third of its triangles'.
std::vector<double> vertexAreas(const Mesh& mesh);

// Parts of a mesh that regions need: kept with it, so that a new stroke does not walk over all of it.
struct MeshParts
{
  std::vector<double> areas; // see vertexAreas
  std::vector<int> of;       // by vertex: the connected part of the mesh, in the order of their lowest vertex
  int count = 0;
  std::vector<double> partAreas;
};
MeshParts findParts(const Mesh& mesh, const Adjacency& adjacency, const Context& context = Context());

// Selects every connected piece of the unselected rest of a mesh component but the one of the largest area.
void fillIslands(const MeshParts& parts, const Adjacency& adjacency, std::vector<char>& region);

// Deselects connected pieces of the region without a seed.
void dropSeedless(const Adjacency& adjacency, const std::vector<char>& isSeed, std::vector<char>& region);

// Seeds and, where they are fewer than `needed`, the nearest vertices within `tolerance` (edge path) of a
// seed, nearest first, until there are that many. Ascending.
std::vector<int> expandSeeds(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& seeds,
  std::size_t needed,
  double tolerance);

struct RegionOptions
{
  double lambda = 0.2;
  bool fillIslands = true;
  bool limitRunaway = true;
  bool cutAtJunction = true;
  bool reachEnds = true;
  double near = 0.0;  // if over 0, leave of a body only what is so near to a seed, along edges [model length]
  double shift = 0.0; // the border's, after all that, outwards where positive [model length]
};

// Input of region detection besides the mesh.
struct RegionEvidence
{
  std::vector<int> seeds;       // ascending
  std::vector<double> ratio;    // ln p_fg - ln p_whole per vertex; NaN where it is not known yet
  std::vector<double> diameter; // per vertex [model length]; read where ratio is known
  double sectionLength = 0.0;   // [model length]; read by limitRunaway alone
  // Vertices of the section beyond the seeds at either end, as far as they are to move; and how far off the
  // region they may lie, along edges [model length]. Read by reachEnds alone.
  std::array<std::vector<int>, 2> ends;
  double endLength = 0.0;
  // Makes ratio and diameter known at some vertices. Called where they are about to be read.
  std::function<void(const std::vector<int>&)> require = [](const std::vector<int>&) {};
};

// Growing and its amendments. With ratio(v) = ln p_fg(x_v) - ln p_whole(x_v), E^c(v, label) = -ln
// p_label(x_v) and E^s(v, label) the number of v's neighbours with the other label, a vertex is selected when
// ratio(v) > lambda (b - f), b and f its unselected and selected neighbours. First come, first served, from
// the seeds in their order, neighbours by id; additions only, so it ends. In this order: grow; fill islands;
// where the region then exceeds half of the area of the connected parts it lies in, grow again within an edge
// path of one section length of the seeds, and fill islands again; cut off what hangs on narrow bridges (see
// cutBridges) and what lies beyond a fork (see cutAtFork), and cut at the junction (see cutAtJunction),
// unless that exceeds the half; drop pieces without a seed; extend the rest towards the section's ends (see
// reachEnds), unless that exceeds the half; where the seeds' median diameter is over 1.25 times `near`, so
// that the section is of a body and not of a limb, leave what is within `near` of a seed; shift the border
// (see shiftBorder). Throws Error(BadRegion) without seeds and when a part is selected wholly, for nothing
// would be left to hold it.
std::vector<char> detectRegion(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const MeshParts& parts,
  const RegionEvidence& evidence,
  const RegionOptions& options,
  const Context& context = {});

} // namespace oversketch
#endif
