// Where the handles of a gizmo are seen, and where a drag of one puts what it is of.
#ifndef oversketch_applications_studio_tools_gizmo_drag_h
#define oversketch_applications_studio_tools_gizmo_drag_h

#include "Matrix/pose.h"
#include "Mesh/view.h"

#include <array>
#include <optional>
#include <vector>

namespace oversketch_studio
{

// The line of sight through a pixel, from a place on it that is about as far off as another one.
using Sight = Eigen::ParametrizedLine<double, 3>;
Sight sightAt(const oversketch::View& view,
  const oversketch::Vector2& display,
  const oversketch::Vector3& place);
// How far along an axis through a place it comes next to the line of sight through a pixel.
double alongAxis(const oversketch::View& view,
  const oversketch::Vector2& display,
  const oversketch::Vector3& place,
  const oversketch::Vector3& axis);

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

// Sizes of it, and how near to a handle the cursor takes hold of it [px as Qt counts them].
struct GizmoSize
{
  double square = 7.0, arrowFrom = 14.0, arrowTo = 58.0, box = 74.0, boxSide = 6.0, ring = 96.0, grab = 8.0;
};

// What is seen of it [px of the screen].
struct GizmoShape
{
  struct Axis
  {
    std::optional<oversketch::Vector2> run; // its direction; absent where it points at the eye, or away
    std::vector<oversketch::Vector2> ring;  // closed
  };
  oversketch::Vector2 middle;
  std::array<Axis, 3> axes;
  double ratio = 1.0; // px of the screen a px as Qt counts them
};

// Nothing where a part of it is behind the eye.
std::optional<GizmoShape> seeGizmo(const oversketch::View& view,
  const oversketch::Vector3& middle,
  const Eigen::Matrix3d& axes,
  double ratio);
std::optional<GizmoGrip> gripAt(const GizmoShape& shape, const oversketch::Vector2& place);

// The pose of what stood in another one, about its middle before that, when a handle was taken. Axes are
// those of the thing, which turn with it.
oversketch::Pose posed(const oversketch::View& view,
  const oversketch::Vector3& middle,
  const oversketch::Pose& from,
  const GizmoGrip& grip,
  const oversketch::Vector2& start,
  const oversketch::Vector2& now,
  bool uniform);

} // namespace oversketch_studio
#endif
