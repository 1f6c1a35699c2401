// Cuts holes out of a drawing's mesh.
#ifndef oversketch_kernels_planar_trim_h
#define oversketch_kernels_planar_trim_h

#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

namespace oversketch
{

// Source: image-assisted modelling, section 14: the mesh without the faces of the regions that are `gone`, by
// the region that they inherited; points and edges of strokes that no face has then are left out, the others
// keep their order. Points between what is left and what is gone are of kind Hole. Throws
// Error(Failure::BadMesh), naming it, for a face of a region that there is not.
PlanarMesh withoutRegions(const PlanarMesh& mesh, const std::vector<char>& gone);

// Leaves out points that no face has. Returns the numbers of the others, -1 for those.
template <typename AnyMesh>
std::vector<int> dropUnusedPoints(AnyMesh& mesh)
{
  std::vector<int> numbers(mesh.points.size(), -1);
  for (const auto& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      numbers[face.corners[k]] = 0;
    }
  }
  int count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] == 0)
    {
      mesh.points[count] = mesh.points[i];
      numbers[i] = count++;
    }
  }
  mesh.points.resize(count);
  for (auto& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      face.corners[k] = numbers[face.corners[k]];
    }
  }
  return numbers;
}

// Leaves out points that no face has, and edges of strokes that are not kept; numbers them anew.
void compact(PlanarMesh& mesh, const std::vector<char>& keptEdges);

} // namespace oversketch
#endif
