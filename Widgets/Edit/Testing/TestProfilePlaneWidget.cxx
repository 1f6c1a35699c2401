// The plane that slides along the line, and the section drawn anew in a window of its own.
#include "Stroke/polyline.h"
#include "widget_scenes.h"

#include "vtkFieldData.h"
#include "vtkPointData.h"

using namespace oversketch_test;

TEST(B8_4, KeysShowPlanesAndAnAcceptedStrokeIsMatched)
{
  ProfileScene scene;
  std::vector<int> seen;
  const auto note = [&] { seen.push_back(scene.shown()->GetNumberOfVisiblePlanes()); };
  scene.play("profile_key_7.log");
  note();
  EXPECT_TRUE(scene.shown()->GetPlaneVisibility(vtkOversketchProfilePlaneRepresentation::N));
  scene.play("profile_key_6.log");
  note();
  scene.play("profile_key_0.log");
  note();
  EXPECT_EQ(seen, (std::vector<int>{ 1, 3, 0 }));
  scene.key("9");
  EXPECT_TRUE(scene.shown()->GetPlaneVisibility(vtkOversketchProfilePlaneRepresentation::B));

  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.drawBump(0.2);
  EXPECT_EQ(changes.count, 0) << "a stroke that was not accepted counts";
  scene.flat.key("Return");
  EXPECT_EQ(changes.count, 1);
  ASSERT_EQ(scene.widget->GetProfile()->GetNumberOfLines(), 1);
  vtkNew<vtkPolyData> drawn;
  scene.widget->GetProfileRepresentation()->GetDrawn(drawn);
  double highest = 0.0;
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    highest = std::max(highest, drawn->GetPoint(i)[1]);
  }
  // The system over it; its section is cut again.
  const double meanEdge =
    scene.region.system->GetOutput()->GetFieldData()->GetArray("MeanEdge")
      ? scene.region.system->GetOutput()->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0)
      : scene.region.mesh()->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
  const auto matrix = scene.widget->GetSectionProfile()->GetFieldData()->GetArray("ProfileMatrix");
  Eigen::Matrix4d toWorld;
  for (int i = 0; i < 16; ++i)
  {
    toWorld(i / 4, i % 4) = matrix->GetComponent(0, i);
  }
  const double width = toWorld.col(0).head<3>().norm();
  scene.region.system->SetInputConnection(3, scene.widget->GetProfilePort());
  scene.region.system->SetProfileAt(scene.widget->GetProfileAt());
  vtkPolyData* bent = scene.region.run();
  double off = 0.0;
  int compared = 0;
  // Vertices near the plane lie on the drawn profile.
  std::vector<Vector2> target;
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    target.emplace_back(drawn->GetPoint(i)[0], drawn->GetPoint(i)[1]);
  }
  const oversketch::NearestPlace nearest(target);
  for (vtkIdType i = 0; i < bent->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector4d at = toWorld.inverse() * Vector3(bent->GetPoint(i)).homogeneous();
    if (std::abs(at[2]) * width < 0.1 * meanEdge && at[0] > 0.12 && at[0] < 0.88 && at[1] > 0.1)
    {
      off = std::max(off, nearest(Vector2(at[0], at[1])).distance * width);
      ++compared;
    }
  }
  EXPECT_GT(compared, 3);
  EXPECT_LT(off, 0.25 * meanEdge) << compared;
  fact("B8_4",
    "keys 7, 6, 0 show 1, 3 and 0 planes; vertices at the plane within " + std::to_string(off / meanEdge) +
      " mean edges of the profile drawn and accepted in its window");
}

