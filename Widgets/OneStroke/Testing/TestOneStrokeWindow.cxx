// The pen that deforms a mesh in windows that change and go, and under events in any order, on a small mesh.
#include "Harness/live_window.h"
#include "dog_scene.h"

#include "vtkSphereSource.h"

#include <array>
#include <cmath>

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
  expectItMayGoInMidDrag<Dog>(ball(), shippedModel("dog"), drawOverBall);
}

TEST(OneStrokeWindow, AnObserverMayLetGoOfIt)
{
  expectAnObserverMayLetGoOfIt<Dog>(ball(), drawOverBall);
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
  // That turned to the stroke's view, where as much is seen across the smaller side, 400 px for 300.
  const int inView[2] = { int(200 + (first[0] - 200) * 4 / 3), int(300 + (first[1] - 150) * 4 / 3) };
  EXPECT_LT(line->DistanceTo(inView[0], inView[1]), 3.0);
  scene.press(inView[0], inView[1]);
  scene.move(inView[0] + 12, inView[1]);
  scene.release(inView[0] + 12, inView[1]);
  EXPECT_NEAR(scene.widget->GetStroke()->GetPoint(0)[0], first[0] + 9.0, 1e-9);
}

TEST(Random, EventsOnTheOneStrokeWidget)
{
#ifdef __SANITIZE_ADDRESS__
  constexpr double most = 8.0; // small blocks take several times their size
#else
  constexpr double most = 4.0;
#endif
  expectItWithstandsEvents<Dog>(
    ball(),
    { vtkCommand::MouseWheelForwardEvent },
    [](Dog& scene, unsigned seed) { scene.widget->GetOneStroke()->SetRemesh(static_cast<int>(seed % 3)); },
    drawOverBall,
    [](Dog& scene, const auto& below) { scene.widget->GetOneStroke()->SetRemesh(below(3)); },
    most);
}
