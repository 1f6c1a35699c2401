// The pen that draws lines on a mesh: a ball in a window of 400 x 300 px, the line and the wheel by logs.
#include "Harness/live_window.h"
#include "ball_scene.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkTimerLog.h"

#include <cmath>
#include <functional>

using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

using Setting = std::function<void(vtkOversketchAugment*)>;

// What a system of its own makes of a mesh and a stroke.
vtkSmartPointer<vtkPolyData> made(vtkPolyData* mesh, vtkPolyData* stroke, const Setting& set = {})
{
  vtkNew<vtkOversketchAugment> system;
  if (set)
  {
    set(system);
  }
  system->SetInputData(0, mesh);
  system->SetInputData(1, copyOf(stroke));
  system->Update();
  EXPECT_EQ(system->GetErrorCode(), 0u);
  return copyOf(system->GetOutput());
}

// What the pen shows of a stroke, and the share of the lines' places that have its colour in a picture; where
// lines cross one of them is hidden.
struct Shown
{
  double crest = 0.0, feet = 0.0;
};
Shown shownOf(const Pixels& picture, vtkPolyData* mesh, vtkPolyData* stroke, const Setting& set = {})
{
  vtkNew<vtkOversketchAugment> system;
  if (set)
  {
    set(system);
  }
  vtkNew<vtkPolyData> crest;
  EXPECT_TRUE(system->PreviewCrest(copyOf(mesh), copyOf(stroke), crest));
  const oversketch::View view = oversketch::ViewOf(stroke);
  vtkDataArray* parts = crest->GetCellData()->GetArray("Part");
  double found[2] = { 0, 0 }, all[2] = { 0, 0 };
  for (vtkIdType line = 0; line < crest->GetNumberOfLines(); ++line)
  {
    vtkNew<vtkIdList> ids;
    crest->GetCellPoints(line, ids);
    const int kind = parts->GetComponent(line, 0) > 0.0;
    for (const vtkIdType id : *ids)
    {
      const oversketch::Vector3 at = view.toDisplay(oversketch::Vector3(crest->GetPoint(id)));
      bool orange = false;
      for (int dx = -1; dx <= 1; ++dx)
      {
        for (int dy = -1; dy <= 1; ++dy)
        {
          orange |= isOrange(pixel(
            picture, static_cast<int>(std::floor(at[0])) + dx, static_cast<int>(std::floor(at[1])) + dy));
        }
      }
      found[kind] += orange;
      all[kind] += 1.0;
    }
  }
  return { found[0] / all[0], found[1] / all[1] };
}

// Counts how often a step of the system runs.
Counter runsOf(Ball& scene, const char* step)
{
  return Counter(scene.system()->GetStep(step), vtkCommand::StartEvent);
}

} // namespace

TEST(AugmentWidget, CurveCrestAndFeetAreShownUnderThePenAndNoSceneIsDrawn)
{
  Ball scene;
  Counter starts(scene.widget, vtkCommand::StartInteractionEvent),
    moves(scene.widget, vtkCommand::InteractionEvent), ends(scene.widget, vtkCommand::EndInteractionEvent),
    changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.move(140, 200); // the hand comes
  Counter renders(scene.renderer, vtkCommand::StartEvent);
  scene.play("augment_line.log");
  EXPECT_EQ(renders.count, 0);
  EXPECT_EQ(starts.count, 1);
  EXPECT_GT(moves.count, 20);
  EXPECT_EQ(changes.count, 0);
  const Pixels during = scene.pixels();
  EXPECT_GT(scene.count(isRed), 200);
  EXPECT_GT(scene.count(isBlue), 20) << "the curve on the surface, a rim of the stroke";
  EXPECT_TRUE(identical(scene.widget->GetOutput(), scene.mesh));
  vtkNew<vtkPolyData> drawn;
  scene.widget->GetPen()->GetStrokeRepresentation()->GetPolyData(drawn);
  const Shown shown = shownOf(during, scene.mesh, drawn);
  EXPECT_GT(shown.crest, 0.99);
  EXPECT_GT(shown.feet, 0.9);

  scene.play("augment_up.log");
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(changes.count, 1);
  EXPECT_TRUE(scene.widget->IsNew());
  EXPECT_EQ(scene.count(isOrange), 0) << "the crest stays after the stroke";
  EXPECT_EQ(scene.count(isBlue), 0);
  EXPECT_GT(scene.count(isRed), 200) << "the stroke does not stay";
}

TEST(AugmentWidget, AfterTheReleaseTheMeshIsTheSystemsOwn)
{
  Ball scene;
  scene.drawLine();
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  const auto alone = made(scene.mesh, scene.widget->GetStroke());
  EXPECT_GT(alone->GetNumberOfPolys(), scene.mesh->GetNumberOfPolys());
  EXPECT_TRUE(identical(alone, scene.widget->GetOutput()));
}

