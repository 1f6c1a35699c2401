// The pen that deforms a mesh: the shipped dog in a window of 400 x 300 px, the leg drawn longer by a log.
#include "Harness/interaction.h"
#include "Harness/live_window.h"
#include "Harness/shipped.h"
#include "dog_scene.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchMatch.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInteractorStyleTrackballCamera.h"

#include <cmath>

using namespace oversketch_test;

namespace
{

// What a system of its own makes of a mesh and a stroke.
vtkSmartPointer<vtkPolyData> made(vtkPolyData* mesh, vtkPolyData* stroke, int remesh = 0)
{
  vtkNew<vtkOversketchOneStroke> system;
  system->SetBackendToHost();
  system->SetRemesh(remesh);
  system->SetInputData(0, mesh);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(stroke);
  system->SetInputData(1, copy);
  system->Update();
  EXPECT_EQ(system->GetErrorCode(), 0u);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(system->GetOutput());
  return result;
}

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

} // namespace

TEST(OneStrokeWidget, TheSectionIsShownUnderThePenAndNoSceneIsDrawn)
{
  Dog scene;
  Counter starts(scene.widget, vtkCommand::StartInteractionEvent),
    moves(scene.widget, vtkCommand::InteractionEvent), ends(scene.widget, vtkCommand::EndInteractionEvent),
    changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  EXPECT_EQ(scene.count(isBlue), 0);
  scene.move(251, 125); // the hand comes
  Counter renders(scene.renderer, vtkCommand::StartEvent);
  scene.play("pen_dog_leg.log");
  EXPECT_EQ(renders.count, 0);
  EXPECT_EQ(starts.count, 1);
  EXPECT_GT(moves.count, 20);
  EXPECT_EQ(changes.count, 0);
  const Pixels during = scene.pixels();
  EXPECT_TRUE(identical(scene.widget->GetOutput(), scene.mesh));
  scene.play("pen_up.log");
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(changes.count, 1);
  EXPECT_TRUE(scene.widget->IsNew());
  // What was blue is what the system took hold of.
  vtkPolyData* section = scene.widget->GetOneStroke()->GetInnerOutput("Match");
  vtkDataArray* places = section->GetPointData()->GetArray("Display");
  ASSERT_GT(places->GetNumberOfTuples(), 30);
  int blue = 0, red = 0;
  for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
  {
    const int x = static_cast<int>(places->GetComponent(i, 0)),
              y = static_cast<int>(places->GetComponent(i, 1));
    blue += isBlue(during, x, y);
    red += isRed(during, x, y);
  }
  EXPECT_GT(blue + red, 0.98 * static_cast<double>(places->GetNumberOfTuples()));
  EXPECT_GT(blue, 0.3 * static_cast<double>(places->GetNumberOfTuples()));
  EXPECT_EQ(scene.count(isBlue), 0) << "the section stays after the stroke";
  EXPECT_GT(scene.count(isRed), 100) << "the stroke does not stay";
}

TEST(OneStrokeWidget, AfterTheReleaseTheMeshIsTheSystemsOwn)
{
  Dog scene;
  scene.drawLeg();
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  const auto alone = made(scene.mesh, scene.widget->GetStroke());
  EXPECT_GT(largestMove(alone, scene.mesh), 0.1);
  EXPECT_TRUE(identical(alone, scene.widget->GetOutput()));
  auto* port = scene.widget->GetOutputPort();
  EXPECT_EQ(port->GetProducer()->GetOutputDataObject(port->GetIndex()), scene.widget->GetOutput());
}

