// Relaxing of a surface along curves on it: within a band on both sides of them what is smaller than the band
// goes, the shape stays.
#ifndef oversketch_kernels_relax_relax_h
#define oversketch_kernels_relax_relax_h

#include "Mesh/part.h"
#include "Stellar/curves.h"

#include <vector>

namespace oversketch
{

struct RelaxOptions
{
  // How far to each side of a curve the surface is relaxed [model length], above 0; a curve's own goes
  // before. From there on the effect fades, and ends at 5/4 of it.
  double radius = 0.0;
  double strength = 1.0;       // share of the way to the relaxed place, 0 to 1
  bool usePressure = true;     // which the strength is multiplied by, where a curve has it
  double featureAngle = 180.0; // points at edges that bend by more stay [degrees]; 180: none
  // Of each vertex, what its share is lessened by, 1: it stays, as those of a border do; empty: nothing.
  std::vector<double> mask = {};
};

// A band and what its rim goes on as: the vertices nearer than 5/2 of the radius to a curve, by a way over
// the surface that is not much longer, and, with the surface bent by less than a half circle, on the curve's
// side of the model. Vertices of a border or of an edge with more than two triangles stay.
struct RelaxBand
{
  MeshPart part; // the vertices that are solved for are its region
  // Numbers of each vertex of the part: the share of the way that it moves; a length, 5/4 of the radius or
  // 3/20 of how thick the model is; and how much it counts for, a fifth within the radius and 300 beyond the
  // band.
  std::vector<double> share, scale, weight;
  // Areas and weights of edges are those of the surface without its noise, and points move less where a
  // triangle would turn over; else those of the surface as it is, and points go all their way.
  bool isNoisy = true;
};

// Curves have cells, and normals where the surface's side is to count. Throws Error(Failure::BadStroke) for a
// curve without cells or a radius that is not positive.
RelaxBand relaxBand(const Mesh& mesh,
  const FeatureCurves& curves,
  const RelaxOptions& options,
  const Context& context = Context());

// The places of the part's vertices. Each moves by its share towards the surface x that minimises
//   sum_i weight_i A_i |x_i - p_i|^2 + sum_i (scale_i^4 / A_i) |sum_j w_ij (x_i - x_j)|^2,
// p the surface as it was, A a third of the triangles' area at a vertex, w cotangent weights of edges. So a
// wave of number k keeps weight / (weight + (k scale)^4) of its height, whatever the triangles: within the
// band one of ten scales about half, one a third as long a sixtieth. A point moves less where a triangle
// would turn over, in folds that are narrower than the band. Throws Error(Failure::SolveFailed),
// Error(Failure::Cancelled).
//
// Source: thin-plate energy (M. Botsch, L. Kobbelt, "An intuitive framework for real-time freeform modeling",
// 2004), implicit in its time step (M. Desbrun et al., "Implicit fairing of irregular meshes using diffusion
// and curvature flow", 1999). Departures: areas and weights are those of the surface without its noise
// (G. Taubin, "A signal processing approach to fair surface design", 1995), since a crumpled one's own hold
// the crumples. The rim is not held at once, with the noise of its tangents, but by many points beyond it.
std::vector<Vector3> relaxed(const RelaxBand& band, const Context& context = Context());

} // namespace oversketch
#endif
