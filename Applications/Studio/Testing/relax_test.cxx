// The tool Smooth, and Shift over the model with another tool in the hand.
#include "scene.h"
#include "tool.h"

#include "vtkCamera.h"

#include <QDoubleSpinBox>
#include <QWheelEvent>

using namespace oversketch_studio;
using oversketch_session::findSystem;

namespace
{

struct RelaxScene : Scene
{
  RelaxScene() { QApplication::setActiveWindow(&this->window); }

  // Over the body, or beside it.
  void line(Qt::KeyboardModifiers keys, const QPoint& beside = {})
  {
    this->settle();
    const QPoint middle = this->seen(this->document->result().mesh->GetCenter()) + beside;
    const auto at = [&](int i)
    { return middle + QPoint(4 * i - 50, static_cast<int>(std::lround(6.0 * std::sin(0.4 * i)))); };
    QTest::mousePress(this->view, Qt::LeftButton, keys, at(0));
    sweepMouse(this->view, 1, 25, at, keys);
    QTest::mouseRelease(this->view, Qt::LeftButton, keys, at(25));
    this->wait();
  }
  std::string lastSystem()
  {
    const auto& nodes = this->document->session().nodes;
    return nodes.empty() ? std::string() : nodes.back().step->system;
  }
  // Points of two meshes that differ.
  static vtkIdType moved(vtkPolyData* a, vtkPolyData* b)
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      a->GetPoint(i, p);
      b->GetPoint(i, q);
      count += p[0] != q[0] || p[1] != q[1] || p[2] != q[2];
    }
    return count;
  }
};

} // namespace

TEST(Relax, ALineSmoothsWhereItIsDrawnAndItsWidthFollowsTheWheel)
{
  if (!findSystem("Relax"))
  {
    return;
  }
  RelaxScene scene;
  const vtkSmartPointer<vtkPolyData> before = scene.document->result().mesh.Get();
  QTest::keyClick(scene.view, Qt::Key_Q);
  ASSERT_EQ(scene.view->tool()->system(), "Relax");
  scene.line(Qt::NoModifier);
  ASSERT_EQ(scene.lastSystem(), "Relax");
  const vtkIdType narrow = RelaxScene::moved(before, scene.document->result().mesh);
  EXPECT_GT(narrow, 50);
  EXPECT_LT(narrow, before->GetNumberOfPoints() / 4);
  for (int i = 0; i < 5; ++i)
  {
    const QPoint at(10, 10);
    QWheelEvent turn(at,
      scene.view->mapToGlobal(at),
      {},
      { 0, 120 },
      Qt::NoButton,
      Qt::ControlModifier,
      Qt::NoScrollPhase,
      false);
    turn.setTimestamp(1000 + 20 * i);
    QApplication::sendEvent(scene.view, &turn);
  }
  scene.wait();
  EXPECT_EQ(scene.document->session().nodes.size(), 1u) << "the wheel made another step";
  EXPECT_GT(RelaxScene::moved(before, scene.document->result().mesh), narrow * 5 / 4);
  scene.document->undo(); // all five are one
  scene.wait();
  EXPECT_EQ(RelaxScene::moved(before, scene.document->result().mesh), narrow);
}

TEST(Relax, ShiftOverTheModelSmoothsItAndGivesTheToolBack)
{
  if (!findSystem("Relax") || !findSystem("OneStroke"))
  {
    return;
  }
  RelaxScene scene;
  Tool* outline = scene.view->tool();
  ASSERT_EQ(outline->system(), "OneStroke");
  const vtkSmartPointer<vtkPolyData> before = scene.document->result().mesh.Get();
  scene.pictureAtRest();
  const auto looked = lookOf(*scene.view);
  scene.line(Qt::ShiftModifier);
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(scene.lastSystem(), "Relax");
  EXPECT_EQ(scene.view->tool(), outline);
  EXPECT_GT(RelaxScene::moved(before, scene.document->result().mesh), 50);
  EXPECT_TRUE(lookOf(*scene.view) == looked) << "the camera has moved";
  // The tool draws on as before.
  scene.draw();
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 2u);
  EXPECT_EQ(scene.lastSystem(), "OneStroke");
  scene.document->undo();
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(RelaxScene::moved(before, scene.document->result().mesh), 0);
}

TEST(Relax, ShiftBesideTheModelPans)
{
  RelaxScene scene;
  double before[3], after[3];
  scene.renderer()->GetActiveCamera()->GetFocalPoint(before);
  scene.line(Qt::ShiftModifier, QPoint(0, 300));
  scene.renderer()->GetActiveCamera()->GetFocalPoint(after);
  EXPECT_TRUE(scene.document->session().nodes.empty());
  EXPECT_NE(before[0], after[0]);
}
