// The tool Place: arrows, rings, boxes and the square of its gizmo, the surface that a part is put on, the
// twin.
#include "pieces.h"
#include "place_gizmo.h"
#include "scene.h"
#include "systems.h"
#include "tool.h"

#include "Harness/shapes.h"
#include "pen_view.h"

#include "vtkStaticCellLocator.h"

using namespace oversketch_studio;
using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;
using oversketch_session::findSystem;

namespace
{

using Gizmo = std::vector<GizmoShape>;

// A handle's outline, of its last piece; none where it is not seen.
oversketch::Polyline outlineOf(const Gizmo& gizmo, GizmoGrip::Part part, int axis = 0)
{
  oversketch::Polyline outline;
  for (const GizmoShape& shape : gizmo)
  {
    outline = shape.grip == GizmoGrip{ part, axis } ? shape.outline : outline;
  }
  return outline;
}

// The middle of a square or a box.
Vector2 placeOf(const Gizmo& gizmo, GizmoGrip::Part part, int axis = 0)
{
  const oversketch::Polyline corners = outlineOf(gizmo, part, axis);
  EXPECT_EQ(corners.size(), 4u);
  return 0.5 * (corners.at(0) + corners.at(2));
}

Vector2 boxOf(const Gizmo& gizmo, int axis)
{
  return placeOf(gizmo, GizmoGrip::Box, axis);
}

Vector2 middleOf(const Gizmo& gizmo)
{
  return placeOf(gizmo, GizmoGrip::Square);
}

// The direction of an axis in the picture.
Vector2 runOf(const Gizmo& gizmo, int axis)
{
  return (boxOf(gizmo, axis) - middleOf(gizmo)).normalized();
}

// The window with the tool in the hand, and a hand that counts from the screen's lower left corner.
struct PlaceScene : Scene
{
  PlaceScene()
  {
    QApplication::setActiveWindow(&this->window);
    QTest::keyClick(this->view, Qt::Key_7);
    this->settle();
  }
  View look() { return oversketch::PenView::of(this->renderer()).kernelView(); }
  QPoint qt(const Vector2& at)
  {
    return { static_cast<int>(std::lround(at[0])),
      this->view->height() - 1 - static_cast<int>(std::lround(at[1])) };
  }
  void click(const Vector2& at)
  {
    QTest::mouseClick(this->view, Qt::LeftButton, Qt::NoModifier, this->qt(at));
    QApplication::processEvents();
    this->wait();
  }
  void drag(const Vector2& from,
    const Vector2& to,
    Qt::KeyboardModifiers keys = Qt::NoModifier,
    bool release = true)
  {
    moveMouse(this->view, this->qt(from), Qt::NoButton);
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, this->qt(from));
    sweepMouse(
      this->view, 1, 10, [&](int i) { return this->qt(from + 0.1 * i * (to - from)); }, keys);
    if (release)
    {
      QTest::mouseRelease(this->view, Qt::LeftButton, keys, this->qt(to));
      this->wait();
      this->settle();
    }
  }
  Vector3 middleOf(int part = -1)
  {
    vtkPolyData* mesh = this->document->result().mesh;
    return Vector3((part < 0 ? mesh : oversketch_files::partAlone(mesh, part).Get())->GetCenter());
  }
  Gizmo gizmoAt(const Vector3& middle, const Vector3& turn = Vector3::Zero())
  {
    return seeGizmo(this->look(), middle, Pose{ Vector3::Zero(), turn, Vector3::Ones() }.axes(), 1.0);
  }
  Vector2 display(const Vector3& place) { return this->look().toDisplay(place).head<2>(); }
  std::size_t steps() { return this->document->session().nodes.size(); }
  const oversketch_session::Step& last() { return *this->document->session().nodes.back().step; }
  Vector3 value(const char* property)
  {
    const auto& parameter = *findParameter(*findSystem("Transform"), property);
    return Vector3(std::get<std::vector<double>>(valueOf(this->last(), parameter)).data());
  }
  // The axis that points at the eye, in the view from the front.
  int facing(const Gizmo& gizmo)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (outlineOf(gizmo, GizmoGrip::Arrow, k).empty())
      {
        return k;
      }
    }
    ADD_FAILURE() << "no axis points at the eye";
    return 2;
  }
};

} // namespace

