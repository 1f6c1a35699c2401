// Crossings of polylines on the image plane.
#ifndef oversketch_kernels_silhouette_crossings_h
#define oversketch_kernels_silhouette_crossings_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// A polyline's segment on the image plane, from point `first` to point `second` of a curve.
struct ImageSegment
{
  int curve, first, second;
  Vector2 from, to;
};

// Where a segment is crossed: at from + place * (to - from), place in [0, 1].
struct Crossing
{
  int segment;
  double place;
};

// All crossings of segments that share no point, two entries for each, ascending by segment and place. A
// segment whose end lies exactly on another crosses it if it does so after an infinitesimal shift, so a
// polyline that crosses another in a point of its own does it once.
std::vector<Crossing> findCrossings(const std::vector<ImageSegment>& segments);

} // namespace oversketch
#endif
