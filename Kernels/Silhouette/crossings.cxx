#include "Silhouette/crossings.h"

#include "Mesh/context.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

namespace
{

double cross(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// A uniform grid of the segments' boxes. What lies far outside the middle of the picture, as perspective can
// throw it, falls into the cells of the rim.
struct Grid
{
  Vector2 origin = Vector2::Zero(), perUnit = Vector2::Zero();
  int side;

  explicit Grid(const std::vector<ImageSegment>& segments)
    : side(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(segments.size())))))
  {
    for (int k = 0; k < 2; ++k)
    {
      std::vector<double> values;
      values.reserve(segments.size());
      for (const ImageSegment& s : segments)
      {
        values.push_back(s.from[k]);
      }
      // The middle 98 % decide.
      const auto rank = [&](double share)
      {
        const auto at =
          values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), at, values.end());
        return *at;
      };
      const double low = rank(0.01), high = rank(0.99);
      this->origin[k] = low;
      this->perUnit[k] = high > low ? this->side / (high - low) : 0.0;
    }
  }

  int cell(double value, int k) const
  {
    const double place = (value - this->origin[k]) * this->perUnit[k];
    return place <= 0.0 ? 0 : place >= this->side - 1 ? this->side - 1 : static_cast<int>(place);
  }
};

} // namespace

std::vector<Crossing> findCrossings(const std::vector<ImageSegment>& segments)
{
  std::vector<Crossing> crossings;
  if (segments.empty())
  {
    return crossings;
  }
  for (const ImageSegment& s : segments)
  {
    if (!s.from.allFinite() || !s.to.allFinite())
    {
      throw Error(Failure::BadStroke,
        "A curve of the outline has no place in the picture: it passes through the plane of the camera, or "
        "the mesh or the view is damaged. Draw the stroke in a view from farther away.");
    }
  }
  const Grid grid(segments);
  const int cellCount = grid.side * grid.side;
  std::vector<int> starts(cellCount + 1, 0), entries;
  const auto eachCell = [&](const ImageSegment& s, auto&& visit)
  {
    const Vector2 low = s.from.cwiseMin(s.to), high = s.from.cwiseMax(s.to);
    const int x0 = grid.cell(low[0], 0), x1 = grid.cell(high[0], 0), y1 = grid.cell(high[1], 1);
    for (int y = grid.cell(low[1], 1); y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        visit(y * grid.side + x);
  };
  for (const ImageSegment& s : segments)
  {
    eachCell(s, [&](int cell) { ++starts[cell + 1]; });
  }
  for (int i = 0; i < cellCount; ++i)
  {
    starts[i + 1] += starts[i];
  }
  entries.resize(starts[cellCount]);
  std::vector<int> next(starts.begin(), starts.end() - 1);
  for (int i = 0; i < static_cast<int>(segments.size()); ++i)
  {
    eachCell(segments[i], [&](int cell) { entries[next[cell]++] = i; });
  }

  const auto test = [&](int i, int j, int cell)
  {
    const ImageSegment& p = segments[i];
    const ImageSegment& q = segments[j];
    const Vector2 low = p.from.cwiseMin(p.to).cwiseMax(q.from.cwiseMin(q.to));
    const Vector2 high = p.from.cwiseMax(p.to).cwiseMin(q.from.cwiseMax(q.to));
    // A pair belongs to the cell of the low corner of what their boxes share.
    if (low[0] > high[0] || low[1] > high[1] ||
        grid.cell(low[1], 1) * grid.side + grid.cell(low[0], 0) != cell)
    {
      return;
    }
    if (p.curve == q.curve &&
        (p.first == q.first || p.first == q.second || p.second == q.first || p.second == q.second))
    {
      return;
    }
    const double q0 = cross(p.to - p.from, q.from - p.from), q1 = cross(p.to - p.from, q.to - p.from);
    const double p0 = cross(q.to - q.from, p.from - q.from), p1 = cross(q.to - q.from, p.to - q.from);
    if ((q0 >= 0.0) != (q1 >= 0.0) && (p0 >= 0.0) != (p1 >= 0.0))
    {
      crossings.push_back({ i, p0 / (p0 - p1) });
      crossings.push_back({ j, q0 / (q0 - q1) });
    }
  };
  for (int cell = 0; cell < cellCount; ++cell)
  {
    for (int i = starts[cell]; i < starts[cell + 1]; ++i)
      for (int j = i + 1; j < starts[cell + 1]; ++j)
        test(entries[i], entries[j], cell);
  }
  std::sort(crossings.begin(),
    crossings.end(),
    [](const Crossing& a, const Crossing& b)
    { return a.segment != b.segment ? a.segment < b.segment : a.place < b.place; });
  return crossings;
}

} // namespace oversketch
