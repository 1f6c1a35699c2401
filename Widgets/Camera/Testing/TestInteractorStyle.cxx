// How the hand turns, pans and zooms: numbers of editors.md, section 13 (camera).
#include "style_scene.h"

#include "vtkCellPicker.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace oversketch_test;

TEST(B1_1, TheTrackballLogPutsItThere)
{
  StyleScene scene;
  scene.play("camera_turn.log");
  expectNear(three(scene.camera()->GetPosition()), { -5.0, 0.0, 10.0 * std::sqrt(0.75) }, 1e-12);
  expectNear(three(scene.camera()->GetFocalPoint()), { 0.0, 0.0, 0.0 }, 0.0);
  const auto at = scene.display({ 0.0, 0.0, 1.0 });
  EXPECT_NEAR(at[0], 300.0, 1e-9);
  EXPECT_NEAR(at[1], 200.0, 1e-9);
  const double* eye = scene.camera()->GetPosition();
  fact("B1_1",
    "camera at (" + std::to_string(eye[0]) + ", " + std::to_string(eye[1]) + ", " + std::to_string(eye[2]) +
      "), the picked point at (" + std::to_string(at[0]) + ", " + std::to_string(at[1]) + ") px");
}

TEST(B1_2, ThereAndBackRestoresIt)
{
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    const auto before = scene.state();
    scene.play("camera_turn_back.log");
    expectNear(scene.state(), before, 1e-12);
  }
  fact("B1_2", "there and back: the camera within 1e-12, in parallel and in perspective");
}

TEST(B1_2, ThePickedPointStaysUnderTheCursor)
{
  double worst = 0.0;
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int drag = 0; drag < 20; ++drag)
    {
      const double radius = parallel ? 190.0 : 70.0; // px: both ends on the sphere
      const auto place = [&]
      {
        const double r = radius * std::sqrt(part(random)), angle = 2.0 * vtkMath::Pi() * part(random);
        return std::array<int, 2>{ int(200.0 + r * std::cos(angle)), int(200.0 + r * std::sin(angle)) };
      };
      const auto from = place();
      // Where the press's line of sight meets the mesh.
      vtkNew<vtkCellPicker> picker;
      picker->SetTolerance(0.0);
      ASSERT_TRUE(picker->Pick(from[0], from[1], 0.0, scene.renderer));
      const std::array<double, 3> picked{
        picker->GetPickPosition()[0], picker->GetPickPosition()[1], picker->GetPickPosition()[2]
      };
      const auto pressed = scene.display(picked);
      scene.event(vtkCommand::MiddleButtonPressEvent, from[0], from[1]);
      for (int i = 0; i < 10; ++i)
      {
        const auto to = place();
        // A point of a facet lies a little inside the sphere, on which not every place is.
        scene.move(to[0], to[1]);
        const auto at = scene.display(picked);
        worst = std::max(worst,
          std::hypot(at[0] - to[0], at[1] - to[1]) - std::hypot(pressed[0] - from[0], pressed[1] - from[1]));
      }
      scene.event(vtkCommand::MiddleButtonReleaseEvent, 0, 0);
    }
    EXPECT_LT(worst, 1e-9) << (parallel ? "parallel" : "perspective");
  }
  fact("B1_2",
    "40 drags over a sphere, half in perspective: the picked point off the cursor by at most " +
      std::to_string(static_cast<int>(std::ceil(1e12 * worst))) + "e-12 px");
}

TEST(Camera, LargeMeshesArePickedAlike)
{
  // 80 x 80 makes the mesh small enough to be walked through, 200 x 200 large enough for a locator.
  for (const int resolution : { 80, 200 })
  {
    StyleScene scene;
    scene.sphere->SetThetaResolution(resolution);
    scene.sphere->SetPhiResolution(resolution + 1);
    scene.interactor->EnableRenderOn();
    scene.window->Render();
    const auto before = scene.state();
    scene.play("camera_turn.log");
    expectNear(three(scene.camera()->GetPosition()), { -5.0, 0.0, 10.0 * std::sqrt(0.75) }, 1e-12);
    scene.style->ResetToFirstView();
    // The mesh changes in place: half the radius, so beside (300, 300) there is nothing any more.
    scene.sphere->SetRadius(0.5);
    scene.window->Render();
    scene.event(vtkCommand::MiddleButtonPressEvent, 300, 300);
    scene.move(200, 200);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 200, 200);
    // So the ball about its box turns, of the radius 0.5 times the root of 3.
    const double third = 10.0 / std::sqrt(3.0);
    expectNear(three(scene.camera()->GetPosition()), { third, third, third }, 1e-6);
    scene.style->ResetToFirstView();
    expectNear(scene.state(), before, 0.0);
  }
}

