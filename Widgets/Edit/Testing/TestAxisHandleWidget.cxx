// Handles on a line, dragged by their axes and by the line itself.
#include "widget_scenes.h"

#include <Eigen/Geometry>

#include <sstream>

using namespace oversketch_test;

namespace
{

struct Row
{
  std::string verb, axis;
  double t = 0.0, amount = 0.0;
};
std::vector<Row> rowsOf(const std::string& text)
{
  std::vector<Row> rows;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');)
  {
    std::istringstream words(part);
    Row row;
    words >> row.verb >> row.t >> row.axis >> row.amount;
    rows.push_back(row);
  }
  return rows;
}

} // namespace

TEST(B10_6, ThirdsOfAnAxisMoveScaleAndTurn)
{
  AxisScene scene;
  ASSERT_TRUE(scene.widget->AddHandle(0.5));
  const Vector2 from = scene.middle();
  ASSERT_NEAR(from[0], 200.0, 3.0);
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.play("axis_thirds.log"); // at 15, 45 and 75 px up, the side's axis: 20 px up, 15 px up, 30 px right
  const std::vector<Row> rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 3u) << scene.operations();
  const std::vector<std::string> verbs{ "move", "scale", "rotate" };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(rows[i].verb, verbs[i]);
    EXPECT_EQ(rows[i].axis, "w") << "another axis has changed";
    EXPECT_EQ(rows[i].t, 0.5);
  }
  EXPECT_NEAR(rows[0].amount, 0.2, 2e-3);
  // The handle has moved up by 20 px, and the ratio is that of distances from where it then was.
  EXPECT_NEAR(rows[1].amount, (215.0 + 15.0 - from[1] - 20.0) / (215.0 - from[1] - 20.0), 2e-2);
  EXPECT_NEAR(rows[2].amount, 30.0, 5e-3);
  EXPECT_EQ(changes.count, 3);
  fact("B10_6",
    "presses at 15, 45 and 75 px on one axis: " + scene.operations() + "; no other axis has changed");
}

TEST(AxisHandleWidget, TheSameAxisAgainChangesItsRowAnotherMakesOne)
{
  AxisScene scene;
  scene.widget->AddHandle(0.5);
  const auto pull = [&](double along, int dx, int dy, const Vector2& axis)
  {
    // Where the handle is now: it moves with what was done.
    const std::vector<Row> rows = rowsOf(scene.operations());
    Vector2 at = scene.middle();
    for (const Row& row : rows)
    {
      at += row.verb != "move" ? Vector2::Zero()
            : row.axis == "w"  ? Vector2(0.0, 100.0 * row.amount)
                               : Vector2(100.0 * row.amount, 0.0);
    }
    const int x = int(std::lround(at[0] + along * axis[0])), y = int(std::lround(at[1] + along * axis[1]));
    scene.drag(x, y, x + dx, y + dy);
    scene.release(x + dx, y + dy);
  };
  pull(15.0, 0, 10, Vector2::UnitY());
  pull(15.0, 0, 14, Vector2::UnitY());
  std::vector<Row> rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 1u) << scene.operations();
  EXPECT_NEAR(rows[0].amount, 0.24, 2e-3);
  pull(15.0, 10, 0, Vector2::UnitX());
  rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 2u) << scene.operations();
  EXPECT_EQ(rows[1].axis, "t");
  EXPECT_NEAR(rows[0].amount, 0.24, 2e-3);
  EXPECT_NEAR(rows[1].amount, 0.1, 2e-3);
}

TEST(AxisHandleWidget, AClickPlacesAHandleAndDeleteTakesItAway)
{
  AxisScene scene;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.play("axis_place.log"); // clicks at x = 180 and 225
  std::vector<Row> rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 2u) << scene.operations();
  EXPECT_EQ(rows[0].verb, "pin");
  EXPECT_NEAR(rows[0].t, 0.25, 0.02);
  EXPECT_NEAR(rows[1].t, 0.81, 0.025);
  EXPECT_EQ(scene.shown()->GetSelectedHandle(), 1) << "the last one is selected";
  EXPECT_EQ(changes.count, 2);
  scene.key("Delete");
  rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].t, 0.25, 0.02);
  scene.key("Delete"); // none is selected
  EXPECT_EQ(rowsOf(scene.operations()).size(), 1u);
  scene.click(180, 149); // on the handle: selected
  EXPECT_EQ(scene.shown()->GetSelectedHandle(), 0);
  scene.key("Escape");
  EXPECT_EQ(scene.shown()->GetSelectedHandle(), -1);
  EXPECT_EQ(changes.count, 3);
  scene.click(100, 250); // beside all
  EXPECT_EQ(rowsOf(scene.operations()).size(), 1u);
}

