// From the matched section and the stroke to displacement targets (SEED, Sec. 3.4, Eqs. 4 to 7), and further
// ones where the deformed outline still misses the stroke.
#ifndef oversketch_kernels_silhouette_targets_h
#define oversketch_kernels_silhouette_targets_h

#include "Mesh/context.h"
#include "Mesh/view.h"
#include "Silhouette/curves.h"
#include "Stroke/polyline.h"

#include <vector>

namespace oversketch
{

struct SectionPoint
{
  Vector2 display;                  // px, where it lies on the section
  Vector2 offset = Vector2::Zero(); // px, its own picture minus display
  Vector3 position = Vector3::Zero();
  Binding binding; // vertices -1: it only lends its length
};

struct Handle
{
  int point = -1;           // of the section
  double relative = 0.0;    // r_j
  Vector3 unmerged, target; // p*_j, p'_j
};

// f(r) of Eq. 7 with g = sqrt: 0 at both ends, 1 from omega to 1 - omega.
double mergeRatio(double r, double omega);

// One handle per bound point of the section, in its order. Lengths are taken in the image plane on both
// curves; an offset is added back turned by the angle between section and stroke; targets lie on the plane
// through the section point parallel to the image plane. Throws Error(Failure::NoMatch) when fewer than two
// points are bound or the section has no length, Error(Failure::BadStroke) when the stroke has none.
std::vector<Handle> mapTargets(const std::vector<SectionPoint>& section,
  const Polyline& stroke,
  const View& view,
  double omega);

// Length of a polyline whose points are first replaced by the (1, 4, 6, 4, 1) / 16 mean of their neighbours:
// control points lie to and fro across the curve by up to an edge, which is no length of it.
double curveLength(const std::vector<Vector3>& points);

// Keeps, of handles on several layers, those of the layer that covers most of the section. A layer is a set
// of handles joined by mesh edges; further layers stay when they are geodesically within 2.5 times their gap
// along the section + 6 edges of what is kept.
std::vector<Handle> keepOneLayer(const std::vector<Handle>& handles,
  const std::vector<SectionPoint>& section,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const View& view);

struct OutlineCorrection
{
  int vertex = -1;
  double relative = 0.0;            // of the place on the stroke that it is pulled to
  Vector3 target = Vector3::Zero(); // at the vertex's own depth
};

// The control points bring the old silhouette to the stroke, but bending and stretching turn other vertices
// into the outline. Returns the chosen vertices that now lie on the outline of the mesh (within 1 px), where
// it is between `tolerance` and `reach` px off the stroke's part from omega to 1 - omega, by rising vertex;
// the target shifts a vertex as the outline beside it must shift to lie on the stroke.
std::vector<OutlineCorrection> correctOutline(const Mesh& deformed,
  const std::vector<char>& chosen,
  const Polyline& stroke,
  const View& view,
  double omega,
  double tolerance,
  double reach,
  const Context& context = {});

} // namespace oversketch
#endif
