#include "Ray/curve.h"

#include "Ray/wide.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr int bits = 10; // per axis

using WideBits = std::uint32_t __attribute__((vector_size(wide * sizeof(std::uint32_t))));

// All bits where the given one is set, none where it is not.
__attribute__((always_inline)) inline void everyBit(const WideBits& x, int bit, WideBits& all)
{
  all = -((x >> bit) & 1u);
}

// Two zeros before each bit.
__attribute__((always_inline)) inline void spread(WideBits& x)
{
  x = (x | x << 16) & 0x030000ffu;
  x = (x | x << 8) & 0x0300f00fu;
  x = (x | x << 4) & 0x030c30c3u;
  x = (x | x << 2) & 0x09249249u;
}

// Where the curve reaches some cells (Skilling, "Programming the Hilbert curve", 2004: undo the excess work
// of the Gray code, axis by axis).
OVERSKETCH_CLONES void curveKeys(const WideBits* cells, WideBits& keys)
{
  WideBits x[3] = { cells[0], cells[1], cells[2] }, set, flips = {};
  for (int bit = bits - 1; bit > 0; --bit)
  {
    const std::uint32_t lower = (1u << bit) - 1;
    for (WideBits& axis : x)
    {
      // The lower bits of the first axis are inverted where the bit is set, else exchanged with this one's.
      everyBit(axis, bit, set);
      const WideBits inverted = set & lower;
      const WideBits exchanged = (x[0] ^ axis) & (inverted ^ lower);
      x[0] ^= exchanged ^ inverted;
      axis ^= exchanged;
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  for (int bit = bits - 1; bit > 0; --bit)
  {
    everyBit(x[2], bit, set);
    flips ^= set & ((1u << bit) - 1);
  }
  keys = WideBits{};
  for (WideBits& axis : x)
  {
    axis ^= flips;
    spread(axis);
    keys = keys << 1 | axis;
  }
}

// The cell of a place along one axis.
std::uint32_t cellOf(float x)
{
  return static_cast<std::uint32_t>(std::clamp(512.0f * (x + 1.0f), 0.0f, 1023.0f));
}

} // namespace

CurveOrder curveOrder(const std::vector<std::array<float, 4>>& points, const Context& context)
{
  struct Entry
  {
    std::uint32_t key;
    int index;
  };
  const int count = static_cast<int>(points.size());
  std::vector<Entry> entries(points.size()), sorted(points.size());
  context.parallelFor((count + wide - 1) / wide,
    [&](int begin, int end)
    {
      for (int block = begin; block < end; ++block)
      {
        const int first = block * wide, last = std::min(first + wide, count);
        WideBits cells[3] = {}, keys;
        for (int i = first; i < last; ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            cells[k][i - first] = cellOf(points[i][k]);
          }
        }
        curveKeys(cells, keys);
        for (int i = first; i < last; ++i)
        {
          entries[i] = { keys[i - first], i };
        }
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
  CurveOrder order{ std::vector<int>(points.size()), std::vector<std::uint32_t>(points.size()) };
  for (int i = 0; i < count; ++i)
  {
    order.indices[i] = entries[i].index;
    order.cells[i] = entries[i].key;
  }
  return order;
}

} // namespace oversketch
