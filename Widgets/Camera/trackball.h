// The thesis's trackball: the mesh turns so that the picked point stays under the cursor.
#ifndef oversketch_widgets_camera_trackball_h
#define oversketch_widgets_camera_trackball_h

#include <Eigen/Geometry>

namespace oversketch
{

using Line = Eigen::ParametrizedLine<double, 3>;

// The smallest rotation about the centre that takes the picked point, which lies on the line `press`, to
// where the line `now` meets the sphere through it: on the near or far side of the sphere as at the press, or
// at the sphere's point nearest to the line where the line misses it. Identity when the picked point is the
// centre. Lines point away from the viewer.
Eigen::Quaterniond trackballTurn(const Eigen::Vector3d& centre,
  const Eigen::Vector3d& picked,
  const Line& press,
  const Line& now);

} // namespace oversketch
#endif