TEST(OneStrokeWidget, ADragIsAPreviewAndTheReleaseTheFullPath)
{
  Dog scene;
  scene.widget->GetOneStroke()->SetRemeshToOff();
  scene.drawLeg();
  const auto before = copyOf(scene.widget->GetOutput()), stroke = copyOf(scene.widget->GetStroke());
  vtkOversketchOneStroke* system = scene.widget->GetOneStroke();
  auto* step = vtkOversketchLaplacianDeform::SafeDownCast(system->GetStep(system->GetDeformationName()));
  const auto handles = copyOf(vtkPolyData::SafeDownCast(step->GetInputDataObject(1, 0)));
  const auto region = copyOf(vtkPolyData::SafeDownCast(step->GetInputDataObject(0, 0)));
  const double weight = step->GetHandleWeight();

  scene.play("one_stroke_drag.log");
  ASSERT_TRUE(scene.widget->IsMoving());
  const double* t = scene.widget->GetTranslation();
  // 10 px to the right and 10 down, in a window of 300 px that shows 120 / 47.
  const double expected = 10.0 * (120.0 / 47.0) / 300.0;
  EXPECT_NEAR(t[0], expected, 1e-12);
  EXPECT_NEAR(t[1], -expected, 1e-12);
  EXPECT_NEAR(t[2], 0.0, 1e-12);
  vtkDataArray* targets = handles->GetPointData()->GetArray("Target");
  vtkDataArray* ratios = handles->GetPointData()->GetArray("MergeRatio");
  for (vtkIdType i = 0; i < targets->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      targets->SetComponent(i, k, targets->GetComponent(i, k) + ratios->GetComponent(i, 0) * t[k]);
    }
  }
  vtkNew<vtkOversketchLaplacianDeform> moved;
  moved->SetHandleWeight(weight);
  moved->SetInputData(0, region);
  moved->SetInputData(1, handles);
  moved->Update();
  EXPECT_LT(largestMove(moved->GetOutput(), scene.widget->GetOutput()), 1e-5);
  EXPECT_GT(largestMove(before, scene.widget->GetOutput()), 0.8 * expected);

  scene.play("one_stroke_drop.log");
  EXPECT_FALSE(scene.widget->IsMoving());
  EXPECT_FALSE(scene.widget->IsNew());
  vtkPolyData* now = scene.widget->GetStroke();
  ASSERT_EQ(now->GetNumberOfPoints(), stroke->GetNumberOfPoints());
  for (vtkIdType i = 0; i < now->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(now->GetPoint(i)[0], stroke->GetPoint(i)[0] + 10.0, 1e-9);
    EXPECT_NEAR(now->GetPoint(i)[1], stroke->GetPoint(i)[1] - 10.0, 1e-9);
  }
  EXPECT_TRUE(identical(made(scene.mesh, now, vtkOversketchOneStroke::RemeshOff), scene.widget->GetOutput()));
}

// The longer leg's line pulled away by 60 px: drawn there it would take hold of another part, dragged it
// keeps its own, and what was seen on the way is what comes.
TEST(OneStrokeWidget, ADragKeepsItsSection)
{
  Dog scene;
  vtkOversketchOneStroke* system = scene.widget->GetOneStroke();
  system->SetRemeshToOff();
  scene.drawLeg();
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  const auto before = copyOf(system->GetInnerOutput("Match"));
  const auto drag = [&](int x, int y)
  {
    scene.move(283, 67);
    scene.press(283, 67);
    for (int i = 1; i <= 10; ++i)
    {
      scene.move(283 + i * x / 10, 67 + i * y / 10);
    }
  };
  drag(60, -20);
  const auto preview = copyOf(scene.widget->GetOutput());
  scene.release(343, 47);
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  vtkPolyData* held = system->GetInnerOutput("Match");
  ASSERT_EQ(held->GetNumberOfPoints(), before->GetNumberOfPoints());
  EXPECT_LT(largestMove(held, before), 1e-12);
  const double pixel = (120.0 / 47.0) / 300.0;
  const double apart = largestMove(preview, scene.widget->GetOutput()) / pixel;
  EXPECT_LT(apart, 3.0);
  fact("drag", "preview and release apart by " + std::to_string(apart) + " px");
  vtkDataArray* moved = scene.widget->GetStroke()->GetCellData()->GetArray("Moved");
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->GetComponent(0, 0), 60.0, 1e-9);
  EXPECT_NEAR(moved->GetComponent(0, 1), -20.0, 1e-9);

  // The same line, drawn there.
  vtkNew<vtkPolyData> drawn;
  drawn->DeepCopy(scene.widget->GetStroke());
  drawn->GetCellData()->RemoveArray("Moved");
  vtkNew<vtkPolyData> there;
  vtkNew<vtkOversketchOneStroke> other;
  const bool found = other->Preview(scene.mesh, drawn, there);
  EXPECT_FALSE(
    found && there->GetNumberOfPoints() == before->GetNumberOfPoints() && largestMove(there, before) < pixel);
}

