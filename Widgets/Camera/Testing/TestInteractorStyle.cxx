// Numbers of editors.md, section 13 (camera): a 400 x 400 window, parallel scale 1, unit sphere, camera at
// (0, 0, 10).
#include "Harness/interaction.h"
#include "Harness/sequences.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkActor.h"
#include "vtkCellPicker.h"
#include "vtkMath.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using namespace oversketch_test;

namespace
{

struct Scene : Window
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkActor> actor;
  vtkNew<vtkOversketchInteractorStyle> style;

  explicit Scene(bool parallel = true)
  {
    this->sphere->SetThetaResolution(64);
    this->sphere->SetPhiResolution(65);
    this->sphere->SetRadius(1.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->sphere->GetOutputPort());
    this->actor->SetMapper(mapper);
    this->renderer->AddActor(this->actor);
    this->camera()->SetParallelProjection(parallel);
    this->camera()->SetParallelScale(1.0);
    this->camera()->SetPosition(0.0, 0.0, 10.0);
    this->renderer->ResetCameraClippingRange();
    this->interactor->SetInteractorStyle(this->style);
    this->window->Render();
    this->interactor->EnableRenderOff(); // the camera is what is tested
  }

  std::vector<double> state()
  {
    vtkCamera* c = this->camera();
    std::vector<double> all{ c->GetViewAngle(), c->GetParallelScale() };
    for (const double* v : { c->GetPosition(), c->GetFocalPoint(), c->GetViewUp() })
    {
      all.insert(all.end(), v, v + 3);
    }
    return all;
  }
};

void expectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
  }
}

std::vector<double> three(const double* v)
{
  return { v[0], v[1], v[2] };
}

} // namespace

TEST(Camera, TheTrackballLogPutsItThere)
{
  Scene scene;
  scene.play("camera_turn.log");
  expectNear(three(scene.camera()->GetPosition()), { -5.0, 0.0, 10.0 * std::sqrt(0.75) }, 1e-12);
  expectNear(three(scene.camera()->GetFocalPoint()), { 0.0, 0.0, 0.0 }, 0.0);
  const auto at = scene.display({ 0.0, 0.0, 1.0 });
  EXPECT_NEAR(at[0], 300.0, 1e-9);
  EXPECT_NEAR(at[1], 200.0, 1e-9);
}

TEST(Camera, ThereAndBackRestoresIt)
{
  for (const bool parallel : { true, false })
  {
    Scene scene(parallel);
    const auto before = scene.state();
    scene.play("camera_turn_back.log");
    expectNear(scene.state(), before, 1e-12);
  }
}

TEST(Camera, ThePickedPointStaysUnderTheCursor)
{
  for (const bool parallel : { true, false })
  {
    Scene scene(parallel);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    double worst = 0.0;
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
    std::cout << (parallel ? "parallel" : "perspective") << ": picked point off the cursor by at most "
              << worst << " px\n";
    EXPECT_LT(worst, 1e-9);
  }
}

TEST(Camera, LargeMeshesArePickedAlike)
{
  // 80 x 80 makes the mesh small enough to be walked through, 200 x 200 large enough for a locator.
  for (const int resolution : { 80, 200 })
  {
    Scene scene;
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
    Scene scene(parallel);
    const auto direction = three(scene.camera()->GetDirectionOfProjection());
    scene.event(vtkCommand::RightButtonPressEvent, 200, 200);
    scene.move(251, 137);
    scene.event(vtkCommand::RightButtonReleaseEvent, 251, 137);
    const auto at = scene.display({ 0.0, 0.0, 1.0 });
    EXPECT_NEAR(at[0], 251.0, 1e-9);
    EXPECT_NEAR(at[1], 137.0, 1e-9);
    expectNear(three(scene.camera()->GetDirectionOfProjection()), direction, 0.0);
    // Beside the mesh the plane of the focal point follows.
    Scene beside(parallel);
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
      Scene scene(parallel);
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
  Scene scene;
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
    Scene scene(parallel);
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

TEST(Camera, ASideIsLookedFromUpright)
{
  Scene scene;
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
  Scene scene(false);
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
  Scene scene;
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
  Scene scene;
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

TEST(Camera, ZoomMultipliesTheApparentSize)
{
  for (const bool parallel : { true, false })
  {
    Scene scene(parallel);
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
}

TEST(Camera, AskingForTheZoomDoesNotFixTheFirstView)
{
  Scene scene;
  EXPECT_EQ(scene.style->GetZoom(), 1.0);
  scene.camera()->SetParallelScale(3.0); // the host's own
  EXPECT_EQ(scene.style->GetZoom(), 1.0);
  scene.style->SetZoom(2.0);
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.5, 1e-15);
  scene.key("w");
  EXPECT_EQ(scene.camera()->GetParallelScale(), 3.0);
}

TEST(Camera, TheDialSpins)
{
  Scene scene;
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
}

TEST(Keys, LookAlongTheAxes)
{
  Scene scene;
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
}

TEST(Keys, EachGoesWhereTheTableSays)
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
    Scene scene;
    Counter moved(scene.style, vtkCommand::InteractionEvent);
    scene.key(one.key, one.modifiers);
    expectNear(three(scene.camera()->GetPosition()), one.position, 1e-12);
    expectNear(three(scene.camera()->GetViewUp()), one.up, 1e-12);
    EXPECT_NEAR(scene.camera()->GetDistance(), 10.0, 1e-12);
    EXPECT_EQ(scene.camera()->GetParallelScale(), 1.0);
    EXPECT_EQ(moved.count, 1);
  }
  Scene scene;
  scene.key("n");
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.0 / 1.1, 1e-15);
  scene.key("p");
  EXPECT_NEAR(scene.camera()->GetParallelScale(), 1.0, 1e-15);
}

TEST(Keys, EachIsUndoneByItsReverse)
{
  for (const bool parallel : { true, false })
  {
    Scene scene(parallel);
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
  Scene scene;
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

TEST(Keys, VTKsOwnAreSwallowed)
{
  Scene scene;
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
}

TEST(Mode, DrawingNeverOrbits)
{
  Scene scene;
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
  Scene scene;
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
  const Sequences sequences = sequencesAsked(100);
  MemoryLevel memory(sequences);
  int moves = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    Scene scene(seed % 2 == 0);
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
