// Who follows the hint exactly gets what it says.
#include "hint.h"
#include "scene.h"
#include "tool.h"

#include <QLabel>

#include <algorithm>

using namespace oversketch_studio;
using oversketch::Polyline;
using oversketch::Vector2;

namespace
{

// A person new to it on the shipped model, who does what the hints say.
struct Pupil : Scene
{
  Pupil()
  {
    QApplication::setActiveWindow(&this->window);
    this->view->setFocus();
  }
  Polyline hinted(HintShape shape)
  {
    vtkPolyData* mesh = this->document->result().mesh;
    Polyline picture;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      this->renderer()->SetWorldPoint(p[0], p[1], p[2], 1.0);
      this->renderer()->WorldToDisplay();
      picture.emplace_back(this->renderer()->GetDisplayPoint()[0], this->renderer()->GetDisplayPoint()[1]);
    }
    const Polyline line = hintLine(shape, picture, 1.0);
    EXPECT_GT(line.size(), 20u);
    return oversketch::uniformPolyline(line, 3.0);
  }
  void followHint()
  {
    ASSERT_FALSE(this->view->hint().isEmpty()) << qPrintable(this->view->tool()->title());
    const Polyline line = this->hinted(this->view->tool()->hintShape());
    const auto at = [&](const Vector2& p)
    {
      return QPoint(
        static_cast<int>(std::lround(p[0])), this->view->height() - 1 - static_cast<int>(std::lround(p[1])));
    };
    moveMouse(this->view, at(line.front()), Qt::NoButton);
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(line.front()));
    EXPECT_TRUE(this->view->hint().isEmpty()) << "it lies under the line being drawn";
    sweepMouse(this->view, 0, static_cast<int>(line.size()) - 1, [&](int i) { return at(line[i]); });
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, at(line.back()));
    QApplication::processEvents();
    this->wait();
    QApplication::processEvents();
  }
  void expectGood()
  {
    const auto& nodes = this->document->result().nodes;
    ASSERT_EQ(nodes.size(), 1u) << qPrintable(this->window.findChild<QLabel*>("advice")->text());
    EXPECT_EQ(nodes[0].failure, "");
    EXPECT_EQ(nodes[0].remark, "");
    EXPECT_TRUE(this->view->hint().isEmpty()) << "it has been learned";
    EXPECT_FALSE(this->window.findChild<QLabel*>("advice")->text().contains("did nothing"));
  }
};

} // namespace

TEST(Hint, FollowedExactlyItMakesTheTailLonger)
{
  Pupil pupil;
  const int tip = pupil.top().y();
  pupil.followHint();
  pupil.expectGood();
  EXPECT_LT(pupil.top().y(), tip - 20);
}

// Of each tool that draws on the model.
TEST(Hint, FollowedExactlyEachGivesAGoodResult)
{
  int tools = 0;
  Pupil pupil;
  for (Tool* tool : pupil.view->findChildren<Tool*>())
  {
    SCOPED_TRACE(qPrintable(tool->title()));
    pupil.window.openShippedModel();
    pupil.wait();
    QTest::keyClick(pupil.view, static_cast<Qt::Key>(tool->key()[0]));
    ASSERT_EQ(pupil.view->tool(), tool);
    QApplication::processEvents();
    pupil.wait();
    QApplication::processEvents();
    if (tool->hint().isEmpty())
    {
      EXPECT_TRUE(pupil.view->hint().isEmpty()) << "another tool's hint";
      continue;
    }
    ++tools;
    pupil.followHint();
    if (pupil.document->session().nodes.empty()) // a line comes before its ring
    {
      ASSERT_EQ(tool->hintShape(), HintShape::Ring)
        << qPrintable(pupil.window.findChild<QLabel*>("advice")->text());
      pupil.followHint();
    }
    pupil.expectGood();
    pupil.document->undo();
    pupil.wait();
  }
#if defined(OVERSKETCH_WITH_EDIT) && defined(OVERSKETCH_WITH_AUGMENT)
  EXPECT_EQ(tools, 6);
#endif
  EXPECT_GE(tools, 1);
}

TEST(Hint, IsGoneOnceTheModelIsTurnedOrAnotherIsOpened)
{
  Pupil pupil;
  EXPECT_FALSE(pupil.view->hint().isEmpty());
  QTest::keyClick(pupil.view, Qt::Key_X);
  EXPECT_TRUE(pupil.view->hint().isEmpty());
  QTest::keyClick(pupil.view, Qt::Key_B);
  EXPECT_TRUE(pupil.view->hint().isEmpty());
  pupil.window.openShippedModel();
  pupil.wait();
  EXPECT_FALSE(pupil.view->hint().isEmpty());
  ASSERT_TRUE(pupil.window.open(OVERSKETCH_DATA_FOLDER "/Models/bear.ply"));
  EXPECT_TRUE(pupil.view->hint().isEmpty());
  pupil.wait();
}

TEST(Hint, IsThereForAnyPicture)
{
  EXPECT_TRUE(hintLine({}, 1.0).empty());
  for (const Polyline& picture :
    { Polyline{ { 100, 100 } }, Polyline{ { 0, 0 }, { 500, 0 }, { 500, 500 }, { 0, 500 } } })
  {
    const Polyline line = hintLine(picture, 2.0);
    ASSERT_GT(line.size(), 3u);
    for (const Vector2& p : line)
    {
      EXPECT_TRUE(p.allFinite());
    }
  }
}
