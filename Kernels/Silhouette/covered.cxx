#include "Silhouette/covered.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace oversketch
{

namespace
{

// Where a triangle's edge crosses the line along which the coordinate `axis` is `centre`. Lower id first:
// both triangles of an edge compute the same crossing, bit for bit.
CoveredEnd crossingOf(const PicturePoints& picture, int corner, int next, int axis, double centre)
{
  const int v0 = std::min(corner, next), v1 = std::max(corner, next);
  const Vector2 &a = picture.points[v0], &b = picture.points[v1];
  const double s = (centre - a[axis]) / (b[axis] - a[axis]);
  return { a[1 - axis] + s * (b[1 - axis] - a[1 - axis]), v0, v1, s };
}

// Span that a triangle covers of such a line, as much of it as merging needs.
struct Span
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  int triangle;

  Span(const PicturePoints& picture, const Triangle& t, int triangleId, int axis, double centre)
    : triangle(triangleId)
  {
    const auto below = [&](int k) { return int(picture.points[t[k]][axis] <= centre); };
    // The corner that the line parts from the others; both edges there cross it. Without a branch that goes
    // wrong for every other triangle.
    constexpr int apart[8] = { -1, 0, 1, 2, 2, 1, 0, -1 };
    const int k = apart[below(0) + 2 * below(1) + 4 * below(2)];
    if (k >= 0)
    {
      for (const int other : { (k + 1) % 3, (k + 2) % 3 })
      {
        const double at = crossingOf(picture, t[k], t[other], axis, centre).at;
        this->low = at < this->low ? at : this->low;
        this->high = at > this->high ? at : this->high;
      }
    }
  }
  bool empty() const { return !(this->low <= this->high); }
  bool operator<(const Span& other) const
  {
    return this->low != other.low ? this->low < other.low : this->triangle < other.triangle;
  }
  // The low end, or the high one; of two that are equal that of the first edge.
  CoveredEnd end(const PicturePoints& picture, const Triangle& t, int axis, double centre, bool isHigh) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if ((picture.points[t[k]][axis] <= centre) != (picture.points[t[next]][axis] <= centre))
      {
        const CoveredEnd crossing = crossingOf(picture, t[k], t[next], axis, centre);
        if (crossing.at == (isHigh ? this->high : this->low))
        {
          return crossing;
        }
      }
    }
    return {};
  }
};

// Sorts spans of a line `length` px long by their low ends. By the pixel first: there are few in one.
class SpanSorter
{
public:
  SpanSorter(int first, int length)
    : First(first)
    , Starts(static_cast<std::size_t>(length) + 3)
  {
  }
  const std::vector<Span>& operator()(const std::vector<Span>& spans)
  {
    std::fill(this->Starts.begin(), this->Starts.end(), 0);
    for (const Span& span : spans)
    {
      ++this->Starts[this->pixel(span) + 1];
    }
    std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
    this->Sorted = spans;
    for (const Span& span : spans)
    {
      this->Sorted[this->Starts[this->pixel(span)]++] = span;
    }
    auto begin = this->Sorted.begin();
    for (const int start : this->Starts) // by now where the next pixel's begin
    {
      const auto end = this->Sorted.begin() + start;
      std::sort(begin, end);
      begin = end;
    }
    return this->Sorted;
  }

private:
  std::size_t pixel(const Span& span) const
  {
    const double last = static_cast<double>(this->Starts.size() - 2);
    return static_cast<std::size_t>(std::clamp(span.low - this->First + 1.0, 0.0, last));
  }

  int First;
  std::vector<int> Starts;
  std::vector<Span> Sorted;
};

} // namespace

PicturePoints::PicturePoints(const Mesh& mesh, const View& view, const Context& context)
  : model(mesh)
  , from(view)
  , points(mesh.points.size())
  , seen(mesh.points.size(), 0)
{
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      if (view.inFront(mesh.points[v]))
      {
        this->points[v] = view.toDisplay(mesh.points[v]).head<2>();
        this->seen[v] = this->points[v].allFinite();
      }
    });
}

