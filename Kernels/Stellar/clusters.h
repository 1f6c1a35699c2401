// Simplification by clusters of four faces, with the way back to the original surface.
#ifndef oversketch_kernels_stellar_clusters_h
#define oversketch_kernels_stellar_clusters_h

#include "Stellar/parametrisation.h"

#include <vector>

namespace oversketch
{

struct ClusterOptions
{
  int targetFaces = 0;       // 0: a quarter of what there are
  double maximumError = 0.0; // [model length] of a removed vertex from the faces in its place; 0: any
};

struct ClusterResult
{
  Mesh mesh;
  std::vector<int> pointFrom; // per point of the mesh its point in the original
  std::vector<int> faceFrom;  // per triangle its face in the parametrisation
  Parametrisation original;
  int removed = 0, flips = 0, levels = 0;
};

// Velho's four-face clusters: in levels, vertices by ascending quadric error, whose stars share no face;
// edges of a star are flipped until it has four, which become two; three become one, and on a straight
// boundary two become one. No operation makes an edge twice, a face whose normal turns by 90 degrees or more,
// one that has no area when laid flat, or (ours) one with an angle under 15 degrees and narrower than all
// that it replaces: needles, which no later split widens. Ends at the target, or when a level removes
// nothing. Throws Error(BadMesh) as checkManifold().
ClusterResult simplifyByClusters(const Mesh& mesh, const ClusterOptions& options, const Context& context);

} // namespace oversketch
#endif
