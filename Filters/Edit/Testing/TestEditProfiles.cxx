// Profiles that no section can be, and strokes of another view, are refused by name.
#include "EditSystem.h"

#include "Harness/promises.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// Strokes of places in the section's plane.
vtkSmartPointer<vtkPolyData> flat(const std::vector<std::vector<Vector2>>& strokes)
{
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const auto& stroke : strokes)
  {
    lines->InsertNextCell(static_cast<int>(stroke.size()));
    for (const Vector2& p : stroke)
    {
      lines->InsertCellPoint(points->InsertNextPoint(p[0], p[1], 0.0));
    }
  }
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  return drawn;
}

const std::vector<Vector2> looped = { { 0, 0 }, { 0.7, 0.5 }, { 0.3, 0.5 }, { 1, 0 } };
const std::vector<Vector2> arched = { { 0, 0 }, { 0.5, 0.4 }, { 1, 0 } };

// A parallel view of a square of this side about (0.5, height), turned about x by an angle.
View squareView(double side, double degrees, double height = 0.0)
{
  Eigen::Affine3d see = Eigen::Translation3d(0.0, 0.0, -10.0) *
                        Eigen::AngleAxisd(degrees * pi / 180.0, Vector3::UnitX()) *
                        Eigen::Translation3d(-0.5, -height, 0.0);
  Eigen::Matrix4d project = Eigen::Matrix4d::Identity();
  project(0, 0) = project(1, 1) = 2.0 / side;
  project(2, 2) = -0.1;
  project(2, 3) = -1.0;
  return View(see.matrix(), project, 400, 400);
}

} // namespace

TEST(EditProfiles, WhatNoSectionCanBeIsRefused)
{
  EditSystem s(shippedModel("bear"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  const auto expect = [&s](vtkPolyData* profile, const char* words)
  {
    SCOPED_TRACE(words);
    s.filter->SetProfileData(profile);
    expectRefusal(s.filter, Failure::BadStroke, words);
  };
  expect(flat({ looped }), "The profile crosses itself near (0.5, 0.357); draw it from side to side");
  expect(flat({ arched, looped }), "Stroke 1 of the profile crosses itself near (0.5, 0.357)");
  expect(flat({ { { 0.2, 0.2 }, { 0.8, 0.2 }, { 0.8, 0.6 }, { 0.2, 0.2 } } }), "The profile is closed");
  expect(flat({ { { 0, 0 }, { 200, 90 }, { 400, 0 } } }), "The profile ends at (400, 0), 399 times");
  expect(flat({ arched, { { 5, 5 }, { 6, 6 } } }), "Stroke 1 of the profile begins at (5, 5)");
  // What trembles or turns back is drawn as it can be.
  for (const auto& line :
    { std::vector<Vector2>{ { 0, 0 }, { 0.5, 0.41 }, { 0.49, 0.4 }, { 0.5, 0.4 }, { 1, 0 } },
      std::vector<Vector2>{ { 0, 0 }, { 0.6, 0.1 }, { 0.3, 0.2 }, { 1, 0.3 } } })
  {
    s.filter->SetProfileData(flat({ line }));
    s.run();
    EXPECT_GT(s.filter->GetMovedPoints(), 0);
  }
}

// In a view onto the section a stroke is taken; one that was drawn on the model is told from it.
TEST(EditProfiles, StrokesOfAnotherViewAreRefused)
{
  EditSystem s(shippedModel("bear"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  const std::vector<Vector2> arch = { { 100, 200 }, { 200, 300 }, { 300, 200 } };
  s.filter->SetProfileData(toStroke(arch, squareView(2.0, 0.0)));
  s.run();
  EXPECT_GT(s.filter->GetMovedPoints(), 0);
  s.filter->SetProfileData(toStroke(arch, squareView(2.0, 60.0)));
  expectRefusal(s.filter, Failure::BadStroke, "was drawn in a view that looks at the section's plane askew");
  s.filter->SetProfileData(toStroke(lineOver(), s.view));
  expectRefusal(
    s.filter, Failure::BadStroke, "was drawn on the model, in the view of the line or of the ring");
  s.filter->SetProfileData(nullptr);
  s.operate("move 0.5 n %.9g", 0.02);
  s.filter->SetAreasData(toStroke(ringOver(), s.view));
  expectRefusal(s.filter, Failure::BadStroke, "An area was drawn on the model");
}

// Drawn in a view, as in the window, a profile makes what it makes where its places are given.
TEST(EditProfiles, OneDrawnInAViewMakesWhatItsPlacesMake)
{
  EditSystem s(shippedModel("dinosaur"));
  s.filter->SetReferenceData(shippedStroke("dinosaur_crest"));
  s.filter->SetBoundaryData(shippedStroke("dinosaur_crest_ring"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  double farthest = 0.0;
  for (const double height : { 0.3, 0.45, 0.6 })
  {
    std::vector<Vector2> arch, seen;
    for (int i = 0; i <= 100; ++i)
    {
      const double x = i / 100.0, y = height * std::sin(pi * x);
      arch.emplace_back(x, y);
      seen.emplace_back(200.0 + (x - 0.5) / 0.6 * 200.0, 200.0 + (y - 0.3) / 0.6 * 200.0);
    }
    s.filter->SetProfileData(flat({ arch }));
    vtkNew<vtkPolyData> given;
    given->DeepCopy(s.run());
    EXPECT_GT(s.filter->GetMovedPoints(), 0);
    s.filter->SetProfileData(toStroke(seen, squareView(1.2, 0.0, 0.3)));
    farthest = std::max(farthest, largestMove(given, s.run()));
  }
  EXPECT_LT(farthest, 1e-6 * s.diagonal());
}
