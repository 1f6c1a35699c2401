// All of the edit by one widget: a region, handles, layers, areas and a profile over one system.
#include "edit_widget_scene.h"

using namespace oversketch_test;

namespace
{

// What a system of its own makes of what the widget has.
vtkSmartPointer<vtkPolyData> madeAlone(EditScene& scene, int rule)
{
  vtkNew<vtkOversketchEdit> system;
  const auto copy = [](vtkPolyData* data)
  {
    auto one = vtkSmartPointer<vtkPolyData>::New();
    one->DeepCopy(data);
    return one;
  };
  system->SetInputData(0, scene.mesh);
  system->SetReferenceData(copy(scene.widget->GetRegionWidget()->GetReference()));
  system->SetBoundaryData(copy(scene.widget->GetRegionWidget()->GetBoundary()));
  system->SetProfileData(copy(scene.widget->GetProfilePlaneWidget()->GetProfile()));
  system->SetAreasData(copy(scene.widget->GetAreaSelectWidget()->GetAreas()));
  system->SetOperations(scene.widget->GetAxisHandleWidget()->GetOperations());
  system->SetLayers(scene.widget->GetLayerHandleWidget()->GetLayers());
  system->SetProfileAt(scene.widget->GetProfilePlaneWidget()->GetProfileAt());
  system->SetRule(rule);
  Ear ear(system);
  system->Update();
  EXPECT_EQ(system->GetErrorCode(), 0u) << (ear.errors.empty() ? "" : ear.errors[0]);
  return copy(system->GetOutput());
}

Counter runsOf(EditScene& scene, const char* step)
{
  return Counter(scene.system()->GetStep(step), vtkCommand::StartEvent);
}

} // namespace

TEST(EditWidget, WhileAHandleIsDraggedTheRegionFollowsAndTrianglesComeWithTheRelease)
{
  EditScene scene;
  scene.drawBoth();
  ASSERT_TRUE(scene.widget->HasRegion()) << scene.widget->GetMessage();
  EXPECT_TRUE(identical(scene.output(), scene.mesh)) << "a region alone moves something";
  scene.placeHandle();
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  Counter solves = runsOf(scene, "Distance"), discs = runsOf(scene, "Flatten"),
          triangles = runsOf(scene, "Retriangulate"), curves = runsOf(scene, "BoundaryInsert"),
          moves = runsOf(scene, "Deform");
  scene.play("axis_drag.log"); // the side's axis, 20 px
  EXPECT_TRUE(scene.widget->IsPreviewing());
  EXPECT_EQ(solves.count + discs.count + curves.count + triangles.count, 0)
    << "a drag costs more than its move";
  EXPECT_GE(moves.count, 5);
  const auto off = madeAlone(scene, vtkOversketchEdit::Off);
  EXPECT_FALSE(identical(scene.output(), scene.mesh));
  EXPECT_TRUE(identical(scene.output(), off)) << "the last preview is not the result without new triangles";
  scene.release(200, 185);
  EXPECT_FALSE(scene.widget->IsPreviewing());
  EXPECT_EQ(changes.count, 1);
  scene.window->Render();
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Edit)));
  EXPECT_EQ(triangles.count, 1);
}

TEST(EditWidget, TheLineIsInTheMeshBeforeTheRingIsReleased)
{
  EditScene scene;
  scene.widget->SetInputData(toPolyData(icosphere(6))); // fine enough for both
  scene.window->Render();
  Counter lines = runsOf(scene, "ReferenceInsert"), rings = runsOf(scene, "BoundaryInsert"),
          regions = runsOf(scene, "Enclose"), discs = runsOf(scene, "Flatten"),
          solves = runsOf(scene, "Distance"), layers = runsOf(scene, "Shading");
  scene.play("region_line.log");
  EXPECT_EQ(lines.count, 1);
  EXPECT_EQ(rings.count + regions.count, 0);
  EXPECT_FALSE(scene.widget->HasRegion());
  EXPECT_STREQ(scene.widget->GetMessage(), "");
  scene.play("region_ring.log");
  scene.window->Render();
  ASSERT_TRUE(scene.widget->HasRegion()) << scene.widget->GetMessage();
  EXPECT_EQ(lines.count, 1) << "the ring's release lays the line again";
  for (const Counter* step : { &rings, &regions, &discs, &solves, &layers })
  {
    EXPECT_EQ(step->count, 1);
  }
}

