// A curve drawn over a part of another one replaces that part.
#ifndef oversketch_kernels_stroke_resketch_h
#define oversketch_kernels_stroke_resketch_h

#include "Stroke/polyline.h"

namespace oversketch
{

// Where a sample of the result comes from: (1 - weight) of a place on the old curve + weight of one on the
// new curve. Other values of the samples (pressure, time) are blended alike.
struct Origin
{
  Blend before, after; // of a new sample in resketch's result, `before` is the place that it takes
  double weight = 0.0;

  template <typename Value>
  Value of(const std::vector<Value>& old, const std::vector<Value>& fresh) const
  {
    return static_cast<Value>(
      (1.0 - this->weight) * this->before.of(old) + this->weight * this->after.of(fresh));
  }
};

struct Resketched
{
  Polyline points;
  std::vector<Origin> origins;
};

struct ResketchRules
{
  enum class Middle
  {
    ArcLength, // the new curve's own samples
    Closest    // as published: of each sample of the old curve, the nearest place of the new one
  };

  double reach = 6.0;
  double spacing = 1.0; // px, of samples in between
  Middle middle = Middle::ArcLength;
  bool rawTangents = false; // as published: the steps to the next samples, whatever their length
};

// All of the old curve, or of the new one.
Resketched unchanged(const Polyline& points, bool isFresh);

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.2. The new curve
// replaces the old one between the places S and E nearest to its two ends; the old one runs into it from S' =
// S - reach d / L on, d being the new end's distance to the old curve and L the old one's length, and out of
// it up to E' alike, by a Hermite curve blended with the old one. Where S' < 0 or E' > 1 (as shares of L) the
// result starts or ends with the new curve: a curve drawn elsewhere replaces the old one, one that runs on
// from its end extends it. The direction is the old curve's.
//
// Departures: the thesis forgets to divide by L, prints the same symbol for two things, and maps the middle
// of the old curve to the nearest places of the new one, which loses bulges: here the new curve's own samples
// replace it, by their share of its length. Tangents count by their direction. When both ends are nearest to
// the same inner place the result is the old curve; at an end of the old curve it is an extension.
//
// Samples of the old curve outside [S', E'] and all of the new one are kept as they are. Both curves need two
// points that differ, else the old one is the result.
Resketched resketch(const Polyline& old, const Polyline& fresh, const ResketchRules& rules = {});

// The old curve as far as its last point, and the new one from its first on, wherever that ends: blended as
// above, within the old curve's length. Both need two points that differ, else the new one is the result.
Resketched continued(const Polyline& old, const Polyline& fresh, const ResketchRules& rules = {});

// The share of the old curve's length at which each sample takes its place; along an open curve they never
// fall.
std::vector<double> sourcesOf(const std::vector<Origin>& origins, const Polyline& old, bool closed = false);

} // namespace oversketch
#endif
