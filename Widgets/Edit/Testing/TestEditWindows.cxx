// The widgets of the edit in windows that change and go, and under events in any order.
#include "Harness/windows.h"
#include "Shading/layer_list.h"
#include "edit_widget_scene.h"
#include "widget_scenes.h"

#include <functional>
#include <iostream>
#include <random>

using namespace oversketch_test;

namespace
{

template <class Scene>
void expectItMayGoAfter(const std::string& log)
{
  expectItMayGo<Scene>(&Scene::widget, [&](Scene& scene) { scene.play(log); }, {});
}

template <class Scene>
void expectAnObserverMayLetGoIn(const std::vector<std::string>& logs)
{
  expectAnObserverMayLetGo<Scene>(&Scene::widget,
    [&](Scene& scene)
    {
      for (const std::string& log : logs)
      {
        scene.play(log);
      }
    });
}

using Below = std::function<int(std::size_t)>;

// Sequences of 200 events of a random hand, every second one after the logs; `change` does what a host may.
template <class Scene>
void expectItWithstandsHands(const std::vector<std::string>& logs,
  const std::function<void(Scene&, const Below&)>& change,
  const std::function<void(Scene&)>& judge)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse =
    mouseEvents({ vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent });
  const std::vector<const char*> keys{
    "Escape", "BackSpace", "Delete", "Return", "6", "7", "0", "x", "w", "r", "question", "q"
  };
  Scene scene;
  const Sequences sequences = sequencesAsked(12);
  MemoryLevel memory(sequences);
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent),
    moves(scene.widget, vtkCommand::InteractionEvent);
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Below below = [&](std::size_t n) { return static_cast<int>(random() % n); };
    scene.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    for (std::size_t i = 0; seed % 2 == 0 && i < logs.size(); ++i)
    {
      scene.play(logs[i]);
    }
    for (int i = 0; i < 200; ++i)
    {
      // Near the middle, where there is something, as often as anywhere.
      const bool near = below(2) != 0;
      const int x = near ? 120 + below(160) : below(480) - 40, y = near ? 90 + below(120) : below(380) - 40;
      const int modifiers = below(4) ? 0 : below(8);
      switch (below(10))
      {
        case 0:
          scene.key(keys[static_cast<std::size_t>(below(keys.size()))], modifiers, x, y);
          break;
        case 1:
        case 2:
        case 3:
          scene.event(mouse[static_cast<std::size_t>(below(mouse.size()))], x, y, modifiers);
          break;
        case 4:
          switch (below(4))
          {
            case 0:
              scene.widget->SetEnabled(below(3) != 0);
              break;
            case 1:
              scene.window->SetSize(300 + below(2) * 100, 300);
              break;
            case 2:
              scene.window->Render();
              break;
            default:
              change(scene, below);
          }
          break;
        default:
          scene.move(x, y, modifiers);
      }
    }
    letGoOfAllButtons(scene);
    judge(scene);
    expectItDraws(scene);
    if (testing::Test::HasFailure())
    {
      return;
    }
    // The same state after each sequence, so that what is in use would show what grows.
    scene.interactor->EnableRenderOn();
    scene.widget->On();
    scene.style->ShowKeysOff();
    scene.window->SetSize(400, 300);
    scene.reset();
    scene.window->Render();
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || 2 * changes.count > static_cast<int>(sequences.count)) << changes.count;
  std::cout << changes.count << " changes, " << moves.count << " events in a drag, ";
  memory.print();
  EXPECT_LT(memory.growth(), 4.0);
}

} // namespace

TEST(EditWindows, EachGoesAwayInMidDragInAnyOrder)
{
  expectItMayGoAfter<RegionScene>("region_pen_down.log");
  expectItMayGoAfter<AxisScene>("axis_line_drag.log");
  expectItMayGoAfter<LayerScene>("layer_drag.log");
  expectItMayGoAfter<AreaScene>("region_pen_down.log");
  expectItMayGoAfter<ProfileScene>("profile_slide.log");
}

