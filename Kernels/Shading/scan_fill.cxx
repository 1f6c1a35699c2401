#include "Shading/scan_fill.h"

#include "Mesh/context.h"

#include <algorithm>

namespace oversketch
{
namespace
{

constexpr int farthest = 1000000;

// An edge that is not horizontal, at one row: x + remainder / height, 0 <= remainder < height.
struct ScanEdge
{
  int bottom, top; // rows bottom <= y < top
  int x, remainder = 0;
  int step, stepRemainder; // from a row to the next

  ScanEdge(const Pixel& low, const Pixel& high)
    : bottom(low[1])
    , top(high[1])
    , x(low[0])
  {
    const int height = high[1] - low[1], across = high[0] - low[0];
    this->step = across / height - (across % height < 0 ? 1 : 0); // rounded down
    this->stepRemainder = across - this->step * height;
  }
  int firstInside() const { return this->x + (this->remainder > 0 ? 1 : 0); }
  void next()
  {
    this->x += this->step;
    this->remainder += this->stepRemainder;
    if (this->remainder >= this->top - this->bottom)
    {
      this->remainder -= this->top - this->bottom;
      ++this->x;
    }
  }
};

} // namespace

std::vector<Span> scanFill(const std::vector<Pixel>& polygon)
{
  std::vector<ScanEdge> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Pixel &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (std::abs(a[0]) > farthest || std::abs(a[1]) > farthest)
    {
      throw Error(
        Failure::BadStroke, "Point %1 of the selection lies far outside the picture; draw it anew.", i);
    }
    if (a[1] != b[1])
    {
      edges.emplace_back(a[1] < b[1] ? a : b, a[1] < b[1] ? b : a);
    }
  }
  std::sort(
    edges.begin(), edges.end(), [](const ScanEdge& a, const ScanEdge& b) { return a.bottom < b.bottom; });

  std::vector<Span> spans;
  std::vector<ScanEdge> active;
  std::vector<int> crossings;
  std::size_t next = 0;
  for (int y = edges.empty() ? 0 : edges.front().bottom; next < edges.size() || !active.empty(); ++y)
  {
    active.erase(
      std::remove_if(active.begin(), active.end(), [y](const ScanEdge& edge) { return edge.top == y; }),
      active.end());
    for (; next < edges.size() && edges[next].bottom == y; ++next)
    {
      active.push_back(edges[next]);
    }
    crossings.clear();
    for (ScanEdge& edge : active)
    {
      crossings.push_back(edge.firstInside());
      edge.next();
    }
    // Anew for each row: edges cross.
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      const int begin = crossings[i], end = crossings[i + 1];
      if (!spans.empty() && spans.back().y == y && spans.back().end == begin && begin < end)
      {
        spans.back().end = end;
      }
      else if (begin < end)
      {
        spans.push_back({ y, begin, end });
      }
    }
  }
  return spans;
}

std::vector<char> filledMask(const std::vector<Pixel>& polygon, int width, int height)
{
  std::vector<char> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (const Span& span : scanFill(polygon))
  {
    if (span.y >= 0 && span.y < height)
    {
      char* row = mask.data() + static_cast<std::size_t>(span.y) * static_cast<std::size_t>(width);
      const int begin = std::clamp(span.begin, 0, width), end = std::clamp(span.end, 0, width);
      std::fill(row + begin, row + end, 1);
    }
  }
  return mask;
}

} // namespace oversketch
