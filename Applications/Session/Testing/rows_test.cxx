// What a list of steps shows of them: which order they can have, small pictures, strokes on the surface.
#include "Harness/drawings.h"
#include "drawing_lines.h"
#include "step_lines.h"
#include "step_order.h"
#include "thumbnail.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStaticCellLocator.h"

#include <gtest/gtest.h>

#include <memory>

using namespace oversketch_session;

namespace
{

Node nodeTaking(int id, int of)
{
  auto step = std::make_shared<Step>();
  step->system = "Edit";
  if (of > 0)
  {
    step->inputs["Reference"] = StepOutput{ of, 1 };
  }
  Node node;
  node.id = id;
  node.step = step;
  return node;
}

vtkSmartPointer<vtkPolyData> ball()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(50.0);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->Update();
  return source->GetOutput();
}

// Across the upper half of the ball, which a canvas of 200 x 150 shows from the front.
vtkSmartPointer<vtkPolyData> strokeOver()
{
  const oversketch::View view = oversketch_test::viewOver({ -100.0, -75.0 }, { 200.0, 150.0 }, 200, 150);
  std::vector<oversketch::Vector2> places;
  for (int i = 0; i <= 40; ++i)
  {
    places.emplace_back(i - 20.0, 30.0);
  }
  return oversketch_test::toStroke(oversketch_test::seen(places, view), view);
}

} // namespace

TEST(Order, OneThatTakesOfAnotherComesAfterIt)
{
  Session session;
  session.mesh = ball();
  session.nodes = { nodeTaking(1, 0), nodeTaking(2, 0), nodeTaking(3, 1), nodeTaking(4, 0) };
  EXPECT_FALSE(faultOfMove(session, 1, 3));
  EXPECT_FALSE(faultOfMove(session, 3, 0));
  EXPECT_FALSE(faultOfMove(session, 2, 1));
  const OrderFault down = faultOfMove(session, 0, 2), up = faultOfMove(session, 2, 0);
  for (const OrderFault& fault : { down, up })
  {
    EXPECT_EQ(fault.step, 2);
    EXPECT_EQ(fault.needed, 0);
  }
  std::vector<int> ids;
  for (const Node& node : moved(session.nodes, 0, 2))
  {
    ids.push_back(node.id);
  }
  EXPECT_EQ(ids, (std::vector<int>{ 2, 3, 1, 4 }));
  // Without a mesh to begin with the first step makes one.
  session.mesh = {};
  EXPECT_EQ(faultOfMove(session, 3, 0).needed, 0);
  EXPECT_EQ(faultOfMove(session, 0, 1).needed, 0);
  EXPECT_FALSE(faultOfMove(session, 1, 3));
}

TEST(Thumbnails, ShowTheModelWhatMovedAndTheStroke)
{
  const auto mesh = ball();
  vtkNew<vtkPolyData> upper; // of the ball
  upper->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> faces;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(i, ids);
    if (mesh->GetPoint(ids->GetId(0))[1] > 10.0)
    {
      faces->InsertNextCell(ids);
    }
  }
  upper->SetPolys(faces);
  const auto made = thumbnailOf(mesh, upper, strokeOver(), {});
  ASSERT_TRUE(made);
  ASSERT_EQ(made->pixels.size(), std::size_t(4) * Thumbnail::width * Thumbnail::height);
  int clay = 0, orange = 0, red = 0, clear = 0;
  for (std::size_t i = 0; i < made->pixels.size(); i += 4)
  {
    const int r = made->pixels[i], g = made->pixels[i + 1], b = made->pixels[i + 2], a = made->pixels[i + 3];
    clear += a == 0;
    red += a == 255 && r > 150 && g < 70 && b < 70;
    orange += a == 255 && r > 2 * b && g > 70;
    clay += a == 255 && r < 1.2 * b;
  }
  // A disc as high as the picture but for its border, of which 0.37 is orange.
  const double disc = M_PI / 4.0 * std::pow(0.88 * Thumbnail::height, 2);
  EXPECT_NEAR(clay + orange + red, disc, 0.06 * disc);
  EXPECT_NEAR(orange + red, 0.37 * disc, 0.05 * disc);
  EXPECT_GT(red, 25);
  EXPECT_GT(clear, 4000);
  // The same without a stroke, from the front; and none once it is not wanted any more.
  EXPECT_TRUE(thumbnailOf(mesh, nullptr, nullptr, {}));
  EXPECT_FALSE(thumbnailOf(mesh, upper, strokeOver(), [] { return true; }));
  vtkNew<vtkPolyData> none;
  EXPECT_TRUE(thumbnailOf(none, nullptr, nullptr, {}));
}

TEST(StrokeOnSurface, LiesThereAndIsCutWhereNothingIsNear)
{
  const auto mesh = ball();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  const auto stroke = strokeOver();
  vtkNew<vtkPolyData> hold; // on the near side
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 30.0, 40.0);
  hold->SetPoints(places);
  const auto on = strokeOn(locator, stroke, hold, 10.0);
  ASSERT_TRUE(on);
  EXPECT_EQ(on->GetNumberOfLines(), 1);
  EXPECT_EQ(on->GetNumberOfPoints(), stroke->GetNumberOfPoints());
  for (vtkIdType i = 0; i < on->GetNumberOfPoints(); ++i)
  {
    const double* at = on->GetPoint(i);
    EXPECT_NEAR(oversketch::Vector3(at).norm(), 50.0, 0.3);
    EXPECT_GT(at[2], 25.0);
  }
  EXPECT_FALSE(strokeOn(locator, stroke, hold, 1e-6));
  vtkNew<vtkPolyData> nothing;
  EXPECT_FALSE(strokeOn(locator, stroke, nothing, 10.0));
  EXPECT_FALSE(strokeOn(locator, hold, hold, 10.0)) << "no stroke";
}
