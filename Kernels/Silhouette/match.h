// Matching a stroke to a section of the silhouette (SEED, Sec. 3.3, Eq. 3). Image-plane geometry.
#ifndef oversketch_match_h
#define oversketch_match_h

#include "Mesh/context.h"
#include "Stroke/polyline.h"

#include <vector>

namespace oversketch
{

struct MatchCandidate
{
  Polyline display;        // px; the first is not repeated at the end of a closed one
  std::vector<char> bound; // per point: hangs on the mesh, so it can become a control point
  bool closed = false;
  bool outline = false; // a loop round the picture of the mesh, not a silhouette curve
};

struct MatchRules
{
  bool amendedScore = true;     // off: least D, as published
  double maximumDistance = 0.0; // px, 0 for no gate
  double spacing = 2.0;         // px between the samples that D averages over
};

struct MatchedSection
{
  int candidate = -1;
  std::vector<Blend>
    places; // on the candidate, along the stroke: nearest to its first sample, points, nearest to its last
  double distance = 0.0; // D of Eq. 3, px
  double score = 0.0;    // what was minimised, px
};

// The published rule takes the candidate of least D = mean over the stroke's samples of the distance to the
// nearest point of the candidate, and of a closed one the arc with the smaller mean distance back to the
// stroke. The amended rule takes the section (both arcs compete) of least score = mean distance of the stroke
// to the section + mean distance of the section to the stroke + half the sum of the two end gaps; a
// silhouette curve that runs along an outline is left to the outline. Sections shorter than the spacing or
// with fewer than two bound points do not qualify. Throws Error(Failure::NoMatch) when nothing does.
MatchedSection matchStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const MatchRules& rules,
  const Context& context = {});

} // namespace oversketch
#endif
