#include "vtkOversketchCarriedArrays.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

bool mixable(const char* name, int type, int components = 1)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return oversketch::IsMixable(array);
}

} // namespace

TEST(Mixable, MeasuresAndColoursAre)
{
  EXPECT_TRUE(mixable("RegionId", VTK_DOUBLE));
  EXPECT_TRUE(mixable("RGB", VTK_UNSIGNED_CHAR, 3));
  EXPECT_TRUE(mixable("Colour of the region", VTK_UNSIGNED_SHORT, 4));
  EXPECT_TRUE(mixable("intensity", VTK_UNSIGNED_CHAR));
  EXPECT_TRUE(mixable("Identity", VTK_SHORT)) << "no word of it is id";
  EXPECT_TRUE(mixable("width", VTK_INT));
  EXPECT_TRUE(mixable(nullptr, VTK_UNSIGNED_INT));
}

TEST(Mixable, IdsAndLabelsAreNot)
{
  for (const char* name :
    { "RegionId", "id", "ids", "PART_ID", "point_labels", "material", "Classes", "group2", "vertexIndices" })
  {
    EXPECT_FALSE(mixable(name, VTK_INT)) << name;
    EXPECT_FALSE(mixable(name, VTK_UNSIGNED_CHAR)) << name;
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Original");
  vtkNew<vtkBitArray> bits;
  bits->SetName("Heat");
  vtkNew<vtkStringArray> words;
  EXPECT_FALSE(oversketch::IsMixable(ids));
  EXPECT_FALSE(oversketch::IsMixable(bits));
  EXPECT_FALSE(oversketch::IsMixable(words));
  EXPECT_FALSE(oversketch::IsMixable(nullptr));
}

TEST(CarriedArrays, PointsAreTakenOrMixed)
{
  vtkNew<vtkIntArray> measure, label;
  vtkNew<vtkFloatArray> normals;
  measure->SetName("width");
  measure->SetNumberOfComponents(2);
  measure->SetComponentName(1, "deep");
  label->SetName("RegionId");
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 3; ++i)
  {
    measure->InsertNextTuple2(10 * i, -7 * i);
    label->InsertNextValue(i);
    normals->InsertNextTuple3(i == 0, i == 1, i == 2);
  }
  const std::vector<int> sources{ 1, 2, -1 };
  const oversketch::Mix mix{ { 0, 0.25 }, { 1, 0.75 } };
  const oversketch::CarriedPoints carried{ sources,
    [&mix](vtkIdType) -> const oversketch::Mix& { return mix; } };
  const vtkSmartPointer<vtkIntArray> mixed = vtkIntArray::SafeDownCast(carried.Array(measure, false));
  EXPECT_STREQ(mixed->GetName(), "width");
  EXPECT_STREQ(mixed->GetComponentName(1), "deep");
  EXPECT_EQ(mixed->GetTypedComponent(1, 0), 20);
  EXPECT_EQ(mixed->GetTypedComponent(2, 0), 8) << "7.5 is rounded";
  EXPECT_EQ(mixed->GetTypedComponent(2, 1), -5) << "-5.25 is rounded";
  EXPECT_EQ(vtkIntArray::SafeDownCast(carried.Array(label, false))->GetValue(2), 1);
  const vtkSmartPointer<vtkFloatArray> turned = vtkFloatArray::SafeDownCast(carried.Array(normals, true));
  EXPECT_NEAR(turned->GetTypedComponent(2, 1), 3.0 / std::sqrt(10.0), 1e-6);
}

TEST(CarriedArrays, PartsAreKeptAndGlobalIdsAreNot)
{
  vtkNew<vtkPointData> from, to;
  vtkNew<vtkIntArray> ids, heat, other;
  ids->SetName("Ids");
  heat->SetName("Heat");
  other->SetName("Other");
  from->SetGlobalIds(ids);
  from->SetScalars(heat);
  from->AddArray(other);
  oversketch::CarryArrays(from,
    to,
    [&](vtkAbstractArray* array, bool) -> vtkSmartPointer<vtkAbstractArray>
    { return oversketch::IsNamed(array, "Other") ? nullptr : array; });
  EXPECT_EQ(to->GetNumberOfArrays(), 1);
  EXPECT_EQ(to->GetScalars(), heat);
}

TEST(CarriedArrays, WhatStandsIsMadeOnce)
{
  oversketch::KeptArrays kept;
  vtkNew<vtkIntArray> array;
  int made = 0;
  const auto run = [&](int use)
  {
    const auto result = kept.Provide(array,
      use,
      [&]
      {
        ++made;
        return oversketch::LikeArray<vtkAbstractArray>(array, 2);
      });
    kept.EndRun();
    return result;
  };
  const auto first = run(1);
  EXPECT_EQ(run(1), first);
  EXPECT_EQ(made, 1);
  run(2);
  run(1);
  EXPECT_EQ(made, 3) << "what a run did not ask for is forgotten";
  array->Modified();
  run(1);
  EXPECT_EQ(made, 4);
}
