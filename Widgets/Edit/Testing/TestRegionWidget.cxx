// A line and a ring drawn on a ball by logs, redrawn in part, taken back.
#include "vtkOversketchFilterTools.h"
#include "widget_scenes.h"

#include "vtkIdList.h"

using namespace oversketch_test;

namespace
{

bool endsAsItBegins(vtkPolyData* strokes, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  strokes->GetCellPoints(cell, ids);
  return ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
}

} // namespace

TEST(RegionWidget, ALineThenARingThatClosesThenThePenRests)
{
  RegionScene scene;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  Counter renders(scene.renderer, vtkCommand::StartEvent);
  scene.play("region_pen_down.log");
  EXPECT_EQ(renders.count, 0) << "the scene is drawn while the pen is";
  EXPECT_TRUE(scene.widget->GetPen()->IsDrawing());
  scene.key("Escape");
  scene.release(0, 0);
  EXPECT_FALSE(scene.widget->HasReference());
  EXPECT_EQ(changes.count, 0);

  scene.drawBoth();
  EXPECT_EQ(changes.count, 2);
  ASSERT_EQ(scene.widget->GetReference()->GetNumberOfLines(), 1);
  ASSERT_EQ(scene.widget->GetBoundary()->GetNumberOfLines(), 1);
  EXPECT_FALSE(endsAsItBegins(scene.widget->GetReference(), 0));
  EXPECT_TRUE(endsAsItBegins(scene.widget->GetBoundary(), 0));
  EXPECT_NO_THROW(oversketch::ViewOf(scene.widget->GetReference()));
  EXPECT_NO_THROW(oversketch::ViewOf(scene.widget->GetBoundary()));
  EXPECT_LT(scene.shown()->DistanceTo(vtkOversketchRegionRepresentation::Reference, 200, 150), 1.0);
  EXPECT_LT(scene.shown()->DistanceTo(vtkOversketchRegionRepresentation::Boundary, 200, 210), 1.0);
  EXPECT_NEAR(scene.shown()->DistanceTo(vtkOversketchRegionRepresentation::Boundary, 200, 150), 60.0, 1.0);

  // The left button is the camera's again.
  const CameraState before(scene);
  scene.drag(200, 150, 230, 150);
  scene.release(230, 150);
  EXPECT_FALSE(CameraState(scene) == before);
  EXPECT_EQ(changes.count, 2);
}

TEST(RegionWidget, WhatIsDrawnIsWhatTheSystemAsksFor)
{
  RegionScene scene;
  scene.drawBoth();
  vtkNew<vtkOversketchEdit> system;
  system->SetInputData(0, scene.mesh);
  system->SetInputConnection(1, scene.widget->GetReferencePort());
  system->SetInputConnection(2, scene.widget->GetBoundaryPort());
  system->SetOperations("move 0.5 n 0.2");
  Ear ear(system);
  system->Update();
  EXPECT_EQ(system->GetErrorCode(), 0u) << (ear.errors.empty() ? "" : ear.errors[0]);
  EXPECT_GT(system->GetMovedPoints(), 50);
  double highest = 0.0;
  for (vtkIdType i = 0; i < system->GetOutput()->GetNumberOfPoints(); ++i)
  {
    highest = std::max(highest, Vector3(system->GetOutput()->GetPoint(i)).norm());
  }
  EXPECT_NEAR(highest, 1.2, 0.01);
  // The system's own curves are shown in place of the hand's, until it draws again.
  scene.widget->ShowCurves(system->GetReferenceOutput(), system->GetBoundaryOutput());
  scene.camera()->SetPosition(0.0, 10.0, 0.0);
  scene.camera()->SetViewUp(0.0, 0.0, -1.0);
  EXPECT_LT(scene.shown()->DistanceTo(vtkOversketchRegionRepresentation::Reference, 200, 30), 3.0);
}

