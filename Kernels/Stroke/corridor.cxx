#include "Stroke/corridor.h"

#include "Stroke/path_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int chordReach = 4; // samples to either side that the stroke's direction is taken from
constexpr double nearWeight = 1.0, strongWeight = 0.4; // of a px of way
constexpr double strongShare = 0.75;                   // of a corridor's edges, weaker than a strong one

// The angle between two lines without direction, in [0, pi / 2].
double between(double a, double b)
{
  const double difference = std::abs(std::remainder(a - b, pi));
  return std::min(difference, pi - difference);
}

// The line across a way at a place, met row by row. Two such lines cut a row of pixels [from, to]: those go
// that lie behind both, a px and more along either way, so that rounding does not matter.
class LineAcross
{
public:
  LineAcross(const Vector2& place, const Vector2& way)
    : Place(place)
  {
    const double length = way.norm(), x = std::abs(way[0]), y = std::abs(way[1]);
    if (!(length > 0.01)) // a px along it would be no way
    {
      return;
    }
    this->Faces = x > 1e-6 * y ? (way[0] > 0.0 ? Right : Left) : (way[1] > 0.0 ? Down : Up);
    const bool isSteep = this->Faces == Right || this->Faces == Left;
    this->Slope = isSteep ? -way[1] / way[0] : 0.0;
    this->Margin = isSteep ? length / x : 2.0;
  }
  void leaveAfter(const LineAcross& other, double y, double& from, double& to) const
  {
    this->leave(other, this->Faces, y, from, to);
  }
  void leaveBefore(const LineAcross& other, double y, double& from, double& to) const
  {
    this->leave(other, -this->Faces, y, from, to);
  }

private:
  enum Direction
  {
    Nowhere = 0,
    Right = 1,
    Left = -1,
    Down = 2,
    Up = -2
  };
  double at(double y) const { return this->Place[0] + (y - this->Place[1]) * this->Slope; }
  // Those in a direction from both.
  void leave(const LineAcross& other, int direction, double y, double& from, double& to) const
  {
    if (this->Faces != other.Faces || this->Faces == Nowhere)
    {
      return;
    }
    const double margin = std::max(this->Margin, other.Margin);
    if (direction == Right)
    {
      to = std::min(to, std::max(this->at(y), other.at(y)) + margin);
    }
    else if (direction == Left)
    {
      from = std::max(from, std::min(this->at(y), other.at(y)) - margin);
    }
    else if (0.5 * direction * (y - this->Place[1]) > margin) // one place is both lines'
    {
      to = from - 1.0;
    }
  }

  Vector2 Place;
  int Faces = Nowhere;
  double Slope = 0.0, Margin = 0.0; // px along the row: a row down, and what stays
};

bool besideEdge(const PathField& field, const Pixel& pixel)
{
  for (int y = -1; y <= 1; ++y)
  {
    for (int x = -1; x <= 1; ++x)
    {
      const int i = indexOf(field, pixel + Pixel(x, y));
      if (i >= 0 && field.states[i] == PathField::Edge)
      {
        return true;
      }
    }
  }
  return false;
}

// Makes ways dearer far from the stroke and off strong edges. `extra` holds the squares of the pixels'
// distances from the stroke, of which `limit` is the greatest.
void favour(const EdgeFeatures& features, double limit, PathField& field)
{
  const auto strength = [&](int x, int y) -> const float&
  { return features.magnitude[static_cast<std::size_t>(field.y0 + y) * features.width + field.x0 + x]; };
  std::vector<float> edges;
  for (int y = 0; y < field.height; ++y)
  {
    for (int x = 0; x < field.width; ++x)
    {
      if (field.states[static_cast<std::size_t>(y) * field.width + x] == PathField::Edge)
      {
        edges.push_back(strength(x, y));
      }
    }
  }
  double strong = 1.0;
  if (!edges.empty())
  {
    const auto at = edges.begin() + static_cast<std::ptrdiff_t>(strongShare * double(edges.size() - 1));
    std::nth_element(edges.begin(), at, edges.end());
    strong = *at;
  }
  for (int y = 0; y < field.height; ++y) // what is outside too, which costs less than to ask
  {
    float* extra = &field.extra[static_cast<std::size_t>(y) * field.width];
    const float* strengths = &strength(0, y);
    for (int x = 0; x < field.width; ++x)
    {
      const double share = strengths[x] / strong;
      extra[x] = static_cast<float>(
        nearWeight * extra[x] / limit + strongWeight * (1.0 - (share < 1.0 ? share : 1.0)));
    }
  }
}

