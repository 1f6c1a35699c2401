#include "Stroke/path_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr double straightAngle = PathWeights::straightAngle;
constexpr std::array<std::array<int, 2>, 8> steps{
  { { -1, -1 }, { 0, -1 }, { 1, -1 }, { -1, 0 }, { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } }
};

constexpr std::array<bool, 8> diagonal{ true, false, true, false, false, true, false, true };

constexpr double floatRounding = 1.5e-7; // more than that of a float, relative

float roundedDown(double cost)
{
  return static_cast<float>(cost - floatRounding * cost);
}

std::array<double, 8> stepAngles()
{
  std::array<double, 8> angles{};
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    angles[k] = std::atan2(steps[k][1], steps[k][0]);
  }
  return angles;
}

} // namespace

// Pixel as the search knows it; those of a field stand row by row with a frame of one pixel around,
// which, like what is outside, has been reached for less than nothing: no way goes there.
struct PathSearch::Cell
{
  double reached = -std::numeric_limits<double>::infinity(); // the least cost so far
  double tangent = 0.0, flat = 0.0;
  float extra = 0.0f;
  std::uint8_t plain = 0, straight = 0, wanted = 0; // straight: there is no tangent
  std::uint8_t back = static_cast<std::uint8_t>(steps.size());

  static constexpr std::array<double, 2> edgeCosts{ 0.0, PathWeights::edge };
  static constexpr double root = 1.41421356237309504880;
  double edgeCost() const { return edgeCosts[this->plain]; }
  double flatCost(bool slant) const { return slant ? this->flat : this->flat * (0.5 * root); }
  double extraCost(bool slant) const { return (slant ? root : 1.0) * this->extra; }
  // Where there is no tangent, a step turns by a right angle.
  double leastTurn() const { return this->straight ? 0.5 * PathWeights::turn : 0.0; }
  // Cost of a step here but for turns.
  double least(bool slant) const { return this->edgeCost() + this->flatCost(slant) + this->extraCost(slant); }
};

// Cost at most of a place for a step from it to be looked at, rounded up; a place without a tangent
// costs what it turns any step by more. It rejects most steps, and is small: the eight around a place lie in
// three rows of it.
struct PathSearch::Slack
{
  float axis = -std::numeric_limits<float>::infinity(), slant = axis;

  Slack() = default;
  explicit Slack(const Cell& cell)
  {
    const double above = cell.reached + floatRounding * cell.reached - cell.leastTurn();
    this->axis = static_cast<float>(above - cell.least(false));
    this->slant = static_cast<float>(above - cell.least(true));
  }
};

PathSearch::PathSearch()
  : Angles(stepAngles())
{
}

PathSearch::~PathSearch() = default;

double PathSearch::fill(const EdgeFeatures& features, const PathField& field)
{
  const double scale = features.greatest > 0.0f ? 1.0 / features.greatest : 0.0;
  constexpr int ahead = 4; // rows: the picture's memory is slow to come
  const int across = field.width + 2;
  const std::size_t size = static_cast<std::size_t>(across) * (field.height + 2);
  this->Cells.assign(size, Cell());
  this->Slacks.assign(size, Slack());
  float most = 0.0f;
  for (int y = 0; y < field.height; ++y)
  {
    const std::size_t row = static_cast<std::size_t>(y) * field.width;
    const std::size_t first = static_cast<std::size_t>(field.y0 + y) * features.width + field.x0;
    const std::size_t begin = static_cast<std::size_t>(y + 1) * across + 1;
    for (int x = 0; x < field.width && y + ahead < field.height; x += 16) // of floats, in 64 bytes
    {
      const std::size_t later = first + static_cast<std::size_t>(ahead) * features.width + x;
      __builtin_prefetch(&features.gx[later]);
      __builtin_prefetch(&features.gy[later]);
      __builtin_prefetch(&features.magnitude[later]);
    }
    Cell* cells = &this->Cells[begin];
    Slack* slacks = &this->Slacks[begin];
    for (int x = 0; x < field.width; ++x)
    {
      const std::uint8_t state = field.states[row + x];
      if (state == PathField::Outside)
      {
        continue;
      }
      Cell& cell = cells[x];
      cell.reached = std::numeric_limits<double>::infinity();
      slacks[x].axis = slacks[x].slant = std::numeric_limits<float>::infinity();
      cell.flat = PathWeights::gradient * (1.0 - scale * features.magnitude[first + x]);
      cell.extra = field.extra.empty() ? 0.0f : field.extra[row + x];
      cell.plain = state != PathField::Edge;
      most = std::max(most, cell.extra);
      const double tangent = tangentOf(features, first + x);
      cell.straight = std::isnan(tangent);
      cell.tangent = cell.straight ? 0.0 : tangent;
    }
  }
  // One turn is a right angle at most, the other a straight one.
  return PathWeights::edge + 1.5 * PathWeights::turn + PathWeights::gradient + std::sqrt(2.0) * most;
}

