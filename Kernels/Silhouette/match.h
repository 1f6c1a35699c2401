// Matching a stroke to a section of the silhouette (SEED, Sec. 3.3, Eq. 3). Image-plane geometry.
#ifndef oversketch_kernels_silhouette_match_h
#define oversketch_kernels_silhouette_match_h

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
  double maximumGap = 0.0;      // px from the stroke to the nearest candidate, 0 for no gate
  double spacing = 2.0;         // px between the samples that D averages over
  bool compareShapes = true;    // with the amended score: sections of the stroke's shape compete, see below
  int rank = 0;                 // 0 for the section that fits best, 1 for the second, ...
};

struct MatchedSection
{
  int candidate = -1;
  std::vector<Blend>
    places; // on the candidate, along the stroke: nearest to its first sample, points, nearest to its last
  double begin = 0.0, length = 0.0; // px along the candidate, as in CandidatePart
  double distance = 0.0;            // D of Eq. 3, px
  double score = 0.0;               // what was minimised, px
  bool twisted = false; // wound apart from the stroke, see woundApart: it would turn the limb inside out
  int rivals = 1;       // sections that fit, this one among them
};

// The published rule takes the candidate of least D = mean over the stroke's samples of the distance to the
// nearest point of the candidate, and of a closed one the arc with the smaller mean distance back to the
// stroke. The amended rule takes the section (both arcs compete) of least score = mean distance of the stroke
// to the section + mean distance of the section to the stroke + half the sum of the two end gaps; a
// silhouette curve that runs along an outline is left to the outline, and one that is wound apart from the
// stroke (woundApart) to those that are not. Sections shorter than the spacing or
// with fewer than two bound points do not qualify. Throws Error(Failure::NoMatch) when nothing does, and
// where a gate or the rank asks for what there is not.
//
// With compareShapes the section found so far must stand against those that look like the stroke somewhere
// else (findShapes): a stroke beside its limb has its ends nearest to another one, and the section between
// them is the crotch, or the long way round the whole body. Where one of them has a lesser score, as it is
// defined there, and is not the same section, it is taken: its ends are the places nearest to the stroke's
// ends less its shift, within a tenth of its length.
MatchedSection matchStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const MatchRules& rules,
  const Context& context = {});

} // namespace oversketch
#endif
