// A limb follows the new course of its bone.
#ifndef oversketch_kernels_pose_pose_h
#define oversketch_kernels_pose_pose_h

#include "Pose/bone.h"
#include "Pose/limb.h"

#include <vector>

namespace oversketch
{

struct PoseOptions
{
  double softness = 1.0; // length over which a joint bends, in thicknesses of the limb there, above 0
  bool stretch = false;  // the bone becomes as long as its course
};

struct Posed
{
  std::vector<Vector3> places; // of the limb's vertices
  int joints = 0;              // places of the bone that turn by over a degree
  double bend = 0.0;           // largest angle between the bone and its course [degrees]
};

// The bone is laid along the course [px] in a view, from the joint on, to which the course's begin is moved,
// its end not: its places at the distances that they have in the picture, beyond the course's end straight
// on. At each place the rest of the limb turns about it, in the plane of the picture, by the angle by which
// the course bends more there than the bone; depths stay. The turn grows along the bone from 0 to its whole
// over the softness, round the place, but from the joint on and no farther than the bone's end: a point takes
// its share of each turn, the nearest to the tip first. With `stretch` the bone is scaled first.
//
// Source: M. Alexa, "Linear Combination of Transformations", 2002: exp(s log A), which of a turn about a
// place is the turn by the share s. Departures: turns come one after the other, from the tip on, and not at
// once, so that beyond a joint the limb stays rigid and lies where the course does, and half a turn is none
// that has no logarithm. In a joint's bend areas are kept, as all turns there have one centre.
//
// A point that nothing turns keeps its bits; so do all where the course is the bone, to 1e-7 of an angle.
// Throws Error(Failure::BadStroke) for a bone behind the eye or seen from its end.
Posed posed(const std::vector<Vector3>& points,
  const Limb& limb,
  const Bone& bone,
  const View& view,
  const Polyline& course,
  const PoseOptions& options,
  const Context& context = Context());

} // namespace oversketch
#endif
