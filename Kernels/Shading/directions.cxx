#include "Shading/directions.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

Directions::Directions(const Mesh& mesh, const Adjacency& adjacency, const Context& context)
  : Surface(mesh)
  , Links(adjacency)
  , First(mesh.triangles.size())
  , Corner(mesh.triangles.size())
  , Round(mesh.points.size(), 0.0)
{
  context.eachUntilCancelled(mesh.triangleCount(),
    [&](int t)
    {
      const Triangle& c = mesh.triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 a = mesh.points[c[(k + 1) % 3]] - mesh.points[c[k]],
                      b = mesh.points[c[(k + 2) % 3]] - mesh.points[c[k]];
        this->Corner[t][k] = std::atan2(a.cross(b).norm(), a.dot(b));
      }
    });
  context.eachUntilCancelled(mesh.vertexCount(), [&](int v) { this->order(v); });
  context.checkpoint(0.0);
}

double Directions::toward(int vertex, int neighbour) const
{
  for (const int t : this->Links.vertexTriangles[vertex])
  {
    const int k = this->corner(t, vertex);
    const Triangle& c = this->Surface.triangles[t];
    if (c[(k + 1) % 3] == neighbour || c[(k + 2) % 3] == neighbour)
    {
      return c[(k + 1) % 3] == neighbour ? this->next(t, k) : this->previous(t, k);
    }
  }
  return 0.0;
}

double Directions::between(int vertex, double a, double b) const
{
  const double direct = std::abs(a - b), round = this->Round[vertex];
  return round > 0.0 ? std::min(direct, round - direct) : direct;
}

void Directions::order(int vertex)
{
  const int *begin = this->Links.vertexTriangles.begin(vertex),
            *end = this->Links.vertexTriangles.end(vertex);
  const auto with = [&](int step, int neighbour) // the triangle that has it next or before, or the end
  {
    return std::find_if(begin,
      end,
      [&](int t) { return this->Surface.triangles[t][(this->corner(t, vertex) + step) % 3] == neighbour; });
  };
  const auto far = [&](int t, int step)
  { return this->Surface.triangles[t][(this->corner(t, vertex) + step) % 3]; };
  const int* start = begin;
  if (this->Links.borderVertex[vertex])
  {
    start = std::find_if(begin, end, [&](int t) { return with(2, far(t, 1)) == end; });
  }
  double sum = 0.0;
  const int* at = start;
  for (int met = 0, count = static_cast<int>(end - begin); at != end && met < count; ++met)
  {
    const int k = this->corner(*at, vertex);
    this->First[*at][k] = sum;
    sum += this->Corner[*at][k];
    at = with(1, far(*at, 2));
  }
  this->Round[vertex] = this->Links.borderVertex[vertex] ? 0.0 : sum;
}

} // namespace oversketch
