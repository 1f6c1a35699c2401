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
  double radius = 0.0;     // half the width of the band [model length], above 0; a curve's own goes before
  double strength = 1.0;   // share of the way to the relaxed place, 0 to 1
  bool usePressure = true; // which the strength is multiplied by, where a curve has it
  double featureAngle = 180.0; // points at edges that bend by more stay [degrees]; 180: none
};

// A band and what its rim goes on as: the vertices nearer than twice the radius to a curve, by a way over the
// surface that is not much longer, and, with the surface bent by less than a half circle, on the curve's side
// of the model. Vertices of a border or of an edge with more than two triangles stay.
struct RelaxBand
{
  MeshPart part; // the vertices that are solved for are its region
  // Of each vertex of the part: the share of the way that it moves, 0 from one radius on; the length below
  // which the surface is relaxed; and how much it counts for, more beyond the radius.
  std::vector<double> share, scale, weight;
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
// wave as long as 2 pi scale loses half its height, one a third as long 99 %, one three times as long 1 %,
// whatever the triangles. Throws Error(Failure::SolveFailed), Error(Failure::Cancelled).
//
// Source: thin-plate energy (M. Botsch, L. Kobbelt, "An intuitive framework for real-time freeform modeling",
// 2004), implicit in its time step (M. Desbrun et al., "Implicit fairing of irregular meshes using diffusion
// and curvature flow", 1999). Departures: areas and weights are those of the surface without its noise
// (G. Taubin, "A signal processing approach to fair surface design", 1995), since a crumpled one's own hold
// the crumples. The rim is not held at once, with the noise of its tangents, but by many points beyond it.
std::vector<Vector3> relaxed(const RelaxBand& band, const Context& context = Context());

} // namespace oversketch
#endif