TEST(EditWidget, ALayersDragTakesTheRegionOutOfTheMeshOnce)
{
  EditScene scene;
  scene.drawBoth();
  scene.system()->SetOperations("move 0.5 n 0.3");
  scene.widget->SetModeToShade();
  scene.window->Render();
  vtkOversketchLayerHandleRepresentation* layers =
    scene.widget->GetLayerHandleWidget()->GetLayerHandleRepresentation();
  const int before = layers->GetPatchCount();
  Counter previews = runsOf(scene, "Deform");
  scene.drag(200, 175, 200, 182);
  for (const int y : { 184, 186, 188, 190 })
  {
    scene.move(200, y);
  }
  ASSERT_TRUE(scene.widget->IsPreviewing());
  ASSERT_GE(previews.count, 4);
  // Of the mesh without new triangles once; then it follows.
  EXPECT_EQ(layers->GetPatchCount(), before + 1);
  EXPECT_NEAR(layers->GetBounds()[5], scene.output()->GetBounds()[5], 1e-9);
  // Where the hand is, is asked of the surface as it has moved.
  const double share = layers->GetShareAt(200, 190);
  vtkNew<vtkOversketchLayerHandleRepresentation> fresh;
  fresh->SetRenderer(scene.renderer);
  fresh->SetSideToModel();
  ASSERT_TRUE(fresh->SetRegion(scene.system()->GetInnerOutput("Deform")));
  EXPECT_EQ(share, fresh->GetShareAt(200, 190));
  EXPECT_LT(share, 1.0);
  scene.release(200, 190);
}

TEST(EditWidget, ADraggedLineTakesAllOfItAlong)
{
  EditScene scene;
  scene.drawBoth();
  scene.widget->SetModeToDirect();
  scene.play("axis_line_drag.log"); // 12 px to the right, 24 up
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Off)));
  scene.play("axis_drop.log");
  vtkPolyData* before =
    vtkPolyData::SafeDownCast(scene.system()->GetStep("Enclose")->GetInputDataObject(1, 0));
  const double *from = before->GetBounds(), *to = scene.system()->GetReferenceOutput()->GetBounds();
  EXPECT_NEAR(to[0] - from[0], 0.12, 1e-5);
  EXPECT_NEAR(to[2] - from[2], 0.24, 1e-5);
}

TEST(EditWidget, TheRegionStaysFromModeToMode)
{
  EditScene scene;
  scene.drawBoth();
  scene.placeHandle();
  scene.play("axis_drag.log");
  scene.release(200, 185);
  // A layer, on the model: more follows.
  scene.widget->SetModeToShade();
  Counter solves = runsOf(scene, "Distance");
  const auto before = madeAlone(scene, vtkOversketchEdit::Off);
  scene.drag(200, 175, 200, 190);
  EXPECT_TRUE(scene.widget->IsPreviewing());
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Off)));
  EXPECT_FALSE(identical(scene.output(), before));
  scene.release(200, 190);
  EXPECT_EQ(solves.count, 0) << "a layer solves fields";
  EXPECT_NE(std::string(scene.system()->GetLayers()), "");
  // An area with handles of its own, then taken back with its layers.
  scene.widget->SetModeToAreas();
  scene.play("area_lasso.log");
  ASSERT_EQ(scene.widget->GetAreaSelectWidget()->GetAreas()->GetNumberOfLines(), 1)
    << scene.widget->GetMessage();
  scene.widget->SetModeToShade();
  scene.click(232, 168);
  EXPECT_NE(std::string(scene.system()->GetLayers()).find("area 0"), std::string::npos)
    << scene.system()->GetLayers();
  scene.widget->SetModeToAreas();
  scene.key("Escape");
  EXPECT_EQ(std::string(scene.system()->GetLayers()).find("area"), std::string::npos)
    << scene.system()->GetLayers();
  // The ring redrawn in part: the same handle on another region.
  scene.widget->SetModeToRegion();
  scene.play("region_redraw_ring.log");
  ASSERT_TRUE(scene.widget->HasRegion()) << scene.widget->GetMessage();
  EXPECT_GT(solves.count, 0);
  EXPECT_NE(std::string(scene.system()->GetOperations()).find("move 0.5 w"), std::string::npos);
  scene.window->Render();
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Edit)));
}

