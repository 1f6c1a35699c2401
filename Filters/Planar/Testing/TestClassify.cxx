#include "CurveShapes.h"
#include "vtkOversketchClassify.h"

#include "vtkImageShiftScale.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Polyline spiral()
{
  Polyline points;
  for (int i = 0; i <= 600; ++i)
  {
    const double angle = 0.05 * i, radius = 30.0 + 0.5 * i;
    points.emplace_back(500.0 + radius * std::cos(angle), 500.0 + radius * std::sin(angle));
  }
  return points;
}

Polyline figureOfEight()
{
  Polyline points;
  for (int i = 0; i < 200; ++i)
  {
    const double angle = turn * (i + 0.3) / 200;
    points.emplace_back(500.0 + 300.0 * std::sin(angle), 500.0 + 200.0 * std::sin(2.0 * angle));
  }
  return points;
}

} // namespace

TEST(ClassifyFilter, RolesRegionsObjectsAndTheRasterOfTheSixthFigure)
{
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(toCurves(bodyWithFeatures()));
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  vtkPolyData* curves = filter->GetOutput();
  EXPECT_EQ(cellValues(curves, "Role"), (std::vector<int>{ 1, 2, 3, 3, 2 }));
  EXPECT_EQ(cellValues(curves, "RegionId"), (std::vector<int>{ 0, 0, 1, 0, 0 }));
  EXPECT_EQ(cellValues(curves, "ChildRegionId"), (std::vector<int>{ -1, 1, -1, -1, 2 }));
  EXPECT_EQ(cellValues(curves, "ObjectId"), (std::vector<int>{ 0, 0, 0, 0, 0 }));
  EXPECT_EQ(curves->GetFieldData()->GetArray("Resolution")->GetComponent(0, 0), 1024.0);
  EXPECT_TRUE(curves->GetPointData()->HasArray("ArcLength"));
  // The raster: outside, the rest of the body, and the strokes where they are drawn.
  vtkImageData* labels = filter->GetLabelsOutput();
  ASSERT_EQ(labels->GetDimensions()[0], 1028);
  EXPECT_EQ(labels->GetSpacing()[0], 1.0);
  EXPECT_EQ(labels->GetOrigin()[0], -1.5);
  const auto at = [&](double x, double y)
  {
    double place[3] = { x, y, 0.0 };
    return labels->GetPointData()->GetScalars()->GetComponent(labels->FindPoint(place), 0);
  };
  EXPECT_EQ(at(5, 5), 0.0);
  EXPECT_GT(at(500, 850), 0.0);
  EXPECT_EQ(at(500, 850), at(620, 500)) << "one area round all features";
  EXPECT_NE(at(700, 650), at(500, 850));
  EXPECT_EQ(at(350, 520), -3.0);
  int onBody = 0;
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
    if (labels->GetPointData()->GetScalars()->GetComponent(i, 0) == -1.0)
    {
      ++onBody;
      EXPECT_NEAR((Vector2(labels->GetPoint(i)) - Vector2(500, 500)).norm(), 400.0, 1.0);
    }
  EXPECT_GT(onBody, 2200) << "8-connected, 2263 px round";
}

TEST(ClassifyFilter, AnImageFilterTakesTheLabels)
{
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(toCurves(bodyWithFeatures()));
  vtkNew<vtkImageShiftScale> shift;
  shift->SetInputConnection(filter->GetOutputPort(1));
  shift->SetShift(10.0);
  for (const int resolution : { 1024, 100, 512 })
  {
    filter->SetResolution(resolution);
    shift->Update();
    EXPECT_EQ(shift->GetOutput()->GetDimensions()[0], resolution + 4);
    EXPECT_EQ(shift->GetOutput()->GetScalarRange()[0], 5.0);
    shift->Modified();
    shift->Update();
  }
  EXPECT_EQ(filter->GetClassificationCount(), 3);
  filter->SetInputData(toCurves(bodyWithFeatures(), { Vector2(0, 0), Vector2(2048, 1024) }));
  shift->Update();
  EXPECT_EQ(shift->GetOutput()->GetDimensions()[1], 256 + 4);
  EXPECT_EQ(filter->GetClassificationCount(), 4);
}