// acos of the dot product of two unit vectors is the angle between them, and turning both tangents about is
// turning the step, so no cosine is needed.
void PathSearch::leave(const PlaceQueue::Place& place, int across)
{
  constexpr double rightAngle = 0.5 * straightAngle;
  constexpr std::array<double, 2> least{ 0.0, rightAngle }, most{ straightAngle, rightAngle };
  Cell* from = &this->Cells[place.number];
  const std::array<int, 8> offsets{
    -across - 1, -across, -across + 1, -1, 1, across - 1, across, across + 1
  };
  unsigned worth = 0; // a bit for each step that may be cheaper than what there is
  const Slack* around = &this->Slacks[place.number];
  const float cost = roundedDown(place.cost + from->leastTurn());
  for (int k = 0; k < 8; ++k)
  {
    const Slack& slack = around[offsets[k]];
    worth |= static_cast<unsigned>(cost < (diagonal[k] ? slack.slant : slack.axis)) << k;
  }
  // In [0, straightAngle]; where there is no tangent, a right angle. No branches: none could be foretold.
  const auto turn = [&](const Cell& cell, int k)
  {
    const double angle = std::abs(cell.tangent - this->Angles[k]);
    const double turned = std::min(angle, 2.0 * straightAngle - angle);
    return std::min(std::max(turned, least[cell.straight]), most[cell.straight]);
  };
  for (; worth != 0; worth &= worth - 1)
  {
    const int k = __builtin_ctz(worth);
    Cell& to = from[offsets[k]];
    const double tp = turn(*from, k), tq = turn(to, k);
    const double sign = std::copysign(1.0, rightAngle - tp); // -1: both tangents turn about
    const double ap = std::min(tp, straightAngle - tp), aq = (rightAngle - rightAngle * sign) + sign * tq;
    const double next = place.cost + (to.edgeCost() + PathWeights::turn * (ap + aq) / straightAngle +
                                       to.flatCost(diagonal[k]) + to.extraCost(diagonal[k]));
    if (next < to.reached)
    {
      to.reached = next;
      this->Slacks[place.number + offsets[k]] = Slack(to);
      to.back = static_cast<std::uint8_t>(k);
      this->Queue.push({ next, place.number + offsets[k] });
    }
  }
}

PathTree PathSearch::operator()(const EdgeFeatures& features,
  const PathField& field,
  const std::vector<PathTree::Start>& starts,
  const std::vector<Pixel>& targets,
  const Context& context)
{
  PathTree tree;
  tree.X0 = field.x0 - 1;
  tree.Y0 = field.y0 - 1;
  tree.Width = field.width + 2;
  const auto numberOf = [&](const Pixel& pixel)
  {
    const int i = indexOf(field, pixel);
    const bool inside = i >= 0 && field.states[i] != PathField::Outside;
    return inside ? (pixel[1] - tree.Y0) * tree.Width + pixel[0] - tree.X0 : -1;
  };
  std::vector<int> wanted;
  for (const Pixel& target : targets)
  {
    const int number = numberOf(target);
    if (number >= 0)
    {
      wanted.push_back(number);
    }
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::size_t left = wanted.size();
  std::vector<PlaceQueue::Place> begins;
  for (const PathTree::Start& start : starts)
  {
    const int number = numberOf(start.pixel);
    if (number >= 0)
    {
      begins.push_back({ start.cost, number });
    }
  }
  if (begins.empty() || left == 0)
  {
    return tree;
  }
  const double step = this->fill(features, field);
  for (const int number : wanted)
  {
    this->Cells[number].wanted = 1;
  }
  for (const PlaceQueue::Place& place : begins)
  {
    Cell& cell = this->Cells[place.number];
    cell.reached = std::min(cell.reached, place.cost);
    this->Slacks[place.number] = Slack(cell);
  }
  this->Queue.begin(begins, step);
  PlaceQueue::Place place{};
  for (int popped = 1; left > 0 && this->Queue.pop(place); ++popped)
  {
    if (popped % 16384 == 0)
    {
      context.checkpoint(0.0);
    }
    Cell& cell = this->Cells[place.number];
    if (place.cost > cell.reached)
    {
      continue;
    }
    left -= cell.wanted;
    cell.wanted = 0;
    this->leave(place, tree.Width);
  }
  tree.Back.resize(this->Cells.size());
  std::transform(
    this->Cells.begin(), this->Cells.end(), tree.Back.begin(), [](const Cell& cell) { return cell.back; });
  for (const int number : wanted)
  {
    tree.Costs.emplace_back(number, this->Cells[number].reached);
  }
  return tree;
}

int PathTree::numberOf(const Pixel& pixel) const
{
  const int x = pixel[0] - this->X0, y = pixel[1] - this->Y0;
  return x < 0 || y < 0 || x >= this->Width ? -1 : y * this->Width + x;
}

double PathTree::cost(const Pixel& target) const
{
  const int number = this->numberOf(target);
  const auto at = std::lower_bound(this->Costs.begin(),
    this->Costs.end(),
    number,
    [](const std::pair<int, double>& cost, int n) { return cost.first < n; });
  return at == this->Costs.end() || at->first != number ? std::numeric_limits<double>::infinity()
                                                        : at->second;
}

std::vector<Pixel> PathTree::pathTo(const Pixel& target) const
{
  std::vector<Pixel> path;
  if (std::isinf(this->cost(target)))
  {
    return path;
  }
  int at = this->numberOf(target);
  path.push_back(target);
  while (this->Back[at] < steps.size())
  {
    const auto& step = steps[this->Back[at]];
    at -= step[1] * this->Width + step[0];
    path.emplace_back(this->X0 + at % this->Width, this->Y0 + at / this->Width);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace oversketch