// While the pen is on the mesh a sample costs its curve, nothing else; before the first one all is ready.
TEST(AugmentWidget, ASampleRunsTheCurvesAlone)
{
  Ball scene;
  Counter base = runsOf(scene, "Base"), curves = runsOf(scene, "Curves"), refine = runsOf(scene, "Refine"),
          snap = runsOf(scene, "Snap"), displace = runsOf(scene, "Displace");
  scene.move(140, 200);
  scene.move(141, 200);
  EXPECT_EQ(base.count, 1);
  const int ready = curves.count;
  for (int i = 0; i < 10; ++i)
  {
    scene.move(142 + i, 200);
  }
  EXPECT_EQ(curves.count, ready) << "a hand in the air costs work";
  scene.play("augment_line.log");
  EXPECT_EQ(base.count, 1);
  EXPECT_GT(curves.count, ready + 10);
  EXPECT_LT(curves.count, ready + 40);
  EXPECT_EQ(refine.count + snap.count + displace.count, 0);
  // Without frames no sample costs anything.
  scene.key("Escape");
  scene.release(0, 0);
  scene.interactor->EnableRenderOff();
  const int before = curves.count;
  scene.play("augment_line.log");
  EXPECT_LE(curves.count, before + 1);
}

TEST(AugmentWidget, WhatIsShownIsQuickOnAnyMesh)
{
  vtkNew<vtkLinearSubdivisionFilter> split;
  split->SetInputData(ball());
  split->SetNumberOfSubdivisions(3);
  split->Update();
  Ball scene(split->GetOutput());
  scene.move(140, 200);
  scene.move(141, 200);
  scene.drawLine();
  vtkNew<vtkPolyData> crest;
  std::vector<double> times;
  scene.system()->PreviewCrest(scene.mesh, scene.widget->GetStroke(), crest);
  for (int i = 0; i < 51; ++i)
  {
    const auto stroke = copyOf(scene.widget->GetStroke());
    const double start = vtkTimerLog::GetUniversalTime();
    ASSERT_TRUE(scene.system()->PreviewCrest(scene.mesh, stroke, crest));
    times.push_back(1000.0 * (vtkTimerLog::GetUniversalTime() - start));
  }
  std::nth_element(times.begin(), times.begin() + 25, times.end());
  fact("crest under the pen",
    std::to_string(scene.mesh->GetNumberOfPolys()) + " triangles, median " + std::to_string(times[25]) +
      " ms");
  EXPECT_LT(times[25], 20.0); // 1 on a machine that does nothing else, without a sanitizer
}

TEST(AugmentWidget, TheWheelChangesTheLiveStrokeAndThePlainOneTheCamera)
{
  Ball scene;
  scene.drawLine();
  const double diagonal = scene.mesh->GetLength(), radius = 0.03 * diagonal;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  const double zoom = scene.camera()->GetParallelScale();
  scene.wheel(2, Control);
  const double wide = 1.21 * radius;
  EXPECT_NEAR(scene.system()->GetRadius(), wide, 1e-12);
  EXPECT_EQ(changes.count, 2);
  EXPECT_TRUE(identical(made(scene.mesh,
                          scene.widget->GetStroke(),
                          [&](auto* system) { system->SetRadius(scene.system()->GetRadius()); }),
    scene.widget->GetOutput()));
  EXPECT_GT(
    scene.count([](const std::array<int, 3>& p) { return p[0] > 250 && p[1] > 250 && p[2] > 250; }), 40)
    << "no text says what it is now";
  // Half the radius, and tenths of it: through 0 to a groove.
  scene.wheel(1, Shift);
  EXPECT_NEAR(scene.system()->GetHeight(), 0.6 * wide, 1e-12);
  scene.wheel(-6, Shift);
  EXPECT_NEAR(scene.system()->GetHeight(), -0.1 * wide, 1e-12) << "0 would be half the radius";
  scene.wheel(-3, Shift);
  EXPECT_NEAR(scene.system()->GetHeight(), -0.4 * wide, 1e-12);
  EXPECT_TRUE(identical(made(scene.mesh,
                          scene.widget->GetStroke(),
                          [&](auto* system)
                          {
                            system->SetRadius(scene.system()->GetRadius());
                            system->SetHeight(scene.system()->GetHeight());
                          }),
    scene.widget->GetOutput()));
  EXPECT_EQ(scene.camera()->GetParallelScale(), zoom);
  // The camera's, and nobody's mesh.
  const auto before = copyOf(scene.widget->GetOutput());
  const int count = changes.count;
  scene.wheel(1, NoModifier);
  EXPECT_LT(scene.camera()->GetParallelScale(), zoom);
  scene.wheel(1, Control | Shift);
  EXPECT_EQ(changes.count, count);
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
}

