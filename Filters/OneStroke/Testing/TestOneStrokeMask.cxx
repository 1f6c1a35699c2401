// The mask that a mesh carries under a stroke: masked points stay, the rest follows.
#include "Harness/promises.h"
#include "Harness/shipped.h"

#include "Mesh/context.h"
#include "vtkOversketchOneStroke.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Place = std::array<double, 3>;

Place placeAt(vtkPolyData* mesh, vtkIdType i)
{
  Place place;
  mesh->GetPoint(i, place.data());
  return place;
}

struct MaskedLeg : testing::Test
{
  MaskedLeg()
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokeData(shippedStroke("dog_longer_leg"));
    this->filter->SetRemeshToOff();
    this->filter->Update();
    this->free->DeepCopy(this->filter->GetOutput());
    this->mask->SetName("Mask");
    this->mask->SetNumberOfValues(this->mesh->GetNumberOfPoints());
    this->mask->Fill(0.0);
    this->mesh->GetPointData()->AddArray(this->mask);
  }
  // Masks the upper half of what the stroke moves where nothing is masked.
  void maskUpperHalf()
  {
    std::vector<double> heights;
    for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
    {
      if (placeAt(this->mesh, i) != placeAt(this->free, i))
      {
        heights.push_back(this->mesh->GetPoint(i)[1]);
      }
    }
    std::sort(heights.begin(), heights.end());
    for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
    {
      this->mask->SetValue(i, this->mesh->GetPoint(i)[1] > heights[heights.size() / 2] ? 1.0f : 0.0f);
    }
    this->mask->Modified();
    this->filter->Modified();
  }

  vtkSmartPointer<vtkPolyData> mesh = shippedModel("dog");
  vtkNew<vtkFloatArray> mask;
  vtkNew<vtkPolyData> free;
  vtkNew<vtkOversketchOneStroke> filter;
};

} // namespace

TEST_F(MaskedLeg, AMaskOfNothingChangesNoBit)
{
  this->filter->Modified();
  this->filter->Update();
  vtkNew<vtkPolyData> made;
  made->DeepCopy(this->filter->GetOutput());
  made->GetPointData()->RemoveArray("Mask");
  EXPECT_TRUE(identical(this->free, made));
}

TEST_F(MaskedLeg, MaskedPointsStayToTheBitAndTheRestFollows)
{
  this->maskUpperHalf();
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  int moved = 0;
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    const bool stays = placeAt(this->mesh, i) == placeAt(this->filter->GetOutput(), i);
    EXPECT_TRUE(stays || this->mask->GetValue(i) == 0.0f) << i;
    moved += !stays;
  }
  EXPECT_GT(moved, 50);
}

TEST_F(MaskedLeg, RemeshingLeavesMaskedPointsAlone)
{
  this->maskUpperHalf();
  this->filter->SetRemeshToOn();
  this->filter->SetAllowTorn(true);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  vtkPolyData* output = this->filter->GetOutput();
  auto* carried = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("Mask"));
  ASSERT_NE(carried, nullptr);
  std::multiset<Place> before, after;
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    if (this->mask->GetValue(i) == 1.0f)
    {
      before.insert(placeAt(this->mesh, i));
    }
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (carried->GetValue(i) == 1.0f)
    {
      after.insert(placeAt(output, i));
    }
  }
  EXPECT_EQ(before, after);
}

TEST_F(MaskedLeg, WhatIsMaskedAsAWholeIsRefused)
{
  this->mask->Fill(1.0);
  this->mask->Modified();
  this->filter->Modified();
  expectRefusal(this->filter, Failure::BadRegion, "masked");
}
