// A stroke that stays, without a system.
#include "held_scene.h"

#include "vtkInteractorStyleTrackballCamera.h"

using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

} // namespace

TEST(HeldStroke, ANewStrokeIsHeldAndTold)
{
  Held scene;
  Counter starts(scene.held, vtkCommand::StartInteractionEvent),
    moves(scene.held, vtkCommand::InteractionEvent), ends(scene.held, vtkCommand::EndInteractionEvent),
    changes(scene.held, vtkCommand::WidgetValueChangedEvent);
  vtkPolyData* stroke = scene.held->GetStroke();
  EXPECT_EQ(stroke->GetNumberOfPoints(), 0);
  EXPECT_FALSE(scene.line()->HasStroke());
  scene.drawLine(60, 220, 150);
  EXPECT_EQ(starts.count, 1);
  EXPECT_EQ(moves.count, 41);
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(changes.count, 1);
  EXPECT_TRUE(scene.held->IsNew());
  EXPECT_EQ(stroke->GetNumberOfPoints(), 41);
  EXPECT_TRUE(scene.line()->IsInItsView());
  EXPECT_NEAR(scene.line()->DistanceTo(100, 157), 7.0, 1e-9);
  EXPECT_GT(scene.red(), 300);
  // The next one replaces it, and is not drawn over it.
  scene.press(60, 100);
  scene.move(100, 100);
  EXPECT_LT(scene.red(), 300) << "the held stroke is seen under the pen";
  scene.key("Escape");
  EXPECT_EQ(stroke->GetNumberOfPoints(), 41);
  EXPECT_GT(scene.red(), 300) << "the held stroke is gone with one that was dropped";
  scene.release(100, 100);
  scene.drawLine(60, 140, 100);
  EXPECT_EQ(changes.count, 2);
  EXPECT_TRUE(scene.held->IsNew());
  EXPECT_EQ(stroke->GetPoint(0)[1], 100.0);
}

TEST(HeldStroke, IsHeldWhereTheHostSays)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  const auto drawn = copyOf(scene.held->GetStroke());
  Counter changes(scene.held, vtkCommand::WidgetValueChangedEvent);
  const double near[3] = { 0.0, 0.0, 1.0 };
  scene.held->HoldStroke(drawn, near);
  EXPECT_EQ(scene.held->GetStroke()->GetNumberOfPoints(), drawn->GetNumberOfPoints());
  scene.held->HoldStroke(scene.held->GetStroke(), near); // its own
  EXPECT_EQ(scene.held->GetStroke()->GetNumberOfPoints(), drawn->GetNumberOfPoints());
  // (100, 150) is x = -1 of the world; a quarter turn about y takes z = 1 to the left or the right of it.
  scene.camera()->Azimuth(90.0);
  const auto seen = scene.display({ -1.0, 0.0, 1.0 });
  EXPECT_LT(scene.line()->DistanceTo(seen[0], seen[1]), 1e-6);
  scene.held->HoldStroke(nullptr, nullptr);
  EXPECT_FALSE(scene.line()->HasStroke());
  EXPECT_EQ(scene.held->GetStroke()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.red(), 0);
  EXPECT_EQ(changes.count, 0);
}

TEST(HeldStroke, IsMovedByTheHand)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  const auto drawn = copyOf(scene.held->GetStroke());
  Counter changes(scene.held, vtkCommand::WidgetValueChangedEvent),
    moves(scene.held, vtkCommand::InteractionEvent);
  scene.move(100, 152);
  EXPECT_TRUE(scene.line()->GetHighlighted());
  scene.drag(100, 152, 130, 132);
  EXPECT_TRUE(scene.held->IsMoving());
  EXPECT_NEAR(scene.held->GetTranslation()[0], 0.3, 1e-12);
  EXPECT_NEAR(scene.held->GetTranslation()[1], -0.2, 1e-12);
  EXPECT_EQ(moves.count, 1);
  scene.key("x"); // not in mid-drag
  scene.key("Escape");
  EXPECT_FALSE(scene.held->IsMoving());
  scene.release(130, 132);
  EXPECT_EQ(changes.count, 0);
  EXPECT_EQ(scene.held->GetStroke()->GetPoint(0)[0], drawn->GetPoint(0)[0]);
  // Let go, it stays; a click alone moves nothing.
  scene.drag(100, 152, 130, 132);
  scene.release(130, 132);
  EXPECT_EQ(changes.count, 1);
  EXPECT_FALSE(scene.held->IsNew());
  EXPECT_NEAR(scene.held->GetStroke()->GetPoint(0)[0], drawn->GetPoint(0)[0] + 30.0, 1e-9);
  EXPECT_NEAR(scene.held->GetStroke()->GetPoint(0)[1], drawn->GetPoint(0)[1] - 20.0, 1e-9);
  scene.press(130, 132);
  scene.release(130, 132);
  EXPECT_EQ(changes.count, 1);
  // The keys of one that stands are the host's.
  scene.key("Escape");
  scene.key("Return");
  EXPECT_GT(scene.held->GetStroke()->GetNumberOfPoints(), 0);
}

