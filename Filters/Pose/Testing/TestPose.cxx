// The system as a filter: what it promises of limbs, seams, bad hands, cancelling and what runs again. How a
// limb bends is the kernel's test's.
#include "Harness/copies.h"
#include "Harness/promises.h"
#include "Harness/shapes.h"
#include "Harness/shipped.h"
#include "Harness/strokes.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchPose.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

View front()
{
  return orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0);
}

struct Pose : testing::Test
{
  Pose()
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetBoneData(this->bone);
    this->filter->SetPoseData(this->pose);
  }

  vtkSmartPointer<vtkPolyData> mesh = toPolyData(capsule(0.25, 2.0, 48, 121));
  vtkSmartPointer<vtkPolyData> bone = toStroke(straight({ 400, 300 }, { 620, 300 }, 60), front());
  vtkSmartPointer<vtkPolyData> pose = toStroke(straight({ 400, 300 }, { 400, 520 }, 60), front());
  vtkNew<vtkOversketchPose> filter;
};

} // namespace

TEST_F(Pose, TheLimbMovesAndNothingElse)
{
  const auto kept = deepCopy(this->mesh);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  vtkPolyData* output = this->filter->GetOutput();
  vtkIdType moved = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Vector3 before, after;
    this->mesh->GetPoint(i, before.data());
    output->GetPoint(i, after.data());
    moved += before != after;
    EXPECT_TRUE(before == after || before[0] > 0.0);
    EXPECT_NEAR(before[2], after[2], 1e-9) << "depths stay";
  }
  EXPECT_GT(moved, output->GetNumberOfPoints() / 3);
  EXPECT_EQ(this->filter->GetFigure("moved"), moved);
  EXPECT_EQ(this->filter->GetFigure("folded_edges"), 0);
  EXPECT_EQ(this->filter->GetFigure("joints"), 1);
  EXPECT_NEAR(this->filter->GetFigure("bend"), 90.0, 0.01);
  EXPECT_EQ(std::string(this->filter->GetRemark()),
    "The bone takes 50 % of the model with it: begin it where the limb leaves the body, if that is not "
    "meant.");
  EXPECT_TRUE(identical(kept, this->mesh)) << "the input was touched";
  EXPECT_EQ(output->GetPolys()->GetMTime(), this->mesh->GetPolys()->GetMTime());
  vtkNew<vtkPolyData> hold, region;
  this->filter->GetHold(hold);
  this->filter->GetRegion(region);
  EXPECT_GT(hold->GetNumberOfPoints(), 20);
  EXPECT_NEAR(hold->GetPoint(0)[2], 0.25, 0.01) << "in front";
  EXPECT_GT(region->GetNumberOfPolys(), moved);
}

TEST_F(Pose, MaskedPointsStay)
{
  this->filter->Update();
  const auto free = deepCopy(this->filter->GetOutput());
  std::vector<double> mask(static_cast<std::size_t>(this->mesh->GetNumberOfPoints()), 0.0);
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    const double height = this->mesh->GetPoint(i)[1];
    mask[static_cast<std::size_t>(i)] = height > 0.1 ? 1.0 : height > 0.0 ? 0.25 : 0.0;
  }
  PutMask(mask, this->mesh);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  int held = 0;
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 before(this->mesh->GetPoint(i)), way = Vector3(free->GetPoint(i)) - before;
    const Vector3 after(this->filter->GetOutput()->GetPoint(i));
    const double one = mask[static_cast<std::size_t>(i)];
    EXPECT_LT((after - before - (1.0 - one) * way).norm(), 1e-6);
    EXPECT_TRUE(one < 1.0 || after == before);
    held += one == 1.0 && way.norm() > 0.01;
  }
  EXPECT_GT(held, 100);
  // Folds are those of what comes out: none where all stays.
  this->filter->SetPoseData(toStroke(straight({ 400, 300 }, { 200, 320 }, 60), front()));
  this->filter->Update();
  EXPECT_GT(this->filter->GetFigure("folded_edges"), 0);
  PutMask(std::vector<double>(mask.size(), 1.0), this->mesh);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetFigure("moved"), 0);
  EXPECT_EQ(this->filter->GetFigure("folded_edges"), 0);
}

TEST_F(Pose, WithoutACourseTheMeshGoesThrough)
{
  this->filter->SetPoseData(nullptr);
  this->filter->SetInputConnection(2, nullptr);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->filter->GetOutput()->GetPoints(), this->mesh->GetPoints());
  vtkNew<vtkPolyData> hold, region;
  this->filter->GetHold(hold);
  this->filter->GetRegion(region);
  EXPECT_GT(hold->GetNumberOfPoints(), 20);
  EXPECT_EQ(region->GetNumberOfPolys(), 0);
  this->filter->SetPoseData(this->bone); // as it lies
  this->filter->Update();
  EXPECT_EQ(largestMove(this->mesh, this->filter->GetOutput()), 0.0);
}

