// Zoom slider and spin dial, in the pen's scene: a window of 400 x 300 px, the dial's centre at (355, 45),
// the slider from (355, 100) to (355, 200).
#include "../../Pen/Testing/pen_scene.h"
#include "Harness/sequences.h"
#include "vtkOversketchCameraRepresentation.h"
#include "vtkOversketchCameraWidget.h"

#include "vtkInteractorStyleTrackballCamera.h"

#include <array>
#include <cmath>
#include <iostream>
#include <random>

using namespace oversketch_test;

namespace
{

struct Controls : Pen
{
  vtkSmartPointer<vtkOversketchCameraWidget> controls = vtkSmartPointer<vtkOversketchCameraWidget>::New();

  Controls()
  {
    this->controls->SetInteractor(this->interactor);
    this->controls->On();
    this->window->Render();
  }
  double width() { return this->display({ 0.1, 0.0, 0.0 })[0] - this->display({ 0.0, 0.0, 0.0 })[0]; }
};

} // namespace

TEST(Controls, TheLogSpinsAQuarterAndDoubles)
{
  Controls scene;
  const double before = scene.width();
  Counter starts(scene.controls, vtkCommand::StartInteractionEvent),
    moves(scene.controls, vtkCommand::InteractionEvent),
    ends(scene.controls, vtkCommand::EndInteractionEvent),
    strokes(scene.pen, vtkCommand::StartInteractionEvent);
  scene.play("camera_controls.log");
  EXPECT_NEAR(scene.style->GetSpin(), 90.0, 1e-12);
  EXPECT_NEAR(scene.style->GetZoom(), std::pow(10.0, 0.3), 1e-12); // 15 of 50 px a decade
  scene.style->SetSpin(0.0);
  EXPECT_NEAR(scene.width(), std::pow(10.0, 0.3) * before, 1e-9);
  EXPECT_EQ(starts.count, 2);
  EXPECT_EQ(moves.count, 9 + 3);
  EXPECT_EQ(ends.count, 2);
  EXPECT_EQ(strokes.count, 0) << "a drag on the controls drew";
}

TEST(Controls, OnceRoundIsWhereItWas)
{
  Controls scene;
  const std::vector<double> up(scene.camera()->GetViewUp(), scene.camera()->GetViewUp() + 3);
  scene.press(355, 75);
  for (int degrees = 5; degrees <= 360; degrees += 5)
  {
    const double a = degrees * M_PI / 180.0;
    scene.move(static_cast<int>(std::lround(355 - 1000 * std::sin(a))),
      static_cast<int>(std::lround(45 + 1000 * std::cos(a))));
    EXPECT_NEAR(std::remainder(scene.style->GetSpin() - degrees, 360.0), 0.0, 0.1); // whole pixels
  }
  scene.release(355, 1045);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(scene.camera()->GetViewUp()[i], up[i], 1e-12);
  }
}

TEST(Controls, APressAloneChangesNothingAndEscapeGoesBack)
{
  Controls scene;
  scene.style->SetSpin(30.0);
  scene.style->SetZoom(2.0);
  const double spin = scene.style->GetSpin(), zoom = scene.style->GetZoom();
  for (const int y : { 60, 120 }) // on the dial, on the slider
  {
    scene.press(355, y);
    scene.release(355, y);
    EXPECT_EQ(scene.style->GetSpin(), spin);
    EXPECT_EQ(scene.style->GetZoom(), zoom);
    scene.press(355, y);
    scene.move(340, y + 7);
    EXPECT_TRUE(scene.style->GetSpin() != spin || scene.style->GetZoom() != zoom);
    scene.key("x"); // not in mid-drag
    scene.event(vtkCommand::MouseWheelForwardEvent, 340, y);
    scene.key("Escape");
    EXPECT_NEAR(scene.style->GetSpin(), spin, 1e-12);
    EXPECT_NEAR(scene.style->GetZoom(), zoom, 1e-12);
    EXPECT_NEAR(scene.camera()->GetDirectionOfProjection()[2], -1.0, 1e-12);
    scene.move(300, 200);
    EXPECT_NEAR(scene.style->GetSpin(), spin, 1e-12);
    scene.release(300, 200);
  }
  // The ends of the slider are the ends of the range.
  scene.press(355, 150);
  scene.move(355, 290);
  EXPECT_NEAR(scene.style->GetZoom(), 10.0, 1e-12);
  scene.move(355, 5);
  EXPECT_NEAR(scene.style->GetZoom(), 0.1, 1e-12);
  scene.release(355, 5);
}