TEST(HeldStroke, IsMovedInItsPlaneAtAnyZoom)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  const auto drawn = copyOf(scene.held->GetStroke());
  scene.camera()->SetParallelScale(0.75);
  EXPECT_TRUE(scene.line()->IsInReach());
  EXPECT_FALSE(scene.line()->IsInItsView());
  scene.drag(100, 150, 120, 150);
  EXPECT_NEAR(scene.held->GetTranslation()[0], 0.1, 1e-12);
  scene.release(120, 150);
  EXPECT_NEAR(scene.held->GetStroke()->GetPoint(0)[0], drawn->GetPoint(0)[0] + 10.0, 1e-9);
}

TEST(HeldStroke, APartIsDrawnAnew)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  Counter changes(scene.held, vtkCommand::WidgetValueChangedEvent);
  scene.event(vtkCommand::LeftButtonPressEvent, 100, 150, Shift);
  EXPECT_TRUE(scene.held->IsRedrawing());
  for (int x = 104; x <= 160; x += 4)
  {
    scene.move(x, 156, Shift);
  }
  scene.release(160, 150);
  EXPECT_EQ(changes.count, 1);
  EXPECT_FALSE(scene.held->IsNew());
  EXPECT_FALSE(scene.held->IsRedrawing());
  vtkPolyData* stroke = scene.held->GetStroke();
  EXPECT_EQ(stroke->GetPoint(0)[0], 60.0);
  EXPECT_EQ(stroke->GetPoint(stroke->GetNumberOfPoints() - 1)[0], 220.0);
  double bounds[6];
  stroke->GetBounds(bounds);
  EXPECT_NEAR(bounds[3], 156.0, 1.0);
}

TEST(HeldStroke, FromElsewhereAClickTurnsBackToIt)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  const auto drawn = copyOf(scene.held->GetStroke());
  scene.camera()->Azimuth(50.0);
  scene.window->Render();
  EXPECT_FALSE(scene.line()->IsInReach());
  const auto seen = scene.display({ -1.0, 0.0, 0.0 });
  scene.press(int(seen[0]), int(seen[1]));
  scene.release(int(seen[0]), int(seen[1]));
  EXPECT_TRUE(scene.line()->IsInItsView());
  EXPECT_FALSE(scene.held->IsMoving());
  EXPECT_EQ(scene.held->GetStroke()->GetPoint(0)[0], drawn->GetPoint(0)[0]);
}

TEST(HeldStroke, TheCameraLooksFromAStroke)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  const auto drawn = copyOf(scene.held->GetStroke());
  Counter told(scene.style, vtkCommand::InteractionEvent);
  for (const bool parallel : { true, false })
  {
    scene.camera()->Azimuth(50.0);
    scene.camera()->SetParallelProjection(parallel);
    scene.camera()->SetParallelScale(0.5);
    EXPECT_TRUE(scene.style->LookFrom(drawn));
    EXPECT_TRUE(scene.line()->IsInItsView());
  }
  EXPECT_EQ(told.count, 2);
  const double* was = scene.camera()->GetPosition();
  const double x = was[0];
  vtkNew<vtkPolyData> none;
  EXPECT_FALSE(scene.style->LookFrom(none));
  EXPECT_FALSE(scene.style->LookFrom(nullptr));
  EXPECT_EQ(scene.camera()->GetPosition()[0], x);
  // The pen's own word on the present view says the same.
  vtkNew<vtkPolyData> view;
  scene.held->GetPen()->GetStrokeRepresentation()->PutView(view);
  EXPECT_EQ(view->GetNumberOfPoints(), 1);
  scene.camera()->Azimuth(50.0);
  EXPECT_TRUE(scene.style->LookFrom(view));
  EXPECT_TRUE(scene.line()->IsInItsView());
}
