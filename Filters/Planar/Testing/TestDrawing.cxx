// Facts of image-assisted.md, section 1, through the filters from the pen to the distance maps.
#include "CurveShapes.h"
#include "Harness/drawings.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchClassify.h"
#include "vtkOversketchDistance.h"
#include "vtkOversketchMagneticSnap.h"
#include "vtkOversketchRedraw.h"
#include "vtkOversketchResample.h"
#include "vtkOversketchTreatment.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr int windowWidth = 800, windowHeight = 600;

Eigen::Matrix4d matrixOf(vtkMatrix4x4* matrix)
{
  Eigen::Matrix4d m;
  for (int i = 0; i < 16; ++i)
    m(i / 4, i % 4) = matrix->GetElement(i / 4, i % 4);
  return m;
}

// A window over the picture: what a stroke drawn now carries.
View viewOfWindow(vtkCamera* camera)
{
  return View(matrixOf(camera->GetViewTransformMatrix()),
    matrixOf(camera->GetProjectionTransformMatrix(windowWidth / static_cast<double>(windowHeight), -1, 1)),
    windowWidth,
    windowHeight);
}

// All filters between the pen and the planar mesh.
struct Front
{
  vtkNew<vtkOversketchCanvas> canvas;
  vtkNew<vtkOversketchRedraw> redraw;
  vtkNew<vtkOversketchMagneticSnap> snap;
  vtkNew<vtkOversketchResample> resample;
  vtkNew<vtkOversketchClassify> classify;
  vtkNew<vtkOversketchTreatment> treatment;
  vtkNew<vtkOversketchDistance> distance;
  std::vector<vtkPolyDataAlgorithm*> steps{ canvas, redraw, snap, resample, classify, treatment, distance };
  std::vector<int> runs = std::vector<int>(steps.size(), 0);
  vtkNew<vtkCallbackCommand> listener;

  Front(vtkPolyData* drawing, vtkImageData* image)
  {
    this->canvas->SetInputData(drawing);
    this->canvas->SetPictureData(image);
    this->snap->SetPictureData(image);
    for (std::size_t i = 1; i < this->steps.size(); ++i)
      this->steps[i]->SetInputConnection(this->steps[i - 1]->GetOutputPort());
    this->listener->SetClientData(this);
    this->listener->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void*)
      {
        auto* front = static_cast<Front*>(self);
        for (std::size_t i = 0; i < front->steps.size(); ++i)
          front->runs[i] += front->steps[i] == caller;
      });
    for (vtkPolyDataAlgorithm* step : this->steps)
      step->AddObserver(vtkCommand::StartEvent, this->listener);
  }
};

} // namespace

TEST(C1_1, PanAndZoomChangeNoStroke)
{
  const auto image = discPicture(400, 120, { 200, 200 });
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(199.5, 199.5, 0);
  camera->SetPosition(199.5, 199.5, 500);
  camera->SetParallelScale(220);
  const std::vector<Vector2> outline = ring({ 200, 200 }, 124, 200);
  std::vector<std::pair<std::vector<Vector2>, View>> strokes{ { seen(outline, viewOfWindow(camera)),
    viewOfWindow(camera) } };
  const auto drawing = [&]
  {
    auto all = toStrokes(strokes, { true });
    std::vector<double> magnetic(strokes.size(), 0.0);
    magnetic[0] = 1.0;
    all->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", magnetic));
    return all;
  };
  Front front(drawing(), image);
  front.distance->Update();
  ASSERT_EQ(front.distance->GetErrorCode(), 0u);
  const std::vector<int> once = front.runs;
  EXPECT_EQ(once, std::vector<int>(7, 1));
  const std::vector<Vector3> drawn = pointsOfCell(front.canvas->GetOutput(), 0);
  const std::vector<Vector3> snapped = pointsOfCell(front.resample->GetOutput(), 0);
  vtkDataArray* const depths = front.distance->GetDistanceOutput()->GetPointData()->GetArray("T");
  // The wheel zooms about a place, the middle button drags the picture.
  int moves = 0;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (; moves < 200; ++moves)
  {
    const double scale = camera->GetParallelScale();
    double focus[3], eye[3];
    camera->GetFocalPoint(focus);
    camera->GetPosition(eye);
    const double dx = 0.2 * scale * share(random), dy = 0.2 * scale * share(random);
    camera->SetFocalPoint(focus[0] + dx, focus[1] + dy, focus[2]);
    camera->SetPosition(eye[0] + dx, eye[1] + dy, eye[2]);
    camera->SetParallelScale(std::clamp(scale * std::exp2(share(random)), 20.0, 2000.0));
    front.distance->Update();
  }
  EXPECT_EQ(front.runs, once) << "nothing executed";
  EXPECT_EQ(pointsOfCell(front.canvas->GetOutput(), 0), drawn);
  // What is drawn now carries what is seen now; the first stroke stays to the bit, and what is made of it
  // too.
  camera->SetParallelScale(37);
  strokes.emplace_back(
    seen({ { 150, 200 }, { 200, 230 }, { 240, 190 } }, viewOfWindow(camera)), viewOfWindow(camera));
  front.canvas->SetInputData(drawing());
  front.distance->Update();
  EXPECT_EQ(pointsOfCell(front.canvas->GetOutput(), 0), drawn);
  EXPECT_EQ(pointsOfCell(front.resample->GetOutput(), 0), snapped);
  EXPECT_EQ(front.snap->GetSnapCount(), 1);
  EXPECT_EQ(front.snap->GetEdgeCount(), 1);
  EXPECT_EQ(front.distance->GetDistanceCount(), 1);
  EXPECT_EQ(front.distance->GetDistanceOutput()->GetPointData()->GetArray("T"), depths);
  EXPECT_EQ(cellValues(front.distance->GetOutput(), "Role"), (std::vector<int>{ 1, 3 }));
  fact("C1_1",
    std::to_string(moves) + " pans and zooms: no filter of seven executes, the stroke's " +
      std::to_string(drawn.size() - 1) +
      " points to the bit; a stroke drawn in the view after them neither moves the first nor computes edges, "
      "path or distance anew");
}

