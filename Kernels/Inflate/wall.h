// Walls between the front and the back of a surface.
#ifndef oversketch_kernels_inflate_wall_h
#define oversketch_kernels_inflate_wall_h

#include "Inflate/sheet.h"
#include "Inflate/solid.h"

#include <vector>

namespace oversketch
{

// Joins a border of the front to that of the back by `rows` rows of quads, each two triangles where the face
// that the wall hangs on is one. Points between are equally spaced; all diagonals run the same way, so that
// points within the wall have six edges, four with quads. twins: of each point of the border that of the
// back.
void addWall(Solid& solid, const std::vector<BorderEdge>& border, const std::vector<int>& twins, int rows);

} // namespace oversketch
#endif
