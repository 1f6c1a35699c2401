#include "Planar/corners.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr int cornerReach = 4; // samples, 0.02 of the canvas's longest side

double turningAngle(const Vector2& before, const Vector2& here, const Vector2& after)
{
  const Vector2 a = here - before, b = after - here;
  return std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b)));
}

} // namespace

std::vector<int> corners(const Polyline& stroke, bool closed, double angle)
{
  const int count = static_cast<int>(stroke.size());
  std::vector<double> turns(count, 0.0);
  const int first = closed ? 0 : cornerReach, end = closed ? count : count - cornerReach;
  if (count <= 2 * cornerReach)
  {
    return {};
  }
  for (int i = first; i < end; ++i)
  {
    turns[i] =
      turningAngle(stroke[(i - cornerReach + count) % count], stroke[i], stroke[(i + cornerReach) % count]);
  }
  // A cyclic walk begins behind a gap between two runs, so that no run goes over its end.
  int start = 0;
  if (closed)
  {
    int calm = 0;
    while (start < 2 * count && calm < cornerReach - 1)
    {
      calm = turns[start % count] > angle ? 0 : calm + 1;
      ++start;
    }
    if (calm < cornerReach - 1)
    {
      return {};
    }
  }
  std::vector<int> result;
  int last = -cornerReach; // of the walk, the last sample near a corner
  for (int i = 0; i < count; ++i)
  {
    const int sample = (start + i) % count;
    if (!(turns[sample] > angle))
    {
      continue;
    }
    if (result.empty() || i - last >= cornerReach)
    {
      result.push_back(sample);
    }
    else if (turns[sample] > turns[result.back()])
    {
      result.back() = sample;
    }
    last = i;
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace oversketch
