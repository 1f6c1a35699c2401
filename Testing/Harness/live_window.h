// A widget that holds a live stroke over a mesh, in windows that change and go, and under events in any
// order: what is asked of each in the same way. A scene is a Window with such a `widget`. Header-only.
#ifndef oversketch_testing_harness_live_window_h
#define oversketch_testing_harness_live_window_h

#include "Harness/interaction.h"
#include "Harness/sequences.h"
#include "Harness/windows.h"

#include "Stroke/polyline.h"
#include "vtkOversketchFilterTools.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace oversketch_test
{

// It goes, or what it needs does, while its stroke is dragged; `draw(scene)` draws one, `other` is another
// mesh.
template <class Scene, class Draw>
void expectItMayGoInMidDrag(vtkPolyData* mesh, vtkPolyData* other, const Draw& draw)
{
  expectItMayGo<Scene>(
    &Scene::widget,
    [&](Scene& scene)
    {
      draw(scene);
      ASSERT_STREQ(scene.widget->GetMessage(), "");
      const double* p = scene.widget->GetStroke()->GetPoint(7);
      const int x = int(p[0]), y = int(p[1]);
      scene.move(x, y);
      scene.press(x, y);
      scene.move(x + 5, y + 5);
      ASSERT_TRUE(scene.widget->IsMoving());
    },
    { [&](Scene& scene) { scene.widget->SetInputData(other); }, [](Scene& scene) { scene.widget->Drop(); } },
    mesh);
}

// The log draws a part of the live stroke `first` anew: its ends stay, and the new part is off it by so many
// pixels at most.
template <class Scene>
void expectAPartIsDrawnAnew(Scene& scene, vtkPolyData* first, const char* log, double least, double most)
{
  scene.play(log);
  EXPECT_FALSE(scene.widget->IsNew());
  const oversketch::Polyline old = oversketch::StrokeOf(first);
  const oversketch::Polyline now = oversketch::StrokeOf(scene.widget->GetStroke());
  EXPECT_EQ(now.front(), old.front());
  EXPECT_EQ(now.back(), old.back());
  const oversketch::NearestPlace nearest(old);
  double off = 0.0;
  for (const oversketch::Vector2& place : now)
  {
    off = std::max(off, nearest(place).distance);
  }
  EXPECT_GT(off, least);
  EXPECT_LT(off, most);
}

template <class Scene, class Draw>
void expectAnObserverMayLetGoOfIt(vtkPolyData* mesh, const Draw& draw)
{
  expectAnObserverMayLetGo<Scene>(&Scene::widget, draw, mesh);
}

// One event of a random hand; `change(scene, below)` sets a parameter of the system at random.
template <class Scene, class Below, class Change>
void randomEvent(Scene& scene,
  vtkPolyData* start,
  const std::vector<unsigned long>& mouse,
  const Below& below,
  const Change& change)
{
  const std::vector<const char*> keys{ "Escape", "BackSpace", "Return", "o", "x", "w", "r", "question", "q" };
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
          change(scene, below);
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
}

// Lets go of all buttons: then the widget holds nothing, draws, and its mesh is one.
template <class Scene>
void expectItRests(Scene& scene)
{
  letGoOfAllButtons(scene);
  scene.widget->GetPen()->CancelStroke();
  ASSERT_FALSE(scene.widget->IsMoving());
  expectItDraws(scene);
  vtkPolyData* mesh = scene.widget->GetOutput();
  ASSERT_GT(mesh->GetNumberOfPolys(), 0); // strokes across the ball, remeshed, may leave few
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    ASSERT_TRUE(std::isfinite(mesh->GetPoint(p)[0] + mesh->GetPoint(p)[1] + mesh->GetPoint(p)[2]));
  }
}

// Sequences of 200 events of a random hand, each on a scene of its own, in which `begin(scene, seed)` sets
// what depends on the sequence; every second one begins with a stroke. `wheel`: its events, as often as they
// are to come.
template <class Scene, class Begin, class Draw, class Change>
void expectItWithstandsEvents(vtkPolyData* start,
  const std::vector<unsigned long>& wheel,
  const Begin& begin,
  const Draw& draw,
  const Change& change,
  double most = 4.0)
{
  Quiet quiet;
  const Sequences sequences = sequencesAsked(20);
  MemoryLevel memory(sequences);
  const std::vector<unsigned long> mouse = mouseEvents(wheel);
  int strokes = 0, grabs = 0;
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    Scene scene(start);
    begin(scene, seed);
    Counter commits(scene.widget, vtkCommand::WidgetValueChangedEvent);
    std::mt19937 random(seed);
    const auto below = [&](size_t n) { return static_cast<int>(random() % n); };
    scene.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    if (seed % 2 == 0)
    {
      draw(scene);
    }
    for (int i = 0; i < 200; ++i)
    {
      randomEvent(scene, start, mouse, below, change);
      grabs += scene.widget->IsMoving();
    }
    expectItRests(scene);
    if (testing::Test::HasFatalFailure())
    {
      return;
    }
    strokes += commits.count;
  }
  EXPECT_EQ(quiet.errors(), 0);
  EXPECT_TRUE(!sequences.areMany() || strokes > static_cast<int>(sequences.count)) << strokes;
  EXPECT_TRUE(!sequences.areMany() || grabs > static_cast<int>(sequences.count)) << grabs;
  std::cout << strokes << " changes, " << grabs << " events in a drag, ";
  memory.print();
  EXPECT_LT(memory.growth(memoryKeptOfAWindow()), most);
}

} // namespace oversketch_test
#endif