TEST(Camera, PanKeepsThePickedPointUnderTheCursor)
{
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    const auto direction = three(scene.camera()->GetDirectionOfProjection());
    scene.event(vtkCommand::RightButtonPressEvent, 200, 200);
    scene.move(251, 137);
    scene.event(vtkCommand::RightButtonReleaseEvent, 251, 137);
    const auto at = scene.display({ 0.0, 0.0, 1.0 });
    EXPECT_NEAR(at[0], 251.0, 1e-9);
    EXPECT_NEAR(at[1], 137.0, 1e-9);
    expectNear(three(scene.camera()->GetDirectionOfProjection()), direction, 0.0);
    // Beside the mesh the plane of the focal point follows.
    StyleScene beside(parallel);
    beside.camera()->SetParallelScale(2.0);
    const auto before = beside.display({ 0.0, 0.0, 0.0 });
    beside.event(vtkCommand::LeftButtonPressEvent, 2, 2, Shift);
    beside.move(12, 32, Shift);
    const auto after = beside.display({ 0.0, 0.0, 0.0 });
    EXPECT_NEAR(after[0] - before[0], 10.0, 1e-9);
    EXPECT_NEAR(after[1] - before[1], 30.0, 1e-9);
  }
}

TEST(Camera, ATurnBesideTheMeshIsAboutItsMiddle)
{
  for (const bool parallel : { true, false })
  {
    for (const int orbit :
      { vtkOversketchInteractorStyle::Trackball, vtkOversketchInteractorStyle::Turntable })
    {
      StyleScene scene(parallel);
      scene.style->SetOrbit(orbit);
      scene.actor->SetPosition(0.2, -0.1, 0.3);
      scene.camera()->SetFocalPoint(0.0, 0.0, 1.0);
      const auto before = scene.state();
      const auto middle = scene.display({ 0.2, -0.1, 0.3 });
      Counter started(scene.style, vtkCommand::StartInteractionEvent);
      scene.event(vtkCommand::MiddleButtonPressEvent, 2, 2);
      scene.move(90, 40);
      EXPECT_NE(scene.state(), before);
      const auto after = scene.display({ 0.2, -0.1, 0.3 });
      EXPECT_NEAR(after[0], middle[0], 1e-6);
      EXPECT_NEAR(after[1], middle[1], 1e-6);
      scene.move(2, 2);
      expectNear(scene.state(), before, 1e-12);
      scene.event(vtkCommand::MiddleButtonReleaseEvent, 2, 2);
      EXPECT_EQ(started.count, 1);
    }
  }
}

TEST(Camera, ATurntableKeepsTheHorizonAndStopsAtThePoles)
{
  StyleScene scene;
  scene.style->SetOrbitToTurntable();
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 399);
  for (int drag = 0; drag < 20; ++drag)
  {
    scene.event(vtkCommand::MiddleButtonPressEvent, place(random), place(random));
    scene.move(place(random), place(random));
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 0, 0);
    double right[3];
    vtkMath::Cross(scene.camera()->GetDirectionOfProjection(), scene.camera()->GetViewUp(), right);
    EXPECT_NEAR(right[1], 0.0, 1e-9);
    EXPECT_GE(scene.camera()->GetViewUp()[1], -1e-9);
  }
  scene.style->ResetToFirstView();
  // The whole height from the front is half a turn, and there is a quarter to the pole.
  scene.event(vtkCommand::MiddleButtonPressEvent, 5, 395);
  scene.move(5, 5);
  scene.event(vtkCommand::MiddleButtonReleaseEvent, 5, 5);
  expectNear(three(scene.camera()->GetPosition()), { 0.0, 10.0, 0.0 }, 1e-9);
  // 60 px on the model are 27 degrees in a view of 400, whatever is under the cursor.
  scene.style->ResetToFirstView();
  scene.event(vtkCommand::MiddleButtonPressEvent, 200, 200);
  scene.move(260, 200);
  const double* direction = scene.camera()->GetDirectionOfProjection();
  EXPECT_NEAR(vtkMath::DegreesFromRadians(std::atan2(direction[0], -direction[2])), 27.0, 1e-9);
  scene.event(vtkCommand::MiddleButtonReleaseEvent, 260, 200);
}

