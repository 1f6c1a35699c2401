// The gizmo of the tool that places: arrows, boxes, rings and a square over the model, as large at any zoom.
#ifndef oversketch_applications_studio_tools_place_gizmo_h
#define oversketch_applications_studio_tools_place_gizmo_h

#include "Mesh/view.h"
#include "Stroke/polyline.h"

#include "vtkNew.h"

#include <optional>
#include <vector>

class vtkActor2D;
class vtkPolyData;

namespace oversketch_studio
{

class Viewport;

// How a thing stands beside where it was (vtkOversketchTransform).
struct Pose
{
  oversketch::Vector3 move = oversketch::Vector3::Zero(), turn = oversketch::Vector3::Zero(),
                      scale = oversketch::Vector3::Ones();

  Eigen::Affine3d about(const oversketch::Vector3& middle) const;
  Eigen::Matrix3d axes() const; // as they are turned
};

struct GizmoGrip
{
  enum Part
  {
    Square, // in the middle: moves in the picture's plane
    Arrow,  // moves along an axis
    Box,    // at its end: scales along it, or all alike
    Ring    // turns about it
  };
  Part part = Square;
  int axis = 0;

  bool operator==(const GizmoGrip& other) const
  {
    return this->part == other.part && this->axis == other.axis;
  }
};

// A handle, or a piece of one, as it is seen [px of the screen].
struct GizmoShape
{
  GizmoGrip grip;
  oversketch::Polyline outline;
  bool isFilled; // else a line
};

// Those of a gizmo that stands there, `ratio` px of the screen a px as Qt counts them. An axis that points at
// the eye has a ring alone; none are there where a part of it is behind the eye.
std::vector<GizmoShape> seeGizmo(const oversketch::View& view,
  const oversketch::Vector3& middle,
  const Eigen::Matrix3d& axes,
  double ratio);
std::optional<GizmoGrip> gripAt(const std::vector<GizmoShape>& seen,
  const oversketch::Vector2& place,
  double ratio);

// The pose of what stood in another one, about its middle before that, when a handle was taken. Axes are
// those of the thing, which turn with it.
Pose posed(const oversketch::View& view,
  const oversketch::Vector3& middle,
  const Pose& from,
  const GizmoGrip& grip,
  const oversketch::Vector2& start,
  const oversketch::Vector2& now,
  bool uniform);

class PlaceGizmo
{
public:
  explicit PlaceGizmo(Viewport* view);
  ~PlaceGizmo();

  // The place it stands on: the middle before the pose, and the pose.
  struct Stand
  {
    oversketch::Vector3 middle;
    Pose pose;
  };
  void show(const std::optional<Stand>& stand);
  const std::optional<Stand>& stand() const { return this->Shown; }
  // A frame begins: where it is seen in it.
  void follow();
  // The handle at a place of the screen [px]; the one that is painted stronger, under the cursor or in the
  // hand.
  std::optional<GizmoGrip> at(const oversketch::Vector2& place) const;
  void light(const std::optional<GizmoGrip>& grip);
  // For a picture without it.
  void setVisible(bool visible) { this->Visible = visible; }
  void setPixelRatio(double ratio);

private:
  Viewport* View;
  std::optional<Stand> Shown;
  std::vector<GizmoShape> Seen;
  std::optional<GizmoGrip> Lit;
  double Ratio = 1.0;
  bool Visible = true;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkActor2D> Actor;
};

} // namespace oversketch_studio
#endif
