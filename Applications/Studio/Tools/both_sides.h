// The preview of what the hand does to a region, shown on the other side of a plane too, where the step has
// yet to run.
#ifndef oversketch_applications_studio_tools_both_sides_h
#define oversketch_applications_studio_tools_both_sides_h

#include "step.h"
#include "turning_normals.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

class vtkOversketchEdit;

namespace oversketch_studio
{

class BothSides
{
public:
  // The mesh that the edit shows by now, with what it does seen in the mirror: points that lie, there, on the
  // region go as it goes there. The mesh itself where line and ring lie over the plane, so that the edit acts
  // once, or nothing is seen in the mirror.
  vtkPolyData* show(vtkPolyData* live, vtkOversketchEdit* edit, const oversketch_session::MirrorPlane& plane);

private:
  // A point of the mesh, and the place of the region that it is seen at.
  struct Follower
  {
    vtkIdType point;
    std::array<vtkIdType, 3> corners;
    std::array<double, 3> weights;
  };
  void bind(vtkPolyData* live,
    vtkPolyData* rest,
    vtkPolyData* moved,
    const oversketch_session::MirrorPlane& plane);

  // Things that it was bound to.
  const void *Cells = nullptr, *RestPoints = nullptr;
  oversketch_session::MirrorPlane Plane;
  std::vector<Follower> Followers;
  TurningNormals Normals;
  vtkNew<vtkPolyData> Shown;
};

} // namespace oversketch_studio
#endif