TEST_F(Pose, ThreadsChangeNothingAndWhatIsKnownIsKept)
{
  this->filter->Update();
  const auto first = deepCopy(this->filter->GetOutput());
  this->filter->SetSoftness(2.0);
  this->filter->Update();
  EXPECT_GT(largestMove(first, this->filter->GetOutput()), 0.01);
  EXPECT_EQ(this->filter->GetLimbCount(), 1);
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchPose> other;
    other->SetInputData(0, deepCopy(this->mesh));
    other->SetBoneData(this->bone);
    other->SetPoseData(this->pose);
    other->Update();
    EXPECT_TRUE(identical(first, other->GetOutput())) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(Pose, APreviewIsTheResultToTheBit)
{
  vtkNew<vtkPolyData> shown;
  ASSERT_TRUE(this->filter->PreviewPose(shown));
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
  this->filter->Update();
  EXPECT_TRUE(identical(shown, this->filter->GetOutput()));
  EXPECT_EQ(this->filter->GetLimbCount(), 1);
  vtkNew<vtkPolyData> hold;
  EXPECT_FALSE(this->filter->Preview(this->mesh, toStroke({ { 400, 300 } }, front()), hold));
  EXPECT_TRUE(this->filter->Preview(this->mesh, this->bone, hold));
  EXPECT_GT(hold->GetNumberOfPoints(), 20);
}

TEST_F(Pose, SeamsStayClosedAndNormalsTurn)
{
  const Mesh whole = capsule(0.25, 2.0, 48, 121);
  Mesh split;
  for (const Triangle& t : whole.triangles)
  {
    const int first = split.vertexCount();
    for (const int v : t)
    {
      split.points.push_back(whole.points[v]);
    }
    split.triangles.push_back({ first, first + 1, first + 2 });
  }
  const auto cut = toPolyData(split);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      normals->InsertNextTuple(facetNormal(whole, t).data());
    }
  }
  cut->GetPointData()->SetNormals(normals);
  this->filter->Update();
  vtkNew<vtkOversketchPose> other;
  other->SetInputData(0, cut);
  other->SetBoneData(this->bone);
  other->SetPoseData(this->pose);
  other->Update();
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 expected(this->filter->GetOutput()->GetPoint(whole.triangles[t][k]));
      EXPECT_LT((expected - Vector3(other->GetOutput()->GetPoint(3 * t + k))).norm(), 1e-9);
      if (whole.points[whole.triangles[t][k]][0] > 1.0) // turned by 90 degrees
      {
        const Vector3 before = facetNormal(whole, t);
        Vector3 after;
        other->GetOutput()->GetPointData()->GetNormals()->GetTuple(3 * t + k, after.data());
        EXPECT_GT(after.dot(Vector3(-before[1], before[0], before[2])), 0.98); // by the vertex normals' turn
      }
    }
  }
}

TEST_F(Pose, WhatFoldsOrTakesTheModelAlongIsSaid)
{
  this->filter->SetPoseData(toStroke(straight({ 400, 300 }, { 200, 320 }, 60), front()));
  this->filter->Update();
  EXPECT_GT(this->filter->GetFigure("folded_edges"), 0);
  EXPECT_NE(std::string(this->filter->GetRemark()).find("folds the model"), std::string::npos);
  this->filter->SetBoneData(toStroke(straight({ 300, 300 }, { 620, 300 }, 60), front()));
  this->filter->SetPoseData(this->bone);
  this->filter->Update();
  EXPECT_GT(this->filter->GetFigure("share"), 0.5);
  EXPECT_NE(std::string(this->filter->GetRemark()).find("of the model with it"), std::string::npos);
}

TEST_F(Pose, WhatOfABoneLiesBesideTheModelIsSaid)
{
  this->filter->SetBoneData(toStroke(straight({ 400, 300 }, { 850, 300 }, 60), front()));
  this->filter->Update();
  EXPECT_EQ(std::string(this->filter->GetRemark()).find("50 % of the bone lie beside the model"), 0u)
    << this->filter->GetRemark();
}

TEST_F(Pose, ABadHandIsToldWhatIsWrong)
{
  const auto bone = [this](const std::vector<Vector2>& samples)
  { this->filter->SetBoneData(toStroke(samples, front())); };
  bone(straight({ 20, 20 }, { 80, 20 }, 10));
  expectRefusal(this->filter, Failure::BadStroke, "beside the model");
  bone({ { 400, 300 }, { 403, 300 } });
  expectRefusal(this->filter, Failure::BadStroke, "The bone cannot be used: ");
  vtkNew<vtkPolyData> none;
  this->filter->SetBoneData(none);
  expectRefusal(this->filter, Failure::BadStroke, "no bone");
  this->filter->SetBoneData(toStrokes({ { straight({ 400, 300 }, { 620, 300 }, 9), front() },
    { straight({ 400, 310 }, { 620, 310 }, 9), front() } }));
  expectRefusal(this->filter, Failure::BadStroke, "exactly one polyline");
  this->filter->SetBoneData(this->bone);
  this->filter->SetPoseData(toStroke({ { 400, 300 }, { std::nan(""), 300 } }, front()));
  expectRefusal(this->filter, Failure::BadStroke, "The pose cannot be used: ");
  this->filter->SetPoseData(
    toStroke(straight({ 400, 300 }, { 400, 520 }, 60), orthographicView({ 1, 0, 0 }, { 0, 1, 0 }, 100.0)));
  expectRefusal(this->filter, Failure::BadStroke, "seen from its end");
  this->filter->SetPoseData(this->pose);
  this->filter->SetSoftness(std::nan(""));
  expectRefusal(this->filter, Failure::BadStroke, "Softness");
}

TEST_F(Pose, CancelLeavesNothing)
{
  expectCancel(this->filter);
  expectCancel(this->filter, 0.5);
  this->filter->Update();
  EXPECT_GT(this->filter->GetFigure("moved"), 100);
}

TEST_F(Pose, NothingInGivesNothingOut)
{
  vtkNew<vtkPolyData> none;
  this->filter->SetInputData(0, none);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
}
