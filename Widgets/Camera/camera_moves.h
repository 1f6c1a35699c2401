// Moves of a camera by drags, gestures and keys.
#ifndef oversketch_widgets_camera_camera_moves_h
#define oversketch_widgets_camera_camera_moves_h

#include "camera_keys.h"
#include "camera_state.h"

#include <optional>

class vtkRenderer;

namespace oversketch
{

// The thesis's trackball, by which the mesh turns so that the picked point stays under the cursor.
//
// The smallest rotation about the centre that takes the picked point, which lies on the line `press`, to
// where the line `now` meets the sphere through it: on the near or far side of the sphere as at the press, or
// at the sphere's point nearest to the line where the line misses it. Identity when the picked point is the
// centre. Lines point away from the viewer.
Eigen::Quaterniond trackballTurn(const Eigen::Vector3d& centre,
  const Eigen::Vector3d& picked,
  const Line& press,
  const Line& now);

// How an upright camera turns when the hand moves by so much [heights of the view, up and to the right]:
// about the world's axis that is up (1 for y, 2 for z) and its own right, half a turn for a height, and not
// beyond the poles.
Eigen::Quaterniond turntableTurn(const CameraState& camera, const Eigen::Vector2d& moved, int up);

// The camera that looks straight ahead and sees a point where this one sees it, which looks past the middle
// of its picture (CameraState::centre).
CameraState straightened(const CameraState& camera, const Eigen::Vector3d& point, vtkRenderer* in);

// The camera looks at a point from the positive or negative side of an axis, upright; from above and below it
// sees the front, which is that of +z where y is up and that of -y where z is, at the bottom and the top of
// the picture.
void lookFromSide(CameraState& camera, const Eigen::Vector3d& point, int axis, bool negative, int up);

// The box of what can be picked in a renderer: the models, without what is drawn about them.
struct Box
{
  Eigen::Vector3d centre;
  double radius; // of the ball about it
};
std::optional<Box> modelsIn(vtkRenderer* renderer);

// A step of the camera by a key. False for keys that are no such steps.
bool moveByKey(const CameraAction& action, FirstView& first);

} // namespace oversketch
#endif
