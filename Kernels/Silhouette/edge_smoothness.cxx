#include "Silhouette/edge_smoothness.h"

#include "Mesh/clones.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr int lanes = 8;
constexpr int intervals = 32; // 33 samples, then golden section
constexpr int goldenSteps = 16;
constexpr double ratio = 0.6180339887498949;

// The interval of a golden section, its two inner places, and what one step makes of it.
struct Section
{
  double from, to, left, right;

  // Goes on in the lower part, where the left place had the larger value, or in the upper part. The new place
  // is left or right accordingly.
  Section next(bool lower) const
  {
    Section s = *this;
    if (lower)
    {
      s.to = s.right;
      s.right = s.left;
      s.left = s.to - ratio * (s.to - s.from);
    }
    else
    {
      s.from = s.left;
      s.left = s.right;
      s.right = s.from + ratio * (s.to - s.from);
    }
    return s;
  }
};

// By value and apart, or the compiler must take it that a value written changes the energy.
inline void evaluate(const EdgeSmoothness energy,
  const double* __restrict__ places,
  double* __restrict__ values)
{
  for (int i = 0; i < lanes; ++i)
  {
    values[i] = energy(places[i]);
  }
}

} // namespace

// Operations are the same, in the same order, on every path, none of them fused: vectors change how many
// energies are found at a time, not one bit of them.
OVERSKETCH_CLONES double searchStraightest(const EdgeSmoothness& energy, double low, double high)
{
  const double step = (high - low) / intervals;
  constexpr int sampled = (intervals + lanes) / lanes * lanes;
  double places[sampled], values[sampled];
  for (int k = 0; k < sampled; ++k)
  {
    places[k] = k == 0 ? low : k >= intervals ? high : low + k * step;
  }
  for (int k = 0; k < sampled; k += lanes)
  {
    evaluate(energy, places + k, values + k);
  }
  double top[lanes];
  std::copy_n(values, lanes, top);
  for (int k = lanes; k < sampled; k += lanes)
  {
    for (int i = 0; i < lanes; ++i)
    {
      top[i] = values[k + i] > top[i] ? values[k + i] : top[i];
    }
  }
  const double highest = *std::max_element(top, top + lanes);
  const int bestSample = static_cast<int>(std::find(values, values + intervals, highest) - values);
  const double best = places[bestSample], bestValue = values[bestSample];
  // At an end, mostly: where the limit on E_geo holds the snaxel back.
  const double inward = 1e-3 * (best == low ? step : -step);
  Section section{ std::max(low, best - step), std::min(high, best + step), 0.0, 0.0 };
  section.left = section.to - ratio * (section.to - section.from);
  section.right = section.from + ratio * (section.to - section.from);
  double inner[lanes] = { best + inward, section.left, section.right, best, best, best, best, best };
  evaluate(energy, inner, values);
  if ((best == low || best == high) && values[0] <= bestValue)
  {
    return best;
  }
  double leftValue = values[1], rightValue = values[2];
  // Three steps at a time: the first is known, and what the next two may ask for is found beside it. Section
  // i is followed by 2 i + 1 or 2 i + 2, the lower or the upper part of it.
  for (int done = 0; done < goldenSteps;)
  {
    Section sections[lanes - 1];
    bool lowers[lanes - 1];
    lowers[0] = leftValue >= rightValue;
    sections[0] = section.next(lowers[0]);
    for (int i = 1; i < lanes - 1; ++i)
    {
      lowers[i] = i % 2 == 1;
      sections[i] = sections[(i - 1) / 2].next(lowers[i]);
    }
    for (int i = 0; i < lanes; ++i)
    {
      const int j = std::min(i, lanes - 2);
      inner[i] = lowers[j] ? sections[j].left : sections[j].right;
    }
    evaluate(energy, inner, values);
    for (int i = 0; i < lanes - 1 && done < goldenSteps; ++done)
    {
      if (lowers[i])
      {
        rightValue = leftValue;
        leftValue = values[i];
      }
      else
      {
        leftValue = rightValue;
        rightValue = values[i];
      }
      section = sections[i];
      i = 2 * i + (leftValue >= rightValue ? 1 : 2);
    }
  }
  if (std::max(leftValue, rightValue) > bestValue)
  {
    return leftValue >= rightValue ? section.left : section.right;
  }
  return best;
}

} // namespace oversketch
