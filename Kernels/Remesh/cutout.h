// The part of a mesh that a remeshing looks at, by itself.
#ifndef oversketch_kernels_remesh_cutout_h
#define oversketch_kernels_remesh_cutout_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// The triangles at the vertices of active ones, ordered along a space-filling curve that turns with them, so
// that neighbours lie beside each other in memory: remeshing is bound by cache misses, and the rest of the
// mesh costs nothing.
struct Cutout
{
  Mesh mesh;
  std::vector<char> active;             // per triangle of the cut-out
  std::vector<int> vertices, triangles; // their ids in the whole mesh
  std::vector<int> vertexOf;            // per vertex of the whole mesh: its id here, or -1

  Cutout(const Mesh& whole, const std::vector<char>& wholeActive);
};

} // namespace oversketch
#endif