TEST(PlaceGizmo, AnArrowMovesAlongItsAxisAsFarAsTheHandGoes)
{
  const Vector3 middle(0.2, -0.1, 0.3);
  Pose from;
  from.turn = { 20.0, -40.0, 70.0 };
  const View views[] = { oversketch_test::orthographicView({ 1, 2, 3 }, { 0, 1, 0 }, 100.0),
    oversketch_test::perspectiveView({ 3, 2, 6 }, { 0, 1, 0 }, 30.0) };
  for (const View& view : views)
  {
    const Gizmo gizmo = seeGizmo(view, middle, from.axes(), 1.0);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_FALSE(outlineOf(gizmo, GizmoGrip::Arrow, k).empty());
      const Vector2 run = runOf(gizmo, k), start = ::middleOf(gizmo) + 30.0 * run, now = start + 25.0 * run;
      const auto grip = gripAt(gizmo, start, 1.0);
      ASSERT_TRUE(grip);
      EXPECT_EQ(grip->part, GizmoGrip::Arrow);
      EXPECT_EQ(grip->axis, k);
      const Pose to = posed(view, middle, from, *grip, start, now, false);
      const Vector3 axis = from.axes().col(k);
      EXPECT_LT((to.move - to.move.dot(axis) * axis).norm(), 1e-12) << "beside the axis";
      EXPECT_EQ(to.turn, from.turn);
      EXPECT_EQ(to.scale, from.scale);
      // The place of the axis that was under the hand is under it.
      const Vector3 held = middle + alongAxis(view, start, middle, axis) * axis + to.move;
      EXPECT_LT((view.toDisplay(held).head<2>() - now).norm(), 0.02 * 25.0);
    }
  }
}

TEST(PlaceGizmo, ABoxScalesByTheRatioOfDistancesAndNeverTurnsOver)
{
  const View view = oversketch_test::orthographicView({ 1, 2, 3 }, { 0, 1, 0 }, 100.0);
  const Gizmo gizmo = seeGizmo(view, Vector3::Zero(), Eigen::Matrix3d::Identity(), 1.0);
  const Vector2 middle = ::middleOf(gizmo), start = ::boxOf(gizmo, 1);
  const auto grip = gripAt(gizmo, start, 1.0);
  ASSERT_TRUE(grip);
  EXPECT_EQ(grip->part, GizmoGrip::Box);
  const Pose one = posed(view, Vector3::Zero(), {}, *grip, start, 2.0 * start - middle, false);
  EXPECT_LT((one.scale - Vector3(1.0, 2.0, 1.0)).norm(), 1e-9);
  const Pose all = posed(view, Vector3::Zero(), {}, *grip, start, 2.0 * start - middle, true);
  EXPECT_LT((all.scale - Vector3(2.0, 2.0, 2.0)).norm(), 1e-9);
  const Pose over = posed(view, Vector3::Zero(), {}, *grip, start, 2.0 * middle - start, false);
  EXPECT_GT(over.scale[1], 0.0);
}

TEST(PlaceGizmo, ARingTurnsAboutItsAxisWhicheverWayItLooks)
{
  for (const Vector3& from : { Vector3(0.1, 0.2, 1.0), Vector3(1.0, 0.3, 0.05) })
  {
    const View view = oversketch_test::orthographicView(from, { 0, 1, 0 }, 100.0);
    const GizmoGrip grip{ GizmoGrip::Ring, 2 };
    const oversketch::Polyline ring =
      outlineOf(seeGizmo(view, Vector3::Zero(), Eigen::Matrix3d::Identity(), 1.0), grip.part, grip.axis);
    ASSERT_FALSE(ring.empty());
    // The side of the ring that is nearer to the eye: its places follow the hand's direction.
    const std::size_t at = from[2] > 0.5 ? 8 : 0;
    const Pose to = posed(view, Vector3::Zero(), {}, grip, ring[at], ring[at + 2], false);
    EXPECT_GT(to.turn[2], 3.0);
    EXPECT_LT(to.turn[2], 25.0);
    EXPECT_LT(std::hypot(to.turn[0], to.turn[1]), 1e-9);
  }
}

TEST(Place, AClickShowsTheGizmoAndAnArrowMovesAlongItsAxis)
{
  PlaceScene scene;
  ASSERT_EQ(scene.view->tool()->system(), "Transform");
  const Vector3 middle = scene.middleOf();
  const std::string before = scene.document->digest();
  EXPECT_FALSE(scene.view->tool()->holds(scene.display(middle)[0], scene.display(middle)[1]));
  scene.click(scene.display(middle));
  ASSERT_TRUE(scene.view->tool()->holds(scene.display(middle)[0], scene.display(middle)[1]));
  const Gizmo gizmo = scene.gizmoAt(middle);
  const Vector2 run = runOf(gizmo, 0), start = ::middleOf(gizmo) + 40.0 * run;
  scene.drag(start, start + 100.0 * run);
  ASSERT_EQ(scene.steps(), 1u);
  EXPECT_EQ(scene.last().system, "Transform");
  const Vector3 move = scene.value("Move");
  EXPECT_EQ(move[1], 0.0);
  EXPECT_EQ(move[2], 0.0);
  EXPECT_NEAR((scene.display(middle + move) - scene.display(middle)).dot(run), 100.0, 2.0);
  EXPECT_LT((scene.middleOf() - middle - move).norm(), 1e-6 * scene.document->result().mesh->GetLength());
  // The next drag changes the same step, and each is one step of undo.
  const Vector2 again = scene.display(middle + move) + 40.0 * run;
  scene.drag(again, again - 50.0 * run);
  ASSERT_EQ(scene.steps(), 1u);
  EXPECT_NEAR(scene.value("Move")[0], 0.5 * move[0], 0.03 * std::abs(move[0]));
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.value("Move"), move);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.steps(), 0u);
  EXPECT_EQ(scene.document->digest(), before);
}

