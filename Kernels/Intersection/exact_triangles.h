// Whether triangles and segments in space meet, by CGAL's kernel of exact predicates (LGPL). Not installed.
#ifndef oversketch_kernels_intersection_exact_triangles_h
#define oversketch_kernels_intersection_exact_triangles_h

#include "Mesh/mesh.h"

#include <array>

namespace oversketch
{

using Corners = std::array<Vector3, 3>;

// Whether the corners lie on no line. False where one is not finite.
bool hasExactArea(const Corners& t);

// Whether two triangles with area have a point in common.
bool trianglesMeet(const Corners& a, const Corners& b);

// Whether two triangles with area whose corners 0 are the same have another point in common.
bool fansMeet(const Corners& a, const Corners& b);

} // namespace oversketch
#endif
