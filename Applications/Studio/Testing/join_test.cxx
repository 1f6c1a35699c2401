// Parts that become one body: the button of the panel Scene, the tool Join, and Place on what is joined.
#include "mesh_file.h"
#include "pieces.h"
#include "place_gizmo.h"
#include "row_delegate.h"
#include "sheet.h"
#include "tool.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"

#include <QToolButton>

#include <cmath>

using namespace oversketch_studio;

namespace
{

// The window on two balls of radius 1, parts of one mesh, whose middles are so far apart along x.
struct Balls : Sheet
{
  explicit Balls(double apart)
    : join(this->window.findChild<QToolButton*>("join_parts"))
    , things(this->window.findChild<QListWidget*>("scene"))
  {
    QApplication::setActiveWindow(&this->window);
    const oversketch::Mesh ball = oversketch_test::icosphere(4);
    const auto balls = oversketch_test::toPolyData(oversketch_test::joined(ball, ball, { apart, 0, 0 }));
    vtkNew<vtkIntArray> parts;
    parts->SetName("PartId");
    for (int i = 0; i < 2 * ball.triangleCount(); ++i)
    {
      parts->InsertNextValue(i / ball.triangleCount());
    }
    balls->GetCellData()->AddArray(parts);
    const QString path = this->folder.filePath("balls.vtp");
    oversketch_files::Notes notes;
    oversketch_files::writeMesh(balls, path.toStdString(), notes);
    EXPECT_TRUE(this->window.open(path));
    this->settle();
  }
  void takeTool()
  {
    QTest::keyClick(this->view, Qt::Key_8);
    Scene::settle();
    this->pictureAtRest();
  }
  void stroke(const QPoint& from, const QPoint& to)
  {
    const auto at = [&](int i) { return from + (to - from) * i / 40; };
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, from);
    sweepMouse(this->view, 1, 40, at);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, to);
    this->settle();
  }
  // A place in front, on the first ball.
  QPoint front(double x)
  {
    const double place[3] = { x, 0.0, std::sqrt(1.0 - x * x) };
    return this->seen(place);
  }
  double width() { return std::get<double>(this->step(0).values.at("Width")); }

  QToolButton* join;
  QListWidget* things;
};

double volumeOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  return mass->GetVolume();
}

} // namespace

TEST(Join, TheButtonMakesOneBodyAndUndoTakesItBack)
{
  Balls balls(1.2);
  ASSERT_EQ(balls.things->count(), 2);
  EXPECT_EQ(eulerOf(balls.mesh()), 4);
  ASSERT_TRUE(balls.join->isEnabled());
  const std::string before = balls.document->digest();
  QTest::mouseClick(balls.join, Qt::LeftButton);
  balls.settle();
  ASSERT_EQ(balls.session().nodes.size(), 1u);
  EXPECT_EQ(balls.failure(), "");
  EXPECT_EQ(balls.list->currentRow(), 0);
  EXPECT_EQ(balls.list->item(0)->data(RowDelegate::WordsRole).toString(), "makes one body of parts");
  EXPECT_EQ(balls.step(0).system, "Join");
  EXPECT_TRUE(balls.step(0).values.empty());
  EXPECT_EQ(openEdges(balls.mesh()), 0);
  EXPECT_EQ(eulerOf(balls.mesh()), 2) << "not one body";
  // Two balls without the lens that they have in common.
  const double ball = 4.0 / 3.0 * M_PI, lens = M_PI * (4.0 + 1.2) * 0.8 * 0.8 / 12.0;
  EXPECT_NEAR(volumeOf(balls.mesh()), 2.0 * ball - lens, 0.01 * ball);
  EXPECT_EQ(balls.things->count(), 1);
  EXPECT_FALSE(balls.join->isEnabled());
  EXPECT_EQ(replayed(balls.session()), balls.document->digest());
  balls.document->undo();
  balls.settle();
  EXPECT_EQ(balls.document->digest(), before);
  EXPECT_EQ(balls.things->count(), 2);
  balls.document->setModel(0, true, true);
  balls.settle();
  EXPECT_FALSE(balls.join->isEnabled()) << "a locked model takes no steps";
}

