// Who follows the hint exactly gets what it says.
#include "hint_line.h"
#include "scene.h"

#include <algorithm>

using namespace oversketch_studio;
using oversketch::Polyline;
using oversketch::Vector2;

TEST(Hint, FollowedExactlyItMakesTheTailLonger)
{
  Scene scene;
  vtkPolyData* mesh = scene.document->result().mesh;
  vtkRenderer* renderer = scene.renderer();
  Polyline picture;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    renderer->SetWorldPoint(p[0], p[1], p[2], 1.0);
    renderer->WorldToDisplay();
    picture.emplace_back(renderer->GetDisplayPoint()[0], renderer->GetDisplayPoint()[1]);
  }
  const int tip = scene.top().y();
  const Polyline line = oversketch::uniformPolyline(hintLine(picture, 1.0), 3.0);
  ASSERT_GT(line.size(), 20u);
  const auto at = [&](const Vector2& p)
  {
    return QPoint(
      static_cast<int>(std::lround(p[0])), scene.view->height() - 1 - static_cast<int>(std::lround(p[1])));
  };
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, at(line.front()));
  for (const Vector2& p : line)
  {
    moveMouse(scene.view, at(p));
    QApplication::processEvents();
  }
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, at(line.back()));
  scene.wait();
  const auto& nodes = scene.document->result().nodes;
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].failure, "");
  EXPECT_EQ(nodes[0].remark, "");
  EXPECT_LT(scene.top().y(), tip - 20);
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
