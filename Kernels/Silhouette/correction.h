// What the deformed mesh's outline still lacks to follow the stroke: further control points (an amendment to
// SEED).
#ifndef oversketch_kernels_silhouette_correction_h
#define oversketch_kernels_silhouette_correction_h

#include "Mesh/context.h"
#include "Mesh/view.h"
#include "Stroke/polyline.h"

#include <vector>

namespace oversketch
{

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
