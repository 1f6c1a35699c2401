// A polygon with holes in the plane as triangles, for what rounding has left of a face.
#ifndef oversketch_kernels_join_polygon_h
#define oversketch_kernels_join_polygon_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// Twice the area that a loop of points goes round, below 0 where it goes clockwise.
double turnedArea(const std::vector<Vector2>& points, const std::vector<int>& loop);

bool isInLoop(const std::vector<Vector2>& points, const std::vector<int>& loop, const Vector2& p);

// The triangles of what the first loop, counter-clockwise, encloses without the others, clockwise: by ears,
// then Lawson's flips. The loops' edges are the triangles', each once, whatever rounding makes of the points:
// where no ear is left the corner with the least area is one. Why ours: constrainedDelaunay refuses lines
// that cross, and by a rounding they do here.
std::vector<Triangle> triangulatePolygon(const std::vector<Vector2>& points,
  std::vector<std::vector<int>> loops);

} // namespace oversketch
#endif
