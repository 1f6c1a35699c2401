#include "Region/reach.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// The vertices of the region, or of the rest, next to the other, ascending.
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

} // namespace

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
