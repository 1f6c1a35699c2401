#include "Silhouette/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

// Written here because what libraries offer (cv::findContours, marching squares on a mask) follows pixel
// centres or the stairs between pixels: half a pixel of bias or of noise, which the targets would hand on to
// the result.

namespace oversketch
{

namespace
{

constexpr int largestWindow = 4096;

// Triangles seen in the image plane, those that reach behind the eye left out.
struct Picture
{
  std::vector<Vector2> points;
  std::vector<Triangle> triangles;
};

Picture project(const Mesh& mesh, const View& view)
{
  Picture picture;
  picture.points.resize(mesh.points.size(), Vector2::Zero());
  std::vector<char> seen(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (view.inFront(mesh.points[v]))
    {
      picture.points[v] = view.toDisplay(mesh.points[v]).head<2>();
      seen[v] = picture.points[v].allFinite();
    }
  }
  for (const Triangle& t : mesh.triangles)
  {
    if (seen[t[0]] && seen[t[1]] && seen[t[2]])
    {
      picture.triangles.push_back(t);
    }
  }
  return picture;
}

using Interval = std::array<double, 2>;

// The covered part of every pixel row (axis 1) or column (axis 0), measured along the line through the pixel
// centres: disjoint intervals in ascending order.
std::vector<std::vector<Interval>> coveredIntervals(const Picture& picture,
  int axis,
  int firstLine,
  int lineCount,
  const Context& context)
{
  const int along = 1 - axis;
  const auto lineRange = [&](const Triangle& t)
  {
    const double a = picture.points[t[0]][axis], b = picture.points[t[1]][axis],
                 c = picture.points[t[2]][axis];
    // Lines with low <= centre < high; clamped before the cast, since a point near the eye may be anywhere.
    const double low = std::ceil(std::min({ a, b, c }) - 0.5) - firstLine;
    const double high = std::ceil(std::max({ a, b, c }) - 0.5) - firstLine;
    return std::pair(static_cast<int>(std::clamp(low, 0.0, static_cast<double>(lineCount))),
      static_cast<int>(std::clamp(high, 0.0, static_cast<double>(lineCount))));
  };
  std::vector<std::size_t> offsets(static_cast<std::size_t>(lineCount) + 1, 0);
  for (const Triangle& t : picture.triangles)
  {
    const auto [low, high] = lineRange(t);
    for (int line = low; line < high; ++line)
    {
      ++offsets[line + 1];
    }
  }
  for (int line = 0; line < lineCount; ++line)
  {
    offsets[line + 1] += offsets[line];
  }
  std::vector<int> onLine(offsets.back());
  std::vector<std::size_t> fill(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < picture.triangles.size(); ++i)
  {
    const auto [low, high] = lineRange(picture.triangles[i]);
    for (int line = low; line < high; ++line)
    {
      onLine[fill[line]++] = static_cast<int>(i);
    }
  }
  std::vector<std::vector<Interval>> result(lineCount);
  context.parallelFor(lineCount,
    [&](int begin, int end)
    {
      std::vector<Interval> spans;
      for (int line = begin; line < end && !context.cancelled(); ++line)
      {
        const double centre = firstLine + line + 0.5;
        spans.clear();
        for (std::size_t k = offsets[line]; k < offsets[line + 1]; ++k)
        {
          const Triangle& t = picture.triangles[onLine[k]];
          Interval span{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
          for (int corner = 0; corner < 3; ++corner)
          {
            // Lower id first: both triangles of an edge compute the same crossing, bit for bit.
            const Vector2& a = picture.points[std::min(t[corner], t[(corner + 1) % 3])];
            const Vector2& b = picture.points[std::max(t[corner], t[(corner + 1) % 3])];
            if ((a[axis] <= centre) != (b[axis] <= centre))
            {
              const double s = (centre - a[axis]) / (b[axis] - a[axis]);
              const double x = a[along] + s * (b[along] - a[along]);
              span = { std::min(span[0], x), std::max(span[1], x) };
            }
          }
          if (span[0] <= span[1])
          {
            spans.push_back(span);
          }
        }
        std::sort(spans.begin(), spans.end());
        std::vector<Interval>& merged = result[line];
        for (const Interval& span : spans)
        {
          constexpr double seam = 1e-6; // px: rounding along an edge that two triangles do not share by index
          if (!merged.empty() && span[0] <= merged.back()[1] + seam)
          {
            merged.back()[1] = std::max(merged.back()[1], span[1]);
          }
          else
          {
            merged.push_back(span);
          }
        }
      }
    });
  return result;
}

// The covered area, asked by pixel.
class Coverage
{
public:
  Coverage(const Picture& picture, const PixelWindow& window, const Context& context)
    : window_(window)
    , rows_(coveredIntervals(picture, 1, window.y, window.height, context))
    , columns_(coveredIntervals(picture, 0, window.x, window.width, context))
    , covered_(static_cast<std::size_t>(window.width) * window.height, 0)
  {
    for (int j = 0; j < window.height; ++j)
    {
      for (const Interval& interval : this->rows_[j])
      {
        const double low = std::ceil(interval[0] - 0.5) - window.x;
        const double high = std::floor(interval[1] - 0.5) - window.x;
        const int end = static_cast<int>(std::clamp(high, -1.0, window.width - 1.0));
        for (int i = static_cast<int>(std::clamp(low, 0.0, window.width * 1.0)); i <= end; ++i)
        {
          this->covered_[this->index(i, j)] = 1;
        }
      }
    }
  }

  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->window_.width + static_cast<std::size_t>(i);
  }
  bool inside(int i, int j) const
  {
    return i >= 0 && j >= 0 && i < this->window_.width && j < this->window_.height;
  }
  bool operator()(int i, int j) const { return this->inside(i, j) && this->covered_[this->index(i, j)]; }

  // Where the boundary crosses the line from the centre of covered pixel (i, j) to that of its neighbour in
  // direction 0..3 = +x, +y, -x, -y, which is not covered.
  Vector2 crossing(int i, int j, int direction) const
  {
    const bool horizontal = direction % 2 == 0;
    const std::vector<Interval>& intervals = horizontal ? this->rows_[j] : this->columns_[i];
    Vector2 place(this->window_.x + i + 0.5, this->window_.y + j + 0.5);
    double& x = place[horizontal ? 0 : 1];
    const double towards = direction < 2 ? 1.0 : -1.0;
    const auto next = std::upper_bound(intervals.begin(),
      intervals.end(),
      x,
      [](double value, const Interval& interval) { return value < interval[0]; });
    // Rows decide which pixels are covered; a column may disagree by a rounding error, then the centre
    // serves.
    const bool found = next != intervals.begin() && (*(next - 1))[1] >= x;
    const double end = !found ? x : direction < 2 ? (*(next - 1))[1] : (*(next - 1))[0];
    x += towards * std::clamp((end - x) * towards, 0.0, 1.0);
    return place;
  }

private:
  PixelWindow window_;
  std::vector<std::vector<Interval>> rows_, columns_;
  std::vector<char> covered_;
};

constexpr int stepX[4] = { 1, 0, -1, 0 };
constexpr int stepY[4] = { 0, 1, 0, -1 };

double signedArea(const Polyline& loop)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector2& a = loop[i];
    const Vector2& b = loop[(i + 1) % loop.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

} // namespace

PixelWindow outlineWindow(const Mesh& mesh, const View& view, const Polyline& stroke)
{
  const Picture picture = project(mesh, view);
  Eigen::AlignedBox2d box;
  for (const Triangle& t : picture.triangles)
  {
    for (const int v : t)
    {
      box.extend(picture.points[v]);
    }
  }
  if (box.isEmpty())
  {
    return {};
  }
  if (box.sizes().maxCoeff() > largestWindow - 4)
  {
    Eigen::AlignedBox2d focus;
    for (const Vector2& p : stroke)
    {
      focus.extend(p);
    }
    if (stroke.empty())
    {
      focus.extend(Vector2(0.0, 0.0));
      focus.extend(Vector2(view.width(), view.height()));
    }
    const Vector2 half = Vector2::Constant(0.5 * (largestWindow - 4));
    box = box.intersection(Eigen::AlignedBox2d(focus.center() - half, focus.center() + half));
    if (box.isEmpty())
    {
      return {};
    }
  }
  PixelWindow window;
  window.x = static_cast<int>(std::floor(box.min()[0])) - 1;
  window.y = static_cast<int>(std::floor(box.min()[1])) - 1;
  window.width = static_cast<int>(std::ceil(box.max()[0])) + 1 - window.x;
  window.height = static_cast<int>(std::ceil(box.max()[1])) + 1 - window.y;
  return window;
}

std::vector<OutlineLoop> traceOutline(const Mesh& mesh,
  const View& view,
  const PixelWindow& window,
  const Context& context)
{
  std::vector<OutlineLoop> loops;
  if (window.width <= 0 || window.height <= 0)
  {
    return loops;
  }
  const Picture picture = project(mesh, view);
  context.checkpoint(0.1);
  const Coverage covered(picture, window, context);
  context.checkpoint(0.8);

  // A crack is a covered pixel and the direction of an uncovered neighbour. Walking along it, covered on the
  // left, the next one is found from the two pixels ahead.
  std::vector<std::uint8_t> visited(static_cast<std::size_t>(window.width) * window.height, 0);
  for (int startY = 0; startY < window.height; ++startY)
  {
    for (int startX = 0; startX < window.width; ++startX)
    {
      if (!covered(startX, startY))
      {
        continue;
      }
      for (int startSide = 0; startSide < 4; ++startSide)
      {
        int x = startX, y = startY, side = startSide;
        if (covered(x + stepX[side], y + stepY[side]) || (visited[covered.index(x, y)] >> side & 1))
        {
          continue;
        }
        Polyline points;
        std::vector<char> cut; // the crack is the window's edge, not the mesh's
        while (!(visited[covered.index(x, y)] >> side & 1))
        {
          visited[covered.index(x, y)] = static_cast<std::uint8_t>(visited[covered.index(x, y)] | 1 << side);
          points.push_back(covered.crossing(x, y, side));
          cut.push_back(!covered.inside(x + stepX[side], y + stepY[side]));
          const int heading = (side + 1) % 4;
          const int leftX = x + stepX[heading], leftY = y + stepY[heading];
          const int rightX = leftX + stepX[side], rightY = leftY + stepY[side];
          if (covered(rightX, rightY))
          {
            x = rightX;
            y = rightY;
            side = (side + 3) % 4;
          }
          else if (covered(leftX, leftY))
          {
            x = leftX;
            y = leftY;
          }
          else
          {
            side = heading;
          }
        }
        const auto firstCut = std::find(cut.begin(), cut.end(), 1);
        if (firstCut == cut.end())
        {
          const bool hole = signedArea(points) < 0.0;
          loops.push_back({ std::move(points), true, hole });
          continue;
        }
        // What lies between two cuts is an open piece of outline.
        const std::size_t count = points.size(), first = static_cast<std::size_t>(firstCut - cut.begin());
        OutlineLoop piece{ {}, false, false };
        for (std::size_t k = 1; k <= count; ++k)
        {
          const std::size_t i = (first + k) % count;
          if (!cut[i])
          {
            piece.points.push_back(points[i]);
          }
          else if (!piece.points.empty())
          {
            if (piece.points.size() > 1)
            {
              loops.push_back(piece);
            }
            piece.points.clear();
          }
        }
      }
    }
  }
  context.checkpoint(1.0);
  return loops;
}

Polyline smoothLoop(const Polyline& points, bool closed)
{
  const int count = static_cast<int>(points.size());
  constexpr double weights[5] = { 1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16 };
  if (count < 5)
  {
    return points;
  }
  Polyline smooth(points.size(), Vector2::Zero());
  for (int i = 0; i < count; ++i)
  {
    if (!closed && (i < 2 || i + 2 >= count))
    {
      smooth[i] = points[i];
      continue;
    }
    for (int k = -2; k <= 2; ++k)
    {
      smooth[i] += weights[k + 2] * points[(i + k + count) % count];
    }
  }
  return smooth;
}

std::vector<std::vector<OutlineStation>> attachSilhouette(const std::vector<OutlineLoop>& loops,
  const std::vector<VisibleCurve>& curves,
  double attachDistance)
{
  struct Track
  {
    Polyline points;
    std::vector<double> lengths;
    NearestPlace nearest;
    bool closed;
    double whole() const { return this->lengths.back(); }
  };
  std::vector<Track> tracks;
  for (const OutlineLoop& loop : loops)
  {
    const Polyline smooth = smoothLoop(loop.points, loop.closed);
    tracks.push_back(
      { smooth, arcLengths(smooth, loop.closed), NearestPlace(smooth, loop.closed), loop.closed });
  }
  struct Attachment
  {
    int loop = -1;
    NearestPlace::Answer place;
    double along = 0.0; // px along the loop
    Vector2 offset;
    int curve = -1, point = -1;
  };
  std::vector<std::vector<Attachment>> attached(loops.size());
  for (int c = 0; c < static_cast<int>(curves.size()); ++c)
  {
    const VisibleCurve& curve = curves[c];
    const int count = static_cast<int>(curve.display.size());
    std::vector<Attachment> found(curve.display.size());
    for (int i = 0; i < count; ++i)
    {
      double limit = attachDistance;
      for (int l = 0; l < static_cast<int>(tracks.size()); ++l)
      {
        const NearestPlace::Answer place = tracks[l].nearest(curve.display[i], limit);
        if (place.segment >= 0 && (found[i].loop < 0 || place.distance < limit))
        {
          const std::vector<double>& lengths = tracks[l].lengths;
          limit = place.distance;
          found[i] = { l,
            place,
            lengths[place.segment] + place.t * (lengths[place.segment + 1] - lengths[place.segment]),
            curve.display[i] - place.place,
            c,
            i };
        }
      }
    }
    // The step from point i to the next, along the loop they both hang on.
    const auto next = [&](int i) { return i + 1 < count ? i + 1 : curve.closed ? 0 : -1; };
    const auto progress = [&](int i, int j)
    {
      const Track& track = tracks[found[i].loop];
      double step = found[j].along - found[i].along;
      if (track.closed && std::abs(step) > 0.5 * track.whole())
      {
        step -= std::copysign(track.whole(), step);
      }
      return step;
    };
    const auto together = [&](int i, int j) { return found[i].loop >= 0 && found[i].loop == found[j].loop; };
    double run = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const int j = next(i);
      run += j >= 0 && together(i, j) ? progress(i, j) : 0.0;
    }
    const double sign = run < 0.0 ? -1.0 : 1.0;
    // +1: the step runs along the loop; -1: it runs back or leaves it sideways; 0: nothing to tell.
    const auto verdict = [&](int i, int j)
    {
      const double length = (curve.display[j] - curve.display[i]).norm();
      if (together(i, j))
      {
        return sign * progress(i, j) >= 0.3 * length ? 1 : length < 0.25 ? 0 : -1;
      }
      return length > 2.0 * attachDistance ? 0 : -1; // a long step says nothing of its ends
    };
    for (int i = 0; i < count; ++i)
    {
      if (found[i].loop < 0)
      {
        continue;
      }
      const int after = next(i), before = i > 0 ? i - 1 : curve.closed ? count - 1 : -1;
      const int ahead = after >= 0 ? verdict(i, after) : 0, behind = before >= 0 ? verdict(before, i) : 0;
      if (ahead > 0 || behind > 0 || (ahead == 0 && behind == 0))
      {
        attached[found[i].loop].push_back(found[i]);
      }
    }
  }