TEST(EditWidget, AProfileDrawnAnewIsFollowed)
{
  EditScene scene;
  scene.drawBoth();
  scene.widget->SetModeToProfile();
  scene.window->Render();
  EXPECT_GT(scene.widget->GetProfilePlaneWidget()->GetSectionProfile()->GetNumberOfPoints(), 10);
  scene.flat.play("profile_stroke.log");
  EXPECT_TRUE(identical(scene.output(), scene.mesh)) << "a stroke that waits counts";
  scene.flat.key("Return");
  EXPECT_STREQ(scene.widget->GetMessage(), "");
  EXPECT_FALSE(identical(scene.output(), scene.mesh));
  Counter discs = runsOf(scene, "Flatten");
  scene.play("profile_slide.log");
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Off)));
  scene.play("profile_let_go.log");
  EXPECT_EQ(discs.count, 0) << "a slid plane flattens";
  scene.window->Render();
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Edit)));
  // With operations it is refused, in words, and the mesh is as it was.
  scene.placeHandle();
  scene.play("axis_drag.log");
  scene.release(200, 185);
  EXPECT_NE(std::string(scene.widget->GetMessage()).find("profile"), std::string::npos)
    << scene.widget->GetMessage();
  EXPECT_TRUE(identical(scene.output(), scene.mesh));
}

TEST(EditWidget, WhatIsSeenOnTheModelIsWhereTheEditHasTakenIt)
{
  EditScene scene;
  scene.drawBoth();
  scene.system()->SetOperations("move 0.5 n 0.3");
  scene.window->Render();
  const double top = scene.output()->GetBounds()[5];
  ASSERT_NEAR(top, 1.3, 0.01);
  EXPECT_NEAR(
    scene.widget->GetLayerHandleWidget()->GetLayerHandleRepresentation()->GetBounds()[5], top, 1e-9);
  EXPECT_NEAR(scene.widget->GetAreaSelectWidget()->GetAreaSelectRepresentation()->GetBounds()[5], top, 1e-9);
  // While a layer is dragged too.
  scene.widget->SetModeToShade();
  scene.drag(200, 175, 200, 190);
  ASSERT_TRUE(scene.widget->IsPreviewing());
  EXPECT_NEAR(scene.widget->GetLayerHandleWidget()->GetLayerHandleRepresentation()->GetBounds()[5],
    scene.output()->GetBounds()[5],
    1e-9);
  scene.key("Escape");
  scene.release(200, 190);
  scene.system()->SetOperations("");
  // The section of a profile, seen from above: not where it was cut but where it has been bent to.
  scene.widget->SetModeToProfile();
  scene.window->Render();
  scene.flat.play("profile_stroke.log");
  scene.flat.key("Return");
  scene.widget->GetProfilePlaneWidget()->GetProfilePlaneRepresentation()->SetPlaneVisibility(2, false);
  scene.camera()->SetPosition(0.0, 10.0, 0.0);
  scene.camera()->SetViewUp(0.0, 0.0, -1.0);
  const double bent = scene.output()->GetBounds()[5];
  ASSERT_GT(bent, 1.1);
  const auto at = scene.display({ 0.0, 0.0, bent });
  EXPECT_EQ(
    scene.widget->GetProfilePlaneWidget()->GetProfilePlaneRepresentation()->GetGripAt(at[0], at[1]), 3);
}

