#include "Ray/facet_match.h"

#include <utility>

namespace oversketch
{

bool matchFacets(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others)
{
  constexpr int farthest = 8; // triangles over which the two are brought together again
  const int count = before.triangleCount(), last = now.triangleCount();
  const auto same = [&](int i, int j)
  {
    const Triangle &a = before.triangles[i], &b = now.triangles[j];
    return before.points[a[0]] == now.points[b[0]] && before.points[a[1]] == now.points[b[1]] &&
           before.points[a[2]] == now.points[b[2]];
  };
  // The least steps on, in both together, to where they are the same; none where that is far.
  const auto stepsToSame = [&](int i, int j)
  {
    for (int sum = 1; sum <= farthest; ++sum)
    {
      for (int step = 0; step <= sum; ++step)
      {
        if (i + step < count && j + sum - step < last && same(i + step, j + sum - step))
        {
          return std::pair<int, int>(step, sum - step);
        }
      }
    }
    return std::pair<int, int>(1, 1);
  };
  numbers.assign(before.triangles.size(), -1);
  others.clear();
  int i = 0, j = 0, gone = 0;
  const auto pass = [&](int steps, int otherSteps)
  {
    gone += steps;
    i += steps;
    for (int k = 0; k < otherSteps; ++k)
    {
      others.push_back(j++);
    }
    return 8 * static_cast<int>(others.size()) <= last && 8 * gone <= count;
  };
  bool alike = true;
  while (alike && i < count && j < last)
  {
    if (same(i, j))
    {
      numbers[i++] = j++;
      continue;
    }
    const auto [steps, otherSteps] = stepsToSame(i, j);
    alike = pass(steps, otherSteps);
  }
  alike = alike && pass(count - i, last - j);
  if (!alike)
  {
    numbers.clear();
    others.clear();
  }
  return alike;
}

} // namespace oversketch
