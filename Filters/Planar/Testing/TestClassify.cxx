#include "CurveShapes.h"
#include "vtkOversketchClassify.h"

#include "vtkImageShiftScale.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

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
  vtkImageData* labels = filter->GetLabelsOutput();
  EXPECT_EQ(labels->GetDimensions()[0], 1028);
  EXPECT_EQ(labels->GetPointData()->GetScalars()->GetRange()[0], -5.0);
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
