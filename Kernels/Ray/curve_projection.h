// A spline in the picture as curves on what is seen of a surface, sampled evenly along it.
#ifndef oversketch_kernels_ray_curve_projection_h
#define oversketch_kernels_ray_curve_projection_h

#include "Ray/projection.h"

#include <vector>

namespace oversketch
{

struct CurveRules
{
  double gap = 10.0;    // px: the surface leaps where two neighbours are farther apart in space
  double spacing = 0.0; // px of the picture between samples, as published; 0: evenly on the surface
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.1: the spline is
// sampled "every few pixels", and each sample projected to the first place of the surface.
//
// Departures: a ray is sent through every place of `picture` [px], which should lie half a pixel apart, and
// where the surface leaps, or ends, the curve is halved twelve times; it ends there where a miss is left, or
// a rest of more than a fifth of the leap: else one part of the model would be joined to another through the
// air. Each run that is left is sampled at equal lengths along the surface, a step of half the mean edge of
// the triangles under it, but 4 to 10 pixels' size: samples every few pixels mince coarse triangles.
// With `spacing` there are max(2, round(length / spacing) + 1) samples along the whole curve in the picture,
// of which those between the ends of a run belong to it.
//
// `along` of a sample is its place on `picture`; of the run through the first place of a closed curve (not
// repeated) that is cut it runs on beyond the last. Runs are in the order of the curve. A run of fewer than
// two samples, of a closed one three, is left out.
std::vector<SurfaceCurve> projectCurve(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& picture,
  bool closed,
  const CurveRules& rules = {},
  const Context& context = Context());

} // namespace oversketch
#endif
