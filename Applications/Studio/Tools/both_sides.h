// What the hand does to a region, shown on the other side of a plane too, where the step has yet to run.
#ifndef oversketch_applications_studio_tools_both_sides_h
#define oversketch_applications_studio_tools_both_sides_h

#include "step.h"

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
  using Vector = std::array<double, 3>;
  // A point of the mesh, and the place of the region that it is seen at.
  struct Follower
  {
    vtkIdType point;
    std::array<vtkIdType, 3> corners;
    std::array<double, 3> weights;
  };
  struct Face
  {
    std::array<vtkIdType, 3> points;
    std::array<int, 3> turned; // places in Turned, or -1
  };
  void bind(vtkPolyData* live,
    vtkPolyData* rest,
    vtkPolyData* moved,
    const oversketch_session::MirrorPlane& plane);
  void findTurned(vtkPolyData* live);
  std::vector<Vector> normals(vtkPolyData* mesh) const;

  // What it was bound to.
  const void *Cells = nullptr, *RestPoints = nullptr;
  oversketch_session::MirrorPlane Plane;
  std::vector<Follower> Followers;
  std::vector<vtkIdType> Turned; // points whose normals change
  std::vector<Face> Faces;       // round them
  std::vector<Vector> Before;    // their normals at rest
  vtkNew<vtkPolyData> Shown;
};

} // namespace oversketch_studio
#endif