TEST(EditWindows, AnObserverMayLetGoOfEach)
{
  expectAnObserverMayLetGoIn<RegionScene>({ "region_line.log" });
  expectAnObserverMayLetGoIn<AxisScene>({ "axis_line_drag.log", "axis_drop.log" });
  expectAnObserverMayLetGoIn<LayerScene>({ "layer_drag.log", "layer_drop.log" });
  expectAnObserverMayLetGoIn<AreaScene>({ "area_star.log" });
  expectAnObserverMayLetGoIn<ProfileScene>({ "profile_slide.log", "profile_let_go.log" });
}

TEST(EditWindows, TheProfilesWindowMayGoFirst)
{
  Quiet quiet;
  vtkSmartPointer<vtkOversketchProfilePlaneWidget> widget;
  {
    ProfileScene scene;
    scene.drawBump(0.1);
    widget = scene.widget;
    widget->SetInteractor(nullptr);
  }
  widget->SetProfileAt(0.3);
  widget->SetProfileRenderer(nullptr);
  EXPECT_EQ(quiet.errors(), 0);
}

TEST(Random, EventsOnTheRegionWidget)
{
  expectItWithstandsHands<RegionScene>(
    { "region_line.log", "region_ring.log" },
    [](RegionScene& scene, const Below& below)
    {
      below(2) ? scene.widget->GetPen()->CancelStroke()
               : scene.widget->SetModel(below(2) ? scene.mesh.Get() : nullptr);
    },
    [](RegionScene& scene)
    {
      scene.widget->GetPen()->CancelStroke();
      ASSERT_TRUE(scene.widget->HasReference() || !scene.widget->HasBoundary());
    });
}

TEST(Random, EventsOnTheAxisHandleWidget)
{
  expectItWithstandsHands<AxisScene>(
    { "axis_place.log", "axis_line_drag.log", "axis_drop.log" },
    [](AxisScene& scene, const Below& below)
    {
      switch (below(3))
      {
        case 0:
          scene.widget->AddHandle(0.1 * below(11));
          break;
        case 1:
          scene.widget->SetOperations(below(2) ? "rotate 0.4 w 30; scale 0.7 n 2" : "");
          break;
        default:
          scene.widget->SetCurve(below(4) ? scene.region.line.Get() : nullptr, scene.region.mesh());
      }
    },
    [](AxisScene& scene)
    {
      ASSERT_FALSE(scene.widget->IsDragging());
      scene.region.system->SetOperations(scene.widget->GetOperations());
      const std::string text = scene.widget->GetOperations();
      scene.widget->SetOperations("");
      scene.widget->SetOperations(text.c_str()); // it is understood
      ASSERT_EQ(text, scene.widget->GetOperations());
    });
}

TEST(Random, EventsOnTheLayerHandleWidget)
{
  expectItWithstandsHands<LayerScene>(
    { "layer_drag.log", "layer_drop.log" },
    [](LayerScene& scene, const Below& below)
    {
      switch (below(4))
      {
        case 0:
          scene.shown()->SetArea(below(3) - 1);
          break;
        case 1:
          scene.shown()->SetSide(below(2));
          break;
        case 2:
          scene.shown()->SetLevels(2 + below(9));
          break;
        default:
          scene.widget->SetRegion(below(4) ? scene.region.mesh() : nullptr);
      }
    },
    [](LayerScene& scene)
    {
      ASSERT_FALSE(scene.widget->IsDragging());
      const oversketch::LayerList list = oversketch::layerList(scene.widget->GetLayers());
      ASSERT_NO_THROW(oversketch::Layers(5, list.handles));
      scene.shown()->SetArea(-1);
      scene.shown()->SetSideToDisc();
      scene.widget->SetRegion(scene.region.mesh());
    });
}

TEST(Random, EventsOnTheAreaSelectWidget)
{
  expectItWithstandsHands<AreaScene>(
    { "area_star.log" },
    [](AreaScene& scene, const Below& below)
    {
      below(2) ? scene.shown()->SetSide(below(2))
               : void(scene.widget->SetRegion(below(4) ? scene.region.mesh() : nullptr));
    },
    [](AreaScene& scene)
    {
      scene.widget->GetPen()->CancelStroke();
      ASSERT_LE(scene.areas()->GetNumberOfLines(), 64);
      scene.shown()->SetSideToDisc();
    });
}

