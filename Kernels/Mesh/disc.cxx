#include "Mesh/disc.h"

#include "Mesh/context.h"

#include <algorithm>

namespace oversketch
{
namespace
{

[[noreturn]] void refuse(const Message& what)
{
  throw Error(Failure::BadRegion, "The region %1; draw {the boundary} round a piece without holes.", what);
}

} // namespace

std::vector<int> discBorder(const Mesh& patch, const Adjacency& adjacency)
{
  std::vector<int> next(patch.points.size(), -1);
  std::size_t count = 0;
  int start = -1;
  for (const Triangle& t : patch.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3], edge = a == b ? -1 : adjacency.findEdge(a, b);
      if (edge < 0)
      {
        refuse("has a triangle with a repeated vertex");
      }
      if (adjacency.edges[edge].triangleCount > 2)
      {
        refuse("has an edge with three triangles");
      }
      if (adjacency.edges[edge].triangleCount == 1)
      {
        if (next[a] >= 0)
        {
          refuse("is pinched at a vertex");
        }
        next[a] = b;
        start = start < 0 ? a : std::min(start, a);
        ++count;
      }
    }
  }
  if (start < 0)
  {
    refuse("is closed: it has no boundary");
  }
  std::vector<int> border{ start };
  for (int v = next[start]; v != start; v = next[v])
  {
    if (v < 0 || border.size() > count)
    {
      refuse("is pinched or has triangles turned over");
    }
    border.push_back(v);
  }
  if (border.size() < count)
  {
    refuse("has a hole or is in several pieces");
  }
  // A vertex without a triangle belongs to no piece.
  int used = 0;
  for (int v = 0; v < patch.vertexCount(); ++v)
  {
    used += adjacency.vertexTriangles.size(v) > 0 ? 1 : 0;
  }
  if (used < patch.vertexCount())
  {
    refuse("has a vertex without a triangle");
  }
  if (used - static_cast<int>(adjacency.edges.size()) + patch.triangleCount() != 1)
  {
    refuse("has a handle or is in several pieces");
  }
  return border;
}

} // namespace oversketch
