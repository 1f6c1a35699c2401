// Handles on grey layers, on the disc and on the model.
#include "Shading/layer_list.h"
#include "widget_scenes.h"

#include "vtkOversketchShadingLevels.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace oversketch_test;

// The three handles of the fact, placed and dragged on the disc.
TEST(B7_4, ByAHandOnTheDisc)
{
  LayerScene scene;
  const auto place = [&](double share)
  {
    const int y = scene.heightOf(share);
    scene.click(200, y);
    return scene.shown()->GetShareAt(200, y);
  };
  std::vector<double> rests;
  for (const double share : { 0.2, 0.4, 0.8 })
  {
    rests.push_back(place(share));
  }
  ASSERT_EQ(scene.shown()->GetNumberOfHandles(), 3);
  const int from = scene.heightOf(rests[1]), to = scene.heightOf(0.5);
  const double reached = scene.shown()->GetShareAt(200, to);
  scene.drag(200, from, 200, to);
  scene.release(200, to);
  const oversketch::LayerList list = oversketch::layerList(scene.layers());
  ASSERT_EQ(list.handles.size(), 3u) << scene.layers();
  const std::vector<double> made = oversketch::Layers(5, list.handles).boundaries();
  const std::vector<double> asked = oversketch::Layers(5,
    { { rests[0], rests[0] },
      { rests[2], rests[2] },
      { rests[1], reached } }).boundaries();
  double off = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    off = std::max(off, std::abs(made[i] - asked[i]));
    EXPECT_NEAR(made[i], asked[i], 2e-4);
    EXPECT_NEAR(made[i], std::vector<double>({ 0.2, 0.5, 0.65, 0.8 })[i], 0.02);
  }
  const std::set<int> greys = scene.greys();
  for (const int grey : greys)
  {
    EXPECT_TRUE(std::set<int>({ 255, 191, 128, 64, 0 }).count(grey)) << grey;
  }
  EXPECT_LE(greys.size(), 5u);
  fact("B7_4",
    "three clicks and a drag on the disc: boundaries within " + std::to_string(off) +
      " of those of the handles, " + std::to_string(greys.size()) + " greys of 5 are seen");
}

TEST(LayerHandleWidget, ALayerGoesAndComesBack)
{
  LayerScene scene;
  const std::set<int> all{ 255, 191, 128, 64, 0 };
  EXPECT_EQ(scene.greys(), all);
  const std::vector<double> before = scene.weights();
  const int y = scene.heightOf(0.4);
  scene.drag(200, y, 200, 150); // onto the line, and on
  scene.release(200, 150);
  EXPECT_LT(scene.greys().size(), 5u) << scene.layers();
  const oversketch::LayerList gone = oversketch::layerList(scene.layers());
  ASSERT_EQ(gone.handles.size(), 1u);
  EXPECT_LT(gone.handles[0].place, 0.03);
  EXPECT_NE(scene.weights(), before);
  scene.drag(200, scene.heightOf(gone.handles[0].place), 200, y);
  scene.release(200, y);
  EXPECT_EQ(scene.greys(), all) << scene.layers();
  EXPECT_EQ(scene.weights(), before) << scene.layers();
  EXPECT_EQ(scene.shown()->GetNumberOfHandles(), 1) << "the drag back took another handle";
  // Beside the disc is the ring.
  scene.drag(200, y, 30, 280);
  scene.release(30, 280);
  EXPECT_EQ(oversketch::layerList(scene.layers()).handles.at(0).place, 1.0);
}

TEST(LayerHandleWidget, ByALogTheSystemsWeightsFollow)
{
  LayerScene scene;
  const auto sum = [&]
  {
    const std::vector<double> weights = scene.weights();
    return std::accumulate(weights.begin(), weights.end(), 0.0);
  };
  const double before = sum();
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent),
    moves(scene.widget, vtkCommand::InteractionEvent);
  scene.play("layer_drag.log"); // outward
  EXPECT_TRUE(scene.widget->IsDragging());
  scene.play("layer_drop.log");
  EXPECT_EQ(changes.count, 1);
  EXPECT_GT(moves.count, 4);
  EXPECT_GT(sum(), 1.1 * before) << scene.layers();
}

