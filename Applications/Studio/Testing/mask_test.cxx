// The tool Mask: a lasso over the model, what steps leave alone then, the buttons of its bar.
#include "mask_sheet.h"
#include "scene.h"
#include "tool.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <QToolButton>

using namespace oversketch_studio;
using oversketch_session::findSystem;

namespace
{

struct MaskScene : Scene
{
  MaskScene() { QApplication::setActiveWindow(&this->window); }

  QPoint middle() { return this->seen(this->document->result().mesh->GetCenter()); }
  void stroke(const std::function<QPoint(int)>& at, int count)
  {
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(0));
    sweepMouse(this->view, 1, count, at, Qt::NoModifier);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, at(count));
    this->wait();
  }
  // Round what lies right of the middle.
  void lasso()
  {
    QTest::keyClick(this->view, Qt::Key_4);
    ASSERT_EQ(this->view->tool()->system(), "Mask");
    this->settle();
    const QPoint from = this->middle();
    this->stroke(
      [&](int i)
      {
        const double turn = 6.2831853 * i / 40.0;
        return from + QPoint(60 - static_cast<int>(std::lround(60.0 * std::cos(turn))),
                        static_cast<int>(std::lround(40.0 * std::sin(turn))));
      },
      39);
  }
  void line()
  {
    QTest::keyClick(this->view, Qt::Key_Q);
    this->settle();
    const QPoint from = this->middle();
    this->stroke([&](int i) { return from + QPoint(4 * i - 50, 0); }, 25);
  }
  vtkIdType masked() const
  {
    vtkDataArray* mask = this->document->result().mesh->GetPointData()->GetArray("Mask");
    vtkIdType count = 0;
    for (vtkIdType i = 0; mask && i < mask->GetNumberOfTuples(); ++i)
    {
      count += mask->GetComponent(i, 0) == 1.0;
    }
    return count;
  }
  void press(const char* button)
  {
    QTest::mouseClick(this->window.findChild<QToolButton*>(button), Qt::LeftButton);
    this->wait();
  }
};

} // namespace

TEST(Mask, WhatALassoEnclosesIsDarkAndStaysUnderTheNextStroke)
{
  if (!findSystem("Mask") || !findSystem("Relax"))
  {
    return;
  }
  MaskScene scene;
  const vtkSmartPointer<vtkPolyData> before = scene.document->result().mesh.Get();
  EXPECT_FALSE(scene.view->masked().isShown());
  scene.lasso();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
  EXPECT_EQ(scene.document->session().nodes[0].step->system, "Mask");
  EXPECT_GT(scene.masked(), 50);
  EXPECT_LT(scene.masked(), before->GetNumberOfPoints() / 2);
  EXPECT_TRUE(scene.view->masked().isShown());

  scene.line();
  ASSERT_EQ(scene.document->session().nodes.size(), 2u);
  vtkPolyData* after = scene.document->result().mesh;
  vtkDataArray* mask = after->GetPointData()->GetArray("Mask");
  ASSERT_NE(mask, nullptr);
  vtkIdType moved = 0;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    before->GetPoint(i, p);
    after->GetPoint(i, q);
    const bool stays = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
    EXPECT_TRUE(stays || mask->GetComponent(i, 0) < 1.0) << i;
    moved += !stays;
  }
  EXPECT_GT(moved, 20);

  scene.document->undo();
  scene.document->undo();
  scene.wait();
  EXPECT_EQ(scene.masked(), 0);
  EXPECT_FALSE(scene.view->masked().isShown());
}

TEST(Mask, ButtonsChangeTheSelectedStepAndClearMakesOneOfItsOwn)
{
  if (!findSystem("Mask"))
  {
    return;
  }
  MaskScene scene;
  const vtkIdType all = scene.document->result().mesh->GetNumberOfPoints();
  scene.lasso();
  const vtkIdType first = scene.masked();
  scene.press("mask_grow");
  const vtkIdType grown = scene.masked();
  EXPECT_GT(grown, first);
  scene.press("mask_shrink");
  EXPECT_EQ(scene.masked(), first);
  scene.press("mask_invert");
  EXPECT_EQ(scene.masked(), all - first);
  scene.press("mask_grow");
  EXPECT_GT(scene.masked(), all - first);
  EXPECT_EQ(scene.document->session().nodes.size(), 1u);
  scene.press("mask_clear");
  EXPECT_EQ(scene.document->session().nodes.size(), 2u);
  EXPECT_EQ(scene.masked(), 0);
}
