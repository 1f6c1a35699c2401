// Lassos round parts of a region, on the disc and on the model.
#include "widget_scenes.h"

#include "vtkOversketchScanFill.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

using namespace oversketch_test;

namespace
{

// Whether DiscCoords of a vertex lie in a mask's area.
bool liesIn(vtkImageData* mask, const double uv[2])
{
  int size[3];
  mask->GetDimensions(size);
  const auto at = [&](double share) { return std::clamp(int(share * size[0]), 0, size[0] - 1); };
  return mask->GetScalarComponentAsDouble(at(uv[0]), at(uv[1]), 0, 0) != 0.0;
}

} // namespace

// A lasso that crosses itself, drawn on the disc, then layers of its own: nothing outside it changes.
TEST(B7_5, ByAHandOnTheDisc)
{
  AreaScene scene;
  scene.region.system->SetFeather(0.05);
  const std::vector<double> before = scene.weights();
  Counter changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.play("area_star.log");
  EXPECT_EQ(changes.count, 1);
  ASSERT_EQ(scene.areas()->GetNumberOfLines(), 1);
  scene.region.system->SetInputConnection(4, scene.widget->GetAreasPort());
  scene.region.system->SetLayers("area 0 9; handle 0.3 0.7");
  const std::vector<double> after = scene.weights();
  vtkNew<vtkOversketchScanFill> fill;
  fill->SetInputData(scene.areas());
  fill->Update();
  vtkDataArray* coords = scene.region.mesh()->GetPointData()->GetArray("DiscCoords");
  int inside = 0, changed = 0, leaked = 0;
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    double uv[2];
    coords->GetTuple(static_cast<vtkIdType>(i), uv);
    const bool in = uv[0] >= 0.0 && liesIn(fill->GetMaskOutput(), uv);
    inside += in;
    changed += in && before[i] != after[i];
    leaked += !in && before[i] != after[i];
  }
  EXPECT_EQ(leaked, 0);
  EXPECT_GT(inside, 20);
  EXPECT_GT(changed, inside / 2);
  fact("B7_5",
    "a star lassoed by a log, nine levels and a handle in it: " + std::to_string(changed) + " of " +
      std::to_string(inside) + " vertices inside change, none outside");
}

TEST(AreaSelectWidget, OnTheModelItIsTheSamePlaceOfTheDisc)
{
  AreaScene scene(false);
  std::vector<Vector2> lasso;
  for (int i = 0; i < 40; ++i)
  {
    const double a = 2.0 * pi * i / 40;
    lasso.emplace_back(235.0 + 15.0 * std::cos(a), 165.0 + 15.0 * std::sin(a));
  }
  scene.draw(lasso);
  ASSERT_EQ(scene.areas()->GetNumberOfLines(), 1);
  vtkNew<vtkOversketchScanFill> fill;
  fill->SetInputData(scene.areas());
  fill->Update();
  vtkPolyData* mesh = scene.region.mesh();
  vtkDataArray* coords = mesh->GetPointData()->GetArray("DiscCoords");
  int wrong = 0, in = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double uv[2];
    coords->GetTuple(i, uv);
    const double* p = mesh->GetPoint(i);
    const auto at = scene.display({ p[0], p[1], p[2] });
    const double off = (Vector2(at[0], at[1]) - Vector2(235.0, 165.0)).norm();
    if (uv[0] >= 0.0 && std::abs(off - 15.0) > 2.0)
    {
      wrong += (off < 15.0) != liesIn(fill->GetMaskOutput(), uv);
      in += off < 15.0;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(in, 10);
}

TEST(AreaSelectWidget, EscapeTakesBackAndNothingIsRefusedInWords)
{
  AreaScene scene;
  scene.play("area_star.log");
  Counter told(scene.widget, vtkCommand::MessageEvent),
    changes(scene.widget, vtkCommand::WidgetValueChangedEvent);
  scene.draw({ { 200, 150 }, { 200, 151 } });
  EXPECT_EQ(told.count, 1);
  EXPECT_EQ(changes.count, 0);
  EXPECT_EQ(scene.areas()->GetNumberOfLines(), 1);
  scene.key("Escape");
  EXPECT_EQ(scene.areas()->GetNumberOfLines(), 0);
  EXPECT_EQ(scene.areas()->GetNumberOfPoints(), 0) << "the system takes it for none";
  EXPECT_EQ(changes.count, 1);
  scene.key("Escape");
  EXPECT_EQ(changes.count, 1);
  AreaScene onModel(false);
  onModel.draw({ { 20, 20 }, { 60, 20 }, { 40, 60 } }); // in the void
  EXPECT_EQ(onModel.areas()->GetNumberOfLines(), 0);
}

TEST(AreaSelectWidget, WithoutARegionThePenRestsAndDrawingSwallowsWhatItUses)
{
  AreaScene scene;
  const CameraState camera(scene);
  scene.press(150, 150);
  scene.move(180, 190);
  Counter keys(scene.interactor, vtkCommand::CharEvent);
  disturb(scene);
  EXPECT_EQ(keys.count, 0);
  EXPECT_TRUE(CameraState(scene) == camera);
  scene.key("Escape");
  scene.release(0, 0);
  EXPECT_EQ(scene.areas()->GetNumberOfLines(), 0);
  scene.widget->SetRegion(nullptr);
  scene.press(150, 150);
  EXPECT_FALSE(scene.widget->GetPen()->IsDrawing());
  scene.release(150, 150);
}

TEST(AreaSelectWidget, AreasAreHandedOn)
{
  AreaScene scene, other;
  scene.play("area_star.log");
  scene.draw({ { 150, 150 }, { 170, 150 }, { 170, 170 }, { 150, 170 } });
  ASSERT_EQ(scene.areas()->GetNumberOfLines(), 2);
  other.widget->SetAreas(scene.areas());
  EXPECT_EQ(other.areas()->GetNumberOfLines(), 2);
  EXPECT_EQ(other.areas()->GetNumberOfPoints(), scene.areas()->GetNumberOfPoints());
  EXPECT_EQ(other.shown()->GetArea(), 1) << "the last one is the current one";
  other.widget->SetAreas(nullptr);
  EXPECT_EQ(other.areas()->GetNumberOfLines(), 0);
}
