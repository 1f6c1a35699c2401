// What dragging an axis of a handle does.
#ifndef oversketch_kernels_matrix_pose_h
#define oversketch_kernels_matrix_pose_h

#include "Matrix/frames.h"
#include "Matrix/logarithm.h"

namespace oversketch
{

enum class HandleAxis
{
  Along,
  Side,
  Outward
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.5 and chapter 7: a
// handle's frame is moved along one of its axes, scaled along it or turned about it, about the frame's
// origin. The thesis prints T(-c) T S R T(c) with T(c) moving to the origin; what is meant is T(c) T S R
// T(-c), in the frame's axes.
//
// Each is one elementary transformation, so that it has a logarithm: several at once are their logarithms'
// sum. A scaling by 4 after a turn by 150 degrees has none. All throw Error(Failure::BadStroke) for a number
// that is not finite.
Matrix4 movedAlong(const CurveFrame& frame, HandleAxis axis, double length);
// A factor above 0; from 0.05 to 20 what a drag gives.
Matrix4 scaledAlong(const CurveFrame& frame, HandleAxis axis, double factor);
// Counter-clockwise seen from the axis's tip; less than 180 degrees either way.
Matrix4 turnedAbout(const CurveFrame& frame, HandleAxis axis, double degrees);

} // namespace oversketch
#endif
