// When remeshing is worth it, and whether its result may be kept (specification, amendment 13.9).
#ifndef oversketch_kernels_silhouette_judgement_h
#define oversketch_kernels_silhouette_judgement_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/roughness.h"
#include "Mesh/view.h"
#include "Silhouette/outline.h"
#include "Stroke/polyline.h"

#include <vector>

namespace oversketch
{

// Edges whose two triangles have normals over 100 degrees apart, in the region (one byte per vertex) and two
// rings round it: elsewhere they are the same before and after.
int foldedEdges(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& regionVertex,
  const Context& context = Context());

// Share of triangles among `chosen` (one byte per triangle) with an angle under 30 degrees.
double narrowShare(const Mesh& mesh, const std::vector<char>& chosen);

// True where the region was stretched or squeezed enough to ask for remeshing: same connectivity before and
// after.
bool wantsRemeshing(const Mesh& before, const Mesh& after, const std::vector<char>& regionVertex);

// Distance from the stroke's middle 60 % to the outline of the mesh in the view [px].
struct OutlineError
{
  double mean = 0.0;
  double worst = 0.0;
};
// `further` lines in the picture count like loops of the outline.
OutlineError outlineError(const StrokeOutline& outline, const std::vector<OutlineLoop>& further = {});
// Largest distance to the model's outline [px] of the stroke's places beside the model.
double missedBeside(const StrokeOutline& outline);

// The silhouette of the region (one byte per vertex) in the picture, hidden or not: what a stroke over a
// silhouette inside the outline is judged by. In pieces, where a curve leaves the region or passes behind the
// eye.
std::vector<OutlineLoop> regionContours(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const std::vector<char>& region,
  const View& view);

struct Judgement
{
  OutlineError outline;
  int folds = 0;            // folded edges that the mesh before did not have
  Roughness roughness = {}; // of what moved
  double back = 0.0;        // share of what is seen of the mesh that shows its back, and did not before

  static constexpr int tolerableFolds = 5; // half of what the specification lets a result have (stage 12)
  static constexpr double tolerableBack = 0.002;
  // For a second deformation against the first: nearer to the stroke without more folds than are tolerable,
  // or fewer of too many folds for at most 2 px of distance.
  bool betterThan(const Judgement& first) const;
  // For a remeshed result against the plain one: no more folds and at most 0.5 px further from the stroke; or
  // 0.5 px nearer with folds that are tolerable; no rougher, and not more turned inside out.
  bool keptAgainst(const Judgement& plain) const;
};

} // namespace oversketch
#endif
