// The pen in windows that change, and under events in any order.
#include "Harness/sequences.h"
#include "Harness/windows.h"
#include "pen_scene.h"
#include "vtkOversketchFilterTools.h"

#include <cmath>
#include <iostream>
#include <random>

using namespace oversketch_test;

TEST(Window, AResizeDropsTheStroke)
{
  Pen scene;
  scene.press(60, 150);
  scene.move(100, 150);
  scene.window->SetSize(300, 200);
  scene.event(vtkCommand::ConfigureEvent, 100, 150);
  EXPECT_FALSE(scene.pen->IsDrawing());
  EXPECT_TRUE(scene.renderer->GetDraw());
  EXPECT_EQ(scene.window->GetRenderers()->GetNumberOfItems(), 1);
  scene.release(100, 150);
  scene.drawLine(20, 100, 50);
  EXPECT_EQ(oversketch::ViewOf(scene.pen->GetStroke()).width(), 300);
}

TEST(Window, OneViewportOfTwo)
{
  Pen scene;
  vtkNew<vtkRenderer> left;
  scene.renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetBackground(0.0, 0.0, 1.0);
  scene.window->AddRenderer(left);
  scene.pen->Off();
  scene.move(300, 150);
  scene.pen->SetCurrentRenderer(scene.renderer);
  scene.pen->On();
  scene.window->Render();
  scene.drawLine(20, 100, 150); // the other renderer's
  EXPECT_EQ(scene.samples().size(), 0u);
  scene.press(240, 150);
  Counter leftRenders(left, vtkCommand::StartEvent);
  scene.move(300, 150);
  EXPECT_TRUE(isRed(scene.pixels(), 270, 150));
  EXPECT_EQ(leftRenders.count, 0);
  scene.release(300, 150);
  EXPECT_TRUE(isRed(scene.pixels(), 270, 150));
  EXPECT_EQ(scene.samples(), (std::vector<std::array<double, 2>>{ { 40.0, 150.0 }, { 100.0, 150.0 } }));
  EXPECT_EQ(oversketch::ViewOf(scene.pen->GetStroke()).width(), 200);
}

TEST(Window, GoesAwayInMidStrokeInAnyOrder)
{
  expectItMayGo<Pen>(&Pen::pen,
    [](Pen& scene)
    {
      scene.press(60, 150);
      scene.move(100, 150);
    },
    {});
}

TEST(Window, StrokesLeaveNoMemoryBehind)
{
  Pen scene;
  const auto after = [&](int strokes)
  {
    for (int i = 0; i < strokes; ++i)
    {
      scene.drawLine(60, 220, 150, 16);
    }
    return 1048576.0 * memoryInUse();
  };
  const auto redrawn = [&](int frames)
  {
    for (int i = 0; i < frames; ++i)
    {
      scene.camera()->Azimuth(1.0);
      scene.window->Render();
    }
    return 1048576.0 * memoryInUse();
  };
  // As many frames without a stroke show what the graphics library keeps of its own.
  constexpr int strokes = 50, framesOfOne = 18;
  redrawn(5 * framesOfOne);
  const double before = redrawn(0), plain = redrawn(strokes * framesOfOne) - before;
  after(20);
  const double early = after(0), drawn = after(strokes) - early;
  const int* size = scene.window->GetSize();
  const double frame = 3.0 * size[0] * size[1];
  std::cout << "A redraw's growth " << plain / strokes / 1024.0 << " KiB, a stroke's "
            << drawn / strokes / 1024.0 << " KiB, a frame " << frame / 1024.0 << " KiB\n";
  EXPECT_LT(drawn - plain, 0.05 * strokes * frame);
}

TEST(Random, EventsNeitherFailNorLoseTheFrame)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse{ vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent,
    vtkCommand::RightButtonPressEvent,
    vtkCommand::RightButtonReleaseEvent,
    vtkCommand::MouseWheelForwardEvent,
    vtkCommand::EnterEvent,
    vtkCommand::LeaveEvent,
    vtkCommand::ExposeEvent,
    vtkCommand::ConfigureEvent };
  const std::vector<const char*> keys{
    "Escape", "BackSpace", "Return", "KP_Enter", "x", "w", "r", "i", "exclam", "question", "q", "Shift_L"
  };
  Pen scene;
  const Sequences sequences = sequencesAsked(16);
  MemoryLevel memory(sequences);
  int strokes = 0;
  Counter commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    scene.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    for (int i = 0; i < 200; ++i)
    {
      const int x = below(480) - 40, y = below(380) - 40, modifiers = below(4) ? 0 : below(8);
      if (below(25) == 0) // a whole stroke
      {
        scene.press(x, y);
        for (int step = 1; step <= 6; ++step, ++i)
        {
          scene.move(x + step * (10 + below(5)), y + below(10));
        }
        scene.release(x + 90, y);
        i += 2;
        continue;
      }
      switch (below(12))
      {
        case 0:
          scene.key(keys[below(keys.size())], modifiers, x, y);
          break;
        case 1:
        case 2:
        case 3:
          scene.event(mouse[below(mouse.size())], x, y, modifiers);
          break;
        case 4:
          switch (below(8))
          {
            case 0:
              scene.pen->SetEnabled(below(2));
              break;
            case 1:
              scene.pen->SetCommitOnRelease(below(2));
              break;
            case 2:
              scene.pen->SetStabilizer(below(30));
              break;
            case 3:
              scene.pen->Commit();
              break;
            case 4:
              scene.pen->BeginStroke(x, y);
              break;
            case 5:
              scene.pen->EndStroke();
              break;
            case 6:
              scene.window->SetSize(300 + below(2) * 100, 300);
              break;
            default:
              scene.pen->RemoveLastSamples();
          }
          break;
        default:
          scene.move(x, y, modifiers);
      }
    }
    letGoOfAllButtons(scene);
    scene.pen->CancelStroke();
    scene.pen->On();
    expectItDraws(scene);
    ASSERT_TRUE(std::isfinite(scene.camera()->GetPosition()[0]));
    vtkPolyData* stroke = scene.pen->GetStroke();
    if (commits.count > strokes)
    {
      ASSERT_NO_THROW(oversketch::ViewOf(stroke));
      ASSERT_NO_THROW(oversketch::StrokeOf(stroke));
    }
    strokes = commits.count;
    // The same state after each sequence, so that what is in use would show what grows.
    scene.interactor->EnableRenderOn();
    scene.pen->Drop();
    scene.pen->GetStrokeRepresentation()->Clear();
    scene.style->ShowKeysOff();
    scene.style->ResetToFirstView();
    scene.window->SetSize(400, 300);
    scene.window->Render();
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || strokes > static_cast<int>(sequences.count)) << strokes;
  std::cout << strokes << " strokes, ";
  memory.print();
  EXPECT_LT(memory.growth(), memory.allowed()); // the graphics library keeps what it likes
}
