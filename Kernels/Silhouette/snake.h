// Silhouette smoothing by a greedy snake that lives on the mesh (SEED, Sec. 3.1, Eq. 2, Figs. 4 and 5).
#ifndef oversketch_kernels_silhouette_snake_h
#define oversketch_kernels_silhouette_snake_h

#include "Mesh/context.h"
#include "Mesh/view.h"
#include "Silhouette/curves.h"

namespace oversketch
{

// E_geo: |n . d| / |d|, a cosine, 0 on the true contour.
double silhouetteDeviation(const CurvePoint& snaxel, const View& view);

// E_smth: the angle in [0, pi] at a point between its neighbours, all projected onto the plane through it
// that is perpendicular to its normal; pi is geodesically straight. 0 where a neighbour projects onto the
// point itself.
double smoothness(const CurvePoint& before, const CurvePoint& at, const CurvePoint& after);

// Smooths every curve by itself; an open one keeps its ends. A sweep goes along up to eight sections of equal
// length at a time, each from its first snaxel, where the paper goes along the curve once: what a snaxel
// waits for is then worked on for others.
// Snaxels are removed (three in one triangle), split (a vertex snaxel that bends by more than 0.01 rad, at
// most once and five times again per vertex) and relocated along their edge to the largest E_smth with E_geo
// < epsilon where that gains more than 1e-4 rad, until a sweep changes nothing, at most 200 sweeps.
// Consecutive snaxels share a triangle before and after. A closed curve that shrinks to fewer than three
// snaxels is gone. Points bound to three vertices stay where they are.
std::vector<Curve> smoothSilhouette(const std::vector<Curve>& curves,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view,
  double epsilon,
  const Context& context = Context());

} // namespace oversketch
#endif
