// What a hand sees before the system has run: the section under the pen, the mesh under a drag.
#include "Harness/shipped.h"

#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchOutline.h"

#include "vtkCellArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPoints> copyOf(vtkPoints* points, int type)
{
  auto copy = vtkSmartPointer<vtkPoints>::New();
  copy->SetDataType(type);
  copy->DeepCopy(points);
  return copy;
}

Vector3 at(vtkPoints* points, vtkIdType i)
{
  Vector3 p;
  points->GetPoint(i, p.data());
  return p;
}

// The stroke's first samples, as the pen makes them.
vtkSmartPointer<vtkPolyData> begun(vtkPolyData* stroke, vtkIdType count)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->DeepCopy(stroke);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(stroke->GetPoint(i));
    lines->InsertCellPoint(i);
  }
  part->SetPoints(points);
  part->SetLines(lines);
  part->GetPointData()->Initialize();
  return part;
}

struct Preview : testing::Test
{
  Preview()
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokeData(this->stroke);
  }
  vtkSmartPointer<vtkPolyData> mesh = shippedModel("dog");
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_longer_leg");
  vtkNew<vtkOversketchOneStroke> filter;
};

} // namespace

TEST_F(Preview, TheSectionIsTheOneThatTheStrokeWillTake)
{
  vtkNew<vtkPolyData> section;
  auto* outline = vtkOversketchOutline::SafeDownCast(this->filter->GetStep("Outline"));
  Ear ear(this->filter);
  EXPECT_FALSE(this->filter->Preview(this->mesh, begun(this->stroke, 1), section));
  const vtkIdType traces = outline->GetTraceCount();
  EXPECT_EQ(traces, 1);
  vtkIdType grown = 0;
  for (vtkIdType n = 20; n <= this->stroke->GetNumberOfPoints(); n += 10)
  {
    ASSERT_TRUE(this->filter->Preview(this->mesh, begun(this->stroke, n), section)) << n;
    grown += section->GetNumberOfPoints() > 0;
  }
  EXPECT_GT(grown, 5);
  ASSERT_TRUE(this->filter->Preview(this->mesh, this->stroke, section));
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
  this->filter->Update();
  EXPECT_EQ(outline->GetTraceCount(), traces) << "the curves were made again";
  EXPECT_EQ(largestMove(section, this->filter->GetInnerOutput("Match")), 0.0);
  EXPECT_TRUE(ear.errors.empty());
  vtkNew<vtkOversketchOneStroke> other;
  other->SetInputData(0, this->mesh);
  other->SetStrokeData(this->stroke);
  other->Update();
  EXPECT_TRUE(identical(other->GetOutput(), this->filter->GetOutput()));
}

TEST_F(Preview, NothingToTakeHoldOfIsSilent)
{
  Ear ear(this->filter);
  vtkNew<vtkPolyData> section, empty;
  EXPECT_FALSE(this->filter->Preview(empty, this->stroke, section));
  EXPECT_FALSE(this->filter->Preview(this->mesh, empty, section));
  EXPECT_FALSE(this->filter->Preview(nullptr, this->stroke, section));
  ASSERT_TRUE(this->filter->Preview(this->mesh, this->stroke, section));
  EXPECT_FALSE(this->filter->Preview(this->mesh, begun(this->stroke, 2), section)); // too short
  EXPECT_EQ(section->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_TRUE(this->filter->Preview(this->mesh, this->stroke, section));
  this->filter->Update();
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
}

TEST_F(Preview, ADragIsTheDeformationOfMovedTargets)
{
  this->filter->SetRemeshToOff();
  const double translation[3] = { 0.07, -0.11, 0.03 };
  vtkPoints* none = nullptr;
  {
    Ear ear(this->filter);
    EXPECT_FALSE(this->filter->Drag(translation, none));
    EXPECT_EQ(ear.errors.size(), 1u);
  }
  this->filter->Update();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->filter->GetOutput());
  // Looking at another stroke on the new mesh leaves the drag as it is.
  vtkNew<vtkPolyData> section;
  vtkNew<vtkPolyData> result;
  result->ShallowCopy(this->filter->GetOutput());
  ASSERT_TRUE(this->filter->Preview(result, this->stroke, section));

  auto* step =
    vtkOversketchLaplacianDeform::SafeDownCast(this->filter->GetStep(this->filter->GetDeformationName()));
  vtkNew<vtkPolyData> handles;
  handles->DeepCopy(step->GetInputDataObject(1, 0));
  vtkDataArray* targets = handles->GetPointData()->GetArray("Target");
  vtkDataArray* ratios = handles->GetPointData()->GetArray("MergeRatio");
  for (vtkIdType i = 0; i < targets->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      targets->SetComponent(i, k, targets->GetComponent(i, k) + ratios->GetComponent(i, 0) * translation[k]);
    }
  }
  vtkNew<vtkOversketchLaplacianDeform> moved;
  moved->SetHandleWeight(step->GetHandleWeight());
  moved->SetInputDataObject(0, step->GetInputDataObject(0, 0));
  moved->SetInputData(1, handles);
  moved->Update();
  ASSERT_EQ(moved->GetErrorCode(), 0u);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    auto points = copyOf(this->filter->GetOutput()->GetPoints(), type);
    ASSERT_TRUE(this->filter->Drag(translation, points));
    double worst = 0.0, most = 0.0;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst, (at(points, i) - at(moved->GetOutput()->GetPoints(), i)).norm());
      most = std::max(most, (at(points, i) - at(before->GetPoints(), i)).norm());
    }
    EXPECT_LT(worst, 1e-6 * this->mesh->GetLength()); // the mesh's points are float
    EXPECT_GT(most, 0.8 * std::hypot(translation[0], translation[1], translation[2]));
  }
  EXPECT_TRUE(identical(before, this->filter->GetOutput())) << "a preview changed the output";
}

