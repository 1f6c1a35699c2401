// The order of a coarse mesh's faces, which does not depend on how they were made.
#ifndef oversketch_kernels_planar_face_order_h
#define oversketch_kernels_planar_face_order_h

#include "Planar/planar_mesh.h"

#include <algorithm>

namespace oversketch
{

// Faces start at their least corner, ascend, and are each its own base.
inline void orderFaces(PlanarMesh& mesh)
{
  for (PlanarFace& face : mesh.faces)
  {
    const auto end = face.corners.begin() + face.count();
    std::rotate(face.corners.begin(), std::min_element(face.corners.begin(), end), end);
  }
  std::sort(mesh.faces.begin(),
    mesh.faces.end(),
    [](const PlanarFace& a, const PlanarFace& b) { return a.corners < b.corners; });
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    mesh.faces[f].base = static_cast<int>(f);
  }
}

} // namespace oversketch
#endif
