// The part of a mesh that goes with a bone, and where along the bone its points are.
#ifndef oversketch_kernels_pose_limb_h
#define oversketch_kernels_pose_limb_h

#include "Pose/bone.h"

#include <vector>

namespace oversketch
{

struct Limb
{
  std::vector<int> vertices;     // ascending
  std::vector<double> parameter; // of each, a length along the bone, 0 at the joint
};

// The vertices that the surface joins to the tip's side of the limb's cross-section at the joint, and to the
// other side nowhere; of a limb that the cross-section does not cut off, those on the tip's side of its whole
// plane. The parameter is that of the nearest place of the bone, found from neighbour to neighbour from the
// joint on, so that it does not jump to a part of the bone that is near in space alone; no more than the way
// over the surface from the cross-section; and smoothed 4 times. Throws Error(Failure::BadStroke) where the
// plane cuts nothing, Error(Failure::Cancelled).
Limb limbOf(const Mesh& mesh,
  const Adjacency& adjacency,
  const Bone& bone,
  const Context& context = Context());

} // namespace oversketch
#endif
