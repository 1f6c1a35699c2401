// The pen that deforms a mesh in windows that change and go, and under events in any order, on a small mesh.
#include "Harness/sequences.h"
#include "dog_scene.h"

#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <iostream>
#include <random>

using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> ball()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.05, 0.75, 0.0);
  sphere->SetRadius(0.7);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->Update();
  return sphere->GetOutput();
}

// A bulge over the ball's upper right.
void drawOverBall(Dog& scene)
{
  const auto at = [](int i) { return 10.0 + 5.0 * i; };
  const auto x = [&](int i)
  { return int(200 + (82 + 12 * std::sin(at(i) * M_PI / 90)) * std::cos(at(i) * M_PI / 180)); };
  const auto y = [&](int i)
  { return int(150 + (82 + 12 * std::sin(at(i) * M_PI / 90)) * std::sin(at(i) * M_PI / 180)); };
  scene.press(x(0), y(0));
  for (int i = 1; i <= 14; ++i)
  {
    scene.move(x(i), y(i));
  }
  scene.release(x(14), y(14));
}

} // namespace

TEST(OneStrokeWindow, GoesAwayInMidDragInAnyOrder)
{
  Quiet quiet;
  for (int what = 0; what < 8; ++what)
  {
    SCOPED_TRACE(what);
    Dog scene(ball());
    drawOverBall(scene);
    ASSERT_STREQ(scene.widget->GetMessage(), "");
    const double* p = scene.widget->GetStroke()->GetPoint(7);
    const int x = int(p[0]), y = int(p[1]);
    scene.move(x, y);
    scene.press(x, y);
    scene.move(x + 5, y + 5);
    ASSERT_TRUE(scene.widget->IsMoving());
    switch (what)
    {
      case 0:
        scene.widget->Off();
        break;
      case 1:
        scene.widget = nullptr;
        break;
      case 2:
        scene.widget->SetInteractor(nullptr);
        break;
      case 3:
        scene.widget->SetRepresentation(nullptr);
        break;
      case 4:
        scene.widget->SetInputData(shippedModel("dog"));
        break;
      case 5:
        scene.widget->Drop();
        break;
      case 6:
        scene.interactor->SetRenderWindow(nullptr);
        scene.widget->Off();
        break;
      default:
        break; // the window first
    }
    if (what < 6)
    {
      scene.move(x + 9, y);
      scene.window->Render();
      scene.release(x + 9, y);
      EXPECT_TRUE(scene.renderer->GetDraw());
    }
  }
  EXPECT_EQ(quiet.errors(), 0);
}

TEST(OneStrokeWindow, AnObserverMayLetGoOfIt)
{
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent })
  {
    Dog scene(ball());
    vtkNew<vtkCallbackCommand> drop;
    drop->SetClientData(&scene);
    drop->SetCallback(
      [](vtkObject*, unsigned long, void* held, void*) { static_cast<Dog*>(held)->widget = nullptr; });
    scene.widget->AddObserver(event, drop);
    drawOverBall(scene);
    EXPECT_EQ(scene.widget, nullptr);
    scene.window->Render();
    EXPECT_TRUE(scene.renderer->GetDraw());
  }
}

TEST(OneStrokeWindow, AResizedWindowMovesAStrokeButDrawsNotOverIt)
{
  Dog scene(ball());
  drawOverBall(scene);
  scene.window->SetSize(400, 600);
  scene.event(vtkCommand::ConfigureEvent, 0, 0);
  scene.window->Render();
  auto* line = scene.widget->GetLiveStrokeRepresentation();
  EXPECT_TRUE(line->IsInReach());
  EXPECT_FALSE(line->IsInItsView());
  const std::array<double, 2> first{ scene.widget->GetStroke()->GetPoint(0)[0],
    scene.widget->GetStroke()->GetPoint(0)[1] };
  // The picture is twice as large: the ball's right end lay at (282, 150), it lies at (364, 300).
  const int x = int(200 + 2 * (first[0] - 200)), y = int(300 + 2 * (first[1] - 150));
  EXPECT_LT(line->DistanceTo(x, y), 3.0);
  Counter told(scene.widget, vtkCommand::MessageEvent);
  scene.press(x, y, Shift);
  scene.release(x, y);
  EXPECT_EQ(told.count, 1);
  scene.press(x, y);
  scene.move(x + 10, y);
  scene.release(x + 10, y);
  EXPECT_NEAR(scene.widget->GetStroke()->GetPoint(0)[0], first[0] + 5.0, 1e-9);
}

