// Points along a space-filling curve: neighbours on it are neighbours in space.
#ifndef oversketch_kernels_ray_curve_h
#define oversketch_kernels_ray_curve_h

#include "Mesh/context.h"

#include <array>
#include <cstdint>
#include <vector>

namespace oversketch
{

// Points within [-1, 1] along a Hilbert curve through 1024^3 cells.
struct CurveOrder
{
  std::vector<int> indices;         // ascending within a cell
  std::vector<std::uint32_t> cells; // of each of them where the curve reaches its cell: the same in one cell
};
CurveOrder curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context);

} // namespace oversketch
#endif
