// The keys of the camera, its modes, and events in any order.
#include "Harness/sequences.h"
#include "style_scene.h"

#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using namespace oversketch_test;

TEST(B1_3, LookAlongTheAxes)
{
  StyleScene scene;
  const char* keys[] = { "x", "y", "z" };
  const char* capitals[] = { "X", "Y", "Z" };
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> along(3, 0.0), against(3, 0.0), up(3, 0.0);
    along[axis] = 1.0;
    against[axis] = -1.0;
    up[axis == 1 ? 2 : 1] = 1.0;
    for (const char* key : { keys[axis], capitals[axis] }) // Caps Lock is not Shift
    {
      scene.key(key);
      expectNear(three(scene.camera()->GetDirectionOfProjection()), along, 1e-15);
      scene.key(key, Shift);
      expectNear(three(scene.camera()->GetDirectionOfProjection()), against, 1e-15);
    }
    expectNear(three(scene.camera()->GetViewUp()), up, 0.0);
    EXPECT_NEAR(scene.camera()->GetDistance(), 10.0, 1e-14);
  }
  fact("B1_3", "x, y, z look along the axes, with Shift against them, within 1e-15");
}

TEST(B1_3, EachGoesWhereTheTableSays)
{
  const double s = std::sin(vtkMath::RadiansFromDegrees(5.0)), c = std::cos(vtkMath::RadiansFromDegrees(5.0));
  struct Case
  {
    const char* key;
    int modifiers;
    std::vector<double> position, up;
  };
  // Camera at (0, 0, 10), y up; a step of panning is 5 % of the height 2.
  const std::vector<Case> cases{
    { "r", 0, { 0, 0, 10 }, { s, c, 0 } }, // the picture turns counter-clockwise, the camera clockwise
    { "l", 0, { 0, 0, 10 }, { s, c, 0 } },
    { "r", Shift, { 0, 0, 10 }, { -s, c, 0 } },
    { "h", 0, { 0, 0, 10 }, { -s, c, 0 } },
    { "1", 0, { 0, 10 * s, 10 * c }, { 0, c, -s } },
    { "exclam", Shift, { 0, -10 * s, 10 * c }, { 0, c, s } },
    { "2", 0, { -10 * s, 0, 10 * c }, { 0, 1, 0 } },
    { "at", Shift, { 10 * s, 0, 10 * c }, { 0, 1, 0 } },
    { "3", 0, { 0, 0, 10 }, { s, c, 0 } },
    { "numbersign", Shift, { 0, 0, 10 }, { -s, c, 0 } },
    { "i", 0, { 0, 10 * s, 10 * c }, { 0, c, -s } },
    { "m", 0, { 0, -10 * s, 10 * c }, { 0, c, s } },
    { "j", 0, { -10 * s, 0, 10 * c }, { 0, 1, 0 } },
    { "k", 0, { 10 * s, 0, 10 * c }, { 0, 1, 0 } },
    { "I", Shift, { 0, 0.1, 10 }, { 0, 1, 0 } },
    { "M", Shift, { 0, -0.1, 10 }, { 0, 1, 0 } },
    { "J", Shift, { -0.1, 0, 10 }, { 0, 1, 0 } },
    { "K", Shift, { 0.1, 0, 10 }, { 0, 1, 0 } },
    { "H", Shift, { 0, 0, 9.9 }, { 0, 1, 0 } },
    { "L", Shift, { 0, 0, 10.1 }, { 0, 1, 0 } },
    { "P", Shift, { 0, 0, 9.9 }, { 0, 1, 0 } },
    { "N", Shift, { 0, 0, 10.1 }, { 0, 1, 0 } },
  };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(std::string(one.key) + (one.modifiers ? " with Shift" : ""));
    StyleScene scene;
    Counter moved(scene.style, vtkCommand::InteractionEvent);
    scene.key(one.key, one.modifiers);
    expectNear(three(scene.camera()->GetPosition()), one.position, 1e-12);
    expectNear(three(scene.camera()->GetViewUp()), one.up, 1e-12);
    EXPECT_NEAR(scene.camera()->GetDistance(), 10.0, 1e-12);
    EXPECT_EQ(scene.camera()->GetParallelScale(), 1.0);
    EXPECT_EQ(moved.count, 1);
  }
  StyleScene scene;
  scene.key("n");
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.0 / 1.1, 1e-15);
  scene.key("p");
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.0, 1e-15);
  // 1 and then the same key with Shift, r and then h: where it was; r and l are one.
  const auto before = scene.state();
  for (const auto& [there, back] : { std::pair("1", "exclam"), std::pair("r", "h"), std::pair("l", "h") })
  {
    scene.key(there);
    EXPECT_NE(scene.state(), before);
    scene.key(back, back[1] ? Shift : NoModifier);
    expectNear(scene.state(), before, 1e-12);
  }
  fact(
    "B1_3", std::to_string(cases.size()) + " keys go where the table says, 1, r and l are undone by theirs");
}