// Ways may begin at any of the pixels: for nothing, or for what it costs to come there.
std::vector<PathTree::Start> startsAt(const std::vector<Pixel>& pixels, const PathTree* before = nullptr)
{
  std::vector<PathTree::Start> starts;
  for (const Pixel& pixel : pixels)
  {
    const double cost = before ? before->cost(pixel) : 0.0;
    if (std::isfinite(cost))
    {
      starts.push_back({ pixel, cost });
    }
  }
  return starts;
}

// The pixel that is cheapest to come to; there is one.
Pixel cheapest(const PathTree& tree, const std::vector<Pixel>& pixels)
{
  return *std::min_element(pixels.begin(),
    pixels.end(),
    [&](const Pixel& a, const Pixel& b) { return tree.cost(a) < tree.cost(b); });
}

void tellStrong(const std::vector<PathField>& fields, PartPaths& paths)
{
  for (std::size_t part = 0; part < fields.size(); ++part)
  {
    paths.strong.emplace_back();
    for (const Pixel& pixel : paths.pixels[part])
    {
      paths.strong.back().push_back(besideEdge(fields[part], pixel));
    }
  }
}

std::vector<PathField> corridors(const DrawnOver& drawn, const std::vector<int>& ends, const Context& context)
{
  std::vector<PathField> fields;
  for (std::size_t part = 0; part + 1 < ends.size(); ++part)
  {
    context.checkpoint(0.0);
    fields.push_back(drawn.corridor(ends[part], ends[part + 1]));
  }
  return fields;
}

} // namespace

double DrawnOver::chord(int sample) const
{
  int from = sample - chordReach, to = sample + chordReach;
  if (this->closed) // the last point is the first one
  {
    const int period = this->count() - 1;
    from = (from % period + period) % period;
    to = to % period;
  }
  else
  {
    from = std::max(from, 0);
    to = std::min(to, this->count() - 1);
  }
  const Vector2 way = this->points[to] - this->points[from];
  return way == Vector2::Zero() ? std::numeric_limits<double>::quiet_NaN() : std::atan2(way[1], way[0]);
}

inline bool DrawnOver::counts(int x, int y, double angle) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->features.width + x;
  // A stroke without a direction has no wrong one.
  return this->features.edges[pixel] != 0 &&
         !(between(tangentOf(this->features, pixel), angle) > this->rules.edgeAngle + 1e-9);
}

Pixel DrawnOver::seedPixel(int sample) const
{
  const Vector2 seed = this->points[sample];
  // The stroke passes here once: samples in a row that stay near.
  const double reach = 2.0 * this->radius;
  int begin = sample, end = sample;
  while (begin > 0 && (this->points[begin - 1] - seed).norm() <= reach)
  {
    --begin;
  }
  while (end + 1 < this->count() && (this->points[end + 1] - seed).norm() <= reach)
  {
    ++end;
  }
  Pixel best(std::clamp(static_cast<int>(std::lround(seed[0])), 0, this->features.width - 1),
    std::clamp(static_cast<int>(std::lround(seed[1])), 0, this->features.height - 1));
  double strongest = 0.0, nearest = 0.0;
  const int y1 = std::min(this->features.height - 1, static_cast<int>(std::floor(seed[1] + this->radius)));
  const int x1 = std::min(this->features.width - 1, static_cast<int>(std::floor(seed[0] + this->radius)));
  for (int y = std::max(0, static_cast<int>(std::ceil(seed[1] - this->radius))); y <= y1; ++y)
  {
    for (int x = std::max(0, static_cast<int>(std::ceil(seed[0] - this->radius))); x <= x1; ++x)
    {
      const Vector2 place(x, y);
      const double distance = (place - seed).norm();
      const std::size_t pixel = static_cast<std::size_t>(y) * this->features.width + x;
      const double g = this->features.magnitude[pixel];
      if (distance > this->radius || !this->features.edges[pixel] || g < strongest ||
          (g == strongest && distance >= nearest))
      {
        continue;
      }
      int at = sample;
      for (int i = begin; i <= end; ++i)
      {
        at = (this->points[i] - place).squaredNorm() < (this->points[at] - place).squaredNorm() ? i : at;
      }
      if (this->counts(x, y, this->chord(at)))
      {
        strongest = g;
        nearest = distance;
        best = { x, y };
      }
    }
  }
  return best;
}