TEST(OneStrokeWidget, EscapeTakesADragBackAndAClickMovesNothing)
{
  Dog scene;
  scene.drawLeg();
  const auto before = copyOf(scene.widget->GetOutput()), stroke = copyOf(scene.widget->GetStroke());
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.play("one_stroke_drag.log");
  EXPECT_FALSE(identical(before, scene.widget->GetOutput()));
  scene.event(vtkCommand::MouseWheelForwardEvent, 293, 57); // not in mid-drag
  scene.key("x");
  scene.key("Escape");
  EXPECT_FALSE(scene.widget->IsMoving());
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
  EXPECT_NEAR(scene.camera()->GetDirectionOfProjection()[2], -1.0, 1e-12);
  scene.release(293, 57);
  scene.press(283, 67);
  scene.release(283, 67);
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
  EXPECT_EQ(largestMove(stroke, scene.widget->GetStroke()), 0.0);
  EXPECT_EQ(changes.count, 0);
}

TEST(OneStrokeWidget, APartIsDrawnAnew)
{
  Dog scene;
  scene.drawLeg();
  expectAPartIsDrawnAnew(scene, copyOf(scene.widget->GetStroke()), "one_stroke_over.log", 2.5, 7.0);
  EXPECT_TRUE(identical(made(scene.mesh, scene.widget->GetStroke()), scene.widget->GetOutput()));
}

TEST(OneStrokeWidget, AParameterRunsTheStrokeAnew)
{
  Dog scene;
  scene.drawLeg();
  ASSERT_TRUE(scene.widget->GetOneStroke()->GetRemeshed());
  const vtkIdType remeshed = scene.widget->GetOutput()->GetNumberOfPoints();
  scene.widget->GetOneStroke()->SetRemeshToOff();
  scene.window->Render();
  EXPECT_EQ(scene.widget->GetOutput()->GetNumberOfPoints(), scene.mesh->GetNumberOfPoints());
  EXPECT_NE(remeshed, scene.mesh->GetNumberOfPoints());
  EXPECT_TRUE(identical(made(scene.mesh, scene.widget->GetStroke(), vtkOversketchOneStroke::RemeshOff),
    scene.widget->GetOutput()));
  // One of an inner step, too; and another system.
  scene.widget->GetOneStroke()->SetAdjustNormals(true);
  const auto plain = copyOf(scene.widget->GetOutput());
  scene.window->Render();
  EXPECT_GT(largestMove(plain, scene.widget->GetOutput()), 1e-3);
  vtkNew<vtkOversketchOneStroke> other;
  other->SetBackendToHost();
  other->SetRemeshToOff();
  scene.widget->SetOneStroke(other);
  scene.window->Render();
  EXPECT_TRUE(identical(plain, scene.widget->GetOutput()));
}

TEST(OneStrokeWidget, TheNextStrokeIsDrawnOnWhatTheLastOneMade)
{
  Dog scene;
  scene.drawLeg();
  const auto first = copyOf(scene.widget->GetOutput());
  // One that is taken back leaves the first one live.
  scene.press(120, 200);
  scene.move(140, 210);
  EXPECT_EQ(scene.count(isRed) > 100, false) << "the live stroke is seen under the pen";
  scene.key("Escape");
  scene.release(140, 210);
  EXPECT_GT(scene.count(isRed), 100);
  EXPECT_TRUE(identical(first, scene.widget->GetOutput()));
  scene.play("one_stroke_drag.log");
  scene.key("Escape");
  scene.release(0, 0);

  scene.drawTail();
  ASSERT_STREQ(scene.widget->GetMessage(), "");
  const auto second = copyOf(scene.widget->GetOutput());
  EXPECT_TRUE(identical(made(first, scene.widget->GetStroke()), second));
  // Escape is for the live one only; Return is done with it.
  scene.key("Escape");
  EXPECT_TRUE(identical(first, scene.widget->GetOutput()));
  EXPECT_EQ(scene.widget->GetStroke()->GetNumberOfPoints(), 0);
  scene.key("Escape");
  EXPECT_TRUE(identical(first, scene.widget->GetOutput()));
  scene.drawTail();
  scene.key("Return");
  EXPECT_EQ(scene.widget->GetStroke()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.count(isRed), 0);
  scene.key("Escape");
  EXPECT_TRUE(identical(second, scene.widget->GetOutput()));
}

