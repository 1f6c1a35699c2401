#include "Matrix/pose.h"

#include "Mesh/context.h"

#include <Eigen/Geometry>

#include <cmath>

namespace oversketch
{
namespace
{

const Vector3& directionOf(const CurveFrame& frame, HandleAxis axis)
{
  return axis == HandleAxis::Along ? frame.along : axis == HandleAxis::Side ? frame.side : frame.outward;
}

void check(bool good, const char* what, double value, const char* remedy)
{
  if (!good)
  {
    throw Error(Failure::BadStroke, "A handle cannot be %1 %2; %3.", what, value, remedy);
  }
}

// A linear map about the frame's origin.
Matrix4 about(const CurveFrame& frame, const Eigen::Matrix3d& linear)
{
  Matrix4 result = Matrix4::Identity();
  result.topLeftCorner<3, 3>() = linear;
  result.topRightCorner<3, 1>() = frame.origin - linear * frame.origin;
  return result;
}

} // namespace

Matrix4 movedAlong(const CurveFrame& frame, HandleAxis axis, double length)
{
  check(std::isfinite(length), "moved by", length, "give a finite length");
  Matrix4 result = Matrix4::Identity();
  result.topRightCorner<3, 1>() = length * directionOf(frame, axis);
  return result;
}

Matrix4 scaledAlong(const CurveFrame& frame, HandleAxis axis, double factor)
{
  check(std::isfinite(factor) && factor > 0.0, "scaled by", factor, "give a factor above 0");
  const Vector3& d = directionOf(frame, axis);
  return about(frame, Eigen::Matrix3d::Identity() + (factor - 1.0) * d * d.transpose());
}

Matrix4 turnedAbout(const CurveFrame& frame, HandleAxis axis, double degrees)
{
  check(std::abs(degrees) < 180.0, "turned by", degrees, "give less than 180 degrees either way");
  if (degrees == 0.0)
  {
    return Matrix4::Identity();
  }
  const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, directionOf(frame, axis));
  return about(frame, turn.toRotationMatrix());
}

} // namespace oversketch
