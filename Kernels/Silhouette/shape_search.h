// The sections of the silhouette that look like a stroke, wherever a hand put it (amendment to SEED,
// Sec. 3.3). Image-plane geometry.
#ifndef oversketch_kernels_silhouette_shape_search_h
#define oversketch_kernels_silhouette_shape_search_h

#include "Silhouette/match.h"

#include <vector>

namespace oversketch
{

// A part of a candidate, by lengths along it [px]: from `begin` over `length`, against its direction where
// that is negative. On a closed candidate it may run past the first point.
struct CandidatePart
{
  int candidate = -1;
  double begin = 0.0, length = 0.0;
  Vector2 shift = Vector2::Zero(); // px: the stroke less this is what the hand meant to draw beside the part
  double score = 0.0;              // px
  Polyline line;                   // places at equal lengths along it, made when it is scored
};

// The place at a length along a candidate (lengths: arcLengths of it), round and round a closed one.
Blend placeOn(const MatchCandidate& candidate, const std::vector<double>& lengths, double length);

// The score of a part: mean distance of the stroke to it + mean distance of it to the stroke + half the sum
// of the gaps at its two ends, all after the stroke is shifted back, + 1.5 times the shift. Without a shift
// that is the score of matchStroke; so a stroke drawn beside its limb pays the shift once and not three
// times, and keeps the limb of its own shape. The shift is either none or the mean of the differences between
// stroke and part at equal shares of their lengths.
//
// Parts begin at equal steps along every candidate, run both ways and are 0.3 to 2.2 times as long as the
// stroke; those whose shape, less the shift, is nearest to the stroke's are scored, and of those
// that are better than their neighbours the best. None that is wound apart from the stroke, nor whose mean
// distance then is over 0.2 of the stroke's length: a line across the outline looks like no part of it. The
// best first.
std::vector<CandidatePart> findShapes(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const Context& context = {});

// Score for one part, with the better of its two shifts, which is set.
void scorePart(const std::vector<MatchCandidate>& candidates, const Polyline& stroke, CandidatePart& part);

// A closed stroke, drawn round a limb and back over its base, without the part that goes over the base: one
// that runs nearly straight, up to two fifths of the length, so that the rest looks most like a section of
// the candidates (the best score of findShapes + a twentieth of what is left out). It runs as it was drawn,
// from where that part ends to where it begins; the stroke as it is where no such rest looks like any
// section.
Polyline openStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const Context& context = {});

// True where both lines go round a limb, with their ends at most 0.4 of their length apart, and the one does
// so clockwise and the other not: who matches them puts the limb's left side where its right one was drawn.
bool woundApart(const Polyline& a, const Polyline& b);

// The share of the one scored part that runs within 6 px of the other, the lesser of the two ways round.
double likeness(const CandidatePart& a, const CandidatePart& b);

} // namespace oversketch
#endif