TEST(Keys, EachIsUndoneByItsReverse)
{
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    scene.camera()->Azimuth(20.0);
    scene.camera()->Elevation(10.0);
    scene.camera()->OrthogonalizeViewUp();
    const auto before = scene.state();
    scene.play("camera_keys_there_and_back.log");
    expectNear(scene.state(), before, 1e-12);
  }
}

TEST(Keys, ResetAndCentre)
{
  StyleScene scene;
  const auto first = scene.state();
  scene.play("camera_turn.log");
  scene.key("n");
  scene.key("r");
  scene.key("W", Shift); // has no Shift of its own
  expectNear(scene.state(), first, 0.0);
  EXPECT_EQ(scene.style->GetSpin(), 0.0);
  scene.actor->SetPosition(3.0, 4.0, 5.0);
  scene.key("c");
  expectNear(three(scene.camera()->GetFocalPoint()), { 3.0, 4.0, 5.0 }, 1e-6); // float points
  expectNear(three(scene.camera()->GetDirectionOfProjection()), { 0.0, 0.0, -1.0 }, 1e-12);
  EXPECT_NEAR(scene.camera()->GetDistance(), 10.0, 1e-12);
  scene.style->SaveFirstView();
  const auto second = scene.state();
  scene.key("x");
  scene.key("w");
  expectNear(scene.state(), second, 0.0);
}

TEST(B1_4, VTKsOwnAreSwallowed)
{
  StyleScene scene;
  vtkNew<vtkSliderWidget> slider;
  vtkNew<vtkSliderRepresentation2D> look;
  slider->SetInteractor(scene.interactor);
  slider->SetRepresentation(look);
  slider->On();
  const auto before = scene.state();
  for (const char* key : { "i", "m" }) // i would switch the slider off
  {
    scene.key(key);
    EXPECT_TRUE(slider->GetEnabled());
  }
  expectNear(scene.state(), before, 1e-12);
  Counter exits(scene.interactor, vtkCommand::ExitEvent);
  for (const char* key : { "e", "f", "u", "s", "t", "a", "6", "0" })
  {
    scene.key(key);
    scene.key(key, Shift);
  }
  scene.key("Escape");
  expectNear(scene.state(), before, 1e-12);
  EXPECT_EQ(exits.count, 0);
  scene.key("w");
  scene.key("3");
  EXPECT_EQ(scene.window->GetStereoRender(), 0);
  EXPECT_EQ(scene.actor->GetProperty()->GetRepresentation(), VTK_SURFACE);
  // With Ctrl or Alt a key is the host's.
  const auto here = scene.state();
  scene.key("z", Control);
  scene.key("x", Alt);
  scene.key("q", Control);
  expectNear(scene.state(), here, 0.0);
  EXPECT_EQ(exits.count, 0);
  scene.key("q");
  EXPECT_EQ(exits.count, 1);
  fact("B1_4", "i moves the camera alone and leaves widgets on; 3 makes no stereo, w no wireframe");
}

