// Points along a space-filling curve: neighbours on it are neighbours in space.
#ifndef oversketch_curve_h
#define oversketch_curve_h

#include "Mesh/context.h"

#include <array>
#include <cstdint>
#include <vector>

namespace oversketch
{

// The cell of a point within [-1, 1].
std::array<std::uint32_t, 3> curveCell(const std::array<float, 4>& point);

// The indices of points within [-1, 1] along a Hilbert curve through 1024^3 cells; ascending within a cell.
std::vector<int> curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context);

} // namespace oversketch
#endif
