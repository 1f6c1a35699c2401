#include "Stroke/least_path.h"

#include "Mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double straightAngle = 3.14159265358979323846;
constexpr double edgeWeight = 0.43, turnWeight = 0.43, gradientWeight = 0.14;
constexpr std::array<std::array<int, 2>, 8> steps{
  { { -1, -1 }, { 0, -1 }, { 1, -1 }, { -1, 0 }, { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } }
};

// What the steps between a field's pixels cost. acos of the dot product of two unit vectors is the
// angle between them, and turning both tangents about is turning the step, so no cosine is needed.
class Costs
{
public:
  Costs(const EdgeFeatures& features, const PathField& field)
    : Field(field)
    , Tangents(field.states.size())
    , Flat(field.states.size())
  {
    const double scale = features.greatest > 0.0f ? 1.0 / features.greatest : 0.0;
    for (int y = 0; y < field.height; ++y)
    {
      for (int x = 0; x < field.width; ++x)
      {
        const int i = y * field.width + x;
        if (field.states[i] != PathField::Outside)
        {
          const std::size_t pixel = static_cast<std::size_t>(field.y0 + y) * features.width + field.x0 + x;
          this->Tangents[i] = tangentOf(features, pixel);
          this->Flat[i] = gradientWeight * (1.0 - scale * features.magnitude[pixel]);
        }
      }
    }
    for (int k = 0; k < 8; ++k)
    {
      this->Angles[k] = std::atan2(steps[k][1], steps[k][0]);
    }
  }

  double step(int p, int q, int k) const
  {
    const double tp = this->Tangents[p], tq = this->Tangents[q];
    double ap = turn(tp, this->Angles[k]), aq = turn(tq, this->Angles[k]);
    if (ap > 0.5 * straightAngle)
    {
      ap = straightAngle - ap;
      aq = straightAngle - aq;
    }
    const bool diagonal = steps[k][0] != 0 && steps[k][1] != 0;
    const double usual = (this->Field.states[q] == PathField::Edge ? 0.0 : edgeWeight) +
                         turnWeight * (ap + aq) / straightAngle +
                         (diagonal ? this->Flat[q] : this->Flat[q] * std::sqrt(0.5));
    return this->Field.extra.empty() ? usual
                                     : usual + (diagonal ? std::sqrt(2.0) : 1.0) * this->Field.extra[q];
  }

private:
  // In [0, straightAngle]; where there is no edge, a right angle.
  static double turn(double tangent, double angle)
  {
    double a = std::abs(tangent - angle);
    a = a > straightAngle ? 2.0 * straightAngle - a : a;
    return std::isnan(a) ? 0.5 * straightAngle : a;
  }

  const PathField& Field;
  std::vector<double> Tangents, Flat;
  std::array<double, 8> Angles{};
};

} // namespace

double tangentOf(const EdgeFeatures& features, std::size_t pixel)
{
  const float gx = features.gx[pixel], gy = features.gy[pixel];
  return gx == 0.0f && gy == 0.0f ? std::numeric_limits<double>::quiet_NaN()
                                  : std::atan2(-static_cast<double>(gx), static_cast<double>(gy));
}

int indexOf(const PathField& field, const Pixel& pixel)
{
  const int x = pixel[0] - field.x0, y = pixel[1] - field.y0;
  return x < 0 || y < 0 || x >= field.width || y >= field.height ? -1 : y * field.width + x;
}

PathField wholeField(const EdgeFeatures& features)
{
  PathField field{ 0, 0, features.width, features.height, {}, {} };
  field.states.resize(features.edges.size());
  std::transform(features.edges.begin(),
    features.edges.end(),
    field.states.begin(),
    [](std::uint8_t edge) { return edge ? PathField::Edge : PathField::Plain; });
  return field;
}

