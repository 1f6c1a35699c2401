// A part of the mesh under the hand while it is placed: its points follow a transform.
#ifndef oversketch_applications_studio_tools_part_preview_h
#define oversketch_applications_studio_tools_part_preview_h

#include "Mesh/mesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace oversketch_studio
{

// The points of a part by its number (cell array PartId; a mesh without it is one part, 0), of -1 all, in
// their order; and the box round them.
std::vector<vtkIdType> pointsOfPart(vtkPolyData* mesh, int part);
Eigen::AlignedBox3d boxOfPoints(vtkPolyData* mesh, const std::vector<vtkIdType>& points);

class PartPreview
{
public:
  PartPreview(vtkPolyData* rest, int part);

  // The mesh with the part moved from where it rests.
  void moveTo(const Eigen::Affine3d& by);
  vtkPolyData* mesh() const { return this->Shown; }
  vtkPolyData* rest() const { return this->Rest; }
  Eigen::AlignedBox3d box() const { return boxOfPoints(this->Rest, this->Points); } // at rest

private:
  vtkSmartPointer<vtkPolyData> Rest, Shown;
  std::vector<vtkIdType> Points;
};

} // namespace oversketch_studio
#endif
