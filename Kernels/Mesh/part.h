// A part of a mesh by itself, for work that need not look at the rest.
#ifndef oversketch_kernels_mesh_part_h
#define oversketch_kernels_mesh_part_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// A region (one byte per vertex) and two rings round it as a mesh of its own, in the order of the whole: what
// is computed of a vertex of the region or of the first ring, and of an edge there, has the bits that it has
// in the whole, which need not be linked for it.
struct MeshPart
{
  std::vector<int> vertices, triangles; // of the whole, ascending
  Mesh mesh;
  Adjacency adjacency;
  std::vector<char> region;

  // also: vertices that are there with one ring in any case.
  MeshPart(const Mesh& whole,
    const std::vector<char>& regionVertex,
    const Context& context = Context(),
    const std::vector<int>& also = {});
  // Takes the points of another whole with the same triangles.
  void place(const Mesh& whole) { this->mesh.points = valuesAt(whole.points, this->vertices); }
  // The place in `vertices` of one that is there.
  int at(int vertex) const
  {
    const auto found = std::lower_bound(this->vertices.begin(), this->vertices.end(), vertex);
    return static_cast<int>(found - this->vertices.begin());
  }
};

} // namespace oversketch
#endif