PathTree::PathTree(const EdgeFeatures& features,
  const PathField& field,
  const std::vector<Start>& starts,
  const std::vector<Pixel>& targets,
  const Context& context)
  : X0(field.x0)
  , Y0(field.y0)
  , Width(field.width)
  , Height(field.height)
  , Reached(field.states.size(), std::numeric_limits<double>::infinity())
  , Back(field.states.size(), static_cast<std::uint8_t>(steps.size()))
{
  const auto inside = [&](int i) { return i >= 0 && field.states[i] != PathField::Outside; };
  using Place = std::pair<double, int>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> queue;
  for (const Start& start : starts)
  {
    const int i = indexOf(field, start.pixel);
    if (inside(i) && start.cost < this->Reached[i])
    {
      this->Reached[i] = start.cost;
      queue.emplace(start.cost, i);
    }
  }
  std::vector<std::uint8_t> wanted(field.states.size(), 0);
  int left = 0;
  for (const Pixel& target : targets)
  {
    const int i = indexOf(field, target);
    if (inside(i) && !wanted[i])
    {
      wanted[i] = 1;
      ++left;
    }
  }
  if (queue.empty() || left == 0)
  {
    return;
  }
  const Costs costs(features, field);
  for (int popped = 1; !queue.empty(); ++popped)
  {
    if (popped % 16384 == 0)
    {
      context.checkpoint(0.0);
    }
    const auto [cost, p] = queue.top();
    queue.pop();
    if (cost > this->Reached[p])
    {
      continue;
    }
    if (wanted[p])
    {
      wanted[p] = 0;
      if (--left == 0)
      {
        break;
      }
    }
    const int x = p % field.width, y = p / field.width;
    for (int k = 0; k < static_cast<int>(steps.size()); ++k)
    {
      const int qx = x + steps[k][0], qy = y + steps[k][1];
      if (qx < 0 || qy < 0 || qx >= field.width || qy >= field.height)
      {
        continue;
      }
      const int q = qy * field.width + qx;
      if (field.states[q] == PathField::Outside || this->Reached[q] <= cost)
      {
        continue;
      }
      const double next = cost + costs.step(p, q, k);
      if (next < this->Reached[q])
      {
        this->Reached[q] = next;
        this->Back[q] = static_cast<std::uint8_t>(k);
        queue.emplace(next, q);
      }
    }
  }
}

int PathTree::index(const Pixel& pixel) const
{
  const int x = pixel[0] - this->X0, y = pixel[1] - this->Y0;
  return x < 0 || y < 0 || x >= this->Width || y >= this->Height ? -1 : y * this->Width + x;
}

double PathTree::cost(const Pixel& pixel) const
{
  const int i = this->index(pixel);
  return i < 0 ? std::numeric_limits<double>::infinity() : this->Reached[i];
}

std::vector<Pixel> PathTree::pathTo(const Pixel& pixel) const
{
  std::vector<Pixel> path;
  if (std::isinf(this->cost(pixel)))
  {
    return path;
  }
  int at = this->index(pixel);
  path.push_back(pixel);
  while (this->Back[at] < steps.size())
  {
    const auto& step = steps[this->Back[at]];
    at -= step[1] * this->Width + step[0];
    path.emplace_back(this->X0 + at % this->Width, this->Y0 + at / this->Width);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<Pixel> leastPath(const EdgeFeatures& features,
  const PathField& field,
  const Pixel& from,
  const Pixel& to,
  const Context& context)
{
  return PathTree(features, field, { { from, 0.0 } }, { to }, context).pathTo(to);
}

double pathCost(const EdgeFeatures& features, const PathField& field, const std::vector<Pixel>& path)
{
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Pixel p = path[i - 1], q = path[i];
    const auto place = [&](const Pixel& a) { return static_cast<std::size_t>(a[1]) * features.width + a[0]; };
    const Vector2 way = (q - p).cast<double>().normalized();
    const auto along = [&](const Pixel& a)
    {
      const Vector2 tangent(features.gy[place(a)], -static_cast<double>(features.gx[place(a)]));
      const double length = tangent.norm();
      return length > 0.0 ? std::clamp(tangent.dot(way) / length, -1.0, 1.0) : 0.0;
    };
    double dp = along(p), dq = along(q);
    if (dp < 0.0)
    {
      dp = -dp;
      dq = -dq;
    }
    const double flat =
      1.0 - (features.greatest > 0.0f ? features.magnitude[place(q)] / double(features.greatest) : 0.0);
    const bool diagonal = p[0] != q[0] && p[1] != q[1];
    const int at = indexOf(field, q);
    cost += (at >= 0 && field.states[at] == PathField::Edge ? 0.0 : edgeWeight) +
            turnWeight * (std::acos(dp) + std::acos(dq)) / straightAngle +
            gradientWeight * (diagonal ? flat : flat * std::sqrt(0.5));
  }
  return cost;
}

} // namespace oversketch
