// A front that goes over a surface from a curve on it.
#ifndef oversketch_kernels_shading_front_h
#define oversketch_kernels_shading_front_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

class Directions;
struct Context;
struct FeatureCurve;

// The distance of each vertex from a chain of vertices whose segments are edges, and the place on the chain
// that the way leads to, as a length along it.
struct ChainDistances
{
  std::vector<double> distance, place;
};

// `straight` holds distances through space and the nearest places, and is replaced by those over the surface,
// which are never less. `curve` is the chain's, `directions` are the mesh's.
//
// Each vertex has, beside its distance, the direction that its way comes from. By the first variation the
// distance changes along an edge by minus the cosine of the angle between the two, measured over the
// triangles, so on an edge whose ends are known the distance is a cubic of two values and two slopes, and
// behind it the least of that and the straight way on. Where two fronts meet on the edge, or one is still
// round a vertex of the chain, it is the straight way from the centre round which an end's front bows. A
// vertex that a front passed, and a shorter way reaches later, passes that on.
void marchFront(const Mesh& mesh,
  const Adjacency& adjacency,
  const Directions& directions,
  const std::vector<int>& chain,
  const FeatureCurve& curve,
  ChainDistances& straight,
  const Context& context);

} // namespace oversketch
#endif
