#include "Region/border.h"

#include "Region/grow.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace oversketch
{

namespace
{

constexpr int maximumFlips = 2;

enum Kind
{
  Convex,
  Concave,
  Plain
};

} // namespace

std::vector<int> borderOf(const Adjacency& adjacency, const std::vector<char>& region, bool inside)
{
  std::vector<int> border;
  for (int v = 0; v < static_cast<int>(region.size()); ++v)
  {
    if ((region[v] != 0) == inside && std::any_of(adjacency.vertexVertices.begin(v),
                                        adjacency.vertexVertices.end(v),
                                        [&](int n) { return (region[n] != 0) != inside; }))
    {
      border.push_back(v);
    }
  }
  return border;
}

std::vector<char> withinRings(const Adjacency& adjacency, std::vector<int> vertices, int rings)
{
  std::vector<char> near = marksAt(vertices, adjacency.borderVertex.size());
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<int> next;
    for (const int v : vertices)
    {
      for (const int n : adjacency.vertexVertices[v])
      {
        if (!near[n])
        {
          near[n] = 1;
          next.push_back(n);
        }
      }
    }
    vertices = std::move(next);
  }
  return near;
}

std::vector<char> smoothBorder(const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  int rings)
{
  std::vector<char> result = region;
  std::vector<char> flips(region.size(), 0);
  std::vector<char> allowed(region.size(), 1);
  if (rings > 0)
  {
    std::vector<int> border = borderOf(adjacency, region, true);
    const std::vector<int> beyond = borderOf(adjacency, region, false);
    border.insert(border.end(), beyond.begin(), beyond.end());
    allowed = withinRings(adjacency, border, rings - 1);
  }
  const auto mayFlip = [&](int v) { return allowed[v] && flips[v] < maximumFlips; };
  // The kind of a vertex, and the one outside neighbour of a concave one.
  const auto classify = [&](int v) -> std::pair<Kind, int>
  {
    if (!result[v])
    {
      return { Plain, -1 };
    }
    int inside = 0, outside = 0, other = -1;
    for (const int n : adjacency.vertexVertices[v])
    {
      ++(result[n] ? inside : outside);
      other = result[n] ? other : n;
    }
    if (inside <= 2 && outside > 0 && !adjacency.borderVertex[v] && !isSeed[v] && mayFlip(v))
    {
      return { Convex, v };
    }
    return outside == 1 && mayFlip(other) ? std::pair<Kind, int>{ Concave, other }
                                          : std::pair<Kind, int>{ Plain, -1 };
  };
  std::set<std::pair<Kind, int>> queue;
  std::vector<Kind> queuedAs(region.size(), Plain);
  const auto update = [&](int v)
  {
    const Kind kind = classify(v).first;
    if (kind != queuedAs[v])
    {
      queue.erase({ queuedAs[v], v });
      if (kind != Plain)
      {
        queue.insert({ kind, v });
      }
      queuedAs[v] = kind;
    }
  };
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    update(int(v));
  }
  while (!queue.empty())
  {
    const int target = classify(queue.begin()->second).second;
    result[target] = !result[target];
    ++flips[target];
    // A vertex's kind depends on its neighbours, and on whether its one outside neighbour may still flip.
    update(target);
    for (const int n : adjacency.vertexVertices[target])
    {
      update(n);
    }
  }
  if (std::any_of(isSeed.begin(), isSeed.end(), [](char s) { return s != 0; }))
  {
    dropSeedless(adjacency, isSeed, result);
  }
  return result;
}

std::vector<char> reachEnds(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::array<std::vector<int>, 2>& ends,
  double limit,
  const std::vector<char>& region)
{
  const std::vector<int> border = borderOf(adjacency, region, true);
  const std::vector<double> fromRegion = edgeDistances(mesh, adjacency, border, limit);
  std::array<double, 2> length{ 0.0, 0.0 };
  std::array<std::vector<double>, 2> toEnd;
  for (int k = 0; k < 2; ++k)
  {
    for (const int v : ends[k])
    {
      if (!region[v] && std::isfinite(fromRegion[v]))
      {
        length[k] = std::max(length[k], fromRegion[v]);
      }
    }
  }
  if (!(length[0] + length[1] > 0.0))
  {
    return region;
  }
  for (int k = 0; k < 2; ++k)
  {
    toEnd[k] = edgeDistances(mesh, adjacency, ends[k], 5.0 * limit);
  }
  std::vector<char> reached(region);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (region[v] || !(fromRegion[v] <= std::max(length[0], length[1])))
    {
      continue;
    }
    const double first = toEnd[0][v], second = toEnd[1][v];
    // An end that is not there, or too far to be one of this limb, does not count.
    const bool nearFirst = std::isfinite(first), nearSecond = std::isfinite(second);
    double share = nearFirst == nearSecond ? 0.5 : (nearFirst ? 0.0 : 1.0);
    if (nearFirst && nearSecond && first + second > 0.0)
    {
      share = first / (first + second);
    }
    reached[v] = fromRegion[v] <= (1.0 - share) * length[0] + share * length[1];
  }
  return reached;
}

std::vector<char> confineRegion(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& seeds,
  double reach,
  const std::vector<char>& region)
{
  const std::vector<double> distance = edgeDistances(mesh, adjacency, seeds, reach);
  std::vector<char> confined(region);
  std::transform(region.begin(),
    region.end(),
    distance.begin(),
    confined.begin(),
    [](char in, double d) { return static_cast<char>(in && std::isfinite(d)); });
  return confined;
}

std::vector<char> shiftBorder(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  double length,
  const std::vector<char>& region)
{
  const bool grows = length > 0.0;
  const std::vector<double> distance =
    edgeDistances(mesh, adjacency, borderOf(adjacency, region, grows), std::abs(length));
  std::vector<char> shifted(region);
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if ((region[v] != 0) != grows && std::isfinite(distance[v]) && !isSeed[v])
    {
      shifted[v] = grows ? 1 : 0;
    }
  }
  return shifted;
}

} // namespace oversketch
