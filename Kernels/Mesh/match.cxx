#include "Mesh/match.h"

#include <utility>

namespace oversketch
{

bool matchTriangles(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others)
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
  bool alike = 8 * (last - count) <= last && 8 * (count - last) <= count; // else other bodies
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

bool normalsAfter(const Mesh& before,
  const std::vector<Vector3>& normals,
  const Mesh& now,
  const Lists& around,
  std::vector<Vector3>& result)
{
  std::vector<int> numbers, others;
  if (!matchTriangles(before, now, numbers, others))
  {
    return false;
  }
  // A vertex stays where all of its triangles do, and with it no other.
  std::vector<int> from(now.points.size(), -1), to(before.points.size(), -1);
  std::vector<char> changed(now.points.size(), 0), gone(before.points.size(), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = before.triangles[i][k];
      if (numbers[i] < 0)
      {
        gone[v] = 1;
        continue;
      }
      const int w = now.triangles[numbers[i]][k];
      if ((from[w] >= 0 && from[w] != v) || (to[v] >= 0 && to[v] != w))
      {
        changed[w] = 1;
        gone[v] = 1;
      }
      from[w] = v;
      to[v] = w;
    }
  }
  for (const int t : others)
  {
    for (const int w : now.triangles[t])
    {
      changed[w] = 1;
    }
  }
  result.resize(now.points.size());
  for (int w = 0; w < now.vertexCount(); ++w)
  {
    const int v = from[w];
    result[w] = v >= 0 && !changed[w] && !gone[v] ? normals[v] : vertexNormal(now, around, w);
  }
  return true;
}

} // namespace oversketch