std::vector<Pixel> DrawnOver::section(int sample) const
{
  std::vector<Pixel> result;
  const Vector2 seed = this->points[sample];
  const double angle = this->chord(sample);
  const Vector2 along = std::isnan(angle) ? Vector2(1.0, 0.0) : Vector2(std::cos(angle), std::sin(angle));
  const double half = 0.5 * (std::abs(along[0]) + std::abs(along[1])); // of a pixel, along the stroke
  const double y1 = std::min(this->features.height - 1.0, std::floor(seed[1] + this->radius));
  const double x1 = std::min(this->features.width - 1.0, std::floor(seed[0] + this->radius));
  for (double y = std::max(0.0, std::ceil(seed[1] - this->radius)); y <= y1; ++y)
  {
    for (double x = std::max(0.0, std::ceil(seed[0] - this->radius)); x <= x1; ++x)
    {
      const Vector2 way = Vector2(x, y) - seed;
      if (way.squaredNorm() <= this->radius * this->radius && std::abs(way.dot(along)) <= half)
      {
        result.emplace_back(static_cast<int>(x), static_cast<int>(y));
      }
    }
  }
  return result;
}

PathField DrawnOver::corridor(int from, int to) const
{
  Eigen::AlignedBox2d box;
  for (int i = from; i <= to; ++i)
  {
    box.extend(this->points[i]);
  }
  PathField field;
  const auto low = [&](int axis) { return std::max(0.0, std::ceil(box.min()[axis] - this->radius)); };
  const auto high = [&](int axis, int size)
  { return std::min(size - 1.0, std::floor(box.max()[axis] + this->radius)); };
  const double x0 = low(0), y0 = low(1);
  const double x1 = high(0, this->features.width), y1 = high(1, this->features.height);
  if (x0 > x1 || y0 > y1)
  {
    return field; // beside the picture
  }
  field.x0 = static_cast<int>(x0);
  field.y0 = static_cast<int>(y0);
  field.width = static_cast<int>(x1 - x0) + 1;
  field.height = static_cast<int>(y1 - y0) + 1;
  const std::size_t size = static_cast<std::size_t>(field.width) * field.height;
  field.states.assign(size, PathField::Outside);
  // Squares of the pixels' distances to their nearest samples, and those.
  std::vector<float> nearest(size, std::numeric_limits<float>::max());
  std::vector<int> samples(size, -1);
  const double limit = this->radius * this->radius;
  for (int i = from; i < to; ++i)
  {
    const Vector2 a = this->points[i], way = this->points[i + 1] - a;
    // Pixels before the segment are nearer to the one before, where it does not bend away, those after it to
    // the next.
    const bool isFirst = i == from, isLast = i + 1 == to;
    const Vector2& b = this->points[i + 1];
    const LineAcross before(a, isFirst ? way : Vector2(a - this->points[i - 1])), begin(a, way), end(b, way),
      after(b, isLast ? way : Vector2(this->points[i + 2] - b));
    const double square = way.squaredNorm();
    const auto range = [&](int axis, int first, int count)
    {
      const double l = std::ceil(std::min(a[axis], a[axis] + way[axis]) - this->radius) - first;
      const double h = std::floor(std::max(a[axis], a[axis] + way[axis]) + this->radius) - first;
      return std::array<int, 2>{ static_cast<int>(std::clamp(l, 0.0, static_cast<double>(count))),
        static_cast<int>(std::clamp(h, -1.0, count - 1.0)) };
    };
    const auto [ya, yb] = range(1, field.y0, field.height);
    const double length = std::sqrt(square);
    // Looks only at the strip beside a long segment, of its box: where the line's distance allows.
    const bool isFlat = std::abs(way[1]) <= 1e-9 * length;
    const double slope = isFlat ? 0.0 : way[0] / way[1];
    const double half = isFlat ? 0.0 : this->radius * length / std::abs(way[1]) + 1.0;
    const auto [left, right] = range(0, field.x0, field.width);
    for (int y = ya; y <= yb; ++y)
    {
      const double py = field.y0 + y, across = (py - a[1]) * way[1];
      double first = field.x0 + left, last = field.x0 + right;
      if (!isFlat)
      {
        const double middle = a[0] + (py - a[1]) * slope;
        first = std::max(first, middle - half);
        last = std::min(last, middle + half);
      }
      if (!isFirst)
      {
        begin.leaveBefore(before, py, first, last);
      }
      if (!isLast)
      {
        end.leaveAfter(after, py, first, last);
      }
      if (first > last)
      {
        continue;
      }
      const int xa = static_cast<int>(first - field.x0), xb = static_cast<int>(last - field.x0);
      const std::size_t row = static_cast<std::size_t>(y) * field.width;
      for (int x = xa; x <= xb; ++x)
      {
        const double px = field.x0 + x, place = (px - a[0]) * way[0] + across;
        // A segment is short beside the radius: of most pixels an end is nearest, and nothing is divided.
        const double t = place <= 0.0 ? 0.0 : place >= square ? 1.0 : place / square;
        const double dx = a[0] + t * way[0] - px, dy = a[1] + t * way[1] - py;
        const double distance = dx * dx + dy * dy;
        if (distance <= limit && static_cast<float>(distance) < nearest[row + x])
        {
          nearest[row + x] = static_cast<float>(distance);
          samples[row + x] = t < 0.5 ? i : i + 1;
        }
      }
    }
  }
  if (this->rules.together)
  {
    field.extra.assign(nearest.begin(), nearest.end());
  }
  std::vector<double> chords;
  for (int i = from; i <= to; ++i)
  {
    chords.push_back(this->chord(i));
  }
  for (int y = 0; y < field.height; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(y) * field.width;
    for (int x = 0; x < field.width; ++x)
    {
      const int sample = samples[row + x];
      if (sample >= 0)
      {
        const bool isEdge = this->counts(field.x0 + x, field.y0 + y, chords[sample - from]);
        field.states[row + x] = isEdge ? PathField::Edge : PathField::Plain;
      }
    }
  }
  if (this->rules.together)
  {
    favour(this->features, limit, field);
  }
  return field;
}