TEST(Controls, TheyShowWhatKeysChange)
{
  Controls scene;
  scene.camera()->SetPosition(0.0, 0.0, 1000.0); // nothing but the controls is to be seen
  const auto isKnob = [&](int x, int y) { return scene.pixels()[3 * (400 * y + x)] < 0.2 * 255; };
  scene.window->Render();
  EXPECT_TRUE(isKnob(355, 75));
  EXPECT_TRUE(isKnob(355, 150));
  for (int i = 0; i < 18; ++i)
  {
    scene.key("r");
  }
  scene.style->SetZoom(10.0);
  EXPECT_TRUE(isKnob(325, 45)); // a quarter counter-clockwise
  EXPECT_FALSE(isKnob(355, 75));
  EXPECT_TRUE(isKnob(355, 200));
  EXPECT_FALSE(isKnob(355, 150));
}

TEST(Controls, BesideThemThePenDraws)
{
  Controls scene;
  scene.drawLine(60, 320, 45);
  EXPECT_EQ(scene.samples().size(), 66u);
  // Under another style they are not there to be pressed.
  vtkNew<vtkInteractorStyleTrackballCamera> stock;
  scene.interactor->SetInteractorStyle(stock);
  scene.window->Render();
  scene.drawLine(340, 380, 45);
  EXPECT_EQ(scene.samples().size(), 11u);
}

TEST(Random, EventsOnTheControls)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse{ vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent,
    vtkCommand::MouseWheelForwardEvent,
    vtkCommand::ConfigureEvent };
  const std::vector<const char*> keys{ "Escape", "BackSpace", "x", "w", "r", "i", "question" };
  const Sequences sequences = sequencesAsked(16);
  MemoryLevel memory(sequences);
  int turns = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    Controls scene;
    scene.interactor->EnableRenderOff();
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    std::array<double, 2> before{ scene.style->GetSpin(), scene.style->GetZoom() };
    for (int i = 0; i < 200; ++i)
    {
      const bool on = below(3) > 0; // mostly where the controls are
      const int x = on ? 320 + below(70) : below(400), y = on ? below(210) : below(300);
      switch (below(8))
      {
        case 0:
          scene.key(keys[below(keys.size())], below(2), x, y);
          break;
        case 1:
        case 2:
          scene.event(mouse[below(mouse.size())], x, y, below(4) ? 0 : below(8));
          break;
        case 3:
          below(10) ? void() : scene.controls->SetEnabled(below(2));
          break;
        default:
          scene.move(x, y);
      }
      const std::array<double, 2> now{ scene.style->GetSpin(), scene.style->GetZoom() };
      turns += now != before;
      before = now;
      ASSERT_TRUE(std::isfinite(scene.style->GetSpin()));
      ASSERT_GE(scene.style->GetZoom(), 0.1 - 1e-12);
      ASSERT_LE(scene.style->GetZoom(), 10.0 + 1e-12);
    }
    switch (seed % 4)
    {
      case 0:
        scene.controls = nullptr;
        break; // perhaps in a drag
      case 1:
        scene.controls->SetInteractor(nullptr);
        break;
      case 2:
        scene.interactor->SetInteractorStyle(nullptr);
        break;
      default:
        break;
    }
    scene.move(350, 150);
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || turns > static_cast<int>(10 * sequences.count)) << turns;
  std::cout << turns << " changes of spin or zoom, ";
  memory.print();
  EXPECT_LT(memory.growth(memoryKeptOfAWindow()), 4.0);
}
