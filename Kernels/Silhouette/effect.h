// Effect of a stroke on a mesh, in figures and in words (no part of SEED: who draws has to be told when
// the result is not what was drawn).
#ifndef oversketch_kernels_silhouette_effect_h
#define oversketch_kernels_silhouette_effect_h

#include "Silhouette/judgement.h"

#include <vector>

namespace oversketch
{

struct StrokeEffect
{
  OutlineError outline;     // from the stroke's middle 60 % to the outline
  double outlineBack = 0.0; // px, see below
  // px at worst to the outline: of a stroke that was closed from all of it beside the model, as it has no
  // ends that lead there and away; only to be said, 0 where that is not asked
  double missed = 0.0;
  int folds = 0;     // folded edges that the mesh before did not have
  double back = 0.0; // share of what is seen of the mesh that shows its back, and did not before
  int crossings = 0; // pairs of triangles that pass through each other, less those of the mesh before
  Roughness before, after;
  double stretch = 1.0;    // 99 of 100 edges of what moved are stretched or squeezed by no more
  bool remeshed = false;   // what is stretched was made even again
  double movedShare = 0.0; // of the mesh's surface, 0 to 1
  double strayDistance =
    0.0; // px from the stroke and its section to the farthest place that was moved beside them
  double strayMovement = 0.0; // px that such places were moved by at most

  static constexpr double strayLimit = 25.0; // px: what moves nearer to the stroke was meant
  static constexpr int tolerableCrossings = 10;
  static constexpr double tornStretch = 8.0;
  static constexpr double tornShare = 0.7;
};

// Mean distance to the stroke of the outline between the places nearest to the ends of the stroke's middle 60
// % [px]; of a closed loop the way round that lies nearer to the stroke counts, of several loops that come as
// near as the nearest and 2 px the one whose way does. Infinite where no one loop holds both places.
// `further` lines: see outlineError.
double outlineBack(const StrokeOutline& outline, const std::vector<OutlineLoop>& further = {});

// Fills in what the deformation alone tells: stretch, movedShare and the strays. Both meshes have the same
// triangles; region has one byte per vertex; the section is what the stroke was matched with [px]. Stray is
// what was moved by more than 2.5 px in the picture and lies, where it was or where it is, farther than
// strayLimit from the convex hull of the stroke and the section's middle 30 %: of the rest it is not known
// whether it was meant. Vertices behind the eye count for nothing there.
void measureMovement(const Mesh& before,
  const Mesh& after,
  const std::vector<char>& region,
  const View& view,
  const Polyline& stroke,
  const Polyline& section,
  StrokeEffect& effect,
  const Context& context = Context());

// Remarks on it, a sentence each, the worst first; none where the stroke did what was drawn.
std::vector<Message> remarks(const StrokeEffect& effect);

// True where the surface passes through itself and is not as drawn besides: limbs welded, twisted or turned
// over. One that is drawn as it is may be meant to pass through another part.
bool crossesWrongly(const StrokeEffect& effect);

// Why the result is a wreck; empty where it is none. A limb may be drawn many times as long, and a trunk
// moved as a whole: where triangles were made even again and all else is as drawn, nothing is torn.
Message tornBy(const StrokeEffect& effect);

// True where no new triangles can help, so that none need be made: what was moved beside the stroke is most
// of the surface, or the outline is farther from the stroke than a hand misses by.
bool beyondHelp(const StrokeEffect& effect);

} // namespace oversketch
#endif
