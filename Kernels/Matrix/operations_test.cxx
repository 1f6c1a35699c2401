#include "Matrix/operations.h"

#include "Harness/shapes.h"
#include "Matrix/transformations.h"
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
  const auto handles = handlesOf("move 0.5 n 0.1; rotate 0.7 t 30;\n scale 0.3 w 1.5 ; pin 0.2;", frameAt);
  ASSERT_EQ(handles.size(), 4u);
  EXPECT_EQ(handles[0].t, 0.5);
  EXPECT_EQ(handles[0].matrix, shift(0, 0, 0.1));
  EXPECT_EQ(handles[1].frame.origin, Vector3(0.7, 0, 0));
  EXPECT_LT((handles[1].matrix - turn(Vector3::UnitX(), 30.0)).norm(), 1e-15);
  EXPECT_EQ(handles[2].matrix, scale(1, 1.5, 1));
  EXPECT_EQ(handles[3].matrix, Matrix4::Identity());
  EXPECT_EQ(handles[3].t, 0.2);
  EXPECT_TRUE(handlesOf("", frameAt).empty());
  EXPECT_TRUE(handlesOf(" ; ;", frameAt).empty());
  EXPECT_EQ(handlesOf("move 0 w -1e-3; move 0 w 2; pin 1", frameAt).size(), 3u); // several at one place
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
