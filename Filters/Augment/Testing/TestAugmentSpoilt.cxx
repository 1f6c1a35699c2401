// Saved 4-8 meshes that something has spoilt, under the augmentation system: said by name, whatever is made
// of them.
#include "AugmentTools.h"
#include "Harness/spoilt.h"
#include "Hostile/sound.h"

#include "vtkOversketchStellarBase.h"

#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// What a mesh becomes under a second stroke.
struct Second
{
  Second(const System& first, vtkPolyData* mesh)
  {
    this->filter->SetInputData(0, mesh);
    this->filter->SetStrokesData(strokesOf({ vein(80, 20) }, first.view));
    Ear ear(this->filter);
    this->filter->Update();
    this->errors = ear.errors;
    this->warnings = ear.warnings;
  }
  vtkIdType bases() const
  {
    return vtkOversketchStellarBase::SafeDownCast(this->filter->GetStep("Base"))->GetBaseCount();
  }

  vtkNew<vtkOversketchAugment> filter;
  std::vector<std::string> errors, warnings;
};

} // namespace

TEST(AugmentSpoilt, ANewBaseIsMadeAndSaidOrTheMeshRefused)
{
  System first(shippedModel("bear"));
  first.run();
  const Second whole(first, deepCopy(first.filter->GetOutput()));
  ASSERT_TRUE(whole.errors.empty() && whole.warnings.empty());
  ASSERT_EQ(whole.bases(), 0);
  int refused = 0, made = 0;
  for (const Spoilt& way : spoiltWays())
  {
    SCOPED_TRACE(way.words);
    const auto mesh = deepCopy(first.filter->GetOutput());
    if (*way.needs && !mesh->GetPointData()->GetArray(way.needs))
    {
      continue;
    }
    way.spoil(mesh);
    const Second second(first, mesh);
    ASSERT_EQ(second.warnings.size(), 1u);
    EXPECT_NE(second.warnings[0].find(way.words), std::string::npos) << second.warnings[0];
    EXPECT_NE(second.warnings[0].find("new base"), std::string::npos) << second.warnings[0];
    if (second.errors.empty())
    {
      ++made;
      EXPECT_EQ(second.bases(), 1);
      expectForest(second.filter->GetOutput());
      EXPECT_GT(second.filter->GetOutput()->GetNumberOfPolys(), 0);
      continue;
    }
    // Points that were merged may leave no manifold; its defects are counted.
    ++refused;
    ASSERT_EQ(second.errors.size(), 1u);
    EXPECT_EQ(second.filter->GetErrorCode(), codeOf(Failure::BadMesh)) << second.errors[0];
    EXPECT_NE(second.errors[0].find_first_of("0123456789"), std::string::npos) << second.errors[0];
    EXPECT_EQ(second.filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  EXPECT_GT(made, 12);
  EXPECT_LE(refused, 1);
}

TEST(AugmentSpoilt, PointsThatWereSplitAreWeldedAndOthersThatAreNoneRefused)
{
  System first(shippedModel("bear"));
  first.run();
  const Second whole(first, deepCopy(first.filter->GetOutput()));
  const auto split = deepCopy(first.filter->GetOutput());
  splitFirstCell(split);
  const Second second(first, split);
  EXPECT_TRUE(second.errors.empty() && second.warnings.empty());
  EXPECT_EQ(second.bases(), 0);
  EXPECT_EQ(second.filter->GetOutput()->GetNumberOfPolys(), whole.filter->GetOutput()->GetNumberOfPolys());
  const auto broken = deepCopy(first.filter->GetOutput());
  broken->GetPoints()->SetPoint(3, 0.0, std::nan(""), 0.0);
  const Second third(first, broken);
  ASSERT_EQ(third.errors.size(), 1u);
  EXPECT_NE(third.errors[0].find("Point 3"), std::string::npos) << third.errors[0];
  EXPECT_EQ(third.filter->GetOutput()->GetNumberOfPoints(), 0);
}

// A mesh that was saved between snapping and rising knows its curves, and those alone go on from it.
TEST(AugmentSpoilt, AMeshInTheMidstOfAnotherStrokeIsRefusedByName)
{
  System first(shippedModel("bear"));
  first.run();
  vtkPolyData* snapped = first.filter->GetInnerOutput("Snap");
  vtkDataArray* curve = snapped->GetPointData()->GetArray("CurveId");
  ASSERT_TRUE(curve && snapped->GetFieldData()->GetArray("CurveDigest"));
  vtkIdType on = 0;
  while (curve->GetComponent(on, 0) < 0.0)
  {
    ++on;
  }
  const auto refuse = [&](const std::function<void(vtkPolyData*)>& spoil, Failure failure, const char* words)
  {
    const auto mesh = deepCopy(snapped);
    spoil(mesh);
    vtkNew<vtkOversketchAugment> filter;
    filter->SetInputData(0, mesh);
    filter->SetStrokesData(first.strokes);
    expectRefusal(filter, failure, words);
  };
  const auto asSaved = [](vtkPolyData*) {};
  {
    const Second other(first, deepCopy(snapped));
    ASSERT_EQ(other.errors.size(), 1u);
    EXPECT_EQ(other.filter->GetErrorCode(), codeOf(Failure::BadStroke));
    EXPECT_NE(other.errors[0].find("CurveDigest"), std::string::npos) << other.errors[0];
  }
  refuse(asSaved, Failure::BadStroke, "CurveDigest"); // its curve lies on the base, and this mesh is another
  refuse(
    [](vtkPolyData* m)
    {
      auto* digest = vtkTypeUInt64Array::SafeDownCast(m->GetFieldData()->GetArray("CurveDigest"));
      digest->SetValue(0, digest->GetValue(0) ^ 1u);
    },
    Failure::BadStroke,
    "CurveDigest");
  refuse([](vtkPolyData* m) { m->GetFieldData()->RemoveArray("CurveDigest"); },
    Failure::MissingArray,
    "CurveDigest");
  refuse(
    [on](vtkPolyData* m)
    {
      vtkDataArray* at = m->GetPointData()->GetArray("CurveParam");
      at->SetComponent(on, 0, at->GetComponent(on, 0) + 1.0);
    },
    Failure::BadStroke,
    "CurveDigest");
}