TEST(Place, RingsTurnBoxesScaleAndEscapeTakesADragBack)
{
  PlaceScene scene;
  const Vector3 middle = scene.middleOf();
  scene.click(scene.display(middle));
  const Gizmo gizmo = scene.gizmoAt(middle);
  const int facing = scene.facing(gizmo);
  const oversketch::Polyline ring = outlineOf(gizmo, GizmoGrip::Ring, facing);
  ASSERT_FALSE(ring.empty());
  scene.drag(ring[8], ring[24]); // a quarter
  ASSERT_EQ(scene.steps(), 1u);
  Vector3 turned = Vector3::Zero();
  turned[facing] = 90.0;
  EXPECT_LT((scene.value("Turn") - turned).norm(), 2.0);
  EXPECT_EQ(scene.value("Move"), Vector3::Zero());
  // Axes turn with it: the box of the next axis is where that of the one after was.
  const Gizmo now = scene.gizmoAt(middle, scene.value("Turn"));
  const int across = (facing + 1) % 3;
  const Vector2 box = ::boxOf(now, across), half = 0.5 * (box - ::middleOf(now));
  scene.drag(box, box + half, Qt::ShiftModifier);
  ASSERT_EQ(scene.steps(), 1u);
  EXPECT_LT((scene.value("Scale") - Vector3::Constant(1.5)).norm(), 0.06);
  scene.drag(box, box + half);
  EXPECT_NEAR(scene.value("Scale")[across], 2.25, 0.09);
  EXPECT_NEAR(scene.value("Scale")[facing], 1.5, 0.03);
  const std::string kept = scene.document->digest();
  scene.drag(box, box + half, Qt::NoModifier, false);
  EXPECT_TRUE(scene.view->tool()->isBusy());
  QTest::keyClick(scene.view, Qt::Key_Escape);
  EXPECT_FALSE(scene.view->tool()->isBusy());
  QTest::mouseRelease(scene.view, Qt::LeftButton);
  scene.wait();
  EXPECT_EQ(scene.document->digest(), kept);
  EXPECT_EQ(scene.view->mesh()->GetBounds()[0], scene.document->result().display->GetBounds()[0])
    << "the preview stayed";
}

TEST(Place, ADoubleClickMakesATwinAndCtrlPutsItOnWhatIsUnderTheCursor)
{
  PlaceScene scene;
  const Vector3 middle = scene.middleOf();
  const std::string before = scene.document->digest();
  const vtkIdType points = scene.document->result().mesh->GetNumberOfPoints();
  const Vector2 at = scene.display(middle);
  scene.click(at);
  QTest::mouseDClick(scene.view, Qt::LeftButton, Qt::NoModifier, scene.qt(at));
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, scene.qt(at));
  scene.wait();
  scene.settle();
  ASSERT_EQ(scene.steps(), 1u);
  ASSERT_EQ(scene.document->result().mesh->GetNumberOfPoints(), 2 * points);
  ASSERT_EQ(oversketch_files::partsOf(scene.document->result().mesh), (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(replayed(scene.document->session()), scene.document->digest());
  // The twin is the hand's: an arrow puts it aside, as a step of its own.
  const Gizmo gizmo = scene.gizmoAt(scene.middleOf(1));
  const Vector2 run = runOf(gizmo, 0), arrow = ::middleOf(gizmo) + 40.0 * run;
  scene.drag(arrow, arrow + 150.0 * run);
  ASSERT_EQ(scene.steps(), 2u);
  const auto first = oversketch_files::partAlone(scene.document->result().mesh, 0);
  EXPECT_LT((Vector3(first->GetCenter()) - middle).norm(), 1e-9 * first->GetLength() + 1e-12) << "both moved";
  // Onto the other's back, from its square.
  scene.drag(scene.display(scene.middleOf(1)), at, Qt::ControlModifier);
  ASSERT_EQ(scene.steps(), 2u);
  const auto twin = oversketch_files::partAlone(scene.document->result().mesh, 1);
  Vector3 foot(twin->GetCenter());
  const int up = scene.document->upAxis();
  foot[up] = twin->GetBounds()[2 * up];
  EXPECT_LT((scene.display(foot) - at).norm(), 1.5);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(first);
  locator->BuildLocator();
  Vector3 nearest;
  vtkIdType cell = 0;
  int part = 0;
  double square = 0.0;
  locator->FindClosestPoint(foot.data(), nearest.data(), cell, part, square);
  EXPECT_LT(std::sqrt(square), 1e-5 * first->GetLength());
  for (int i = 0; i < 3; ++i)
  {
    scene.document->undo();
    scene.wait();
  }
  EXPECT_EQ(scene.document->digest(), before);
}

TEST(Place, ALockedModelIsNotTakenHoldOf)
{
  PlaceScene scene;
  const Vector2 at = scene.display(scene.middleOf());
  scene.document->setModel(0, true, true);
  scene.wait();
  scene.click(at);
  EXPECT_FALSE(scene.view->tool()->holds(at[0], at[1]));
  scene.document->setModel(0, true, false);
  scene.wait();
  scene.click(at);
  EXPECT_TRUE(scene.view->tool()->holds(at[0], at[1]));
}
