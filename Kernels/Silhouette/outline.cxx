#include "Silhouette/outline.h"

#include "Mesh/shape.h"
#include "Silhouette/covered.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

// Written here because what libraries offer (cv::findContours, marching squares on a mask) follows pixel
// centres or the stairs between pixels: half a pixel of bias or of noise, which the targets would hand on to
// the result.

namespace oversketch
{

namespace
{

constexpr int largestWindow = 4096;

// The covered area, asked by pixel.
class Coverage
{
public:
  Coverage(const MeshPicture& picture, const PixelWindow& window, const Context& context)
    : Window(window)
    , Rows(coveredIntervals(picture, picture.triangles, 1, window, context))
    , Covered(static_cast<std::size_t>(window.width) * window.height, 0)
  {
    for (int j = 0; j < window.height; ++j)
    {
      for (const CoveredInterval& interval : this->Rows[j])
      {
        const double low = std::ceil(interval.low.at - 0.5) - window.x;
        const double high = std::floor(interval.high.at - 0.5) - window.x;
        const int end = static_cast<int>(std::clamp(high, -1.0, window.width - 1.0));
        for (int i = static_cast<int>(std::clamp(low, 0.0, window.width * 1.0)); i <= end; ++i)
        {
          this->Covered[this->index(i, j)] = 1;
        }
      }
    }
    // Columns are asked only for their crossings: what lies about them makes the same ones.
    this->Columns = coveredIntervals(picture, this->aboutCrossings(picture, context), 0, window, context);
  }

  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Window.width + static_cast<std::size_t>(i);
  }
  bool inside(int i, int j) const
  {
    return i >= 0 && j >= 0 && i < this->Window.width && j < this->Window.height;
  }
  bool operator()(int i, int j) const { return this->inside(i, j) && this->Covered[this->index(i, j)]; }
  // Covered as its four neighbours are: no outline here. Most pixels are that.
  bool within(int i, int j) const
  {
    const char* pixel = this->Covered.data() + this->index(i, j);
    return i > 0 && j > 0 && i + 1 < this->Window.width && j + 1 < this->Window.height && pixel[0] &&
           pixel[-1] && pixel[1] && pixel[-this->Window.width] && pixel[this->Window.width];
  }

  // Where the boundary crosses the line from the centre of covered pixel (i, j) to that of its neighbour in
  // direction 0..3 = +x, +y, -x, -y, which is not covered; and the mesh edge that makes it.
  std::pair<Vector2, Binding> crossing(const MeshPicture& picture, int i, int j, int direction) const
  {
    const bool horizontal = direction % 2 == 0;
    const std::vector<CoveredInterval>& intervals = horizontal ? this->Rows[j] : this->Columns[i];
    Vector2 place(this->Window.x + i + 0.5, this->Window.y + j + 0.5);
    double& x = place[horizontal ? 0 : 1];
    const double towards = direction < 2 ? 1.0 : -1.0;
    const auto next = std::upper_bound(intervals.begin(),
      intervals.end(),
      x,
      [](double value, const CoveredInterval& interval) { return value < interval.low.at; });
    // Rows decide which pixels are covered; a column may disagree by a rounding error, then the centre
    // serves.
    if (next == intervals.begin() || (next - 1)->high.at < x)
    {
      return { place, Binding() };
    }
    const CoveredEnd& end = direction < 2 ? (next - 1)->high : (next - 1)->low;
    const double reach = (end.at - x) * towards;
    x += towards * std::clamp(reach, 0.0, 1.0);
    return { place, reach <= 1.0 ? end.binding(picture) : Binding() };
  }

private:
  // The triangles that may lie within a pixel of where a column leaves the covered pixels.
  std::vector<Triangle> aboutCrossings(const MeshPicture& picture, const Context& context) const
  {
    const int width = this->Window.width, height = this->Window.height;
    std::vector<char> about(this->Covered.size(), 0);
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        if (!this->within(i, j) && (*this)(i, j) && !((*this)(i, j - 1) && (*this)(i, j + 1)))
        {
          for (int k = std::max(j - 2, 0); k <= std::min(j + 2, height - 1); ++k)
          {
            about[this->index(i, k)] = 1;
          }
        }
      }
    }
    const auto chosen = [&](const Triangle& t)
    {
      const Vector2 &a = picture.points[t[0]], &b = picture.points[t[1]], &c = picture.points[t[2]];
      const Vector2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      constexpr double large = 8.0; // px: to look at so many pixels would take longer than it saves
      if ((high - low).maxCoeff() > large)
      {
        return true;
      }
      const auto pixel = [](double at, int first, int count)
      { return static_cast<int>(std::clamp(std::floor(at) - first, 0.0, count - 1.0)); };
      const int left = pixel(low[0], this->Window.x, width), right = pixel(high[0], this->Window.x, width);
      const int top = pixel(high[1], this->Window.y, height);
      for (int j = pixel(low[1], this->Window.y, height); j <= top; ++j)
      {
        const char* row = about.data() + this->index(0, j);
        if (std::find(row + left, row + right + 1, 1) != row + right + 1)
        {
          return true;
        }
      }
      return false;
    };
    std::vector<char> keep(picture.triangles.size(), 0);
    context.each(static_cast<int>(keep.size()), [&](int t) { keep[t] = chosen(picture.triangles[t]); });
    return valuesAt(picture.triangles, marked(keep));
  }

  PixelWindow Window;
  std::vector<std::vector<CoveredInterval>> Rows, Columns;
  std::vector<char> Covered;
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
    area += 0.5 * cross(a, b);
  }
  return area;
}

