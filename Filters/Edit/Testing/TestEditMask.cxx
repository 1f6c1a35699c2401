// The mask that a mesh carries under an edit: masked points stay, by each rule and under a profile.
#include "EditSystem.h"

#include "Harness/promises.h"
#include "Harness/shapes.h"
#include "Mesh/context.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

using Place = std::array<double, 3>;

std::set<Place> placesOf(vtkPolyData* mesh)
{
  std::set<Place> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = placeOf(mesh, i);
    places.insert({ p[0], p[1], p[2] });
  }
  return places;
}

struct MaskedEdit
{
  MaskedEdit()
  {
    this->s.operate("move 0.5 n %.9g", 0.03);
    this->mask->SetName("Mask");
    double middle[3];
    this->s.mesh->GetCenter(middle);
    for (vtkIdType i = 0; i < this->s.mesh->GetNumberOfPoints(); ++i)
    {
      this->mask->InsertNextValue(placeOf(this->s.mesh, i)[0] > middle[0] ? 1.0f : 0.0f);
    }
  }
  // Points of either half that are not where they were.
  std::array<int, 2> gone(vtkPolyData* output) const
  {
    const std::set<Place> places = placesOf(output);
    std::array<int, 2> count{};
    for (vtkIdType i = 0; i < this->s.mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(this->s.mesh, i);
      count[this->mask->GetValue(i) == 1.0f] += places.count({ p[0], p[1], p[2] }) == 0;
    }
    return count;
  }
  // The half that is masked stays, where else it would move.
  void expectKept()
  {
    const std::array<int, 2> free = this->gone(this->s.run());
    EXPECT_GT(free[0], 10);
    EXPECT_GT(free[1], 10);
    this->s.mesh->GetPointData()->AddArray(this->mask);
    const std::array<int, 2> masked = this->gone(this->s.run());
    EXPECT_GT(masked[0], 10);
    EXPECT_EQ(masked[1], 0);
    ASSERT_NE(this->s.filter->GetOutput()->GetPointData()->GetArray("Mask"), nullptr);
  }

  EditSystem s{ shippedModel("bear"), lineOver(40.0), ringOver(35.0) };
  vtkNew<vtkFloatArray> mask;
};

} // namespace

TEST(EditMask, MaskedPointsStayByEachRule)
{
  for (const int rule : { vtkOversketchEdit::Off, vtkOversketchEdit::Edit, vtkOversketchEdit::Curvature })
  {
    SCOPED_TRACE(rule);
    MaskedEdit masked;
    masked.s.filter->SetRule(rule);
    masked.expectKept();
  }
}

TEST(EditMask, MaskedPointsStayUnderAProfile)
{
  MaskedEdit masked;
  masked.s.filter->SetOperations("");
  vtkNew<vtkPolyData> drawn;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(101);
  for (int i = 0; i <= 100; ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(i / 100.0, 0.5 * std::sin(pi * i / 100.0), 0.0));
  }
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  masked.s.filter->SetProfileData(drawn);
  masked.expectKept();
}

TEST(EditMask, AMaskOfNothingChangesNoBit)
{
  MaskedEdit masked;
  vtkNew<vtkPolyData> free;
  free->DeepCopy(masked.s.run());
  masked.mask->Fill(0.0);
  masked.s.mesh->GetPointData()->AddArray(masked.mask);
  vtkNew<vtkPolyData> made;
  made->DeepCopy(masked.s.run());
  made->GetPointData()->RemoveArray("Mask");
  EXPECT_TRUE(identical(free, made));
}

TEST(EditMask, ARegionThatIsMaskedAsAWholeIsRefused)
{
  MaskedEdit masked;
  masked.mask->Fill(1.0);
  masked.s.mesh->GetPointData()->AddArray(masked.mask);
  expectRefusal(masked.s.filter, Failure::BadRegion, "masked");
}
