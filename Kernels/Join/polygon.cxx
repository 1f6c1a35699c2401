#include "Join/polygon.h"

#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace oversketch
{

namespace
{

double turnAt(const std::vector<Vector2>& points, int a, int b, int c)
{
  return cross(points[b] - points[a], points[c] - points[a]);
}

// Joins a hole to the loop round it by a bridge from its rightmost point to the nearest corner that it sees.
void bridge(const std::vector<Vector2>& points, const std::vector<int>& hole, std::vector<int>& loop)
{
  const auto right = std::max_element(hole.begin(),
    hole.end(),
    [&](int a, int b)
    { return std::make_pair(points[a][0], points[a][1]) < std::make_pair(points[b][0], points[b][1]); });
  const Vector2& p = points[*right];
  const std::size_t n = loop.size();
  // The edge that a ray to the right meets first, then of the corners in the triangle to its right end the
  // one at the least angle.
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t best = n;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector2 &a = points[loop[i]], &b = points[loop[(i + 1) % n]];
    if ((a[1] <= p[1] && b[1] >= p[1]) && a[1] < b[1]) // counter-clockwise: the inside is to the left
    {
      const double x = a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      if (x >= p[0] && x < nearest)
      {
        nearest = x;
        best = a[0] > b[0] ? i : (i + 1) % n;
      }
    }
  }
  if (best == n) // by rounding: the nearest corner
  {
    best = 0;
    for (std::size_t i = 1; i < n; ++i)
    {
      best = (points[loop[i]] - p).squaredNorm() < (points[loop[best]] - p).squaredNorm() ? i : best;
    }
  }
  else
  {
    const Vector2 hit(nearest, p[1]), end = points[loop[best]];
    const double way = end[1] > p[1] ? 1.0 : -1.0;
    const auto slope = [&](const Vector2& q)
    { return std::abs(q[1] - p[1]) / std::max(q[0] - p[0], 1e-300); };
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vector2& q = points[loop[i]];
      if (q != end && q[0] >= p[0] && way * cross(hit - p, q - p) >= 0.0 &&
          way * cross(end - p, q - p) <= 0.0 && way * cross(end - hit, q - hit) >= 0.0 &&
          (slope(q) < slope(points[loop[best]]) ||
            (slope(q) == slope(points[loop[best]]) && q[0] < points[loop[best]][0])))
      {
        best = i;
      }
    }
  }
  std::vector<int> way(right, hole.end());
  way.insert(way.end(), hole.begin(), right + 1);
  way.push_back(loop[best]);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(best) + 1, way.begin(), way.end());
}

// The triangles of a loop without holes, whose points may be there twice.
std::vector<Triangle> earsOf(const std::vector<Vector2>& points, const std::vector<int>& loop)
{
  const int n = static_cast<int>(loop.size());
  std::vector<int> next(loop.size()), last(loop.size());
  for (int i = 0; i < n; ++i)
  {
    next[i] = (i + 1) % n;
    last[i] = (i + n - 1) % n;
  }
  const auto isEar = [&](int i)
  {
    const int a = loop[last[i]], b = loop[i], c = loop[next[i]];
    if (turnAt(points, a, b, c) <= 0.0)
    {
      return false;
    }
    for (int k = next[next[i]]; k != last[i]; k = next[k])
    {
      const int p = loop[k];
      if (p != a && p != b && p != c && turnAt(points, a, b, p) >= 0.0 && turnAt(points, b, c, p) >= 0.0 &&
          turnAt(points, c, a, p) >= 0.0 && turnAt(points, loop[last[k]], p, loop[next[k]]) <= 0.0)
      {
        return false;
      }
    }
    return true;
  };
  std::vector<Triangle> triangles;
  int at = 0, left = n, tried = 0;
  while (left > 3)
  {
    const bool ear = isEar(at);
    if (!ear && ++tried <= left)
    {
      at = next[at];
      continue;
    }
    if (!ear) // none is left, by rounding: the corner with the least area
    {
      const auto area = [&](int k)
      { return std::abs(turnAt(points, loop[last[k]], loop[k], loop[next[k]])); };
      int best = at;
      for (int i = 0, k = at; i < left; ++i, k = next[k])
      {
        best = area(k) < area(best) ? k : best;
      }
      at = best;
    }
    triangles.push_back({ loop[last[at]], loop[at], loop[next[at]] });
    next[last[at]] = next[at];
    last[next[at]] = last[at];
    at = next[next[at]]; // not the next one: a fan round one corner is made of needles
    --left;
    tried = 0;
  }
  triangles.push_back({ loop[last[at]], loop[at], loop[next[at]] });
  return triangles;
}