TEST(Random, EventsOnTheProfilePlaneWidget)
{
  expectItWithstandsHands<ProfileScene>(
    { "profile_slide.log", "profile_let_go.log" },
    [](ProfileScene& scene, const Below& below)
    {
      switch (below(5))
      {
        case 0:
          scene.widget->SetProfileAt(0.1 * below(11));
          break;
        case 1:
          scene.drawBump(0.1 * below(4));
          scene.flat.key(below(3) ? "Return" : "Escape");
          break;
        case 2:
          scene.flat.event(vtkCommand::LeftButtonPressEvent, below(400), below(300));
          break;
        case 3:
          scene.flat.move(below(400), below(300));
          break;
        default:
          scene.flat.event(vtkCommand::LeftButtonReleaseEvent, below(400), below(300));
      }
    },
    [](ProfileScene& scene)
    {
      scene.flat.event(vtkCommand::LeftButtonReleaseEvent, 0, 0);
      ASSERT_FALSE(scene.widget->IsDragging());
      ASSERT_GE(scene.widget->GetProfileAt(), 0.0);
      ASSERT_LE(scene.widget->GetProfileAt(), 1.0);
    });
}

namespace
{

// A region is drawn, and a handle placed on its line.
struct HandleScene : EditScene
{
  HandleScene()
  {
    this->drawBoth();
    this->placeHandle();
  }
};

} // namespace

TEST(EditWindows, TheEditGoesAwayInMidDragInAnyOrder)
{
  expectItMayGo<HandleScene>(&EditScene::widget,
    [](HandleScene& scene)
    {
      scene.play("axis_drag.log");
      ASSERT_TRUE(scene.widget->IsPreviewing());
    },
    { [](HandleScene& scene) { scene.widget->SetInputData(editBall()); },
      [](HandleScene& scene) { scene.widget->SetModeToShade(); },
      [](HandleScene& scene) { scene.widget->Drop(); } });
}

TEST(EditWindows, AfterADragThatWasBrokenOffNothingIsPreviewed)
{
  for (const bool off : { true, false })
  {
    HandleScene scene;
    scene.play("axis_drag.log");
    ASSERT_TRUE(scene.widget->IsPreviewing());
    off ? scene.widget->Off() : scene.widget->SetModeToShade();
    scene.move(210, 160);
    scene.release(210, 160);
    EXPECT_FALSE(scene.widget->IsPreviewing());
  }
}

TEST(EditWindows, AnObserverMayLetGoOfTheEdit)
{
  expectAnObserverMayLetGo<HandleScene>(&EditScene::widget,
    [](HandleScene& scene)
    {
      scene.play("axis_drag.log");
      scene.release(200, 185);
    });
}

TEST(Random, EventsOnTheEditWidget)
{
  expectItWithstandsHands<EditScene>(
    { "region_line.log", "region_ring.log" },
    [](EditScene& scene, const Below& below)
    {
      switch (below(6))
      {
        case 0:
        case 1:
        case 2:
          scene.widget->SetMode(below(5));
          break;
        case 3:
          scene.widget->SetShowRegion(below(2) != 0);
          break;
        case 4:
          scene.system()->SetOperations(below(2) ? "move 0.4 n 0.1; pin 0.9" : "");
          break;
        default:
          below(3) ? scene.widget->Drop() : scene.widget->Commit();
      }
    },
    [](EditScene& scene)
    {
      scene.widget->GetRegionWidget()->GetPen()->CancelStroke();
      scene.widget->GetAreaSelectWidget()->GetPen()->CancelStroke();
      ASSERT_FALSE(scene.widget->IsPreviewing());
      for (vtkIdType p = 0; p < scene.output()->GetNumberOfPoints(); ++p)
      {
        const double* at = scene.output()->GetPoint(p);
        ASSERT_TRUE(std::isfinite(at[0] + at[1] + at[2]));
      }
    });
}
