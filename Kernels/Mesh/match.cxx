#include "Mesh/match.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// Per item now an equal one before, or -1; and which ones before are equal to none now.
struct Pairs
{
  std::vector<int> found;
  std::vector<char> gone;
};

// Most of a mesh keeps its order: each item is sought behind the one found last. What has taken the place of
// others is as long as they were; where some were left out, those that follow come a little later. Ends where
// more than `most` items now have none.
template <typename Equal>
Pairs matchInOrder(int before, int now, int most, const Equal& equal)
{
  constexpr int window = 64;
  Pairs pairs{ std::vector<int>(now, -1), std::vector<char>(before, 1) };
  int next = 0, missed = 0, lost = 0;
  for (int i = 0; i < now && next < before && lost <= most; ++i)
  {
    int at = next;
    if (!equal(at, i))
    {
      at = next + missed;
      if (at >= before || !equal(at, i))
      {
        ++missed;
        at = before;
        if ((missed & (missed - 1)) == 0) // now and then only, so that all searches together stay short
        {
          const int end = static_cast<int>(std::min<long>(before, next + static_cast<long>(window) * missed));
          for (at = next; at < end && !equal(at, i); ++at)
          {
          }
          at = at < end ? at : before;
        }
      }
    }
    if (at < before)
    {
      pairs.found[i] = at;
      pairs.gone[at] = 0;
      next = at + 1;
      missed = 0;
    }
    lost += at < before ? 0 : 1;
  }
  return pairs;
}

} // namespace

bool matchTriangles(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others)
{
  const int count = before.triangleCount(), last = now.triangleCount();
  numbers.clear();
  others.clear();
  if (8 * (last - count) > last || 8 * (count - last) > count) // other bodies
  {
    return false;
  }
  const Pairs pairs = matchInOrder(count,
    last,
    last / 8,
    [&](int i, int j)
    {
      const Triangle &a = before.triangles[i], &b = now.triangles[j];
      return before.points[a[0]] == now.points[b[0]] && before.points[a[1]] == now.points[b[1]] &&
             before.points[a[2]] == now.points[b[2]];
    });
  numbers.assign(before.triangles.size(), -1);
  for (int j = 0; j < last; ++j)
  {
    pairs.found[j] >= 0 ? void(numbers[pairs.found[j]] = j) : others.push_back(j);
  }
  const auto gone = static_cast<int>(std::count(pairs.gone.begin(), pairs.gone.end(), 1));
  const bool alike = 8 * static_cast<int>(others.size()) <= last && 8 * gone <= count;
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