TEST(Join, ALineGivesTheSeamItsWidth)
{
  Balls balls(1.2);
  balls.takeTool();
  ASSERT_EQ(balls.view->tool()->system(), "Join");
  // From the first ball to the same place of the second one, over the crease between.
  const auto across = [&](double x)
  {
    const double place[3] = { 1.2 - x, 0.0, std::sqrt(1.0 - x * x) };
    balls.stroke(balls.front(x), balls.seen(place));
    return 2.0 * (std::acos(x) - std::acos(0.6));
  };
  const double wide = across(0.3);
  ASSERT_EQ(balls.session().nodes.size(), 1u);
  EXPECT_EQ(balls.failure(), "");
  EXPECT_NEAR(balls.width(), wide, 0.03 * wide);
  EXPECT_EQ(eulerOf(balls.mesh()), 2);
  EXPECT_EQ(openEdges(balls.mesh()), 0);
  const std::string first = balls.document->digest();
  // Another line is another width of the same step. The seam is rounded by now: the way is a little shorter.
  const double wider = across(0.2);
  ASSERT_EQ(balls.session().nodes.size(), 1u);
  EXPECT_GT(balls.width(), wide);
  EXPECT_LT(balls.width(), 1.01 * wider);
  EXPECT_NE(balls.document->digest(), first);
  EXPECT_EQ(replayed(balls.session()), balls.document->digest());
  balls.document->undo();
  balls.settle();
  EXPECT_EQ(balls.document->digest(), first);
}

TEST(Join, ALineBesideTheModelAndAClickDoNothingButSaySo)
{
  Balls balls(1.2);
  balls.takeTool();
  balls.stroke({ 10, 10 }, { 90, 10 });
  EXPECT_TRUE(balls.session().nodes.empty());
  EXPECT_EQ(balls.advice->text(), "The line lies beside the model: draw it on the model.");
  const QPoint at = balls.front(0.3);
  balls.stroke(at, at + QPoint(3, 0));
  EXPECT_TRUE(balls.session().nodes.empty());
  EXPECT_TRUE(balls.advice->text().startsWith("Too short")) << qPrintable(balls.advice->text());
  QTest::mouseClick(balls.view, Qt::LeftButton, Qt::NoModifier, at);
  balls.settle();
  EXPECT_TRUE(balls.session().nodes.empty());
}

TEST(Join, PartsThatDoNotMeetAreLeftAndTheRowSaysWhy)
{
  Balls balls(3.0);
  const std::string before = balls.document->digest();
  QTest::mouseClick(balls.join, Qt::LeftButton);
  balls.settle();
  ASSERT_EQ(balls.session().nodes.size(), 1u);
  EXPECT_NE(balls.failure(), "");
  EXPECT_EQ(balls.document->digest(), before);
  EXPECT_TRUE(balls.advice->text().contains("Part 2 meets none of the others"))
    << qPrintable(balls.advice->text());
  EXPECT_EQ(balls.things->count(), 2) << "still two parts";
}

// Parts that wear pictures keep their numbers, and are one body all the same.
TEST(Join, WhatIsJoinedIsPlacedAsAWhole)
{
  Sheet sheet;
  sheet.open();
  sheet.line(beast());
  sheet.document->add(*sheet.document->partReader(sheet.file)().step);
  sheet.settle();
  sheet.document->setPlacement(1, { { 100.0, 50.0, 500.0, 350.0 }, 20.0 }, false);
  sheet.settle();
  sheet.list->setCurrentRow(2);
  sheet.settle();
  sheet.line(ring({ 200, 150 }, 60));
  auto* things = sheet.window.findChild<QListWidget*>("scene");
  ASSERT_EQ(things->count(), 2);
  things->item(1)->setCheckState(Qt::Unchecked);
  sheet.settle();
  QTest::mouseClick(sheet.window.findChild<QToolButton*>("join_parts"), Qt::LeftButton);
  sheet.settle();
  ASSERT_EQ(sheet.failure(2), "");
  EXPECT_EQ(oversketch_files::partsOf(sheet.mesh()).size(), 2u);
  EXPECT_EQ(things->count(), 1) << "half of a body can be hidden";
  EXPECT_TRUE(hiddenOf(sheet.session(), sheet.document->result().parts).empty());
  QTest::keyClick(sheet.view, Qt::Key_7);
  sheet.settle();
  sheet.view->display().showWhole(sheet.view->fittedSize().data());
  sheet.pictureAtRest();
  const QPoint middle = sheet.seen(sheet.mesh()->GetCenter());
  QTest::mouseClick(sheet.view, Qt::LeftButton, Qt::NoModifier, middle);
  sheet.settle();
  moveMouse(sheet.view, middle, Qt::NoButton);
  QTest::mousePress(sheet.view, Qt::LeftButton, Qt::NoModifier, middle);
  sweepMouse(sheet.view, 1, 10, [&](int i) { return middle + QPoint(4 * i, 0); });
  QTest::mouseRelease(sheet.view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(40, 0));
  sheet.settle();
  ASSERT_EQ(sheet.session().nodes.size(), 4u);
  EXPECT_EQ(sheet.failure(3), "");
  EXPECT_EQ(std::get<int>(sheet.step(3).values.at("Part")), -1);
}