TEST(Camera, TheWheelKeepsWhatIsUnderTheCursorAndTheEye)
{
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    const auto eye = three(scene.camera()->GetPosition());
    const std::array<double, 3> place{ 0.4, 0.3, 0.5 };
    const auto before = scene.display(place);
    const int x = int(std::lround(before[0])), y = int(std::lround(before[1]));
    for (int notch = 0; notch < 5; ++notch)
    {
      scene.event(vtkCommand::MouseWheelForwardEvent, x, y);
    }
    const auto after = scene.display(place);
    const double grown = std::pow(1.1, 5);
    EXPECT_NEAR(after[0] - x, grown * (before[0] - x), 1e-6);
    EXPECT_NEAR(after[1] - y, grown * (before[1] - y), 1e-6);
    expectNear(three(scene.camera()->GetPosition()), eye, 0.0);
    // A press changes nothing; a turn then takes the picked point along, and Escape is the way back.
    const auto zoomed = scene.state();
    scene.event(vtkCommand::MiddleButtonPressEvent, x, y);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, x, y);
    expectNear(scene.state(), zoomed, 0.0);
    scene.event(vtkCommand::MiddleButtonPressEvent, x, y);
    scene.move(x + 20, y);
    EXPECT_EQ(scene.camera()->GetWindowCenter()[0], 0.0);
    scene.key("Escape");
    expectNear(scene.state(), zoomed, 0.0);
    scene.style->ResetToFirstView();
    EXPECT_EQ(scene.camera()->GetWindowCenter()[0], 0.0);
    EXPECT_EQ(scene.display(place), before);
  }
}

TEST(Camera, ItFollowsTheSizeOfItsView)
{
  const int square[2] = { 400, 400 }, narrow[2] = { 200, 400 }, wide[2] = { 800, 400 };
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    scene.style->SetZoom(2.0);
    scene.camera()->SetWindowCenter(0.5, 0.25);
    const auto first = scene.state();
    const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * first[0]));
    EXPECT_TRUE(scene.style->FollowSize(square, narrow));
    EXPECT_NEAR(scene.camera()->GetParallelScale(), 2.0 * first[1], 1e-12);
    EXPECT_NEAR(
      std::tan(vtkMath::RadiansFromDegrees(0.5 * scene.camera()->GetViewAngle())), 2.0 * tangent, 1e-12);
    EXPECT_NEAR(scene.camera()->GetWindowCenter()[0], 0.5, 1e-12); // of a width that is as it was
    EXPECT_NEAR(scene.camera()->GetWindowCenter()[1], 0.125, 1e-12);
    EXPECT_NEAR(scene.style->GetZoom(), 2.0, 1e-12);
    // Of one that is wider than high the height stays, and the middle.
    EXPECT_TRUE(scene.style->FollowSize(narrow, wide));
    expectNear(scene.state(), first, 1e-12);
    EXPECT_NEAR(scene.camera()->GetWindowCenter()[0], 0.25, 1e-12);
    EXPECT_TRUE(scene.style->FollowSize(wide, square));
    expectNear(scene.state(), first, 1e-12);
    // Not in the middle of a drag.
    scene.event(vtkCommand::MiddleButtonPressEvent, 200, 200);
    EXPECT_FALSE(scene.style->FollowSize(square, narrow));
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 200, 200);
    EXPECT_TRUE(scene.style->FollowSize(square, narrow));
  }
}

TEST(Camera, ASideIsLookedFromUpright)
{
  StyleScene scene;
  scene.actor->SetPosition(1.0, 2.0, 3.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool negative : { false, true })
    {
      scene.style->LookFromSide(axis, negative);
      std::vector<double> eye{ 1.0, 2.0, 3.0 };
      eye[axis] += negative ? -10.0 : 10.0;
      expectNear(three(scene.camera()->GetPosition()), eye, 1e-9);
      expectNear(three(scene.camera()->GetFocalPoint()), { 1.0, 2.0, 3.0 }, 1e-9);
      expectNear(three(scene.camera()->GetViewUp()),
        axis == 1 ? std::vector<double>{ 0.0, 0.0, negative ? 1.0 : -1.0 }
                  : std::vector<double>{ 0.0, 1.0, 0.0 },
        1e-9);
    }
  }
}

TEST(Camera, TheProjectionChangesAndTheSizeStays)
{
  StyleScene scene(false);
  scene.style->SetZoom(2.0);
  const auto before = scene.state();
  const auto size = [&] { return scene.display({ 0.1, 0.0, 0.0 })[0] - scene.display({ 0.0, 0.0, 0.0 })[0]; };
  const double wide = size();
  scene.style->SetParallelProjection(true);
  EXPECT_TRUE(scene.camera()->GetParallelProjection());
  EXPECT_NEAR(size(), wide, 1e-9);
  EXPECT_NEAR(scene.style->GetZoom(), 2.0, 1e-12);
  scene.style->SetZoom(1.0);
  EXPECT_NEAR(size(), 0.5 * wide, 1e-9);
  scene.style->SetZoom(2.0);
  scene.style->SetParallelProjection(false);
  EXPECT_FALSE(scene.camera()->GetParallelProjection());
  EXPECT_NEAR(scene.camera()->GetViewAngle(), before[0], 1e-9);
  EXPECT_NEAR(size(), wide, 1e-9);
}