MeshPicture::MeshPicture(const Mesh& mesh,
  const View& view,
  const PixelWindow& window,
  const Context& context)
  : PicturePoints(mesh, view, context)
{
  constexpr int unseen = 16;
  std::vector<char> beyond(mesh.points.size()); // unseen, or the sides of the window that a point lies beyond
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      const Vector2& p = this->points[v];
      beyond[v] = static_cast<char>(
        !this->seen[v] ? unseen
                       : int(p[0] < window.x - 1) + 2 * int(p[0] > window.x + window.width + 1) +
                           4 * int(p[1] < window.y - 1) + 8 * int(p[1] > window.y + window.height + 1));
    });
  std::vector<std::vector<Triangle>> parts(partCount(mesh));
  eachTriangle(mesh,
    context,
    [&](int part, const Triangle& t)
    {
      const char a = beyond[t[0]], b = beyond[t[1]], c = beyond[t[2]];
      if ((a | b | c) < unseen && (a & b & c) == 0)
      {
        parts[part].push_back(t);
      }
    });
  std::size_t count = 0;
  for (const std::vector<Triangle>& part : parts)
  {
    count += part.size();
  }
  this->triangles.reserve(count);
  for (const std::vector<Triangle>& part : parts)
  {
    this->triangles.insert(this->triangles.end(), part.begin(), part.end());
  }
}

Binding CoveredEnd::binding(const PicturePoints& picture) const
{
  const double w0 = (1.0 - this->t) * picture.nearness(this->v0), w1 = this->t * picture.nearness(this->v1);
  return Binding::edge(this->v0, this->v1, w0 / (w0 + w1));
}

std::vector<std::vector<CoveredInterval>> coveredIntervals(const PicturePoints& picture,
  const std::vector<Triangle>& triangles,
  int axis,
  const PixelWindow& window,
  const Context& context)
{
  const int firstLine = axis == 1 ? window.y : window.x, firstAlong = axis == 1 ? window.x : window.y;
  const int lineCount = axis == 1 ? window.height : window.width;
  const int length = axis == 1 ? window.width : window.height;
  // Per triangle its lines: low <= centre < high.
  std::vector<std::array<int, 2>> lines(triangles.size());
  context.each(static_cast<int>(lines.size()),
    [&](int i)
    {
      const Triangle& t = triangles[i];
      const double a = picture.points[t[0]][axis], b = picture.points[t[1]][axis],
                   c = picture.points[t[2]][axis];
      // Clamped before the cast, since a point near the eye may be anywhere.
      const auto lineAt = [&](double at)
      {
        return static_cast<int>(
          std::clamp(std::ceil(at - 0.5) - firstLine, 0.0, static_cast<double>(lineCount)));
      };
      lines[i] = { lineAt(std::min({ a, b, c })), lineAt(std::max({ a, b, c })) };
    });
  std::vector<std::size_t> offsets(static_cast<std::size_t>(lineCount) + 1, 0);
  for (const auto& [low, high] : lines)
  {
    for (int line = low; line < high; ++line)
    {
      ++offsets[line + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> onLine(offsets.back());
  std::vector<std::size_t> fill(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    for (int line = lines[i][0]; line < lines[i][1]; ++line)
    {
      onLine[fill[line]++] = static_cast<int>(i);
    }
  }
  std::vector<std::vector<CoveredInterval>> result(lineCount);
  context.parallelFor(lineCount,
    [&](int begin, int end)
    {
      std::vector<Span> spans;
      SpanSorter sorted(firstAlong, length);
      for (int line = begin; line < end && !context.cancelled(); ++line)
      {
        const double centre = firstLine + line + 0.5;
        spans.clear();
        for (std::size_t k = offsets[line]; k < offsets[line + 1]; ++k)
        {
          const Span span(picture, triangles[onLine[k]], onLine[k], axis, centre);
          if (!span.empty())
          {
            spans.push_back(span);
          }
        }
        const Span *first = nullptr, *last = nullptr;
        const auto put = [&]
        {
          result[line].push_back({ first->end(picture, triangles[first->triangle], axis, centre, false),
            last->end(picture, triangles[last->triangle], axis, centre, true) });
        };
        for (const Span& span : sorted(spans))
        {
          constexpr double seam = 1e-6; // px: rounding along an edge that two triangles do not share by index
          if (!first || span.low > last->high + seam)
          {
            if (first)
            {
              put();
            }
            first = last = &span;
          }
          else if (span.high > last->high)
          {
            last = &span;
          }
        }
        if (first)
        {
          put();
        }
      }
    });
  return result;
}

} // namespace oversketch