TEST(Mode, DrawingNeverOrbits)
{
  StyleScene scene;
  const auto before = scene.state();
  const auto leftDrag = [&](int modifiers)
  {
    scene.event(vtkCommand::LeftButtonPressEvent, 200, 200, modifiers);
    scene.move(250, 230, modifiers);
    scene.event(vtkCommand::LeftButtonReleaseEvent, 250, 230, modifiers);
    auto after = scene.state();
    scene.style->ResetToFirstView();
    return after;
  };
  scene.style->SetModeToDraw();
  EXPECT_EQ(leftDrag(NoModifier), before);
  const auto turned = leftDrag(Control);
  EXPECT_NE(turned, before);
  EXPECT_EQ(leftDrag(Alt), turned);
  const auto panned = leftDrag(Shift);
  EXPECT_NE(panned, before);
  EXPECT_EQ(leftDrag(Shift | Alt), panned);
  scene.style->SetModeToNavigate();
  EXPECT_EQ(leftDrag(NoModifier), turned);
}

TEST(Mode, OneDragAtATime)
{
  StyleScene scene;
  scene.event(vtkCommand::MiddleButtonPressEvent, 200, 200);
  scene.move(260, 200);
  const auto turned = scene.state();
  scene.event(vtkCommand::RightButtonPressEvent, 260, 200);
  scene.event(vtkCommand::LeftButtonPressEvent, 260, 200);
  scene.event(vtkCommand::MouseWheelForwardEvent, 260, 200);
  scene.key("x");
  scene.event(vtkCommand::RightButtonReleaseEvent, 260, 200);
  scene.event(vtkCommand::LeftButtonReleaseEvent, 260, 200);
  expectNear(scene.state(), turned, 0.0);
  scene.event(vtkCommand::MiddleButtonReleaseEvent, 260, 200);
  scene.move(100, 100);
  expectNear(scene.state(), turned, 0.0);
}

TEST(Random, EventsNeitherFailNorBreakTheCamera)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse{ vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent,
    vtkCommand::RightButtonPressEvent,
    vtkCommand::RightButtonReleaseEvent,
    vtkCommand::MouseWheelForwardEvent,
    vtkCommand::MouseWheelBackwardEvent,
    vtkCommand::EnterEvent,
    vtkCommand::LeaveEvent,
    vtkCommand::ExposeEvent,
    vtkCommand::ConfigureEvent };
  const std::vector<const char*> keys{ "r",
    "x",
    "y",
    "z",
    "1",
    "exclam",
    "2",
    "3",
    "w",
    "c",
    "h",
    "l",
    "i",
    "m",
    "j",
    "k",
    "p",
    "n",
    "question",
    "F1",
    "Escape",
    "BackSpace",
    "Q",
    "e",
    "f",
    "s",
    "u",
    "t",
    "0",
    "Shift_L",
    "" };
  const Sequences sequences = sequencesAsked(16);
  MemoryLevel memory(sequences);
  int moves = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    StyleScene scene(seed % 2 == 0);
    auto before = scene.state();
    for (int i = 0; i < 200; ++i)
    {
      const int x = below(480) - 40, y = below(480) - 40, modifiers = below(3) ? 0 : below(8);
      switch (below(10))
      {
        case 0:
        case 1:
        case 2:
        case 3:
          scene.move(x, y, modifiers);
          break;
        case 4:
        case 5:
        case 6:
          scene.event(mouse[below(mouse.size())], x, y, modifiers);
          break;
        case 7:
          scene.style->SetMode(below(2));
          break;
        default:
          scene.key(keys[below(keys.size())], modifiers, x, y);
      }
      const auto state = scene.state();
      ASSERT_TRUE(std::all_of(state.begin(), state.end(), [](double v) { return std::isfinite(v); })) << i;
      ASSERT_GT(scene.camera()->GetDistance(), 1.0) << i;
      moves += state != before;
      before = state;
    }
    if (seed % 3 == 0)
    {
      scene.interactor->SetInteractorStyle(nullptr); // perhaps in a drag
    }
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || moves > static_cast<int>(20 * sequences.count)) << moves;
  std::cout << moves << " moves of the camera, ";
  memory.print();
  EXPECT_LT(memory.growth(memoryKeptOfAWindow()), 4.0);
}
