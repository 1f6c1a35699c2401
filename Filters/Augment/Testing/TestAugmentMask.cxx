// The mask that a mesh carries under strokes that raise it: masked points stay, and what is split between
// them stays where it was.
#include "AugmentTools.h"
#include "Harness/promises.h"

#include "vtkFloatArray.h"
#include "vtkImplicitPolyDataDistance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// What lies right of the middle of the picture.
vtkSmartPointer<vtkFloatArray> rightHalf(const System& s)
{
  auto mask = vtkSmartPointer<vtkFloatArray>::New();
  mask->SetName("Mask");
  for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(s.view.toDisplay(pointOf(s.mesh, i))[0] > 405.0 ? 1.0f : 0.0f);
  }
  return mask;
}

// Points that lie elsewhere, of those that are not masked and of those that are; base points stand first.
std::array<int, 2> moved(const System& s, vtkFloatArray* mask)
{
  std::array<int, 2> count{};
  for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
  {
    count[mask->GetValue(i) == 1.0f] += pointOf(s.filter->GetOutput(), i) != pointOf(s.mesh, i);
  }
  return count;
}

void expectKept(System& s)
{
  const auto mask = rightHalf(s);
  s.run();
  const std::array<int, 2> free = moved(s, mask);
  EXPECT_GT(free[0], 0);
  EXPECT_GT(free[1], 0);
  s.mesh->GetPointData()->AddArray(mask);
  vtkPolyData* output = s.run();
  const std::array<int, 2> held = moved(s, mask);
  EXPECT_GT(held[0], 0);
  EXPECT_EQ(held[1], 0);
  vtkDataArray* carried = output->GetPointData()->GetArray("Mask");
  ASSERT_NE(carried, nullptr);
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(s.mesh);
  for (vtkIdType i = s.mesh->GetNumberOfPoints(); i < output->GetNumberOfPoints(); ++i)
  {
    if (carried->GetComponent(i, 0) == 1.0)
    {
      Vector3 p = pointOf(output, i);
      EXPECT_LT(std::abs(distance->EvaluateFunction(p.data())), 1e-6 * s.diagonal()) << i;
    }
  }
}

} // namespace

TEST(AugmentMask, MaskedPointsStayUnderAVein)
{
  for (const std::string model : { "bear", "dog" })
  {
    SCOPED_TRACE(model);
    System s(shippedModel(model));
    expectKept(s);
  }
}

TEST(AugmentMask, MaskedPointsStayUnderASharpFootAndWhereNothingIsNeeded)
{
  System s(shippedModel("bear"));
  s.filter->SetSharpness(0.5);
  s.filter->SetSimplify(true);
  expectKept(s);
}

TEST(AugmentMask, MaskedPointsStayAsPublished)
{
  System s(shippedModel("bear"));
  s.filter->SetAsPublished(true);
  expectKept(s);
}

TEST(AugmentMask, MaskedPointsStayUnderANewOutline)
{
  System s(shippedModel("bear"));
  s.strokes = strokesOf({ overTheTop(s) }, s.view);
  s.filter->SetStrokesData(s.strokes);
  s.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
  expectKept(s);
}

TEST(AugmentMask, HalfMaskedRisesHalfAsHigh)
{
  System s(shippedModel("bear"));
  const auto most = [](vtkPolyData* mesh)
  {
    vtkDataArray* moves = mesh->GetPointData()->GetArray("Displacement");
    double highest = 0.0;
    for (vtkIdType i = 0; i < moves->GetNumberOfTuples(); ++i)
    {
      highest = std::max(highest, Vector3(moves->GetTuple3(i)).norm());
    }
    return highest;
  };
  const double whole = most(s.run());
  const auto mask = rightHalf(s);
  mask->Fill(0.5);
  s.mesh->GetPointData()->AddArray(mask);
  EXPECT_NEAR(most(s.run()), 0.5 * whole, 1e-6 * whole);
}

TEST(AugmentMask, AMaskOfNothingChangesNoBit)
{
  System s(shippedModel("bear"));
  const auto free = deepCopy(s.run());
  const auto mask = rightHalf(s);
  mask->Fill(0.0);
  s.mesh->GetPointData()->AddArray(mask);
  const auto made = deepCopy(s.run());
  made->GetPointData()->RemoveArray("Mask");
  expectSame(free, made);
}

TEST(AugmentMask, ASimplifiedBaseIsRefused)
{
  System s(shippedModel("bear"));
  s.mesh->GetPointData()->AddArray(rightHalf(s));
  s.filter->SetBaseToSimplified();
  expectRefusal(s.filter, Failure::BadMesh, "masked");
}
