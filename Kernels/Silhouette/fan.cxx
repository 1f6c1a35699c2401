#include "Silhouette/fan.h"

namespace oversketch
{

namespace
{

// Puts the triangle's neighbours across its spoke to `to` at the end of link; true when the walk comes back
// to it.
bool walkFan(const Mesh& mesh,
  const Adjacency& adjacency,
  int centre,
  int triangle,
  int to,
  std::vector<int>& link)
{
  const int first = triangle;
  for (int steps = adjacency.vertexTriangles.size(centre); steps > 0; --steps)
  {
    const int spoke = adjacency.findEdge(centre, to);
    if (spoke < 0 || adjacency.edges[spoke].triangleCount != 2)
    {
      return false;
    }
    const int* sides = adjacency.trianglesBegin(spoke);
    triangle = sides[0] == triangle ? sides[1] : sides[0];
    if (triangle == first)
    {
      link.pop_back(); // the neighbour that the walk began with, met again
      return true;
    }
    for (int v : mesh.triangles[triangle])
    {
      if (v != centre && v != to)
      {
        to = v;
        break;
      }
    }
    link.push_back(to);
  }
  return false;
}

} // namespace

int triangleWith(const Mesh& mesh, const Adjacency& adjacency, const Support& support)
{
  for (const int t : adjacency.vertexTriangles[support.vertices[0]])
  {
    if (std::all_of(support.vertices,
          support.vertices + support.count,
          [&](int v) { return cornerOf(mesh.triangles[t], v) >= 0; }))
    {
      return t;
    }
  }
  return -1;
}

int Fan::placeOf(const Binding& binding) const
{
  Support support;
  support.add(binding);
  const int m = static_cast<int>(this->link.size());
  const int wanted = support.count - (support.holds(this->centre) ? 1 : 0);
  for (int k = 0; k < m; ++k)
  {
    if (wanted == 1 && support.holds(this->link[k]))
    {
      return 2 * k;
    }
    if (wanted == 2 && (this->closed || k + 1 < m) && support.holds(this->link[k]) &&
        support.holds(this->link[(k + 1) % m]))
    {
      return 2 * k + 1;
    }
  }
  return -1;
}

Fan fanOf(const Mesh& mesh, const Adjacency& adjacency, int centre, int triangle)
{
  const Triangle& corners = mesh.triangles[triangle];
  const int k = cornerOf(corners, centre);
  const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
  Fan fan{ centre, { a, b }, false };
  fan.closed = walkFan(mesh, adjacency, centre, triangle, b, fan.link);
  if (!fan.closed)
  {
    std::vector<int> other;
    walkFan(mesh, adjacency, centre, triangle, a, other);
    fan.link.insert(fan.link.begin(), other.rbegin(), other.rend());
  }
  return fan;
}

} // namespace oversketch
