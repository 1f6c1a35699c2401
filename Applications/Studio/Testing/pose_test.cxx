// The tool Pose: a bone along a leg of the shipped dog, and its new course.
#include "scene.h"
#include "tool.h"

#include <vector>

using namespace oversketch_studio;
using oversketch_session::findSystem;

namespace
{

struct PoseScene : Scene
{
  PoseScene()
  {
    QApplication::setActiveWindow(&this->window);
    QTest::keyClick(this->view, Qt::Key_6);
    this->settle();
    this->before = this->document->result().mesh.Get();
    this->foot = this->lowest();
    this->joint = this->foot - QPoint(0, 60);
  }
  // The middle of the paw that is lowest in the picture.
  QPoint lowest()
  {
    std::vector<QPoint> all;
    int low = 0;
    for (vtkIdType i = 0; i < this->before->GetNumberOfPoints(); ++i)
    {
      all.push_back(this->seen(this->before->GetPoint(i)));
      low = std::max(low, all.back().y());
    }
    int left = 0, right = 0;
    for (const QPoint& at : all)
    {
      if (at.y() == low)
      {
        left = right = at.x();
      }
    }
    for (const QPoint& at : all)
    {
      if (at.y() > low - 12 && std::abs(at.x() - left) < 25)
      {
        left = std::min(left, at.x());
        right = std::max(right, at.x());
      }
    }
    return { (left + right) / 2, low };
  }
  void press(const QPoint& from, const QPoint& to)
  {
    this->settle();
    const auto at = [&](int i) { return from + (to - from) * i / 30; };
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(0));
    sweepMouse(this->view, 1, 30, at);
  }
  void line(const QPoint& from, const QPoint& to)
  {
    this->press(from, to);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, to);
    QApplication::processEvents();
    this->wait();
    QApplication::processEvents();
  }
  const oversketch_session::Step& step() { return *this->document->session().nodes.back().step; }
  // Points of a mesh that lie elsewhere than before.
  vtkIdType moved(vtkPolyData* mesh)
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      mesh->GetPoint(i, p);
      this->before->GetPoint(i, q);
      count += p[0] != q[0] || p[1] != q[1] || p[2] != q[2];
    }
    return count;
  }

  vtkSmartPointer<vtkPolyData> before;
  QPoint foot, joint;
};

} // namespace

TEST(Pose, ABoneIsHeldAndItsCourseBendsTheLegUnderThePen)
{
  if (!findSystem("Pose"))
  {
    return;
  }
  PoseScene scene;
  ASSERT_EQ(scene.view->tool()->system(), "Pose");
  scene.line(scene.joint, scene.foot - QPoint(0, 6));
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(scene.document->result().nodes[0].failure, "");
  EXPECT_EQ(scene.moved(scene.document->result().mesh), 0);

  const QPoint there = scene.joint + QPoint(45, 35);
  scene.press(scene.joint + QPoint(2, 1), there);
  EXPECT_GT(scene.moved(scene.view->mesh()), 50) << "nothing follows the pen";
  EXPECT_EQ(scene.moved(scene.document->result().mesh), 0);
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, there);
  QApplication::processEvents();
  scene.wait();
  QApplication::processEvents();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u) << "the course became a bone";
  EXPECT_EQ(scene.step().inputs.count("Pose"), 1u);
  EXPECT_EQ(scene.document->result().nodes[0].failure, "");
  const vtkIdType moved = scene.moved(scene.document->result().mesh);
  EXPECT_GT(moved, 50);
  EXPECT_LT(moved, scene.before->GetNumberOfPoints() / 4);

  // Drawn again it is another course of the same bone.
  const std::string digest = scene.document->digest();
  scene.line(scene.joint, scene.joint + QPoint(-45, 35));
  EXPECT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_NE(scene.document->digest(), digest);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.document->digest(), digest);
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.moved(scene.document->result().mesh), 0);
  EXPECT_EQ(scene.step().inputs.count("Pose"), 0u);
}

TEST(Pose, ReturnLeavesTheBoneAndEscapeTheCourse)
{
  if (!findSystem("Pose"))
  {
    return;
  }
  PoseScene scene;
  scene.line(scene.joint, scene.foot - QPoint(0, 6));
  scene.press(scene.joint, scene.joint + QPoint(45, 35));
  QTest::keyClick(scene.view, Qt::Key_Escape);
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, scene.joint + QPoint(45, 35));
  scene.wait();
  EXPECT_EQ(scene.moved(scene.view->mesh()), 0);
  EXPECT_EQ(scene.step().inputs.count("Pose"), 0u);
  QTest::keyClick(scene.view, Qt::Key_Return);
  scene.line(scene.joint, scene.foot - QPoint(0, 6));
  EXPECT_EQ(scene.document->session().nodes.size(), 2u);
}
