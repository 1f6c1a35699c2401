#include "Matrix/pose.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const CurveFrame tilted = []
{
  const Vector3 along = Vector3(1, 2, 3).normalized(), outward = along.cross(Vector3(0, 1, 0)).normalized();
  return CurveFrame{ { 4, -5, 6 }, along, outward.cross(along), outward };
}();
constexpr HandleAxis axes[] = { HandleAxis::Along, HandleAxis::Side, HandleAxis::Outward };

// A point given in the frame, and where it goes, in the frame again.
Vector3 inFrame(const Matrix4& m, const Vector3& p)
{
  Eigen::Matrix3d frame;
  frame << tilted.along, tilted.side, tilted.outward;
  const Vector3 world = tilted.origin + frame * p;
  return frame.transpose() * ((m * world.homogeneous()).head<3>() - tilted.origin);
}

} // namespace

TEST(Pose, EachAxisDoesOneThing)
{
  const Vector3 p(0.3, -0.7, 1.1);
  for (int k = 0; k < 3; ++k)
  {
    Vector3 moved = p, scaled = p, turned = p;
    moved[k] += 2.5;
    scaled[k] *= 3.0;
    turned[(k + 1) % 3] = -p[(k + 2) % 3]; // a quarter, from the next axis to the one after it
    turned[(k + 2) % 3] = p[(k + 1) % 3];
    EXPECT_LT((inFrame(movedAlong(tilted, axes[k], 2.5), p) - moved).norm(), 1e-13);
    EXPECT_LT((inFrame(scaledAlong(tilted, axes[k], 3.0), p) - scaled).norm(), 1e-13);
    EXPECT_LT((inFrame(turnedAbout(tilted, axes[k], 90.0), p) - turned).norm(), 1e-13);
    // The origin stays where it is scaled and turned.
    EXPECT_LT(inFrame(scaledAlong(tilted, axes[k], 20.0), Vector3::Zero()).norm(), 1e-13);
    EXPECT_LT(inFrame(turnedAbout(tilted, axes[k], -179.0), Vector3::Zero()).norm(), 1e-13);
    // All that a drag gives has a logarithm; nothing is nothing.
    for (const Matrix4& m : { movedAlong(tilted, axes[k], 1e3),
           scaledAlong(tilted, axes[k], 0.05),
           scaledAlong(tilted, axes[k], 20.0),
           turnedAbout(tilted, axes[k], 179.0) })
    {
      EXPECT_LT((exponential(logarithm(m)) - m).norm(), 1e-10 * m.norm());
    }
    for (const Matrix4& m : { movedAlong(tilted, axes[k], 0.0),
           scaledAlong(tilted, axes[k], 1.0),
           turnedAbout(tilted, axes[k], 0.0) })
    {
      EXPECT_EQ(logarithm(m), Matrix4::Zero());
    }
  }
}

TEST(Pose, WhatNoDragGivesIsRefused)
{
  for (const HandleAxis axis : axes)
  {
    EXPECT_THROW(movedAlong(tilted, axis, std::nan("")), Error);
    EXPECT_THROW(scaledAlong(tilted, axis, 0.0), Error);
    EXPECT_THROW(scaledAlong(tilted, axis, -1.0), Error);
    EXPECT_THROW(scaledAlong(tilted, axis, std::numeric_limits<double>::infinity()), Error);
    EXPECT_THROW(turnedAbout(tilted, axis, 180.0), Error);
    EXPECT_THROW(turnedAbout(tilted, axis, -500.0), Error);
    EXPECT_THROW(turnedAbout(tilted, axis, std::nan("")), Error);
  }
  // Both at once would have no logarithm as a product.
  const Matrix4 product =
    scaledAlong(tilted, HandleAxis::Along, 4.0) * turnedAbout(tilted, HandleAxis::Outward, 150.0);
  EXPECT_THROW(logarithm(product), Error);
}
