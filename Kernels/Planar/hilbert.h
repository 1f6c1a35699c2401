// Places in the plane in an order in which neighbours are near each other.
#ifndef oversketch_planar_hilbert_h
#define oversketch_planar_hilbert_h

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace oversketch
{

// The place of a cell of a grid of 2^16 x 2^16 on Hilbert's curve.
inline std::uint32_t hilbertPlace(std::uint32_t x, std::uint32_t y)
{
  std::uint32_t place = 0;
  for (std::uint32_t s = 1u << 15; s > 0; s >>= 1)
  {
    const std::uint32_t rx = (x & s) ? 1 : 0, ry = (y & s) ? 1 : 0;
    place += s * s * ((3 * rx) ^ ry);
    if (ry == 0)
    {
      if (rx == 1)
      {
        x = 0xffff - x;
        y = 0xffff - y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

// Numbers of the points along the curve through their box; those in one cell in their own order.
inline std::vector<int> alongHilbert(const std::vector<Eigen::Vector2d>& points)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points)
  {
    box.extend(p);
  }
  const double size = points.empty() ? 0.0 : box.sizes().maxCoeff();
  std::vector<std::pair<std::uint32_t, int>> keys;
  for (const Eigen::Vector2d& p : points)
  {
    const auto cell = [&](int axis)
    { return static_cast<std::uint32_t>(size > 0.0 ? 65535.0 * ((p[axis] - box.min()[axis]) / size) : 0.0); };
    keys.emplace_back(hilbertPlace(cell(0), cell(1)), static_cast<int>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  for (const auto& key : keys)
  {
    order.push_back(key.second);
  }
  return order;
}

} // namespace oversketch
#endif