TEST(DrawingFront, StrokesOfManyViewsMeetInOneDrawing)
{
  // The body in the picture's view, features zoomed and tilted.
  const auto image = discPicture(400, 120, { 200, 200 });
  const std::vector<View> views{ viewOfPicture(image),
    viewOver({ 150, 150 }, { 100, 75 }, 800, 600),
    perspectiveView({ 350, -50, 500 }, { 0.2, 1, 0 }, 60, 1000, 700),
    viewOver({ -400, -400 }, { 1200, 1200 }, 300, 300) };
  const std::vector<std::vector<Vector2>> worlds{ ring({ 200, 200 }, 118, 200),
    ring({ 180, 190 }, 20, 60),
    { { 210, 220 }, { 230, 240 }, { 260, 230 } },
    ring({ 240, 180 }, 25, 40) };
  std::vector<std::pair<std::vector<Vector2>, View>> strokes;
  for (std::size_t i = 0; i < views.size(); ++i)
    strokes.emplace_back(seen(worlds[i], views[i]), views[i]);
  const auto drawing = toStrokes(strokes);
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 0, 2, 0, 0 }));
  Front front(drawing, image);
  front.treatment->SetHoles("3");
  front.distance->Update();
  ASSERT_EQ(front.distance->GetErrorCode(), 0u);
  vtkPolyData* curves = front.distance->GetOutput();
  EXPECT_EQ(cellValues(curves, "Role"), (std::vector<int>{ 1, 2, 3, 2 }));
  EXPECT_EQ(cellValues(curves, "Closed"), (std::vector<int>{ 1, 1, 0, 1 }));
  EXPECT_EQ(cellValues(curves, "Treatment"), (std::vector<int>{ 0, 2, 0, 1 }));
  // The hole has no inside, the tunnel has.
  vtkImageData* image2 = front.distance->GetDistanceOutput();
  const auto object = [&](double x, double y)
  {
    double place[3] = { x, y, 0.0 };
    return image2->GetPointData()->GetArray("Object")->GetComponent(image2->FindPoint(place), 0);
  };
  EXPECT_EQ(object(240, 180), -1.0);
  EXPECT_EQ(object(180, 190), 0.0);
}

TEST(DrawingFront, ASinglePixelOfAPictureIsACanvas)
{
  const auto image = picture(1, 1, 3, [](int, int, int) { return 77; });
  Front front(toStrokes({ { ring({ 0.5, 0.5 }, 0.4, 60), viewOfPicture(image) } }, { true }), image);
  front.distance->Update();
  ASSERT_EQ(front.distance->GetErrorCode(), 0u);
  EXPECT_EQ(cellValues(front.distance->GetOutput(), "Role"), (std::vector<int>{ 1 }));
  EXPECT_NEAR(front.distance->GetDistanceOutput()->GetPointData()->GetArray("T")->GetRange()[1], 409.6, 2.0);
}
