// A 4-8 base mesh from any triangle mesh: triangles in pairs, the rest in thirds.
#ifndef oversketch_kernels_stellar_pairing_h
#define oversketch_kernels_stellar_pairing_h

#include "Stellar/forest.h"

#include <vector>

namespace oversketch
{

struct PairingOptions
{
  // Finds partners for triangles that the greedy pairing left alone, by exchanging those of at most 8 pairs
  // on the way to another lonely one (A7). In the same way pairs go (ours) whose pieces would have an angle
  // under 0.6 of the mesh's smallest.
  bool improvePairs = true;
  bool eagerPairs = false; // splits every pair at once, as Velho's library does
};

struct BaseMesh
{
  Forest forest;                 // canonical; its first points are the mesh's, then the barycentres
  std::vector<int> rootTriangle; // the triangle that a root is, or is a third of
  std::vector<Triangle> rootCorners;
  int pairs = 0, unpaired = 0;
};

// Pairs triangles over their common edges, longest first (Velho 2000); equally long ones by ascending point
// ids. Cuts those that stay alone into thirds. Throws Error(BadMesh) as checkManifold() does.
BaseMesh pairTriangles(const Mesh& mesh, const PairingOptions& options, const Context& context);

// The forest of a mesh whose triangles 2 i and 2 i + 1 are pairs over the edge opposite their first corners.
Forest forestOfPairs(const Mesh& mesh);

} // namespace oversketch
#endif
