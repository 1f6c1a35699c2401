// The motion of an edit, and that between two meshes with the same triangles, at every place of the first
// one.
#ifndef oversketch_kernels_remesh_motion_h
#define oversketch_kernels_remesh_motion_h

#include "Remesh/retriangulate.h"

#include <vector>

namespace oversketch
{

struct Motion
{
  int channels = 0;           // values of a vertex
  std::vector<double> values; // of each vertex
  Movement movement;
};

// For who does not know what moved the vertices: within a triangle, halfway from the mean of its corners'
// displacements to that of the displacements which the corners expect there, by their own and its slope along
// the surface (least squares over their neighbours). That is T. Boubekeur and M. Alexa, "Phong Tessellation",
// 2008, of displacements in place of positions: at the middle of an edge it is the cubic with the slopes of
// both ends, at vertices the displacement itself.
Motion motionBetween(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Context& context);

} // namespace oversketch
#endif
