// A stroke that stays, in windows that change and go, and under events in any order.
#include "Harness/sequences.h"
#include "Harness/windows.h"
#include "held_scene.h"
#include "vtkOversketchFilterTools.h"

#include <cmath>
#include <iostream>
#include <random>

using namespace oversketch_test;

TEST(HeldStrokeWindow, GoesAwayInMidDragInAnyOrder)
{
  expectItMayGo<Held>(&Held::held,
    [](Held& scene)
    {
      scene.drawLine(60, 220, 150);
      scene.drag(100, 150, 110, 155);
      ASSERT_TRUE(scene.held->IsMoving());
    },
    { [](Held& scene) { scene.held->HoldStroke(nullptr, nullptr); } });
}

TEST(HeldStrokeWindow, AnObserverMayLetGoOfIt)
{
  expectAnObserverMayLetGo<Held>(&Held::held, [](Held& scene) { scene.drawLine(60, 220, 150); });
}

TEST(HeldStrokeWindow, AResizedWindowMovesAStrokeButDrawsNotOverIt)
{
  Held scene;
  scene.drawLine(60, 220, 150);
  scene.window->SetSize(400, 600);
  scene.event(vtkCommand::ConfigureEvent, 0, 0);
  scene.window->Render();
  EXPECT_TRUE(scene.line()->IsInReach());
  EXPECT_FALSE(scene.line()->IsInItsView());
  Counter told(scene.held, vtkCommand::MessageEvent);
  // As much is seen across the smaller side, 400 px for 300: 10 px of the hand are 7.5 of the stroke.
  scene.event(vtkCommand::LeftButtonPressEvent, 20, 300, Shift);
  scene.release(20, 300);
  EXPECT_EQ(told.count, 1);
  EXPECT_STRNE(scene.line()->GetText(), "");
  scene.drag(20, 300, 30, 300);
  EXPECT_STREQ(scene.line()->GetText(), "");
  scene.release(30, 300);
  EXPECT_NEAR(scene.held->GetStroke()->GetPoint(0)[0], 67.5, 1e-9);
}

TEST(Random, EventsOnAHeldStroke)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse = mouseEvents({ vtkCommand::MouseWheelForwardEvent });
  const std::vector<const char*> keys{ "Escape", "BackSpace", "Return", "x", "w", "r", "question", "q" };
  Held scene;
  const Sequences sequences = sequencesAsked(16);
  MemoryLevel memory(sequences);
  Counter commits(scene.held, vtkCommand::WidgetValueChangedEvent);
  int grabs = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    scene.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    scene.drawLine(60, 220, 150, 16);
    for (int i = 0; i < 200; ++i)
    {
      int x = below(480) - 40, y = below(380) - 40;
      const int modifiers = below(4) ? 0 : below(8);
      vtkPolyData* stroke = scene.held->GetStroke();
      if (stroke->GetNumberOfPoints() > 0 && below(3) == 0) // where it can be taken hold of
      {
        const double* p = stroke->GetPoint(below(static_cast<size_t>(stroke->GetNumberOfPoints())));
        x = int(p[0]);
        y = int(p[1]);
        if (below(3) == 0)
        {
          scene.event(vtkCommand::LeftButtonPressEvent, x, y, below(4) ? 0 : Shift);
        }
      }
      const double place[3] = { 0.01 * below(100), 0.01 * below(100), 0.01 * below(100) };
      switch (below(12))
      {
        case 0:
          scene.key(keys[below(keys.size())], modifiers, x, y);
          break;
        case 1:
        case 2:
          scene.event(mouse[below(mouse.size())], x, y, modifiers);
          break;
        case 3:
          switch (below(7))
          {
            case 0:
              scene.held->SetEnabled(below(2));
              break;
            case 1:
              scene.held->HoldStroke(below(2) ? stroke : nullptr, place);
              break;
            case 2:
              scene.held->SetGrabDistance(below(50));
              break;
            case 3:
              scene.held->GetPen()->SetCommitOnRelease(below(4) > 0);
              break;
            case 4:
              scene.window->SetSize(300 + below(2) * 100, 300);
              break;
            case 5:
              scene.held->GetPen()->CancelStroke();
              break;
            default:
              scene.window->Render();
          }
          break;
        default:
          scene.move(x, y, modifiers);
      }
      grabs += scene.held->IsMoving();
    }
    letGoOfAllButtons(scene);
    scene.held->GetPen()->CancelStroke();
    ASSERT_FALSE(scene.held->IsMoving());
    expectItDraws(scene);
    if (scene.held->GetStroke()->GetNumberOfPoints() > 0)
    {
      ASSERT_NO_THROW(oversketch::ViewOf(scene.held->GetStroke()));
      ASSERT_NO_THROW(oversketch::StrokeOf(scene.held->GetStroke()));
    }
    // The same state after each sequence, so that what is in use would show what grows.
    scene.held->On();
    scene.interactor->EnableRenderOn();
    scene.held->GetPen()->Drop();
    scene.held->GetPen()->CommitOnReleaseOn();
    scene.held->HoldStroke(nullptr, nullptr);
    scene.style->ShowKeysOff();
    scene.style->ResetToFirstView();
    scene.window->SetSize(400, 300);
    scene.window->Render();
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || commits.count > static_cast<int>(sequences.count)) << commits.count;
  EXPECT_TRUE(!sequences.areMany() || grabs > static_cast<int>(sequences.count)) << grabs;
  std::cout << commits.count << " changes, " << grabs << " events in a drag, ";
  memory.print();
  EXPECT_LT(memory.growth(), memory.allowed()); // the graphics library keeps what it likes
}
