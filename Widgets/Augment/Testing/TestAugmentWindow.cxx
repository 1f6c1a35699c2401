// The pen that draws lines on a mesh in windows that change and go, and under events in any order.
#include "Harness/live_window.h"
#include "ball_scene.h"

using namespace oversketch_test;

namespace
{

void drawOnBall(Ball& scene)
{
  scene.drawLine();
}

} // namespace

TEST(AugmentWindow, GoesAwayInMidDragInAnyOrder)
{
  expectItMayGoInMidDrag<Ball>(ball(), shippedModel("bear"), drawOnBall);
}

TEST(AugmentWindow, AnObserverMayLetGoOfIt)
{
  expectAnObserverMayLetGoOfIt<Ball>(ball(), drawOnBall);
}

TEST(Random, EventsOnTheAugmentWidget)
{
  expectItWithstandsEvents<Ball>(
    ball(),
    { vtkCommand::MouseWheelForwardEvent,
      vtkCommand::MouseWheelForwardEvent,
      vtkCommand::MouseWheelBackwardEvent,
      vtkCommand::MouseWheelBackwardEvent },
    [](Ball& scene, unsigned seed) { scene.system()->SetSketchMode(seed % 5 == 0); },
    drawOnBall,
    [](Ball& scene, const auto& below) { scene.system()->SetHeight(0.02 * (below(9) - 4)); });
}
