// A closed body, whose triangles say where on the meshes that it was made of they lie.
#ifndef oversketch_kernels_join_body_h
#define oversketch_kernels_join_body_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

struct Body
{
  Mesh mesh;
  // For each triangle: the one that it lies on, and what its corners are of that one's corners.
  std::vector<int> source;
  std::vector<std::array<Vector3, 3>> weights;
  std::vector<int> part; // of each triangle: a number of the body that it came with

  void reserve(std::size_t triangles)
  {
    this->mesh.triangles.reserve(triangles);
    this->source.reserve(triangles);
    this->weights.reserve(triangles);
    this->part.reserve(triangles);
  }
  void add(const Triangle& triangle, int of, const std::array<Vector3, 3>& at, int with)
  {
    this->mesh.triangles.push_back(triangle);
    this->source.push_back(of);
    this->weights.push_back(at);
    this->part.push_back(with);
  }
};

// The corners of a triangle that is a whole one.
inline std::array<Vector3, 3> wholeCorners()
{
  return { Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ() };
}

} // namespace oversketch
#endif
