// Dragging: handles that move together by one vector move everything else in proportion, so that one solve
// serves all places of the hand.
#ifndef oversketch_kernels_sparse_drag_h
#define oversketch_kernels_sparse_drag_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// Places of the vertices that may move for a common displacement d of the handles: rest + response d.
struct Drag
{
  std::vector<int> vertices;    // of the mesh, ascending
  std::vector<Vector3> rest;    // their places for d = 0
  std::vector<double> response; // of each: one factor, or nine of a 3x3 matrix, column-major

  // Writes the places for d into the points of the whole mesh (three numbers each); the others are left
  // alone. Real is float or double.
  template <class Real>
  void place(const Vector3& d, Real* points, const Context& context) const;
};

} // namespace oversketch
#endif
