// A bone drawn over a limb: the limb's centre line under it.
#ifndef oversketch_kernels_pose_bone_h
#define oversketch_kernels_pose_bone_h

#include "Mesh/view.h"
#include "Ray/surface_rays.h"
#include "Stroke/polyline.h"

#include <array>
#include <vector>

namespace oversketch
{

struct Bone
{
  std::vector<Vector3> places;   // from the joint that stays to the tip
  std::vector<double> along;     // length from the joint to each
  std::vector<double> thickness; // of the limb at each, along the line of sight [model length]
  std::vector<Vector3> seen;     // the limb's front over the places, where a ray meets it
  double beside = 0.0;           // share of the line that is left out at its ends, as it lies over nothing
  std::array<int, 2> joint;      // triangles in front of the joint and behind it
  Vector3 across =
    Vector3::Zero(); // unit normal, towards the tip, of the plane that cuts the limb at the joint
};

// The centre line under a line in the picture [px], whose first place is the joint: 3 to 49 places at equal
// distances in the picture, 6 px where that makes as many. A ray through each finds where it enters the model
// first, and where it leaves what it has entered; the middle of both, smooth in depth, is the place. Places
// beside the model are left out at both ends and bridged in between. The plane at the joint holds the line of
// sight. Throws Error(Failure::BadStroke) where fewer than two places lie over a limb.
Bone boneUnder(const SurfaceRays& surface,
  const View& view,
  const Polyline& line,
  const Context& context = Context());

// Places on a line, the first one its begin, each at a distance from the one before: the first onward that is
// so far. Beyond the end they go straight on.
Polyline stepped(const Polyline& line, const std::vector<double>& steps);

// The factor of all steps by which the last place is the line's end.
double scaleToEnd(const Polyline& line, const std::vector<double>& steps);

} // namespace oversketch
#endif
