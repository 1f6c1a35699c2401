#include "Region/border.h"

#include "Region/grow.h"

#include <algorithm>
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

// Vertices within `rings` rings of the region's border, both sides.
std::vector<char> nearBorder(const Adjacency& adjacency, const std::vector<char>& region, int rings)
{
  std::vector<char> near(region.size(), 0);
  std::vector<int> front;
  for (int inside = 0; inside < int(region.size()); ++inside)
  {
    if (!region[inside])
    {
      continue;
    }
    for (const int* n = adjacency.vertexVertices.begin(inside); n != adjacency.vertexVertices.end(inside);
         ++n)
    {
      for (int v : { inside, *n })
      {
        if (!region[*n] && !near[v])
        {
          near[v] = 1;
          front.push_back(v);
        }
      }
    }
  }
  for (int ring = 1; ring < rings; ++ring)
  {
    std::vector<int> next;
    for (int v : front)
    {
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        if (!near[*n])
        {
          near[*n] = 1;
          next.push_back(*n);
        }
      }
    }
    front = std::move(next);
  }
  return near;
}

} // namespace

std::vector<char> smoothBorder(const Adjacency& adjacency,
  const std::vector<char>& isSeed,
  const std::vector<char>& region,
  int rings)
{
  std::vector<char> result = region;
  std::vector<char> flips(region.size(), 0);
  const std::vector<char> allowed =
    rings > 0 ? nearBorder(adjacency, region, rings) : std::vector<char>(region.size(), 1);
  const auto mayFlip = [&](int v) { return allowed[v] && flips[v] < maximumFlips; };
  // What the vertex is, and the one outside neighbour of a concave one.
  const auto classify = [&](int v) -> std::pair<Kind, int>
  {
    if (!result[v])
    {
      return { Plain, -1 };
    }
    int inside = 0, outside = 0, other = -1;
    for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
    {
      ++(result[*n] ? inside : outside);
      other = result[*n] ? other : *n;
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
    for (const int* n = adjacency.vertexVertices.begin(target); n != adjacency.vertexVertices.end(target);
         ++n)
    {
      update(*n);
    }
  }
  if (std::any_of(isSeed.begin(), isSeed.end(), [](char s) { return s != 0; }))
  {
    dropSeedless(adjacency, isSeed, result);
  }
  return result;
}

} // namespace oversketch