TEST(ClassifyFilter, WhatIsNotReadClassifiesNothingAnew)
{
  const auto curves = toCurves(bodyWithFeatures());
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(curves);
  filter->Update();
  vtkDataArray* const roles = filter->GetOutput()->GetCellData()->GetArray("Role");
  vtkDataArray* const labels = filter->GetLabelsOutput()->GetPointData()->GetScalars();
  vtkNew<vtkIntArray> treatment;
  treatment->SetName("Treatment");
  treatment->SetNumberOfTuples(5);
  treatment->Fill(1);
  curves->GetCellData()->AddArray(treatment);
  curves->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetClassificationCount(), 1);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Role"), roles);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Treatment"), treatment);
  EXPECT_EQ(filter->GetLabelsOutput()->GetPointData()->GetScalars(), labels);
  filter->SetContactShare(0.1);
  filter->Update();
  EXPECT_EQ(filter->GetClassificationCount(), 2);
}

TEST(ClassifyFilter, WhatNoDrawingNeedsIsRejectedInOneWarningEach)
{
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(toCurves({ closedStroke(ringAt(500, 500, 300)),
    openStroke({ { 5, 5 } }),
    openStroke({ { 9, 9 }, { 9, 9 } }),
    closedStroke(ringAt(1000, 1000, 60)),
    closedStroke(ringAt(900, 100, 1)),
    openStroke({ { 850, 200 }, { 900, 210 } }),
    openStroke({ { 480, 480 }, { 520, 520 } }) }));
  Ear ear(filter);
  for (std::size_t run = 1; run <= 2; ++run)
  {
    filter->Update();
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    ASSERT_EQ(ear.warnings.size(), 5 * run) << "said whenever it executes, kept or not";
    filter->Modified();
  }
  EXPECT_EQ(filter->GetClassificationCount(), 1);
  const char* const words[] = { "Stroke 1 has too few distinct points; draw a longer one.",
    "Stroke 2 has too few distinct points",
    "Stroke 3 leaves the canvas; draw it inside.",
    "Stroke 4 is closed round less than 9 px",
    "Stroke 5 is open and in no closed stroke" };
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NE(ear.warnings[i].find(words[i]), std::string::npos) << ear.warnings[i];
  EXPECT_EQ(cellValues(filter->GetOutput(), "Role"), (std::vector<int>{ 1, -1, -1, -1, -1, -1, 3 }));
  EXPECT_EQ(cellValues(filter->GetOutput(), "ObjectId"), (std::vector<int>{ 0, -1, -1, -1, -1, -1, 0 }));
}

TEST(ClassifyFilter, StrokesThatMeetAreNamedInOneError)
{
  const DrawnStroke body = closedStroke(ringAt(500, 500, 400));
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(toCurves({ body, closedStroke(figureOfEight()) }));
  expectRefusal(filter, Failure::BadStroke, "Stroke 1 crosses itself near (50");
  filter->SetInputData(toCurves({ body, body }));
  expectRefusal(filter, Failure::BadStroke, "Stroke 0 crosses stroke 1");
  filter->Modified();
  expectRefusal(filter, Failure::BadStroke, "Stroke 1 crosses stroke 0");
  // A T: the end of one lies on the other.
  filter->SetInputData(toCurves(
    { body, openStroke({ { 300, 500 }, { 700, 500 } }), openStroke({ { 500, 500 }, { 500, 700 } }) }));
  expectRefusal(filter, Failure::BadStroke, "Stroke 2 crosses stroke 1 near (500, 500)");
  EXPECT_EQ(filter->GetLabelsOutput()->GetNumberOfPoints(), 0);
  // A spiral that does not meet itself is an open stroke like others.
  filter->SetInputData(toCurves({ body, openStroke(spiral()) }));
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(cellValues(filter->GetOutput(), "Role"), (std::vector<int>{ 1, 3 }));
}

