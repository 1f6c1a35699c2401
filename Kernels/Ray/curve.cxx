#include "Ray/curve.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr int bits = 10; // per axis

// Where the curve reaches a cell (Skilling, "Programming the Hilbert curve", 2004: undo the excess work of
// the Gray code, axis by axis).
std::uint32_t curveKey(std::array<std::uint32_t, 3> x)
{
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
  {
    const std::uint32_t lower = q - 1;
    for (std::uint32_t& axis : x)
    {
      // The lower bits of the first axis are inverted where the bit is set, else exchanged with this one's:
      // without a branch, which would go wrong every other time.
      const std::uint32_t inverted = axis & q ? lower : 0;
      const std::uint32_t exchanged = (x[0] ^ axis) & (lower ^ inverted);
      x[0] ^= exchanged ^ inverted;
      axis ^= exchanged;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flips = 0;
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
  {
    flips ^= x[2] & q ? q - 1 : 0;
  }
  std::uint32_t key = 0;
  for (int bit = bits - 1; bit >= 0; --bit)
  {
    for (const std::uint32_t axis : x)
    {
      key = 2 * key + (((axis ^ flips) >> bit) & 1);
    }
  }
  return key;
}

} // namespace

std::array<std::uint32_t, 3> curveCell(const std::array<float, 4>& point)
{
  std::array<std::uint32_t, 3> cell;
  for (int k = 0; k < 3; ++k)
  {
    cell[k] = static_cast<std::uint32_t>(std::clamp(512.0f * (point[k] + 1.0f), 0.0f, 1023.0f));
  }
  return cell;
}

std::vector<int> curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context)
{
  struct Entry
  {
    std::uint32_t key;
    int index;
  };
  const int count = static_cast<int>(points.size());
  std::vector<Entry> entries(points.size()), sorted(points.size());
  context.parallelFor(count,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        entries[i] = { curveKey(curveCell(points[i])), i };
      }
    });
  // Stable, digit by digit: serial, yet a small part of what the order saves.
  for (int shift = 0; shift < 3 * bits; shift += bits)
  {
    std::array<int, (1 << bits) + 1> starts{};
    const auto digit = [shift](const Entry& e) { return (e.key >> shift) & ((1u << bits) - 1); };
    for (const Entry& entry : entries)
    {
      ++starts[digit(entry) + 1];
    }
    for (int i = 0; i < 1 << bits; ++i)
    {
      starts[i + 1] += starts[i];
    }
    for (const Entry& entry : entries)
    {
      sorted[starts[digit(entry)]++] = entry;
    }
    entries.swap(sorted);
  }
  std::vector<int> order(points.size());
  std::transform(entries.begin(), entries.end(), order.begin(), [](const Entry& e) { return e.index; });
  return order;
}

} // namespace oversketch