TEST(Random, EventsOnTheOneStrokeWidget)
{
  Quiet quiet;
  const Sequences sequences = sequencesAsked(20);
  MemoryLevel memory(sequences);
  const std::vector<unsigned long> mouse{ vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent,
    vtkCommand::RightButtonPressEvent,
    vtkCommand::RightButtonReleaseEvent,
    vtkCommand::MouseWheelForwardEvent,
    vtkCommand::LeaveEvent,
    vtkCommand::ConfigureEvent };
  const std::vector<const char*> keys{ "Escape", "BackSpace", "Return", "o", "x", "w", "r", "question", "q" };
  const auto start = ball();
  int strokes = 0, grabs = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    Dog scene(start);
    scene.widget->GetOneStroke()->SetRemesh(static_cast<int>(seed % 3));
    Counter commits(scene.widget, vtkCommand::WidgetValueChangedEvent);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    scene.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    if (seed % 2 == 0)
    {
      drawOverBall(scene);
    }
    for (int i = 0; i < 200; ++i)
    {
      int x = below(440) - 20, y = below(340) - 20;
      const int modifiers = below(4) ? 0 : below(8);
      vtkPolyData* live = scene.widget->GetStroke();
      if (live->GetNumberOfPoints() > 0 && below(3) == 0) // where it can be taken hold of
      {
        const double* p = live->GetPoint(below(static_cast<size_t>(live->GetNumberOfPoints())));
        x = int(p[0]);
        y = int(p[1]);
        if (below(3) == 0)
        {
          scene.press(x, y, below(4) ? 0 : Shift);
        }
      }
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
          switch (below(10))
          {
            case 0:
              scene.widget->SetEnabled(below(2));
              break;
            case 1:
              scene.widget->SetShowRegion(below(2));
              break;
            case 2:
              scene.widget->GetOneStroke()->SetRemesh(below(3));
              break;
            case 3:
              scene.widget->Commit();
              break;
            case 4:
              scene.window->SetSize(300 + below(2) * 100, 300);
              break;
            case 5:
              scene.widget->GetPen()->SetCommitOnRelease(below(4) > 0);
              break;
            case 6:
              scene.widget->SetStroke(scene.widget->GetStroke());
              break;
            case 7:
              scene.widget->GetPen()->CancelStroke();
              break;
            case 8:
              scene.widget->SetInputData(start);
              break;
            default:
              scene.window->Render();
          }
          break;
        default:
          scene.move(x, y, modifiers);
      }
      grabs += scene.widget->IsMoving();
    }
    for (const unsigned long up : { vtkCommand::LeftButtonReleaseEvent,
           vtkCommand::MiddleButtonReleaseEvent,
           vtkCommand::RightButtonReleaseEvent })
    {
      scene.event(up, 0, 0);
    }
    scene.widget->GetPen()->CancelStroke();
    ASSERT_FALSE(scene.widget->IsMoving());
    ASSERT_TRUE(scene.renderer->GetDraw());
    ASSERT_EQ(scene.window->GetRenderers()->GetNumberOfItems(), 1);
    vtkPolyData* mesh = scene.widget->GetOutput();
    ASSERT_GT(mesh->GetNumberOfPolys(), 0); // strokes across the ball, remeshed, may leave few
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      ASSERT_TRUE(std::isfinite(mesh->GetPoint(p)[0] + mesh->GetPoint(p)[1] + mesh->GetPoint(p)[2]));
    }
    strokes += commits.count;
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || strokes > static_cast<int>(sequences.count)) << strokes;
  EXPECT_TRUE(!sequences.areMany() || grabs > static_cast<int>(sequences.count)) << grabs;
  std::cout << strokes << " changes, " << grabs << " events in a drag, ";
  memory.print();
#ifdef __SANITIZE_ADDRESS__
  constexpr double most = 8.0; // small blocks take several times their size
#else
  constexpr double most = 4.0;
#endif
  EXPECT_LT(memory.growth(memoryKeptOfAWindow()), most);
}
