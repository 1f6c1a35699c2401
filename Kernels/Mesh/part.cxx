#include "Mesh/part.h"

namespace oversketch
{

MeshPart::MeshPart(const Mesh& whole,
  const std::vector<char>& regionVertex,
  const Context& context,
  const std::vector<int>& also)
{
  std::vector<char> near = regionVertex, touched(whole.triangles.size());
  const auto trianglesAt = [&](const std::vector<char>& chosen)
  {
    context.each(whole.triangleCount(),
      [&](int i)
      {
        const Triangle& t = whole.triangles[i];
        touched[i] = static_cast<char>(chosen[t[0]] | chosen[t[1]] | chosen[t[2]]);
      });
    return marked(touched);
  };
  for (const int i : trianglesAt(regionVertex))
  {
    const Triangle& t = whole.triangles[i];
    near[t[0]] = near[t[1]] = near[t[2]] = 1;
  }
  std::vector<int> number(whole.points.size(), -1);
  for (const int v : also)
  {
    near[v] = 1;
    number[v] = 0;
  }
  this->triangles = trianglesAt(near);
  this->mesh.triangles = valuesAt(whole.triangles, this->triangles);
  for (const Triangle& t : this->mesh.triangles)
  {
    number[t[0]] = number[t[1]] = number[t[2]] = 0;
  }
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    if (number[v] == 0)
    {
      number[v] = static_cast<int>(this->vertices.size());
      this->vertices.push_back(v);
      this->region.push_back(regionVertex[v]);
    }
  }
  for (Triangle& t : this->mesh.triangles)
  {
    t = { number[t[0]], number[t[1]], number[t[2]] };
  }
  this->place(whole);
  this->adjacency = buildAdjacency(this->mesh, context);
}

} // namespace oversketch
