// Cleaning of a stroke, before anything looks at it.
#ifndef oversketch_kernels_stroke_stroke_h
#define oversketch_kernels_stroke_stroke_h

#include "Stroke/polyline.h"

namespace oversketch
{

struct StrokeRules
{
  double minimumSpacing = 2.0; // px: a sample nearer to the last one kept is jitter
  double spacing = 2.0;        // px between samples of the result
  double minimumLength = 10.0; // px: shorter ones are a click, not a stroke
  double closedFraction = 0.1; // of the length: nearer ends that run on into each other close the stroke
  bool refuseClosed = true;
  // In diagonals of the viewport [px], if both are given: longer ones are scribbles, and a sample farther
  // than the viewport's size beside it was drawn by no hand.
  double maximumLength = 0.0;
  Vector2 viewport = Vector2::Zero();
};

// px: many times round the largest screen. What is longer is a damaged file or a scribble.
constexpr double longestStroke = 1e5;

// True when the stroke comes back to its start: its ends are nearer than two minimum spacings, or nearer than
// closedFraction of its length while the direction it ends in is within 90 degrees of the one it started in.
// A U round the tip of a limb comes back in the opposite direction and is open.
bool isClosedStroke(const Polyline& samples, const StrokeRules& rules);

// Whether a stroke comes back to its start: three samples or more, the ends nearer than `gap` [px]; and, so
// that a hook of a few pixels is not taken for a ring, nearer than half the length of the stroke.
bool comesBack(const Polyline& samples, double gap);

// Where the samples of the cleaned stroke lie on the given ones: jitter dropped (both ends kept), then
// uniform in arc length. Throws Error(Failure::BadStroke) for fewer than two samples, one that is not finite,
// and for a stroke that is too short, too long, leaves its viewport too far, or is closed.
std::vector<Blend> cleanStroke(const Polyline& samples, const StrokeRules& rules = {});

} // namespace oversketch
#endif