TEST(RegionWidget, ShiftRedrawsTheOneUnderIt)
{
  using Shown = vtkOversketchRegionRepresentation;
  RegionScene scene;
  scene.drawBoth();
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.play("region_redraw_ring.log"); // its top, bulging to y = 225
  EXPECT_EQ(changes.count, 1);
  EXPECT_EQ(scene.widget->GetReference()->GetNumberOfLines(), 1);
  ASSERT_EQ(scene.widget->GetBoundary()->GetNumberOfLines(), 2);
  EXPECT_LT(scene.shown()->DistanceTo(Shown::Boundary, 200, 225), 1.5);
  EXPECT_GT(scene.shown()->DistanceTo(Shown::Boundary, 200, 210), 10.0) << "the old part is still there";
  EXPECT_LT(scene.shown()->DistanceTo(Shown::Boundary, 200, 90), 1.0) << "the rest is not";

  // From elsewhere too: the line, seen from above.
  scene.camera()->SetPosition(0.0, 5.0, 8.660254);
  scene.renderer->ResetCameraClippingRange();
  std::vector<Vector2> over;
  for (int x = 180; x <= 220; x += 2)
  {
    const auto at = scene.display({ 0.01 * (x - 200), 0.0, 1.0 });
    over.emplace_back(x, at[1] + 12.0 * std::cos(pi * (x - 200) / 40.0));
  }
  scene.draw(over, Shift);
  EXPECT_EQ(changes.count, 2);
  ASSERT_EQ(scene.widget->GetReference()->GetNumberOfLines(), 2);
  EXPECT_LT(scene.shown()->DistanceTo(Shown::Reference, 200, over[10][1]), 1.5);
  EXPECT_GT(scene.shown()->DistanceTo(Shown::Reference, 200, over[10][1] - 12.0), 8.0);

  // Where neither is, it is said, and nothing changes.
  Counter told(scene.widget, vtkCommand::MessageEvent);
  scene.draw({ { 20, 20 }, { 30, 20 }, { 40, 20 } }, Shift);
  EXPECT_EQ(told.count, 1);
  EXPECT_EQ(changes.count, 2);
  EXPECT_NE(std::string(scene.shown()->GetText()).find("begin or end on"), std::string::npos);
}

TEST(RegionWidget, EscapeTakesBackWhatWasDrawnLast)
{
  RegionScene scene;
  scene.drawBoth();
  scene.play("region_redraw_ring.log");
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.key("Escape");
  EXPECT_EQ(scene.widget->GetBoundary()->GetNumberOfLines(), 1);
  EXPECT_LT(scene.shown()->DistanceTo(vtkOversketchRegionRepresentation::Boundary, 200, 210), 1.0);
  scene.key("Escape");
  EXPECT_FALSE(scene.widget->HasBoundary());
  EXPECT_TRUE(scene.widget->HasReference());
  scene.play("region_ring.log"); // another ring
  EXPECT_TRUE(scene.widget->HasBoundary());
  scene.key("Escape");
  scene.key("Escape");
  EXPECT_FALSE(scene.widget->HasReference());
  EXPECT_EQ(changes.count, 5);
  scene.key("Escape");
  EXPECT_EQ(changes.count, 5);
}

TEST(RegionWidget, BackspaceShortensTheStroke)
{
  RegionScene scene;
  scene.play("region_pen_down.log");
  const vtkIdType before = scene.widget->GetPen()->GetStrokeRepresentation()->GetNumberOfSamples();
  scene.key("BackSpace");
  EXPECT_LE(scene.widget->GetPen()->GetStrokeRepresentation()->GetNumberOfSamples(), before - 4);
  scene.key("Escape");
}

TEST(RegionWidget, DrawingSwallowsWhatItUses)
{
  RegionScene scene;
  const CameraState before(scene);
  scene.play("region_pen_down.log");
  Counter keys(scene.interactor, vtkCommand::CharEvent);
  disturb(scene);
  EXPECT_TRUE(CameraState(scene) == before);
  EXPECT_EQ(keys.count, 0);
  scene.release(240, 150);
  EXPECT_TRUE(scene.widget->HasReference());
}

TEST(RegionWidget, ARegionIsTakenAndHandedOn)
{
  RegionScene scene, other;
  scene.drawBoth();
  scene.play("region_redraw_ring.log");
  ASSERT_TRUE(other.widget->SetRegion(scene.widget->GetReference(), scene.widget->GetBoundary()));
  EXPECT_EQ(other.widget->GetBoundary()->GetNumberOfLines(), 2);
  EXPECT_TRUE(endsAsItBegins(other.widget->GetBoundary(), 0));
  EXPECT_LT(other.shown()->DistanceTo(vtkOversketchRegionRepresentation::Boundary, 200, 225), 1.5);
  other.key("Escape");
  EXPECT_EQ(other.widget->GetBoundary()->GetNumberOfLines(), 1);
  EXPECT_FALSE(other.widget->SetRegion(scene.mesh, nullptr)) << "no strokes with views";
  EXPECT_TRUE(other.widget->HasBoundary());
  EXPECT_TRUE(other.widget->SetRegion(nullptr, scene.widget->GetBoundary()));
  EXPECT_FALSE(other.widget->HasBoundary()) << "a ring without a line";
}