TEST(AugmentWidget, WidthAndHeightHaveBounds)
{
  Ball scene;
  const double diagonal = scene.mesh->GetLength();
  for (const int way : { 1, -1 })
  {
    scene.wheel(200 * way, Control);
    EXPECT_NEAR(scene.system()->GetRadius(), way > 0 ? diagonal : 1e-3 * diagonal, 1e-12);
  }
  scene.wheel(200, Control);
  scene.wheel(-200, Shift);
  EXPECT_NEAR(scene.system()->GetHeight(), -diagonal, 1e-12);
}

TEST(AugmentWidget, InSilhouetteModeTheSketchIsTheHeight)
{
  Ball scene;
  scene.system()->SetSketchModeToSilhouette();
  scene.drawLine();
  const double zoom = scene.camera()->GetParallelScale(), height = scene.system()->GetHeight();
  scene.wheel(1, Shift);
  EXPECT_EQ(scene.system()->GetHeight(), height);
  EXPECT_LT(scene.camera()->GetParallelScale(), zoom);
  scene.wheel(1, Control);
  EXPECT_GT(scene.system()->GetRadius(), 0.0);
}

TEST(AugmentWidget, TheWheelInTheAirAndWhileItDraws)
{
  Ball scene;
  const double radius = 0.03 * scene.mesh->GetLength();
  scene.move(140, 200);
  scene.wheel(1, Control); // before there is any stroke
  EXPECT_NEAR(scene.system()->GetRadius(), 1.1 * radius, 1e-12);
  EXPECT_TRUE(identical(scene.widget->GetOutput(), scene.mesh));
  const double zoom = scene.camera()->GetParallelScale();
  Counter renders(scene.renderer, vtkCommand::StartEvent);
  scene.play("augment_line.log");
  vtkNew<vtkPolyData> drawn;
  scene.widget->GetPen()->GetStrokeRepresentation()->GetPolyData(drawn);
  scene.play("augment_wheel.log");
  scene.wheel(3, NoModifier); // swallowed
  EXPECT_EQ(renders.count, 0);
  EXPECT_EQ(scene.camera()->GetParallelScale(), zoom);
  const double wide = 1.1 * 1.21 * radius;
  EXPECT_NEAR(scene.system()->GetRadius(), wide, 1e-12);
  EXPECT_NEAR(scene.system()->GetHeight(), 0.8 * wide, 1e-12);
  const Setting now = [&](vtkOversketchAugment* system)
  {
    system->SetRadius(scene.system()->GetRadius());
    system->SetHeight(scene.system()->GetHeight());
  };
  const Pixels during = scene.pixels();
  EXPECT_GT(shownOf(during, scene.mesh, drawn, now).crest, 0.99);
  EXPECT_LT(shownOf(during, scene.mesh, drawn).crest, 0.5) << "the crest did not rise";
  scene.play("augment_up.log");
  EXPECT_TRUE(identical(made(scene.mesh, scene.widget->GetStroke(), now), scene.widget->GetOutput()));

  // A stroke that is dropped takes back what the wheel has done to it; the live one keeps its own.
  const auto first = copyOf(scene.widget->GetOutput());
  scene.press(150, 120);
  scene.move(250, 120);
  scene.play("augment_wheel.log");
  EXPECT_GT(scene.system()->GetRadius(), 1.2 * wide);
  scene.key("Escape");
  scene.release(250, 120);
  EXPECT_NEAR(scene.system()->GetRadius(), wide, 1e-12);
  EXPECT_NEAR(scene.system()->GetHeight(), 0.8 * wide, 1e-12);
  scene.window->Render();
  EXPECT_TRUE(identical(first, scene.widget->GetOutput()));
}

TEST(AugmentWidget, AMovedStrokeShowsItsCrestAndTheMeshComesWithTheRelease)
{
  Ball scene;
  scene.drawLine();
  const auto before = copyOf(scene.widget->GetOutput()), stroke = copyOf(scene.widget->GetStroke());
  scene.play("augment_drag.log");
  ASSERT_TRUE(scene.widget->IsMoving());
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
  vtkNew<vtkPolyData> moved;
  scene.widget->GetLiveStrokeRepresentation()->PutMoved(moved);
  EXPECT_NEAR(moved->GetPoint(0)[0], stroke->GetPoint(0)[0] + 10.0, 1e-9);
  EXPECT_NEAR(moved->GetPoint(0)[1], stroke->GetPoint(0)[1] - 40.0, 1e-9);
  EXPECT_GT(shownOf(scene.pixels(), scene.mesh, moved).crest, 0.9);
  scene.key("Escape");
  EXPECT_EQ(scene.count(isOrange), 0);
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
  scene.release(212, 159);

  scene.play("augment_drag.log");
  scene.wheel(1, Shift);
  scene.play("augment_drop.log");
  EXPECT_FALSE(scene.widget->IsMoving());
  EXPECT_FALSE(scene.widget->IsNew());
  EXPECT_EQ(scene.count(isOrange), 0);
  EXPECT_TRUE(identical(made(scene.mesh,
                          scene.widget->GetStroke(),
                          [&](auto* system) { system->SetHeight(scene.system()->GetHeight()); }),
    scene.widget->GetOutput()));
  EXPECT_FALSE(identical(before, scene.widget->GetOutput()));
}

