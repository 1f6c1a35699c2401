// A stroke as a spline, and the places of the picture that the spline runs through.
#ifndef oversketch_kernels_stroke_fit_h
#define oversketch_kernels_stroke_fit_h

#include "Mesh/view.h"
#include "Stroke/nurbs.h"
#include "Stroke/polyline.h"

namespace oversketch
{

struct FitRules
{
  double spacing = 10.0;    // px: samples nearer to the last one kept are dropped
  bool interpolate = false; // the curve goes through the samples, and not beside them
  bool periodic = true;     // a closed curve has no corner where it begins; off as published
  bool cutLoops = true;     // of a closed curve; off as published
  double step = 0.5;        // px between places of the curve
};

// Samples in space, one for each of a stroke's, and the view that they are seen in.
struct SpaceSamples
{
  View view;
  std::vector<Vector3> points;
};

struct FittedStroke
{
  bool closed = false;
  int degree = 0;
  std::vector<int> kept;              // the sample of each control point
  Polyline controls;                  // px
  std::vector<Vector3> spaceControls; // of a spline in space
  std::vector<double> knots;
  std::vector<int> order; // control points in the order of the knots; those of a periodic curve come again
  // Along the curve at equal lengths, both ends included; of a closed one the first is not repeated.
  std::vector<double> parameters;  // 0 to 1
  std::vector<SplinePlace> places; // of the control points
  Polyline seen;                   // px
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.2 and 4.1: samples
// nearer than 10 px to each other are dropped, the others are control points of a spline, which then is
// sampled evenly. See thinEvenly and Nurbs.
//
// Departures: what is fitted is the stroke in the picture, since a spline in space leaps through the air
// wherever one part of the model hides another; and the shorter part of a closed polygon of control points
// that crosses itself is cut out, since a curve that shall have an inside must not.
//
// With `space`, as published, the control points are the samples in space, and the places of that spline are
// where it is seen.
//
// Throws Error(Failure::BadStroke) for fewer than two samples that differ, of a closed stroke fewer than
// three control points, for one that is not finite or longer than 1e5 px, and for a spline in space that
// leads behind the eye.
FittedStroke fitStroke(const Polyline& samples,
  bool closed,
  const FitRules& rules = {},
  const SpaceSamples* space = nullptr);

// The points of a closed polygon (its first point not repeated) that stay when of each two parts between
// which it crosses itself the shorter one is cut out; ascending.
std::vector<int> withoutLoops(const Polyline& polygon);

} // namespace oversketch
#endif
