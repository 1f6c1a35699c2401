// What the stroke takes hold of is seen while it is drawn, and the pen does not wait for it.
#include "document.h"
#include "main_window.h"
#include "view.h"

#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <QApplication>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace oversketch_studio;

namespace
{

bool isBlue(QColor c)
{
  return c.blue() > 180 && c.red() < 110 && c.green() < 160;
}

bool isRed(QColor c)
{
  return c.red() > 160 && c.green() < 90 && c.blue() < 90;
}

int count(const QImage& image, bool (*is)(QColor))
{
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      found += is(image.pixelColor(x, y));
    }
  }
  return found;
}

struct Scene
{
  Scene()
  {
    this->window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->window, 60000));
    this->window.openShippedModel();
    this->view = this->window.findChild<View*>();
    this->document = this->window.findChild<Document*>();
    this->wait();
    EXPECT_TRUE(
      QTest::qWaitFor([this] { return this->document->result().mesh && !this->document->isBusy(); }, 600000));
  }
  ~Scene() { this->document->discardAutosave(); }

  void wait()
  {
    EXPECT_TRUE(QTest::qWaitFor([this] { return !this->document->isBusy(); }, 600000));
  }
  // Where a place of the world is in the view, in pixels from its upper left corner.
  QPoint seen(const double place[3])
  {
    vtkRenderer* renderer = this->view->renderWindow()->GetRenderers()->GetFirstRenderer();
    renderer->SetWorldPoint(place[0], place[1], place[2], 1.0);
    renderer->WorldToDisplay();
    double at[3];
    renderer->GetDisplayPoint(at);
    return { static_cast<int>(std::lround(at[0])),
      this->view->height() - 1 - static_cast<int>(std::lround(at[1])) };
  }
  QPoint top()
  {
    vtkPolyData* mesh = this->document->result().mesh;
    QPoint highest(0, this->view->height());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const QPoint at = this->seen(mesh->GetPoint(i));
      highest = at.y() < highest.y() ? at : highest;
    }
    return highest;
  }
  // An arch over the model's highest place, the pen left down at its end.
  void draw()
  {
    const QPoint over = this->top();
    const auto at = [&](int i)
    { return over + QPoint(3 * i, static_cast<int>(std::lround(20.0 - 45.0 * std::cos(0.08 * i)))); };
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, at(-15));
    for (int i = -14; i <= 15; ++i)
    {
      QTest::mouseMove(this->view, at(i));
      QApplication::processEvents();
    }
    this->end = at(15);
  }

  MainWindow window;
  View* view = nullptr;
  Document* document = nullptr;
  QPoint end;
};

} // namespace

TEST(PenSection, IsSeenUnderAPenThatStandsAndIsWhatTheStrokeTakesHoldOf)
{
  Scene scene;
  EXPECT_EQ(count(scene.view->grabFramebuffer(), isBlue), 0);
  scene.draw();
  QImage drawn;
  EXPECT_TRUE(QTest::qWaitFor(
    [&]
    {
      drawn = scene.view->grabFramebuffer();
      return count(drawn, isBlue) > 30;
    },
    600000))
    << "no section under the pen";
  EXPECT_GT(count(drawn, isRed), 100) << "no line";
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, scene.end);
  scene.wait();
  const auto& nodes = scene.document->result().nodes;
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_TRUE(nodes[0].matched) << nodes[0].failure;
  const vtkIdType places = nodes[0].matched->GetNumberOfPoints();
  ASSERT_GT(places, 10);
  int met = 0;
  for (vtkIdType i = 0; i < places; ++i)
  {
    const QColor colour = drawn.pixelColor(scene.seen(nodes[0].matched->GetPoint(i)));
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
    QTest::mouseMove(scene.view, { x, 4 + x % 3 });
    QApplication::processEvents();
    most = std::max(most, count(scene.view->grabFramebuffer(), isBlue));
  }
  EXPECT_EQ(most, 0);
  QTest::keyClick(scene.view, Qt::Key_Escape);
  EXPECT_TRUE(scene.document->session().nodes.empty());
}