TEST(ClassifyFilter, AsPublishedEveryAreaCounts)
{
  // Two discs whose bridge, 0.8 px wide, merges in the raster.
  Polyline dumbbell;
  const double opening = std::asin(0.4 / 150.0);
  for (const double side : { 0.0, 0.5 })
    for (int i = 0; i <= 180; ++i)
    {
      const double angle = side * turn + opening + (turn - 2.0 * opening) * i / 180;
      dumbbell.emplace_back(
        (side > 0.0 ? 750.0 : 250.0) + 150.0 * std::cos(angle), 500.0 + 150.0 * std::sin(angle));
    }
  vtkNew<vtkOversketchClassify> filter;
  filter->SetInputData(toCurves({ closedStroke(dumbbell) }));
  filter->Update();
  EXPECT_EQ(cellValues(filter->GetOutput(), "Role"), (std::vector<int>{ 1 }));
  filter->AsPublishedOn();
  expectRefusal(filter, Failure::BadStroke, "Stroke 0 touches 3 areas");
  filter->AsPublishedOff();
  filter->SetContactShare(0.0);
  expectRefusal(filter, Failure::BadStroke, "Stroke 0 touches 3 areas");
}

TEST(ClassifyFilter, TinyFarAndOblongCanvases)
{
  for (const double scale : { 1e-9, 1.0, 1e6 })
  {
    for (const Vector2& corner : { Vector2(0.0, 0.0), Vector2(5e6 * scale, -5e6 * scale) })
    {
      std::vector<DrawnStroke> strokes = bodyWithFeatures();
      for (DrawnStroke& stroke : strokes)
        for (Vector2& p : stroke.points)
          p = corner + scale * p;
      vtkNew<vtkOversketchClassify> filter;
      filter->SetInputData(toCurves(strokes, { corner, scale * Vector2(1024.0, 930.0) }));
      filter->Update();
      EXPECT_EQ(cellValues(filter->GetOutput(), "Role"), (std::vector<int>{ 1, 2, 3, 3, 2 })) << scale;
      EXPECT_EQ(filter->GetLabelsOutput()->GetDimensions()[1], 934);
    }
  }
}

TEST(ClassifyFilter, OneAndTwoThreadsGiveTheSameBits)
{
  std::vector<int> first;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchClassify> filter;
    filter->SetInputData(toCurves(bodyWithFeatures()));
    filter->Update();
    auto* labels = vtkIntArray::SafeDownCast(filter->GetLabelsOutput()->GetPointData()->GetScalars());
    const std::vector<int> values(labels->Begin(), labels->End());
    if (threads == 1)
      first = values;
    EXPECT_EQ(values, first);
  }
  vtkSMPTools::Initialize();
}

TEST(ClassifyFilter, RefusesAndCancels)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkOversketchClassify> filter;
  const auto bare = toCurves(bodyWithFeatures());
  bare->GetFieldData()->RemoveArray("Canvas");
  filter->SetInputData(bare);
  expectRefusal(filter, Failure::MissingArray, "take them from vtkOversketchCanvas");
  filter->SetInputData(toCurves({ openStroke({ { 5, 5 }, { nan, 6 } }) }));
  expectRefusal(filter, Failure::BadStroke, "Stroke 0 cannot be used: sample 1 is not finite");
  const auto mesh = toPolyData(icosphere(1));
  WriteCanvas({ Vector2::Zero(), Vector2::Ones() }, mesh);
  filter->SetInputData(mesh);
  expectRefusal(filter, Failure::BadStroke, "polylines and no other cells");
  filter->SetInputData(toCurves(bodyWithFeatures(), { Vector2::Zero(), Vector2(1024.0, nan) }));
  expectRefusal(filter, Failure::BadStroke, "Canvas has no extent or is not finite");
  filter->SetInputData(toCurves(bodyWithFeatures()));
  expectCancel(filter, 0.4);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 5);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetLabelsOutput()->GetNumberOfPoints(), 0);
}
