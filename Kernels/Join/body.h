// A closed body, whose triangles say where on the meshes that it was made of they lie. Most are whole ones of
// those: only the others have weights.
#ifndef oversketch_kernels_join_body_h
#define oversketch_kernels_join_body_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

// Barycentric coordinates of a triangle's corners in the triangle that it lies on.
using CornerWeights = std::array<Vector3, 3>;

struct Body
{
  Mesh mesh;
  // For each triangle: the one that it lies on, a number of the body that it came with, and where its weights
  // stand, -1 of a whole one.
  std::vector<int> source, part, cut;
  std::vector<CornerWeights> weights;

  void reserve(std::size_t triangles)
  {
    this->mesh.triangles.reserve(triangles);
    this->source.reserve(triangles);
    this->part.reserve(triangles);
    this->cut.reserve(triangles);
  }
  void add(const Triangle& triangle, int of, int with)
  {
    this->mesh.triangles.push_back(triangle);
    this->source.push_back(of);
    this->part.push_back(with);
    this->cut.push_back(-1);
  }
  void add(const Triangle& triangle, int of, int with, const CornerWeights& at)
  {
    this->add(triangle, of, with);
    this->setWeights(this->mesh.triangleCount() - 1, at);
  }

  bool isWhole(int triangle) const { return this->cut[triangle] < 0; }
  CornerWeights weightsOf(int triangle) const
  {
    return this->isWhole(triangle) ? CornerWeights{ Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ() }
                                   : this->weights[this->cut[triangle]];
  }
  void setWeights(int triangle, const CornerWeights& at)
  {
    this->cut[triangle] = static_cast<int>(this->weights.size());
    this->weights.push_back(at);
  }
  // The weights of a place in a triangle.
  Vector3 weightsAt(int triangle, const Vector3& of) const
  {
    const CornerWeights at = this->weightsOf(triangle);
    return of[0] * at[0] + of[1] * at[1] + of[2] * at[2];
  }
};

} // namespace oversketch
#endif
