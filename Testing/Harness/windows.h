// A widget in a window, while that, its owner or what it needs goes, and after hands that do anything: what
// is asked of each in the same way. A scene is a Window with such a widget, its member `held`. Header-only.
#ifndef oversketch_testing_harness_windows_h
#define oversketch_testing_harness_windows_h

#include "Harness/interaction.h"

#include "vtkRendererCollection.h"

#include <functional>
#include <vector>

namespace oversketch_test
{

// In the midst of what `begin(scene)` begins the widget goes, or what it needs does, then in `further` ways;
// last its window, and the scene as a whole. Scenes are made of `given`.
template <class Scene, class Held, class Begin, class... Given>
void expectItMayGo(Held held,
  const Begin& begin,
  const std::vector<std::function<void(Scene&)>>& further,
  const Given&... given)
{
  Quiet quiet;
  std::vector<std::function<void(Scene&)>> ways{ [&](Scene& scene) { (scene.*held)->Off(); },
    [&](Scene& scene) { scene.*held = nullptr; },
    [&](Scene& scene) { (scene.*held)->SetInteractor(nullptr); },
    [&](Scene& scene) { (scene.*held)->SetRepresentation(nullptr); } };
  ways.insert(ways.end(), further.begin(), further.end());
  for (std::size_t way = 0; way < ways.size(); ++way)
  {
    SCOPED_TRACE(way);
    Scene scene(given...);
    begin(scene);
    ways[way](scene);
    scene.move(210, 160);
    scene.window->Render();
    scene.event(vtkCommand::LeftButtonReleaseEvent, 210, 160);
    EXPECT_TRUE(scene.renderer->GetDraw());
  }
  for (const bool windowAlone : { true, false })
  {
    Scene scene(given...);
    begin(scene);
    if (windowAlone)
    {
      scene.interactor->SetRenderWindow(nullptr);
      (scene.*held)->Off();
    }
  }
  EXPECT_EQ(quiet.errors(), 0);
}

// Who hears of what `act(scene)` does lets go of the widget.
template <class Scene, class Held, class Act, class... Given>
void expectAnObserverMayLetGo(Held held, const Act& act, const Given&... given)
{
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent })
  {
    Scene scene(given...);
    std::function<void()> letGo = [&] { scene.*held = nullptr; };
    vtkNew<vtkCallbackCommand> drop;
    drop->SetClientData(&letGo);
    drop->SetCallback(
      [](vtkObject*, unsigned long, void* go, void*) { (*static_cast<std::function<void()>*>(go))(); });
    (scene.*held)->AddObserver(event, drop);
    act(scene);
    EXPECT_EQ(scene.*held, nullptr) << event;
    scene.window->Render();
    EXPECT_TRUE(scene.renderer->GetDraw());
  }
}

// What a random hand does with the mouse, each as often as it stands there; `more` beside buttons and edges.
inline std::vector<unsigned long> mouseEvents(const std::vector<unsigned long>& more)
{
  std::vector<unsigned long> events{ vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::LeftButtonReleaseEvent,
    vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent,
    vtkCommand::RightButtonPressEvent,
    vtkCommand::RightButtonReleaseEvent };
  events.insert(events.end(), more.begin(), more.end());
  events.insert(events.end(), { vtkCommand::LeaveEvent, vtkCommand::ConfigureEvent });
  return events;
}

// All buttons are let go of; then what was drawn over the window is gone.
template <class Scene>
void letGoOfAllButtons(Scene& scene)
{
  for (const unsigned long up : { vtkCommand::LeftButtonReleaseEvent,
         vtkCommand::MiddleButtonReleaseEvent,
         vtkCommand::RightButtonReleaseEvent })
  {
    scene.event(up, 0, 0);
  }
}

template <class Scene>
void expectItDraws(Scene& scene)
{
  EXPECT_TRUE(scene.renderer->GetDraw());
  EXPECT_EQ(scene.window->GetRenderers()->GetNumberOfItems(), 1);
}

} // namespace oversketch_test
#endif