TEST(ProfilePlaneWidget, ThePlaneSlidesUnderTheHand)
{
  ProfileScene scene;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent),
    moves(scene.widget, vtkCommand::InteractionEvent);
  const vtkMTimeType before = scene.widget->GetSection()->GetMTime();
  scene.play("profile_slide.log"); // 24 px to the right by the knob
  EXPECT_TRUE(scene.widget->IsDragging());
  EXPECT_GT(scene.widget->GetSection()->GetMTime(), before) << "the section is the old one";
  EXPECT_GT(moves.count, 4);
  scene.play("profile_let_go.log");
  EXPECT_EQ(changes.count, 1);
  EXPECT_NEAR(scene.widget->GetProfileAt(), 0.5 + 0.24 / 0.84, 0.03);
  // The section goes through the line there, across it.
  const double* box = scene.widget->GetSection()->GetBounds();
  EXPECT_NEAR(0.5 * (box[0] + box[1]), 0.24, 0.15);
  // By the section too, which is nowhere near the knob.
  const vtkIdType count = scene.widget->GetSection()->GetNumberOfPoints();
  const double* p = scene.widget->GetSection()->GetPoint(count / 5);
  const auto at = scene.display({ p[0], p[1], p[2] });
  const double t = scene.widget->GetProfileAt();
  scene.drag(int(at[0]), int(at[1]), int(at[0]) - 30, int(at[1]));
  EXPECT_LT(scene.widget->GetProfileAt(), t - 0.2);
  scene.key("Escape");
  EXPECT_EQ(scene.widget->GetProfileAt(), t);
  scene.release(0, 0);
  EXPECT_EQ(changes.count, 1);
}

TEST(ProfilePlaneWidget, AStrokeWaitsIsDrawnOverAndTakenBack)
{
  ProfileScene scene;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.drawBump(0.2);
  EXPECT_TRUE(scene.widget->GetPen()->IsWaiting());
  scene.flat.key("Escape");
  EXPECT_FALSE(scene.widget->GetPen()->IsWaiting());
  scene.drawBump(0.2);
  scene.drawBump(0.1); // over the one that waits
  scene.flat.key("Return");
  EXPECT_EQ(changes.count, 1);
  EXPECT_EQ(scene.widget->GetProfile()->GetNumberOfLines(), 1);
  scene.flat.key("Escape");
  EXPECT_EQ(changes.count, 2);
  EXPECT_EQ(scene.widget->GetProfile()->GetNumberOfLines(), 0);
  scene.flat.key("Escape");
  EXPECT_EQ(changes.count, 2);
}

TEST(ProfilePlaneWidget, ADragSwallowsTheRestAndKeysAreItsOwn)
{
  ProfileScene scene;
  const CameraState camera(scene);
  scene.play("profile_slide.log");
  Counter keys(scene.interactor, vtkCommand::CharEvent);
  disturb(scene);
  EXPECT_EQ(keys.count, 0);
  EXPECT_TRUE(CameraState(scene) == camera);
  EXPECT_EQ(scene.shown()->GetNumberOfVisiblePlanes(), 3) << "6 counts while the plane slides";
  scene.play("profile_let_go.log");
  scene.key("x");
  EXPECT_FALSE(CameraState(scene) == camera) << "a key of the camera's is swallowed";
  scene.key("0", Control);
  EXPECT_EQ(scene.shown()->GetNumberOfVisiblePlanes(), 3);
}

TEST(ProfilePlaneWidget, WhereNoSectionCanBeCutItIsSaid)
{
  ProfileScene scene;
  Counter told(scene.widget, vtkCommand::MessageEvent);
  EXPECT_FALSE(scene.widget->SetRegion(scene.mesh, scene.region.line, scene.region.ring()))
    << "a mesh without a distance field";
  EXPECT_EQ(told.count, 1);
  EXPECT_NE(std::string(scene.shown()->GetText()), "");
  EXPECT_EQ(scene.widget->GetSectionProfile()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(scene.widget->SetRegion(nullptr, nullptr, nullptr));
  scene.window->Render();
  EXPECT_FALSE(scene.widget->GetPen()->GetEnabled()) << "there is nothing to draw over";
}