TEST(Camera, GesturesTurnPanAndZoom)
{
  StyleScene scene;
  const std::array<double, 3> place{ 0.0, 0.0, 1.0 };
  const auto before = scene.display(place);
  scene.style->PanBy(30.0, -20.0);
  EXPECT_NEAR(scene.display(place)[0] - before[0], 30.0, 1e-9);
  EXPECT_NEAR(scene.display(place)[1] - before[1], -20.0, 1e-9);
  scene.style->ResetToFirstView();
  scene.style->TurnBy(100.0, 0.0); // an eighth of a turn
  EXPECT_NEAR(scene.display(place)[0] - before[0], 200.0 * std::sqrt(0.5), 1e-9);
  scene.style->ResetToFirstView();
  const auto state = scene.state();
  for (const double factor : { 0.0, -1.0, std::nan("") })
  {
    scene.style->ZoomAt(factor, 100.0, 100.0);
    expectNear(scene.state(), state, 0.0);
  }
}

TEST(Camera, EscapeTakesADragBack)
{
  StyleScene scene;
  const auto before = scene.state();
  for (const int modifiers : { int(NoModifier), int(Shift), int(Control) })
  {
    scene.event(vtkCommand::MiddleButtonPressEvent, 210, 220, modifiers);
    scene.move(300, 100, modifiers);
    EXPECT_NE(scene.state(), before);
    scene.key("Escape");
    expectNear(scene.state(), before, 0.0);
    scene.move(100, 100);
    expectNear(scene.state(), before, 0.0);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 100, 100);
  }
}

TEST(B1_5, ZoomMultipliesTheApparentSize)
{
  for (const bool parallel : { true, false })
  {
    StyleScene scene(parallel);
    const auto length = [&] {
      return scene.display({ 0.1, 0.0, 0.5 })[0] - scene.display({ 0.0, 0.0, 0.5 })[0];
    };
    const double before = length();
    scene.style->SetZoom(2.0);
    EXPECT_NEAR(length(), 2.0 * before, 1e-9);
    EXPECT_NEAR(scene.style->GetZoom(), 2.0, 1e-14);
    if (!parallel)
    {
      EXPECT_NEAR(scene.camera()->GetViewAngle(), 15.2615, 5e-5); // vtkCamera::Zoom makes 15
    }
    scene.style->SetZoom(100.0);
    EXPECT_NEAR(length(), 10.0 * before, 1e-9);
    scene.style->SetZoom(0.0);
    EXPECT_NEAR(length(), 0.1 * before, 1e-9);
    scene.style->SetZoom(1.0);
    EXPECT_NEAR(length(), before, 1e-9);
    scene.event(vtkCommand::MouseWheelForwardEvent, 200, 200);
    EXPECT_NEAR(length(), 1.1 * before, 1e-9);
    scene.event(vtkCommand::MouseWheelBackwardEvent, 200, 200);
    EXPECT_NEAR(length(), before, 1e-9);
    // The height of the view is a decade; up makes larger.
    scene.event(vtkCommand::LeftButtonPressEvent, 200, 100, Control | Shift);
    scene.move(200, 300);
    EXPECT_NEAR(length(), std::sqrt(10.0) * before, 1e-9);
    scene.event(vtkCommand::LeftButtonReleaseEvent, 200, 300);
  }
  fact("B1_5", "z = 2 doubles a length in the picture within 1e-9 px, in parallel and in perspective");
}

TEST(Camera, AskingForTheZoomDoesNotFixTheFirstView)
{
  StyleScene scene;
  EXPECT_EQ(scene.style->GetZoom(), 1.0);
  scene.camera()->SetParallelScale(3.0); // the host's own
  EXPECT_EQ(scene.style->GetZoom(), 1.0);
  scene.style->SetZoom(2.0);
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.5, 1e-15);
  scene.key("w");
  EXPECT_EQ(scene.camera()->GetParallelScale(), 3.0);
}

TEST(B1_5, TheDialSpins)
{
  StyleScene scene;
  scene.style->SetSpin(90.0);
  // Counter-clockwise: what was up points left.
  EXPECT_LT(scene.display({ 0.0, 0.5, 0.0 })[0], 150.0);
  scene.style->SetSpin(180.0);
  expectNear(three(scene.camera()->GetViewUp()), { 0.0, -1.0, 0.0 }, 1e-14);
  expectNear(three(scene.camera()->GetPosition()), { 0.0, 0.0, 10.0 }, 1e-14);
  scene.style->SetSpin(360.0);
  expectNear(three(scene.camera()->GetViewUp()), { 0.0, 1.0, 0.0 }, 1e-14);
  EXPECT_EQ(scene.style->GetSpin(), 0.0);
  scene.style->SetSpin(-5.0);
  EXPECT_EQ(scene.style->GetSpin(), 355.0);
  fact("B1_5", "the dial at 180 turns the view's up round, at 360 it is as it was, within 1e-14");
}