TEST(AugmentWidget, APartIsDrawnAnew)
{
  Ball scene;
  scene.drawLine();
  expectAPartIsDrawnAnew(scene, copyOf(scene.widget->GetStroke()), "augment_over.log", 4.0, 12.0);
  EXPECT_TRUE(identical(made(scene.mesh, scene.widget->GetStroke()), scene.widget->GetOutput()));
}

TEST(AugmentWidget, TheNextStrokeIsDrawnOnWhatTheLastOneMade)
{
  Ball scene;
  scene.drawLine();
  const auto first = copyOf(scene.widget->GetOutput());
  const auto drawSecond = [&]
  {
    scene.press(170, 100);
    for (int i = 1; i <= 20; ++i)
    {
      scene.move(170 + 3 * i, 100 + i);
    }
    scene.release(230, 120);
  };
  drawSecond();
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  const auto second = copyOf(scene.widget->GetOutput());
  EXPECT_TRUE(identical(made(first, scene.widget->GetStroke()), second));
  // The wheel is the second's alone.
  scene.wheel(2, Shift);
  EXPECT_TRUE(identical(made(first,
                          scene.widget->GetStroke(),
                          [&](auto* system) { system->SetHeight(scene.system()->GetHeight()); }),
    scene.widget->GetOutput()));
  scene.key("Escape");
  EXPECT_TRUE(identical(first, scene.widget->GetOutput()));
  drawSecond();
  scene.key("Return");
  EXPECT_EQ(scene.widget->GetStroke()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.count(isRed), 0);
}

TEST(AugmentWidget, AStrokeBesideTheMeshSaysSoAndStaysToBeCorrected)
{
  Ball scene;
  Counter messages(scene.widget, vtkCommand::MessageEvent);
  Quiet quiet;
  scene.press(20, 20);
  for (int x = 24; x <= 90; x += 4)
  {
    scene.move(x, 20);
  }
  scene.release(90, 20);
  EXPECT_EQ(messages.count, 1);
  EXPECT_NE(std::string(scene.widget->GetMessage()), "");
  EXPECT_TRUE(identical(scene.mesh, scene.widget->GetOutput()));
  EXPECT_GT(scene.count(isRed), 50) << "the stroke is gone";
  // Dragged onto the ball it rises, and the message goes.
  scene.move(55, 20);
  scene.press(55, 20);
  scene.move(200, 150);
  EXPECT_GT(scene.count(isOrange), 20);
  scene.release(200, 150);
  EXPECT_STREQ(scene.widget->GetMessage(), "");
  EXPECT_FALSE(identical(scene.mesh, scene.widget->GetOutput()));
  EXPECT_EQ(messages.count, 1);
  EXPECT_EQ(quiet.errors(), 0);
}

TEST(AugmentWidget, DrawingSwallowsWhatItUses)
{
  vtkNew<vtkInteractorStyleTrackballCamera> stock;
  for (const bool own : { true, false })
  {
    Ball scene;
    if (!own)
    {
      scene.widget->Off();
      scene.interactor->SetInteractorStyle(stock);
      scene.widget->On();
    }
    const auto seen = [&]
    { return std::make_pair(scene.camera()->GetPosition()[0], scene.camera()->GetParallelScale()); };
    const auto start = seen();
    Counter keys(scene.interactor, vtkCommand::CharEvent);
    scene.play("augment_line.log");
    for (const char* key : { "x", "w", "q", "b", "r" })
    {
      scene.key(key);
    }
    scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
    scene.move(240, 170);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 240, 170);
    scene.wheel(2, NoModifier);
    scene.play("augment_up.log");
    scene.wheel(1, Control);
    scene.wheel(1, Shift);
    scene.play("augment_drag.log");
    scene.wheel(1, NoModifier);
    scene.key("x");
    scene.play("augment_drop.log");
    EXPECT_EQ(seen(), start);
    EXPECT_EQ(keys.count, 0) << "characters reached others while the pen was down";
    scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
    scene.move(230, 160);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 230, 160);
    EXPECT_NE(seen().first, start.first);
  }
}