PartPaths pathsBetweenSeeds(const DrawnOver& drawn, const std::vector<int>& ends, const Context& context)
{
  std::vector<Pixel> places;
  places.reserve(ends.size());
  for (const int end : ends)
  {
    places.push_back(drawn.closed && end == drawn.count() - 1 ? places.front() : drawn.seedPixel(end));
  }
  PartPaths paths;
  const std::vector<PathField> fields = corridors(drawn, ends, context);
  PathSearch search;
  for (std::size_t part = 0; part < fields.size(); ++part)
  {
    context.checkpoint(static_cast<double>(part) / static_cast<double>(ends.size()));
    // A seed of a stroke that leaves the picture may have no pixel in the corridor: no path then.
    paths.pixels.push_back(
      search(drawn.features, fields[part], { { places[part], 0.0 } }, { places[part + 1] }, context)
        .pathTo(places[part + 1]));
  }
  tellStrong(fields, paths);
  return paths;
}

PartPaths pathsTogether(const DrawnOver& drawn, const std::vector<int>& ends, const Context& context)
{
  const std::vector<PathField> fields = corridors(drawn, ends, context);
  const std::size_t count = fields.size();
  auto sections = mapped(ends, [&](int end) { return drawn.section(end); });
  PathSearch search;
  const auto treeOf = [&](std::size_t part, const std::vector<PathTree::Start>& starts)
  { return search(drawn.features, fields[part], starts, sections[part + 1], context); };
  if (drawn.closed && count > 1)
  {
    // A closed one passes its start where the cheapest way along the two parts there does.
    const PathTree before = treeOf(count - 1, startsAt(sections[count - 1]));
    const PathTree after = treeOf(0, startsAt(sections.back(), &before));
    if (!startsAt(sections[1], &after).empty())
    {
      sections.front() = { after.pathTo(cheapest(after, sections[1])).front() };
      sections.back() = sections.front();
    }
  }
  PartPaths paths;
  paths.pixels.resize(count);
  std::vector<PathTree> trees;
  const auto trace = [&](std::size_t first, std::size_t end) // parts, all of which have a way
  {
    for (std::size_t part = end; part-- > first;)
    {
      const Pixel to =
        part + 1 == end ? cheapest(trees[part], sections[end]) : paths.pixels[part + 1].front();
      paths.pixels[part] = trees[part].pathTo(to);
    }
  };
  std::size_t first = 0; // of the parts since the stroke came into the picture
  std::vector<PathTree::Start> starts = startsAt(sections.front());
  for (std::size_t part = 0; part < count; ++part)
  {
    context.checkpoint(static_cast<double>(part) / static_cast<double>(ends.size()));
    trees.push_back(treeOf(part, starts));
    starts = startsAt(sections[part + 1], &trees.back());
    if (starts.empty()) // no way through the picture
    {
      trace(first, part);
      first = part + 1;
      starts = startsAt(sections[part + 1]);
    }
  }
  trace(first, count);
  tellStrong(fields, paths);
  return paths;
}

} // namespace oversketch