TEST(OneStrokeWidget, AStrokeThatTakesHoldOfNothingStaysToBeCorrected)
{
  Dog scene;
  vtkOversketchMatch::SafeDownCast(scene.widget->GetOneStroke()->GetStep("Match"))->SetMaximumDistance(40.0);
  Counter messages(scene.widget, vtkCommand::MessageEvent);
  Quiet quiet;
  scene.press(300, 20);
  for (int x = 304; x <= 380; x += 4)
  {
    scene.move(x, 20);
  }
  scene.release(380, 20);
  EXPECT_EQ(messages.count, 1);
  EXPECT_NE(std::string(scene.widget->GetMessage()).find("MaximumDistance"), std::string::npos)
    << scene.widget->GetMessage();
  EXPECT_TRUE(identical(scene.mesh, scene.widget->GetOutput()));
  EXPECT_GT(scene.count(isRed), 50) << "the stroke is gone";
  const auto stroke = copyOf(scene.widget->GetStroke());
  EXPECT_GT(stroke->GetNumberOfPoints(), 10);
  // Dragged to the muzzle it takes hold, and the message goes.
  scene.move(340, 20);
  scene.press(340, 20);
  scene.move(300, 195);
  EXPECT_TRUE(identical(scene.mesh, scene.widget->GetOutput()));
  scene.release(300, 195);
  EXPECT_STREQ(scene.widget->GetMessage(), "");
  EXPECT_FALSE(identical(scene.mesh, scene.widget->GetOutput()));
  EXPECT_EQ(messages.count, 1);
  // A closed stroke is refused, too.
  scene.press(50, 50);
  for (int i = 1; i <= 36; ++i)
  {
    scene.move(static_cast<int>(30 + 20 * std::cos(i * M_PI / 18)),
      static_cast<int>(50 + 20 * std::sin(i * M_PI / 18)));
  }
  scene.release(50, 50);
  EXPECT_EQ(messages.count, 2);
  EXPECT_STRNE(scene.widget->GetMessage(), "");
  scene.key("Escape");
  EXPECT_STREQ(scene.widget->GetMessage(), "");
  EXPECT_EQ(quiet.errors(), 0);
}

TEST(OneStrokeWidget, FromElsewhereAClickTurnsBackToIt)
{
  Dog scene;
  scene.drawLeg();
  const auto before = copyOf(scene.widget->GetOutput());
  auto* line = scene.widget->GetLiveStrokeRepresentation();
  EXPECT_TRUE(line->IsInItsView());
  EXPECT_LT(line->DistanceTo(283, 67), 1.0);
  scene.camera()->Azimuth(40.0);
  scene.camera()->OrthogonalizeViewUp();
  scene.window->Render();
  EXPECT_FALSE(line->IsInReach());
  // Where a sample of it is seen now.
  const oversketch::View view = oversketch::ViewOf(scene.widget->GetStroke());
  double place[3];
  scene.widget->GetOneStroke()->GetInnerOutput("Match")->GetPoint(
    scene.widget->GetOneStroke()->GetInnerOutput("Match")->GetNumberOfPoints() / 2, place);
  const auto on = view.toWorld({ 283.0, 67.0 }, view.depth(oversketch::Vector3(place)));
  const auto seen = scene.display({ on[0], on[1], on[2] });
  EXPECT_LT(line->DistanceTo(seen[0], seen[1]), 1.5);
  scene.move(int(seen[0]), int(seen[1]));
  EXPECT_TRUE(line->GetHighlighted());
  scene.press(int(seen[0]), int(seen[1]));
  scene.release(int(seen[0]), int(seen[1]));
  EXPECT_FALSE(scene.widget->IsMoving());
  EXPECT_TRUE(line->IsInItsView());
  EXPECT_NEAR(scene.camera()->GetDirectionOfProjection()[2], -1.0, 1e-9);
  EXPECT_TRUE(identical(before, scene.widget->GetOutput()));
  scene.play("one_stroke_over.log"); // in its view again, so it can be drawn over
  EXPECT_GT(scene.widget->GetStroke()->GetNumberOfPoints(), 30);
  EXPECT_FALSE(scene.widget->IsNew());

  // Nearer it is still in reach: 20 px are three quarters as far.
  const auto stroke = copyOf(scene.widget->GetStroke());
  scene.camera()->SetParallelScale(0.75 * scene.camera()->GetParallelScale());
  EXPECT_TRUE(line->IsInReach());
  EXPECT_FALSE(line->IsInItsView());
  const auto zoomed = scene.display({ on[0], on[1], on[2] });
  const int x = int(std::lround(zoomed[0])), y = int(std::lround(zoomed[1]));
  scene.move(x, y);
  ASSERT_TRUE(line->GetHighlighted());
  scene.press(x, y);
  scene.move(x + 20, y - 20);
  scene.release(x + 20, y - 20);
  EXPECT_NEAR(scene.widget->GetStroke()->GetPoint(0)[0], stroke->GetPoint(0)[0] + 15.0, 1e-9);
  EXPECT_NEAR(scene.widget->GetStroke()->GetPoint(0)[1], stroke->GetPoint(0)[1] - 15.0, 1e-9);
}

