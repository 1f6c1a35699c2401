// What the stroke takes hold of is seen while it is drawn, and the pen does not wait for it.
#include "scene.h"

#include <algorithm>

using namespace oversketch_studio;

namespace
{

bool isBlue(const QColor& c)
{
  return c.blue() > 180 && c.red() < 110 && c.green() < 160;
}

bool isRed(const QColor& c)
{
  return c.red() > 160 && c.green() < 90 && c.blue() < 90;
}

} // namespace

TEST(PenSection, IsSeenUnderAPenThatStandsAndIsWhatTheStrokeTakesHoldOf)
{
  Scene scene;
  EXPECT_EQ(count(scene.view->grabFramebuffer(), isBlue), 0);
  scene.draw();
  QImage drawn;
  EXPECT_TRUE(scene.comes(
    [&](const QImage& image)
    {
      drawn = image;
      return count(drawn, isBlue) > 30;
    }))
    << "no section under the pen";
  // It may still be that of fewer samples.
  EXPECT_TRUE(QTest::qWaitFor(
    [&]
    {
      QTest::qWait(1000);
      const QImage before = drawn;
      drawn = scene.view->grabFramebuffer();
      return drawn == before;
    },
    600000));
  EXPECT_GT(count(drawn, isRed), 100) << "no line";
  scene.release();
  scene.wait();
  const auto& nodes = scene.document->result().nodes;
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_TRUE(nodes[0].hold) << nodes[0].failure;
  const vtkIdType places = nodes[0].hold->GetNumberOfPoints();
  ASSERT_GT(places, 10);
  int met = 0;
  for (vtkIdType i = 0; i < places; ++i)
  {
    const QColor colour = drawn.pixelColor(scene.seen(nodes[0].hold->GetPoint(i)));
    met += isBlue(colour) || isRed(colour);
  }
  EXPECT_GT(met, 0.9 * static_cast<double>(places)) << "blue is another place than the one that is taken";
}

TEST(PenSection, GoesWithTheStroke)
{
  Scene scene;
  scene.draw();
  QTest::keyClick(scene.view, Qt::Key_Escape); // answers are on their way
  // A short line far from the model takes hold of nothing, and nothing of the one before is seen under it.
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, { 4, 4 });
  int most = 0;
  for (int x = 5; x < 20; ++x)
  {
    moveMouse(scene.view, { x, 4 + x % 3 });
    QApplication::processEvents();
    most = std::max(most, count(scene.view->grabFramebuffer(), isBlue));
  }
  EXPECT_EQ(most, 0);
  QTest::keyClick(scene.view, Qt::Key_Escape);
  EXPECT_TRUE(scene.document->session().nodes.empty());
}
