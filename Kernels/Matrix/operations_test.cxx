#include "Matrix/operations.h"

#include "Harness/shapes.h"
#include "Harness/transformations.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Along x, side y, outward z, at (t, 0, 0).
CurveFrame frameAt(double t)
{
  return { { t, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
}

void expectRefused(const std::string& text, const std::string& named, const std::string& remedy)
{
  try
  {
    handlesOf(text, frameAt);
    ADD_FAILURE() << "not refused: " << text;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_EQ(std::string(error.what()).rfind(named, 0), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find(remedy), std::string::npos) << error.what();
  }
}

} // namespace

TEST(Operations, AreDoneInTheFrameAtTheirPlace)
{
  const auto handles =
    handlesOf("move 0.5 n 0.1; rotate 0.7 t 30;\n scale 0.3 w 1.5 ; pin 0.2;", frameAt).handles;
  ASSERT_EQ(handles.size(), 4u);
  EXPECT_EQ(handles[0].t, 0.5);
  EXPECT_EQ(handles[0].matrix, shift(0, 0, 0.1));
  EXPECT_EQ(handles[1].frame.origin, Vector3(0.7, 0, 0));
  EXPECT_LT((handles[1].matrix - turn(Vector3::UnitX(), 30.0)).norm(), 1e-15);
  EXPECT_EQ(handles[2].matrix, scale(1, 1.5, 1));
  EXPECT_EQ(handles[3].matrix, Matrix4::Identity());
  EXPECT_EQ(handles[3].t, 0.2);
  EXPECT_TRUE(handlesOf("", frameAt).handles.empty());
  EXPECT_TRUE(handlesOf(" ; ;", frameAt).handles.empty());
  EXPECT_EQ(handlesOf("move 0 w -1e-3; move 0 w 2; pin 1", frameAt).handles.size(),
    3u); // several at one place
}

// A drag is of the curve as a whole: shares of handles sum up to 1, so what is added to each moves all alike.
TEST(Operations, ADragMovesAllOfTheCurve)
{
  const auto shiftOf = [](const Vector2& pixels) { return Vector3(0.01 * pixels[0], 0.01 * pixels[1], 0.0); };
  OperatedHandles dragged = handlesOf("drag 20 -30; move 0.2 n 0.1; drag 5 0; pin 0.8", frameAt, shiftOf);
  ASSERT_EQ(dragged.handles.size(), 2u);
  EXPECT_LT((dragged.shift - Vector3(0.25, -0.3, 0.0)).norm(), 1e-15);
  shiftAll(dragged.handles, dragged.shift, frameAt);
  ASSERT_EQ(dragged.handles.size(), 4u);
  EXPECT_EQ(dragged.handles[2].t, 0.2);
  EXPECT_EQ(dragged.handles[3].t, 0.8);
  for (const std::size_t i : { 2, 3 })
  {
    EXPECT_LT((dragged.handles[i].matrix - shift(0.25, -0.3, 0.0)).norm(), 1e-15);
  }
  std::vector<PlacedHandle> none;
  shiftAll(none, dragged.shift, frameAt);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].t, 0.5);
  expectRefused("drag 3 4", "Operation 1, \"drag 3 4\": the curve carries no view", "draw it");
  expectRefused("drag 3", "Operation 1, \"drag 3\": its way up is missing", "\"drag X Y\"");
  expectRefused("drag 3 4 5", "Operation 1", "\"5\" is too much");
}

TEST(Operations, AreWrittenAsTheyAreRead)
{
  const std::string text = "move 0.5 n 0.1; rotate 0.7 t 30; scale 0.3 w 1.5; pin 0.2; drag 12 -5";
  EXPECT_EQ(operationText(operationsOf(text)), text);
}

TEST(Operations, WhatIsNoneIsNamed)
{
  expectRefused(
    "move 0.5 n 0.1; turn 0.5 n 3", "Operation 2, \"turn 0.5 n 3\"", "write \"move T AXIS LENGTH\"");
  expectRefused("move", "Operation 1, \"move\": its place is missing", "with T from 0 to 1");
  expectRefused("move x n 1", "Operation 1, \"move x n 1\": its place is \"x\"", "with T from 0 to 1");
  expectRefused("move nan n 1", "Operation 1", "its place is \"nan\"");
  expectRefused("move 0.5 b 1", "Operation 1", "its axis is \"b\"; give t, along the curve, w");
  expectRefused("move 0.5 n", "Operation 1", "its amount is missing");
  expectRefused("move 0.5 n 1e", "Operation 1", "its amount is \"1e\"");
  expectRefused("move 0.5 n 1 2", "Operation 1", "\"2\" is too much");
  expectRefused("pin 0.5 n", "Operation 1", "\"n\" is too much");
  expectRefused("pin -1", "Operation 1, \"pin -1\"", "give one from 0, where the curve begins, to 1");
  expectRefused(";;pin 2", "Operation 3, \"pin 2\"", "give one from 0, where the curve begins, to 1");
  expectRefused("scale 0.5 n 0", "Operation 1, \"scale 0.5 n 0\"", "give a factor above 0");
  expectRefused("scale 0.5 n -1", "Operation 1", "give a factor above 0");
  expectRefused(
    "rotate 0.5 t 180", "Operation 1, \"rotate 0.5 t 180\"", "give less than 180 degrees either way");
  expectRefused("rotate 0.5 t -1e9", "Operation 1", "give less than 180 degrees either way");
  expectRefused("move 0.5 n inf", "Operation 1", "its amount is \"inf\"");
}

TEST(Operations, AMatrixOfTheFrameIsOneOfTheWorld)
{
  const Vector3 along = Vector3(1, 2, 3).normalized(), outward = along.cross(Vector3(0, 1, 0)).normalized();
  const CurveFrame frame{ { 4, -5, 6 }, along, outward.cross(along), outward };
  const Matrix4 frames = matrixOf(frame);
  for (const Matrix4& local :
    { turn({ 1, 1, 0 }, 40.0), scale(2, 1, 0.5), Matrix4(shift(1, 2, 3) * turn({ 0, 1, 1 }, 70.0)) })
  {
    EXPECT_LT((inWorld(frame, local) - frames * local * frames.inverse()).norm(), 1e-13);
  }
  EXPECT_EQ(inWorld(frame, Matrix4::Identity()), Matrix4::Identity());
  EXPECT_LT((inWorld(frame, shift(0, 0, 2)) - movedAlong(frame, HandleAxis::Outward, 2.0)).norm(), 1e-15);
  EXPECT_EQ((inWorld(frame, shift(0, 0, 2)).topLeftCorner<3, 3>()), Eigen::Matrix3d::Identity());
}

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