TEST(LayerHandleWidget, OnTheModelToo)
{
  LayerScene scene(false);
  EXPECT_NEAR(scene.shown()->GetShareAt(200, 150), 0.0, 0.05);
  EXPECT_EQ(scene.shown()->GetShareAt(20, 20), 1.0);
  EXPECT_FALSE(scene.shown()->IsOnRegion(200, 230)) << "on the ball, beside the ring";
  scene.click(200, 180);
  ASSERT_EQ(scene.shown()->GetNumberOfHandles(), 1);
  const oversketch::LayerHandle placed = oversketch::layerList(scene.layers()).handles.at(0);
  EXPECT_EQ(placed.rest, placed.place) << "a click moves nothing";
  EXPECT_NEAR(placed.rest, scene.shown()->GetShareAt(200, 180), 1e-4);
  // Its line is a grip all round: below the line of the drawing too.
  int found = 0;
  for (int y = 90; y < 150; ++y)
  {
    found += scene.shown()->GetGripAt(200, y) == 1;
  }
  EXPECT_GT(found, 10);
  // The camera turns the ball about; the layer is under the cursor there.
  const CameraState before(scene);
  scene.drag(200, 180, 200, 195);
  EXPECT_TRUE(CameraState(scene) == before);
  scene.release(200, 195);
  EXPECT_GT(oversketch::layerList(scene.layers()).handles.at(0).place, placed.rest + 0.1);
}

TEST(LayerHandleWidget, EscapePutsAllBackAndADragSwallowsTheRest)
{
  LayerScene scene;
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  const CameraState camera(scene);
  scene.play("layer_drag.log");
  Counter keys(scene.interactor, vtkCommand::CharEvent);
  disturb(scene);
  EXPECT_EQ(keys.count, 0);
  EXPECT_TRUE(CameraState(scene) == camera);
  scene.key("Escape");
  EXPECT_EQ(scene.layers(), "") << "the handle that was placed by the press stays";
  EXPECT_EQ(changes.count, 0);
  scene.release(0, 0);
  scene.play("layer_drag.log");
  scene.play("layer_drop.log");
  EXPECT_NE(scene.layers(), "");
  scene.key("Delete");
  EXPECT_EQ(scene.layers(), "");
  EXPECT_EQ(changes.count, 2);
}

TEST(LayerHandleWidget, HandlesOfAnAreaAreItsOwn)
{
  LayerScene scene;
  scene.widget->SetLayers("handle 0.5 0.6; area 0 9");
  scene.shown()->SetArea(0);
  EXPECT_EQ(scene.shown()->GetNumberOfHandles(), 0);
  scene.click(200, scene.heightOf(0.3));
  EXPECT_EQ(scene.shown()->GetNumberOfHandles(), 1);
  const oversketch::LayerList list = oversketch::layerList(scene.layers());
  ASSERT_EQ(list.areas.size(), 1u) << scene.layers();
  EXPECT_EQ(list.areas[0].levels, 9);
  EXPECT_EQ(list.areas[0].handles.size(), 1u);
  EXPECT_EQ(list.handles.size(), 1u);
  // The areas' greys are the system's image.
  auto* display = vtkImageData::SafeDownCast(
    vtkOversketchShadingLevels::SafeDownCast(scene.region.system->GetStep("Shading"))->GetDisplayOutput());
  scene.shown()->SetDisplay(display);
  scene.window->Render();
  EXPECT_GE(scene.greys().size(), 4u);
}

TEST(LayerHandleWidget, TwoHandlesNeedRoomAndItIsSaid)
{
  LayerScene scene;
  const double share = scene.shown()->GetShareAt(200, 150);
  Counter told(scene.widget, vtkCommand::MessageEvent);
  if (share < 1e-3) // on the line itself
  {
    scene.click(200, 150);
    EXPECT_EQ(told.count, 1);
  }
  Quiet quiet;
  scene.widget->SetLayers("handle 0.4 0.2; handle 0.4 0.5");
  EXPECT_EQ(quiet.errors(), 1);
  EXPECT_EQ(scene.layers(), "");
}
