#include "Raster/nearest.h"

#include <algorithm>
#include <limits>

namespace oversketch
{
namespace
{

// Finds in a strip of columns the row of the nearest chosen pixel in each pixel's column; -1: none.
void searchColumns(const std::uint8_t* chosen, int width, int height, int begin, int end, int* rows)
{
  const auto at = [width](int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width); };
  std::vector<int> last(static_cast<std::size_t>(end - begin), -1);
  for (int y = 0; y < height; ++y)
  {
    for (int x = begin; x < end; ++x)
    {
      int& below = last[static_cast<std::size_t>(x - begin)];
      below = chosen[at(y) + x] ? y : below;
      rows[at(y) + x] = below;
    }
  }
  std::fill(last.begin(), last.end(), -1);
  for (int y = height - 1; y >= 0; --y)
  {
    for (int x = begin; x < end; ++x)
    {
      int& above = last[static_cast<std::size_t>(x - begin)];
      int& own = rows[at(y) + x];
      above = chosen[at(y) + x] ? y : above;
      const bool isNearer = above >= 0 && (own < 0 || above - y < y - own);
      own = isNearer ? above : own;
    }
  }
}

// The columns whose pixels are the nearest ones somewhere in a row, and where each begins to be.
struct Envelope
{
  std::vector<int> column;
  std::vector<double> begin;

  // nearest: the row of the nearest one of each column.
  void find(const int* nearest, int width, int y)
  {
    this->column.clear();
    this->begin.clear();
    const auto height = [&](int x)
    {
      const double far = y - nearest[x];
      return far * far + static_cast<double>(x) * x;
    };
    for (int x = 0; x < width; ++x)
    {
      const bool isWithin =
        x > 0 && x + 1 < width && nearest[x] == y && nearest[x - 1] == y && nearest[x + 1] == y;
      if (nearest[x] < 0 || isWithin) // the ends of what is chosen in the row are nearer to all else
      {
        continue;
      }
      const double own = height(x);
      double from = -std::numeric_limits<double>::infinity();
      while (!this->column.empty())
      {
        const int before = this->column.back();
        from = (own - height(before)) / (2.0 * (x - before));
        if (from > this->begin.back())
        {
          break;
        }
        this->column.pop_back();
        this->begin.pop_back();
        from = -std::numeric_limits<double>::infinity();
      }
      this->column.push_back(x);
      this->begin.push_back(from);
    }
  }
};

} // namespace

std::vector<int> nearestChosen(const std::vector<std::uint8_t>& chosen,
  int width,
  int height,
  const Context& context)
{
  std::vector<int> nearest(chosen.size());
  context.parallelFor(width,
    [&](int begin, int end) { searchColumns(chosen.data(), width, height, begin, end, nearest.data()); });
  context.checkpoint(0.4);
  context.parallelFor(height,
    [&](int begin, int end)
    {
      Envelope envelope;
      std::vector<int> row(static_cast<std::size_t>(width));
      for (int y = begin; y < end && !context.cancelled(); ++y)
      {
        int* own = nearest.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        std::copy_n(own, width, row.begin());
        envelope.find(row.data(), width, y);
        std::size_t k = 0;
        for (int x = 0; x < width && !envelope.column.empty(); ++x)
        {
          if (row[static_cast<std::size_t>(x)] == y)
          {
            own[x] = y * width + x;
            continue;
          }
          while (k + 1 < envelope.column.size() && envelope.begin[k + 1] < x)
          {
            ++k;
          }
          const int column = envelope.column[k];
          own[x] = row[static_cast<std::size_t>(column)] * width + column;
        }
      }
    });
  context.checkpoint(1.0);
  return nearest;
}

} // namespace oversketch