  std::vector<std::vector<OutlineStation>> outlines(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    const Track& track = tracks[l];
    std::vector<Attachment>& list = attached[l];
    std::stable_sort(
      list.begin(), list.end(), [](const Attachment& a, const Attachment& b) { return a.along < b.along; });
    // The offset of a loop point between two attached ones.
    const auto offsetAt = [&](double along, std::size_t nextIndex)
    {
      if (list.empty())
      {
        return Vector2(Vector2::Zero());
      }
      const bool wraps = nextIndex == 0 || nextIndex == list.size();
      const Attachment& a = wraps ? list.back() : list[nextIndex - 1];
      const Attachment& b = wraps ? list.front() : list[nextIndex];
      if (wraps && !track.closed)
      {
        return nextIndex == 0 ? b.offset : a.offset;
      }
      double gap = b.along - a.along, step = along - a.along;
      gap += wraps ? track.whole() : 0.0;
      step += step < 0.0 ? track.whole() : 0.0;
      return Vector2(gap > 0.0 ? a.offset + step / gap * (b.offset - a.offset) : a.offset);
    };
    std::size_t k = 0;
    for (int i = 0; i < static_cast<int>(track.points.size()); ++i)
    {
      outlines[l].push_back({ track.points[i], offsetAt(track.lengths[i], k), -1, -1 });
      for (; k < list.size() && list[k].place.segment == i; ++k)
      {
        outlines[l].push_back({ list[k].place.place, list[k].offset, list[k].curve, list[k].point });
      }
    }
  }
  return outlines;
}

} // namespace oversketch
