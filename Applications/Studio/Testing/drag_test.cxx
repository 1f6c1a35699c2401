// A line that is dragged: what is seen under the hand is what comes of it.
#include "scene.h"

#include "Harness/bits.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkStaticCellLocator.h"

#include <iostream>

using namespace oversketch_studio;

namespace
{

// How far the points of one mesh are from another's surface at most.
double farthest(vtkPolyData* points, vtkPolyData* surface)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  double most = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double nearest[3], squared = 0.0;
    vtkIdType cell = -1;
    int part = 0;
    locator->FindClosestPoint(points->GetPoint(i), nearest, cell, part, squared);
    most = std::max(most, std::sqrt(squared));
  }
  return most;
}

} // namespace

TEST(Drag, EndsAsItsPreview)
{
  Scene scene;
  scene.draw();
  scene.release();
  QApplication::processEvents();
  scene.wait();
  const auto& nodes = scene.document->result().nodes;
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_TRUE(nodes[0].failure.empty() && nodes[0].hold) << nodes[0].failure;
  const auto hold = oversketch_test::deepCopy(nodes[0].hold),
             before = oversketch_test::deepCopy(scene.document->result().mesh);
  // A pixel at the model's middle.
  const double middle[3] = { 0.0, 0.0, 0.0 }, aside[3] = { 1.0, 0.0, 0.0 };
  const double pixel = 1.0 / (scene.seen(aside) - scene.seen(middle)).x();
  // Taken by its middle.
  const QPoint grip = scene.end - QPoint(45, 29), by(26, -10);
  moveMouse(scene.view, grip, Qt::NoButton);
  QTest::mousePress(scene.view, Qt::LeftButton, Qt::NoModifier, grip);
  for (int i = 1; i <= 10; ++i)
  {
    moveMouse(scene.view, grip + i * by / 10);
    QApplication::processEvents();
  }
  const auto preview = oversketch_test::deepCopy(scene.view->mesh());
  ASSERT_GT(farthest(preview, before) / pixel, 10.0) << "nothing follows the hand";
  const auto ticket = scene.document->result().ticket;
  QTest::mouseRelease(scene.view, Qt::LeftButton, Qt::NoModifier, grip + by);
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene.document->result().ticket > ticket; }, 600000));
  scene.wait();
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_TRUE(nodes[0].failure.empty() && nodes[0].hold) << nodes[0].failure;
  vtkPolyData* after = scene.document->result().mesh;
  const double there = farthest(preview, after) / pixel, back = farthest(after, preview) / pixel;
  std::cout << "preview and release apart by " << there << " and " << back << " px\n";
  EXPECT_LT(there, 4.0);
  EXPECT_LT(back, 4.0);
  // It still holds what it took.
  ASSERT_EQ(nodes[0].hold->GetNumberOfPoints(), hold->GetNumberOfPoints());
  for (vtkIdType i = 0; i < hold->GetNumberOfPoints(); ++i)
  {
    double was[3];
    hold->GetPoint(i, was);
    EXPECT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(was, nodes[0].hold->GetPoint(i))), 1e-9);
  }
}