TEST(EditWidget, DoneWithTheNextIsDrawnOnWhatItMade)
{
  EditScene scene;
  scene.drawBoth();
  scene.placeHandle();
  scene.play("axis_drag.log");
  scene.release(200, 185);
  scene.window->Render();
  vtkNew<vtkPolyData> first;
  first->DeepCopy(scene.output());
  scene.key("Return");
  EXPECT_EQ(scene.widget->GetMode(), vtkOversketchEditWidget::Region);
  EXPECT_FALSE(scene.widget->HasRegion());
  EXPECT_TRUE(identical(scene.output(), first));
  EXPECT_STREQ(scene.system()->GetOperations(), "");
  scene.drawBoth();
  EXPECT_TRUE(scene.widget->HasRegion()) << scene.widget->GetMessage();
  EXPECT_TRUE(identical(scene.output(), first)) << "a region alone moves something";
  scene.key("Escape");
  scene.key("Escape");
  EXPECT_FALSE(scene.widget->HasRegion());
  EXPECT_TRUE(identical(scene.output(), first));
  scene.widget->SetInputData(editBall()); // another one at the source
  scene.window->Render();
  EXPECT_FALSE(identical(scene.output(), first));
}

TEST(EditWidget, ARingThatTheSystemRefusesSaysWhyAndLeavesTheMesh)
{
  EditScene scene;
  Counter told(scene.widget, vtkCommand::MessageEvent);
  scene.play("region_line.log");
  std::vector<Vector2> small;
  for (int i = 0; i < 30; ++i)
  {
    const double a = 2.0 * pi * i / 30;
    small.emplace_back(200.0 + 20.0 * std::cos(a), 150.0 + 20.0 * std::sin(a)); // across the line
  }
  scene.draw(small);
  EXPECT_FALSE(scene.widget->HasRegion());
  EXPECT_GE(told.count, 1);
  EXPECT_NE(std::string(scene.widget->GetMessage()), "");
  EXPECT_TRUE(identical(scene.output(), scene.mesh));
  scene.widget->SetModeToDirect(); // there is nothing to take hold of
  scene.click(200, 150);
  EXPECT_STREQ(scene.system()->GetOperations(), "");
  scene.widget->SetModeToRegion();
  scene.key("Escape");
  scene.play("region_ring.log");
  EXPECT_TRUE(scene.widget->HasRegion()) << scene.widget->GetMessage();
  EXPECT_STREQ(scene.widget->GetMessage(), "");
}

TEST(EditWidget, WhatTheHostSetsOfTheSystemIsFollowed)
{
  EditScene scene;
  scene.drawBoth();
  scene.system()->SetOperations("move 0.5 n 0.2; pin 0.1");
  scene.window->Render();
  EXPECT_FALSE(identical(scene.output(), scene.mesh));
  EXPECT_STREQ(scene.widget->GetAxisHandleWidget()->GetOperations(), "move 0.5 n 0.2; pin 0.1");
  EXPECT_EQ(scene.widget->GetAxisHandleWidget()->GetAxisHandleRepresentation()->GetNumberOfHandles(), 2);
  scene.system()->SetOperations("drag 10 -5; pin 0.5");
  scene.window->Render();
  EXPECT_STREQ(scene.widget->GetAxisHandleWidget()->GetOperations(), "drag 10 -5; pin 0.5");
  // The handles' line is where the system has it.
  vtkPolyData* line = scene.system()->GetReferenceOutput();
  scene.widget->SetModeToDirect();
  for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
  {
    const double* p = line->GetPoint(i);
    const auto at = scene.display({ p[0], p[1], p[2] });
    EXPECT_GT(scene.widget->GetAxisHandleWidget()->GetAxisHandleRepresentation()->GetGripAt(at[0], at[1]), 0);
  }
  scene.widget->ShowRegionOn();
  scene.window->Render();
  int orange = 0;
  for (int x = 140; x < 260; x += 3)
  {
    const auto p = scene.pixel(x, 175);
    orange += p[0] > p[2] + 60;
  }
  EXPECT_GT(orange, 5) << "what moved is not shown";
  scene.key("o");
  EXPECT_FALSE(scene.widget->GetShowRegion());
}