PixelWindow pixelsOf(const Eigen::AlignedBox2d& box)
{
  PixelWindow window;
  window.x = static_cast<int>(std::floor(box.min()[0])) - 1;
  window.y = static_cast<int>(std::floor(box.min()[1])) - 1;
  window.width = static_cast<int>(std::ceil(box.max()[0])) + 1 - window.x;
  window.height = static_cast<int>(std::ceil(box.max()[1])) + 1 - window.y;
  return window;
}

} // namespace

PixelWindow outlineWindow(const Mesh& mesh, const View& view, const Polyline& stroke, const Context& context)
{
  const PicturePoints projection(mesh, view, context);
  std::vector<Eigen::AlignedBox2d> boxes(partCount(mesh));
  eachTriangle(mesh,
    context,
    [&](int part, const Triangle& t)
    {
      for (int k = 0; projection.sees(t) && k < 3; ++k)
      {
        boxes[part].extend(projection.points[t[k]]);
      }
    });
  Eigen::AlignedBox2d box;
  for (const Eigen::AlignedBox2d& part : boxes)
  {
    box.extend(part);
  }
  if (box.isEmpty())
  {
    return {};
  }
  if (box.sizes().maxCoeff() > largestWindow - 4)
  {
    Eigen::AlignedBox2d focus = boxRound(stroke);
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
  return pixelsOf(box);
}

PixelWindow strokeWindow(const Polyline& stroke, double margin)
{
  const Eigen::AlignedBox2d box = boxRound(stroke);
  const Vector2 half = (0.5 * box.sizes() + Vector2::Constant(margin)).cwiseMin(0.5 * (largestWindow - 4));
  return pixelsOf({ Vector2(box.center() - half), Vector2(box.center() + half) });
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
  const MeshPicture picture(mesh, view, window, context);
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
      if (covered.within(startX, startY) || !covered(startX, startY))
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
        std::vector<Binding> edges;
        std::vector<char> cut; // the crack is the window's edge, not the mesh's
        while (!(visited[covered.index(x, y)] >> side & 1))
        {
          visited[covered.index(x, y)] = static_cast<std::uint8_t>(visited[covered.index(x, y)] | 1 << side);
          const auto [point, edge] = covered.crossing(picture, x, y, side);
          points.push_back(point);
          edges.push_back(edge);
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
          loops.push_back({ std::move(points), true, hole, std::move(edges) });
          continue;
        }
        // What lies between two cuts is an open piece of outline.
        const std::size_t count = points.size(), first = static_cast<std::size_t>(firstCut - cut.begin());
        OutlineLoop piece{ {}, false, false, {} };
        for (std::size_t k = 1; k <= count; ++k)
        {
          const std::size_t i = (first + k) % count;
          if (!cut[i])
          {
            piece.points.push_back(points[i]);
            piece.edges.push_back(edges[i]);
          }
          else if (!piece.points.empty())
          {
            if (piece.points.size() > 1)
            {
              loops.push_back(piece);
            }
            piece.points.clear();
            piece.edges.clear();
          }
        }
      }
    }
  }
  context.checkpoint(1.0);
  return loops;
}

StrokeOutline::StrokeOutline(const Mesh& mesh, const View& view, Polyline stroke, Context context)
  : Model(&mesh)
  , Seen(view)
  , Stroke(std::move(stroke))
  , Caller(std::move(context))
{
}

const std::vector<OutlineLoop>& StrokeOutline::nearby() const
{
  if (!this->Nearby)
  {
    this->Nearby = traceOutline(*this->Model, this->Seen, strokeWindow(this->Stroke, margin), this->Caller);
  }
  return *this->Nearby;
}

const std::vector<OutlineLoop>& StrokeOutline::whole() const
{
  if (!this->Whole)
  {
    const PixelWindow window = outlineWindow(*this->Model, this->Seen, this->Stroke, this->Caller);
    this->Whole = traceOutline(*this->Model, this->Seen, window, this->Caller);
  }
  return *this->Whole;
}

std::vector<NearestPlace> nearestPlaces(const std::vector<OutlineLoop>& loops)
{
  std::vector<NearestPlace> places;
  for (const OutlineLoop& loop : loops)
  {
    places.emplace_back(loop.points, loop.closed);
  }
  return places;
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

} // namespace oversketch
