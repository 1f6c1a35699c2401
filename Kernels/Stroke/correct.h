// A stroke drawn over a drawing corrects one of its strokes, or is a new one.
#ifndef oversketch_kernels_stroke_correct_h
#define oversketch_kernels_stroke_correct_h

#include "Stroke/resketch.h"

namespace oversketch
{

struct CanvasStroke
{
  Polyline points;     // of a closed one, the first is not repeated
  bool closed = false; // never changed by a correction
};

// resketch for a closed curve: of the two arcs between the places nearest to the new curve's ends, the one of
// smaller mean distance to it is replaced; both are near a curve that goes more than half the way round, so
// then it is the one that the curve goes over. The other one is kept, and its samples outside the blends stay
// as they are; where the blends would meet on it, both are shortened to its middle. The result begins with
// the old curve's first sample if that is kept, and goes in the old curve's direction. A new curve that goes
// all the way round is the result, without what it goes over twice; so is one when the arc that goes is the
// whole curve; when no arc remains to be replaced, the old one. Blends number the points of `old` and
// `fresh`.
Resketched resketchClosed(const Polyline& old, const Polyline& fresh, const ResketchRules& rules = {});

struct Correction
{
  enum Kind
  {
    New,         // no end is near a stroke
    Replacement, // both are: an arc is replaced
    Extension    // one is: all from there to the nearer free end is replaced
  };
  Kind kind = New;
  int stroke = -1;   // that is corrected
  Resketched result; // its new samples; empty for a new stroke
};

// Source: image-assisted modelling, section 2: the candidate is the stroke of least mean distance from the
// new one's samples, of several the first; an end is near when it is within `radius` (usually 0.02 of the
// canvas's longest side) of it. A closed stroke has no free end: with one end near, the new stroke is new.
// Joints blend as resketch's do, with samples `spacing` apart. Throws Error(Failure::BadStroke) when the new
// stroke has fewer than two distinct points or one that is not finite.
Correction corrected(const std::vector<CanvasStroke>& strokes,
  const Polyline& fresh,
  double radius,
  double spacing);

} // namespace oversketch
#endif
