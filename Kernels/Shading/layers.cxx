#include "Shading/layers.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double nearest = 1e-3;

// Both ends count as handles that hold.
std::vector<LayerHandle> heldOf(const std::vector<LayerHandle>& handles)
{
  std::vector<LayerHandle> held;
  for (const LayerHandle& handle : handles)
  {
    double low = 0.0, high = 1.0, lowRest = 0.0, highRest = 1.0;
    const Message name("Layer handle %1", held.size());
    if (!std::isfinite(handle.rest) || !std::isfinite(handle.place))
    {
      throw Error(Failure::BadStroke, "%1 is not finite; remove it.", name);
    }
    for (const LayerHandle& other : held)
    {
      if (!(std::abs(other.rest - handle.rest) >= nearest))
      {
        throw Error(Failure::BadStroke, "%1 is too near to another one; place it farther away.", name);
      }
      if (other.rest < handle.rest && other.rest >= lowRest)
      {
        low = other.place;
        lowRest = other.rest;
      }
      if (other.rest > handle.rest && other.rest <= highRest)
      {
        high = other.place;
        highRest = other.rest;
      }
    }
    if (!(handle.rest >= nearest && handle.rest <= 1.0 - nearest))
    {
      throw Error(
        Failure::BadStroke, "%1 lies on the reference or boundary curve; place it between them.", name);
    }
    held.push_back({ handle.rest, std::clamp(handle.place, low, high) });
  }
  return held;
}

} // namespace

Layers::Layers(int levels, const std::vector<LayerHandle>& handles)
  : Levels(levels)
  , Handles(heldOf(handles))
  , Band(this->Handles)
{
  if (levels < 2 || levels > 256)
  {
    throw Error(Failure::BadStroke, "%1 levels are asked for; there can be 2 to 256.", levels);
  }
  this->Band.push_back({ 0.0, 0.0 });
  this->Band.push_back({ 1.0, 1.0 });
  std::sort(this->Band.begin(),
    this->Band.end(),
    [](const LayerHandle& a, const LayerHandle& b) { return a.rest < b.rest; });
  for (const LayerHandle& h : this->Band)
  {
    if (!this->Knots.empty() && this->Knots.back().place == h.place)
    {
      this->Knots.back().after = h.rest;
    }
    else
    {
      this->Knots.push_back({ h.place, h.rest, h.rest });
    }
  }
  this->findSlopes();
  for (int i = 1; i < levels; ++i)
  {
    this->Boundaries.push_back(this->placeOf(static_cast<double>(i) / levels));
  }
}

double Layers::placeOf(double rest) const
{
  const double x = std::clamp(rest, 0.0, 1.0);
  const auto after = std::upper_bound(this->Band.begin() + 1,
    this->Band.end() - 1,
    x,
    [](double value, const LayerHandle& h) { return value < h.rest; });
  const LayerHandle &a = *(after - 1), &b = *after;
  const double t = (x - a.rest) / (b.rest - a.rest);
  // By how far it has moved: what has not moved keeps its bits.
  return std::clamp(x + (1.0 - t) * (a.place - a.rest) + t * (b.place - b.rest), a.place, b.place);
}

std::pair<const Layers::Knot&, const Layers::Knot&> Layers::aboutPlace(double place) const
{
  const auto after = std::upper_bound(this->Knots.begin(),
    this->Knots.end(),
    place,
    [](double value, const Knot& knot) { return value < knot.place; });
  return { *(after - 1), *after };
}

double Layers::restOf(double s) const
{
  const double x = std::clamp(s, 0.0, 1.0);
  if (x >= this->Knots.back().place)
  {
    return this->Knots.back().after;
  }
  const auto& [a, b] = this->aboutPlace(x);
  const double t = (x - a.place) / (b.place - a.place);
  return std::clamp(x + (1.0 - t) * (a.after - a.place) + t * (b.before - b.place), a.after, b.before);
}

// Fritsch and Carlson's slopes of each piece between places where layers have vanished.
void Layers::findSlopes()
{
  std::vector<double> secants;
  const int last = static_cast<int>(this->Knots.size()) - 1;
  for (int k = 0; k < last; ++k)
  {
    const Knot &a = this->Knots[k], &b = this->Knots[k + 1];
    secants.push_back((b.before - a.after) / (b.place - a.place));
  }
  for (int k = 0; k <= last; ++k)
  {
    Knot& knot = this->Knots[k];
    const double before = secants[std::max(k - 1, 0)], after = secants[std::min(k, last - 1)];
    const bool whole = knot.before == knot.after && k > 0 && k < last;
    knot.slopeBefore = whole ? 0.5 * (before + after) : before;
    knot.slopeAfter = whole ? 0.5 * (before + after) : after;
  }
  for (int k = 0; k < last; ++k)
  {
    Knot &a = this->Knots[k], &b = this->Knots[k + 1];
    const double limit = 3.0 * secants[k], size = std::hypot(a.slopeAfter, b.slopeBefore);
    if (size > limit)
    {
      a.slopeAfter *= limit / size;
      b.slopeBefore *= limit / size;
      // The neighbour's slope is the same one.
      const auto join = [](Knot& knot, double slope)
      {
        if (knot.before == knot.after)
        {
          knot.slopeBefore = knot.slopeAfter = slope;
        }
      };
      join(a, a.slopeAfter);
      join(b, b.slopeBefore);
    }
  }
}

double Layers::smoothRestOf(double s) const
{
  const double x = std::clamp(s, 0.0, 1.0);
  if (x >= this->Knots.back().place)
  {
    return this->Knots.back().after;
  }
  const auto& [a, b] = this->aboutPlace(x);
  const double step = b.place - a.place, t = (x - a.place) / step, u = 1.0 - t;
  // Hermite's cubic of how far it has moved.
  const double moved = u * u * (1.0 + 2.0 * t) * (a.after - a.place) +
                       t * t * (1.0 + 2.0 * u) * (b.before - b.place) +
                       t * u * step * (u * (a.slopeAfter - 1.0) - t * (b.slopeBefore - 1.0));
  return std::clamp(x + moved, a.after, b.before);
}

double Layers::weight(double s, Falloff falloff) const
{
  if (falloff == Falloff::Linear)
  {
    return 1.0 - this->restOf(s);
  }
  const double left = 1.0 - this->smoothRestOf(s);
  return left * left * left * (10.0 - left * (15.0 - 6.0 * left)); // from the boundary's end, where it is 0
}

int Layers::level(double s) const
{
  return static_cast<int>(
    std::upper_bound(this->Boundaries.begin(), this->Boundaries.end(), std::clamp(s, 0.0, 1.0)) -
    this->Boundaries.begin());
}

int Layers::grey(int level) const
{
  return static_cast<int>(std::lround(255.0 * (this->Levels - 1 - level) / (this->Levels - 1)));
}

std::vector<LayerHandle> Layers::held() const
{
  return this->Handles;
}

std::vector<LayerHandle> grasped(const std::vector<LayerHandle>& handles, int which)
{
  std::vector<LayerHandle> held = heldOf(handles);
  std::rotate(held.begin() + which, held.begin() + which + 1, held.end());
  return held;
}

} // namespace oversketch