TEST(AxisHandleWidget, ADragOfTheLineIsOneShiftOfAllOfIt)
{
  for (const bool hasHandles : { false, true })
  {
    AxisScene scene;
    if (hasHandles)
    {
      scene.widget->SetOperations("pin 0.2; rotate 0.8 n 20");
    }
    scene.region.system->SetOperations(scene.widget->GetOperations());
    scene.region.system->SetRuleToOff();
    scene.region.run();
    const auto placesOf = [&]
    {
      std::vector<Vector3> places;
      vtkPolyData* line = scene.region.system->GetReferenceOutput();
      for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
      {
        places.emplace_back(line->GetPoint(i));
      }
      return places;
    };
    const std::vector<Vector3> before = placesOf();
    const int y = int(std::lround(scene.middle()[1]));
    scene.drag(200, y, 212, y + 25);
    EXPECT_TRUE(scene.widget->IsDraggingLine());
    EXPECT_NEAR(scene.widget->GetShift()[0], 0.12, 1e-9);
    EXPECT_NEAR(scene.widget->GetShift()[1], 0.25, 1e-9);
    scene.release(212, y + 25);
    scene.region.system->SetOperations(scene.widget->GetOperations());
    scene.region.run();
    const std::vector<Vector3> after = placesOf();
    ASSERT_EQ(before.size(), after.size());
    double off = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i)
    {
      off = std::max(off, (after[i] - before[i] - Vector3(0.12, 0.25, 0.0)).norm());
    }
    // A turned handle is not only shifted: the sum of a turn's and a shift's logarithms.
    EXPECT_LT(off, hasHandles ? 0.06 : 2e-6) << scene.operations();
  }
}

TEST(AxisHandleWidget, TheHandleIsWhereTheEditHasTakenIt)
{
  AxisScene scene;
  scene.widget->SetOperations("move 0.25 w 0.3; pin 0.75");
  scene.region.system->SetOperations("move 0.25 w 0.3; pin 0.75");
  scene.region.run();
  vtkPolyData* line = scene.region.system->GetReferenceOutput();
  for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
  {
    const double* p = line->GetPoint(i);
    const auto at = scene.display({ p[0], p[1], p[2] });
    EXPECT_GT(scene.shown()->GetGripAt(at[0], at[1]), 0) << i;
  }
}

TEST(AxisHandleWidget, AnAxisThatLooksAtTheViewerTurnsByItsAngle)
{
  AxisScene scene;
  scene.widget->AddHandle(0.5);
  // Outward, z at the middle of the line but for the ball's triangles, looks to the left and up.
  const Vector3 toViewer = Vector3(0.5, -0.4, 0.8).normalized();
  scene.camera()->SetPosition(10.0 * toViewer[0], 10.0 * toViewer[1], 10.0 * toViewer[2]);
  scene.renderer->ResetCameraClippingRange();
  const Vector3 right = Vector3::UnitY().cross(toViewer).normalized(), up = toViewer.cross(right);
  const Vector2 from = scene.middle(), run = Vector2(right[2], up[2]).normalized();
  const auto ontoPlane = [&](const Vector2& px)
  {
    const Vector3 on = 0.01 * px[0] * right + 0.01 * px[1] * up;
    return Vector3(on - on[2] / toViewer[2] * toViewer);
  };
  const Vector3 turned =
    Eigen::AngleAxisd(25.0 * pi / 180.0, Vector3::UnitZ()) * ontoPlane(Vector2(75.0 * run));
  const int x = int(std::lround(from[0] + 75.0 * run[0])), y = int(std::lround(from[1] + 75.0 * run[1]));
  const int toX = int(std::lround(from[0] + 100.0 * turned.dot(right))),
            toY = int(std::lround(from[1] + 100.0 * turned.dot(up)));
  scene.drag(x, y, toX, toY);
  scene.release(toX, toY);
  const std::vector<Row> rows = rowsOf(scene.operations());
  ASSERT_EQ(rows.size(), 1u) << scene.operations();
  EXPECT_EQ(rows[0].verb + rows[0].axis, "rotaten");
  EXPECT_NEAR(rows[0].amount, 25.0, 2.0);
}

TEST(AxisHandleWidget, EscapePutsAllBackAndADragSwallowsTheRest)
{
  AxisScene scene;
  scene.widget->SetOperations("move 0.5 w 0.1");
  const std::string before = scene.operations();
  const CameraState camera(scene);
  const int x = int(std::lround(scene.middle()[0])), y = int(std::lround(scene.middle()[1])) + 10;
  scene.click(x, y); // the handle
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent),
    ends(scene.widget, vtkCommand::EndInteractionEvent);
  scene.drag(x, y + 15, x, y + 40);
  EXPECT_NE(scene.operations(), before);
  Counter keys(scene.interactor, vtkCommand::CharEvent);
  disturb(scene);
  EXPECT_TRUE(scene.widget->IsDragging());
  EXPECT_EQ(keys.count, 0);
  EXPECT_TRUE(CameraState(scene) == camera);
  scene.key("Escape");
  EXPECT_FALSE(scene.widget->IsDragging());
  EXPECT_EQ(scene.operations(), before);
  scene.release(x, y + 40);
  EXPECT_EQ(changes.count, 0);
  EXPECT_EQ(ends.count, 1);
}

TEST(AxisHandleWidget, WhatIsNotUnderstoodIsRefused)
{
  AxisScene scene;
  scene.widget->SetOperations("pin 0.5");
  Quiet quiet;
  scene.widget->SetOperations("lift 0.5");
  EXPECT_EQ(quiet.errors(), 1);
  EXPECT_EQ(scene.operations(), "pin 0.5");
  EXPECT_FALSE(scene.widget->SetCurve(scene.mesh, scene.mesh)) << "no curve on a mesh";
  EXPECT_EQ(quiet.errors(), 2);
  scene.window->Render();
  scene.click(200, 150);
}