TEST(OneStrokeWidget, TheRegionIsShownOnRequest)
{
  Dog scene;
  scene.drawLeg();
  EXPECT_EQ(scene.count(isOrange), 0);
  scene.key("o");
  EXPECT_TRUE(scene.widget->GetShowRegion());
  EXPECT_GT(scene.count(isOrange), 200);
  scene.play("one_stroke_drag.log");
  EXPECT_EQ(scene.count(isOrange), 0) << "the region stands where the leg was";
  scene.play("one_stroke_drop.log");
  EXPECT_GT(scene.count(isOrange), 200);
  scene.key("o");
  EXPECT_EQ(scene.count(isOrange), 0);
}

TEST(OneStrokeWidget, DrawingAndDraggingNeverOrbitAndOrbitingNeverDraws)
{
  vtkNew<vtkInteractorStyleTrackballCamera> stock;
  for (const bool own : { true, false })
  {
    Dog scene;
    if (!own)
    {
      scene.widget->Off();
      scene.interactor->SetInteractorStyle(stock);
      scene.widget->On();
    }
    scene.drawLeg();
    scene.play("one_stroke_drag.log");
    scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
    scene.move(295, 60);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 295, 60);
    scene.play("one_stroke_drop.log");
    EXPECT_NEAR(scene.camera()->GetDirectionOfProjection()[2], -1.0, 1e-12);
    EXPECT_EQ(scene.camera()->GetPosition()[0], 0.05);
    const auto mesh = copyOf(scene.widget->GetOutput()), stroke = copyOf(scene.widget->GetStroke());
    Counter starts(scene.widget, vtkCommand::StartInteractionEvent);
    scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
    scene.move(230, 160);
    scene.event(vtkCommand::MiddleButtonReleaseEvent, 230, 160);
    EXPECT_GT(std::abs(scene.camera()->GetPosition()[0] - 0.05), 1e-3);
    EXPECT_EQ(starts.count, 0);
    EXPECT_TRUE(identical(mesh, scene.widget->GetOutput()));
    EXPECT_EQ(largestMove(stroke, scene.widget->GetStroke()), 0.0);
  }
}

TEST(OneStrokeWidget, AnotherMeshBeginsAnew)
{
  Dog scene;
  scene.drawLeg();
  const auto octopus = shippedModel("octopus");
  scene.widget->SetInputData(octopus);
  scene.window->Render();
  EXPECT_TRUE(identical(octopus, scene.widget->GetOutput()));
  EXPECT_EQ(scene.widget->GetStroke()->GetNumberOfPoints(), 0);
  // A stroke of a file, without a hand.
  scene.widget->SetStroke(shippedStroke("octopus_bent_arm"));
  EXPECT_TRUE(identical(made(octopus, shippedStroke("octopus_bent_arm")), scene.widget->GetOutput()));
  scene.widget->SetStroke(nullptr);
  EXPECT_TRUE(identical(octopus, scene.widget->GetOutput()));
}
