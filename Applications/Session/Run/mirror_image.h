// A mesh as a mirror shows it, for systems that are to act on its other side, and what they made of it seen
// in the mirror again.
#ifndef oversketch_applications_session_run_mirror_image_h
#define oversketch_applications_session_run_mirror_image_h

#include "outcome.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <vector>

namespace oversketch_session
{

// Where a mirror shows a place. Exact where the offset is 0.
Point reflected(Point place, const MirrorPlane& plane);

// Whether they have equally many points and the same polygons of them.
bool sameCells(vtkPolyData* a, vtkPolyData* b);

class MirrorImage
{
public:
  // Reflects a mesh, or curves. Points are double; polygons are turned round, so that they face outward;
  // active normals are reflected, other arrays are as they are. Where the mesh has a point, or a triangle, in
  // the very place of an image's, the image has its number (and the triangle begins where the other one
  // does). Parts that are the same on both sides are so worked on in the same order, which greedy steps such
  // as vtkOversketchSnake show in the fourth digit.
  MirrorImage(vtkPolyData* mesh, const MirrorPlane& plane);

  vtkPolyData* get() const { return this->Image; }

  // Shows what was made of the image, as it is in front of the mirror, with points of the mesh's type. What
  // has the image's polygons gets the numbers of the mesh. Points where the image had one are the mesh's, to
  // the bit.
  vtkSmartPointer<vtkPolyData> back(vtkPolyData* made) const;
  std::shared_ptr<const Details> back(vtkPolyData* made, const Details& details) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh, Image;
  MirrorPlane Plane;
  std::vector<vtkIdType> Points, Polygons; // the image's numbers by the mesh's, and the other way round
};

} // namespace oversketch_session
#endif