TEST(EditWidget, InEveryModeShiftRedrawsAndEscapeTakesNothingBack)
{
  EditScene scene;
  scene.widget->RegionInAllModesOn();
  scene.drawBoth();
  scene.placeHandle();
  scene.key("Escape"); // no handle is selected
  scene.play("region_redraw_ring.log");
  vtkOversketchRegionWidget* region = scene.widget->GetRegionWidget();
  EXPECT_EQ(region->GetBoundary()->GetNumberOfLines(), 2) << scene.widget->GetMessage();
  EXPECT_EQ(scene.widget->GetMode(), vtkOversketchEditWidget::Direct);
  scene.key("Escape");
  EXPECT_EQ(region->GetBoundary()->GetNumberOfLines(), 2);
  EXPECT_TRUE(scene.widget->HasRegion());
  scene.widget->RegionInAllModesOff();
  EXPECT_FALSE(region->GetEnabled());
  scene.widget->SetModeToRegion();
  scene.key("Escape");
  EXPECT_EQ(region->GetBoundary()->GetNumberOfLines(), 1);
}

TEST(EditWidget, ALineThatCannotBeOneIsToldBeforeTheRing)
{
  EditScene scene;
  scene.draw({ { 10.0, 10.0 }, { 25.0, 12.0 }, { 40.0, 10.0 } }); // beside the ball
  EXPECT_NE(std::string(scene.widget->GetMessage()).find("lies on the mesh"), std::string::npos)
    << scene.widget->GetMessage();
  EXPECT_TRUE(identical(scene.output(), scene.mesh));
  scene.key("Escape");
  scene.play("region_line.log");
  EXPECT_STREQ(scene.widget->GetMessage(), "");
}

TEST(EditWidget, TheDiscIsChangedInAWindowOfItsOwn)
{
  EditScene scene;
  Window disc{ 200, 200 };
  disc.camera()->ParallelProjectionOn();
  disc.camera()->SetPosition(0.0, 0.0, 10.0);
  disc.camera()->SetParallelScale(1.0);
  disc.interactor->SetInteractorStyle(nullptr);
  scene.widget->SetDiscRenderer(disc.renderer);
  scene.drawBoth();
  scene.system()->SetOperations("move 0.5 n 0.3");
  scene.window->Render();
  scene.widget->SetModeToShade();
  const auto before = madeAlone(scene, vtkOversketchEdit::Off);
  disc.move(100, 160);
  disc.event(vtkCommand::LeftButtonPressEvent, 100, 160);
  disc.move(100, 130);
  EXPECT_TRUE(scene.widget->IsPreviewing());
  EXPECT_FALSE(identical(scene.output(), before));
  EXPECT_TRUE(identical(scene.output(), madeAlone(scene, vtkOversketchEdit::Off)));
  disc.event(vtkCommand::LeftButtonReleaseEvent, 100, 130);
  EXPECT_STREQ(
    scene.widget->GetLayerHandleWidget()->GetLayers(), scene.widget->GetDiscLayerWidget()->GetLayers());
  EXPECT_NE(std::string(scene.system()->GetLayers()), "");
  // A lasso there is one on the model.
  scene.widget->SetModeToAreas();
  disc.event(vtkCommand::LeftButtonPressEvent, 130, 100);
  for (int i = 1; i <= 20; ++i)
  {
    disc.move(130 + static_cast<int>(25.0 * std::sin(2.0 * pi * i / 20)),
      100 + 25 - static_cast<int>(25.0 * std::cos(2.0 * pi * i / 20)));
  }
  disc.event(vtkCommand::LeftButtonReleaseEvent, 130, 100);
  EXPECT_EQ(scene.widget->GetAreaSelectWidget()->GetAreas()->GetNumberOfLines(), 1);
  EXPECT_EQ(scene.widget->GetDiscAreaWidget()->GetAreas()->GetNumberOfLines(), 1);
  scene.widget->SetDiscRenderer(nullptr);
  EXPECT_EQ(scene.widget->GetDiscRenderer(), nullptr);
}
