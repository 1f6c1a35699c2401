// Silhouette extraction (SEED, Sec. 3.1, Eq. 1).
#ifndef oversketch_kernels_silhouette_extract_h
#define oversketch_kernels_silhouette_extract_h

#include "Mesh/context.h"
#include "Mesh/view.h"
#include "Silhouette/curves.h"

namespace oversketch
{

// The curves where g(v) = n_v . d(v) changes sign, in the order of their lowest edge, where a closed one also
// starts. Topology is decided by a simulated sign, so every triangle has no or two crossed edges and chains
// are manifold by construction: + is g >= -1e-9 of the largest |g|, which rounding does not change where a
// vertex lies on the silhouette; runs of points that lie on one such vertex become one vertex point, and a
// curve that is nothing but one such run goes. Curves end at mesh borders and at edges with more than two
// triangles. Consecutive points share a triangle.
std::vector<Curve> extractSilhouette(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view);

} // namespace oversketch
#endif