TEST_F(Preview, RemeshedPointsFollowTheTrianglesTheyLieOn)
{
  this->filter->SetRemeshToOn();
  this->filter->Update();
  ASSERT_TRUE(this->filter->GetRemeshed());
  vtkPoints* rest = this->filter->GetOutput()->GetPoints();
  auto* step =
    vtkOversketchLaplacianDeform::SafeDownCast(this->filter->GetStep(this->filter->GetDeformationName()));
  vtkPoints* stepRest = step->GetOutput()->GetPoints();
  const double translation[3] = { 0.05, -0.1, 0.0 }, none[3] = { 0.0, 0.0, 0.0 };
  auto points = copyOf(rest, VTK_DOUBLE), stepPoints = copyOf(stepRest, VTK_DOUBLE);
  ASSERT_TRUE(this->filter->Drag(translation, points));
  ASSERT_TRUE(step->Drag(translation, stepPoints));
  // Points that the remesher left in place are vertices of the deformation: they go where those go.
  std::map<std::array<double, 3>, vtkIdType> places;
  for (vtkIdType i = 0; i < stepRest->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = at(stepRest, i);
    places[{ p[0], p[1], p[2] }] = i;
  }
  vtkIdType shared = 0, moving = 0;
  double worst = 0.0, largest = 0.0;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = at(rest, i), move = at(points, i) - p;
    largest = std::max(largest, move.norm());
    moving += move.norm() > 0.01;
    const auto found = places.find({ p[0], p[1], p[2] });
    if (found != places.end())
    {
      ++shared;
      worst = std::max(worst, (move - (at(stepPoints, found->second) - at(stepRest, found->second))).norm());
    }
  }
  EXPECT_GT(shared, rest->GetNumberOfPoints() / 2);
  EXPECT_GT(moving, 100);
  EXPECT_LT(worst, 1e-6);
  const double length = std::hypot(translation[0], translation[1]);
  EXPECT_GT(largest, 0.8 * length);
  EXPECT_LT(largest, 1.5 * length);
  ASSERT_TRUE(this->filter->Drag(none, points));
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(at(points, i), at(rest, i)) << i;
  }
  // Points of another mesh are refused.
  points->SetNumberOfPoints(7);
  Ear ear(this->filter);
  EXPECT_FALSE(this->filter->Drag(translation, points));
  EXPECT_EQ(ear.errors.size(), 1u);
}

TEST_F(Preview, ReleasedWorkIsMadeAnewByTheNextRunAlone)
{
  const double translation[3] = { 0.05, -0.1, 0.0 };
  for (const int remesh : { vtkOversketchOneStroke::RemeshOff, vtkOversketchOneStroke::RemeshOn })
  {
    this->filter->SetRemesh(remesh);
    this->filter->Update();
    vtkNew<vtkPolyData> made, hold, region;
    made->DeepCopy(this->filter->GetOutput());
    const auto dragged = [&]
    {
      auto points = copyOf(made->GetPoints(), VTK_DOUBLE);
      EXPECT_TRUE(this->filter->Drag(translation, points));
      return points;
    };
    const auto before = dragged();
    this->filter->ReleaseWork();
    EXPECT_TRUE(identical(made, this->filter->GetOutput())) << "the output stays";
    this->filter->GetHold(hold);
    this->filter->GetRegion(region);
    EXPECT_EQ(hold->GetNumberOfPoints(), 0);
    EXPECT_EQ(region->GetNumberOfPoints(), 0);
    {
      Ear ear(this->filter);
      EXPECT_FALSE(this->filter->Drag(translation, copyOf(made->GetPoints(), VTK_DOUBLE)));
      EXPECT_EQ(ear.errors.size(), 1u);
    }
    this->filter->Update();
    EXPECT_TRUE(identical(made, this->filter->GetOutput()));
    this->filter->GetHold(hold);
    this->filter->GetRegion(region);
    EXPECT_GT(hold->GetNumberOfPoints(), 0);
    EXPECT_GT(region->GetNumberOfPoints(), 0);
    const auto after = dragged();
    for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(at(before, i), at(after, i)) << i;
    }
  }
}

TEST_F(Preview, PointsOfOnePlaceStayTogether)
{
  // Every corner a point of its own.
  vtkNew<vtkPolyData> split;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < this->mesh->GetNumberOfPolys(); ++t)
  {
    this->mesh->GetCellPoints(t, ids);
    triangles->InsertNextCell(3);
    for (int k = 0; k < 3; ++k)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(this->mesh->GetPoint(ids->GetId(k))));
    }
  }
  split->SetPoints(points);
  split->SetPolys(triangles);
  this->filter->SetInputData(0, split);
  for (const int remesh : { vtkOversketchOneStroke::RemeshOff, vtkOversketchOneStroke::RemeshOn })
  {
    this->filter->SetRemesh(remesh);
    this->filter->Update();
    ASSERT_EQ(this->filter->GetErrorCode(), 0u);
    vtkPoints* rest = this->filter->GetOutput()->GetPoints();
    auto dragged = copyOf(rest, VTK_DOUBLE);
    const double translation[3] = { 0.05, -0.1, 0.02 };
    ASSERT_TRUE(this->filter->Drag(translation, dragged));
    std::map<std::array<double, 3>, Vector3> moves;
    double apart = 0.0;
    for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = at(rest, i), move = at(dragged, i) - p;
      const auto known = moves.emplace(std::array<double, 3>{ p[0], p[1], p[2] }, move);
      apart = std::max(apart, (known.first->second - move).norm());
    }
    EXPECT_LT(apart, 1e-12);
  }
}