// Flips the edges inside, those between two of the triangles, until none is left across which a circle holds
// the other corner.
void flipToDelaunay(const std::vector<Vector2>& points, std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, int> of; // triangle by its edge, in its direction; -1 where there are several
  const auto put = [&](int t)
  {
    for (int k = 0; k < 3; ++k)
    {
      of[{ triangles[t][k], triangles[t][(k + 1) % 3] }] = t;
    }
  };
  std::map<std::pair<int, int>, int> times;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    put(t);
    for (int k = 0; k < 3; ++k)
    {
      ++times[{ triangles[t][k], triangles[t][(k + 1) % 3] }];
    }
  }
  std::vector<std::pair<int, int>> queue;
  for (const auto& edge : times)
  {
    if (edge.first.first < edge.first.second)
    {
      queue.push_back(edge.first);
    }
  }
  std::size_t most = 20 * triangles.size() + 100; // by rounding flips might go round for ever
  while (!queue.empty() && most-- > 0)
  {
    const auto [a, b] = queue.back();
    queue.pop_back();
    const auto one = of.find({ a, b }), two = of.find({ b, a });
    if (one == of.end() || two == of.end() || times[{ a, b }] != 1 || times[{ b, a }] != 1)
    {
      continue;
    }
    const int s = one->second, t = two->second;
    const int c = triangles[s][(cornerOf(triangles[s], b) + 1) % 3],
              d = triangles[t][(cornerOf(triangles[t], a) + 1) % 3];
    if (c == d || of.count({ c, d }) || of.count({ d, c }) || turnAt(points, a, d, c) <= 0.0 ||
        turnAt(points, d, b, c) <= 0.0)
    {
      continue;
    }
    // Angles at c and d together over 180 degrees.
    const Vector2 ca = points[a] - points[c], cb = points[b] - points[c], da = points[a] - points[d],
                  db = points[b] - points[d];
    const double sine = cross(ca, cb) * da.dot(db) + cross(db, da) * ca.dot(cb);
    if (sine >= -1e-12 * ca.norm() * cb.norm() * da.norm() * db.norm())
    {
      continue;
    }
    of.erase(one);
    of.erase({ b, a });
    times.erase({ a, b });
    times.erase({ b, a });
    triangles[s] = { a, d, c };
    triangles[t] = { d, b, c };
    put(s);
    put(t);
    times[{ c, d }] = times[{ d, c }] = 1;
    for (const auto& edge : { std::minmax(a, d), std::minmax(d, b), std::minmax(b, c), std::minmax(c, a) })
    {
      queue.emplace_back(edge.first, edge.second);
    }
  }
}

} // namespace

double turnedArea(const std::vector<Vector2>& points, const std::vector<int>& loop)
{
  double area = 0.0;
  for (std::size_t i = 2; i < loop.size(); ++i)
  {
    area += turnAt(points, loop[0], loop[i - 1], loop[i]);
  }
  return area;
}

bool isInLoop(const std::vector<Vector2>& points, const std::vector<int>& loop, const Vector2& p)
{
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector2 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
    inside ^= (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
  }
  return inside;
}

std::vector<Triangle> triangulatePolygon(const std::vector<Vector2>& points,
  std::vector<std::vector<int>> loops)
{
  std::vector<int> loop = std::move(loops.front());
  loops.erase(loops.begin());
  const auto rightEnd = [&](const std::vector<int>& hole)
  {
    double x = -std::numeric_limits<double>::infinity();
    for (const int p : hole)
    {
      x = std::max(x, points[p][0]);
    }
    return x;
  };
  std::stable_sort(loops.begin(),
    loops.end(),
    [&](const std::vector<int>& a, const std::vector<int>& b) { return rightEnd(a) > rightEnd(b); });
  for (const std::vector<int>& hole : loops)
  {
    bridge(points, hole, loop);
  }
  std::vector<Triangle> triangles = earsOf(points, loop);
  flipToDelaunay(points, triangles);
  return triangles;
}

} // namespace oversketch
