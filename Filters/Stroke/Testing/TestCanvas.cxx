#include "Harness/drawings.h"
#include "Harness/promises.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchResample.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMatrix3x3.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Strokes = std::vector<std::pair<std::vector<Vector2>, View>>;

const View desk = viewOver({ 0, 0 }, { 800, 600 }, 800, 600); // display px are world units

std::vector<double> canvasOfOutput(vtkAlgorithm* filter)
{
  vtkDataArray* array = filter->GetOutputDataObject(0)->GetFieldData()->GetArray("Canvas");
  std::vector<double> values(4, std::numeric_limits<double>::quiet_NaN());
  if (array)
  {
    array->GetTuple(0, values.data());
  }
  return values;
}

std::vector<int> closedOf(vtkPolyData* curves)
{
  std::vector<int> closed;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    curves->GetLines()->GetCellAtId(cell, ids);
    const bool repeats = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
    closed.push_back(repeats);
    EXPECT_EQ(curves->GetCellData()->GetArray("Closed")->GetComponent(cell, 0), repeats ? 1.0 : 0.0);
    EXPECT_EQ(curves->GetCellData()->GetArray("StrokeId")->GetComponent(cell, 0), static_cast<double>(cell));
  }
  return closed;
}

} // namespace

TEST(CanvasFilter, TheRectangleIsThePicturesElseTheFieldsElseTheViews)
{
  const auto drawing = toStrokes({ { straight({ 10, 10 }, { 90, 80 }, 9), desk } });
  const auto image = picture(40, 30, 1, [](int, int, int) { return 0; });
  image->SetSpacing(2.0, 3.0, 1.0);
  image->SetOrigin(5.0, 7.0, 9.0);
  vtkNew<vtkDoubleArray> field;
  field->SetName("Canvas");
  field->SetNumberOfComponents(4);
  field->InsertNextTuple4(-1.0, -2.0, 30.0, 40.0);
  drawing->GetFieldData()->AddArray(field);
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(drawing);
  filter->SetPictureData(image);
  filter->Update();
  EXPECT_EQ(canvasOfOutput(filter), (std::vector<double>{ 4.0, 5.5, 80.0, 90.0 }));
  image->SetExtent(10, 49, -5, 24, 3, 3); // the samples lie elsewhere
  image->Modified();
  filter->Update();
  EXPECT_EQ(canvasOfOutput(filter), (std::vector<double>{ 24.0, -9.5, 80.0, 90.0 }));
  filter->SetInputConnection(1, nullptr);
  filter->Update();
  EXPECT_EQ(canvasOfOutput(filter), (std::vector<double>{ -1.0, -2.0, 30.0, 40.0 }));
  drawing->GetFieldData()->RemoveArray("Canvas");
  drawing->Modified();
  filter->Update();
  const std::vector<double> shown = canvasOfOutput(filter);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(shown[i], (std::vector<double>{ 0.0, 0.0, 800.0, 600.0 })[i], 1e-12);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
}

TEST(CanvasFilter, EachStrokeIsSeenInItsOwnView)
{
  // The same world line by five views, one of them askew.
  const auto image = picture(400, 300, 1, [](int, int, int) { return 0; });
  const View askew = perspectiveView({ 300, -200, 500 }, { 0.1, 1, 0 }, 60, 1000, 700);
  const std::vector<View> views{ viewOfPicture(image),
    viewOver({ 100, 80 }, { 100, 75 }, 800, 600),
    viewOver({ -300, -300 }, { 1200, 900 }, 800, 600),
    viewOver({ 0, 0 }, { 400, 300 }, 50, 37),
    askew };
  const std::vector<Vector2> line = straight({ 120, 100 }, { 180, 140 }, 12);
  Strokes strokes;
  for (const View& view : views)
  {
    strokes.emplace_back(seen(line, view), view);
  }
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(toStrokes(strokes));
  filter->SetPictureData(image);
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  for (vtkIdType cell = 0; cell < 5; ++cell)
  {
    const std::vector<Vector3> points = pointsOfCell(filter->GetOutput(), cell);
    ASSERT_EQ(points.size(), line.size());
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      EXPECT_NEAR((points[i].head<2>() - line[i]).norm(), 0.0, 1e-9) << cell;
      EXPECT_EQ(points[i][2], 0.0);
    }
  }
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    EXPECT_FALSE(filter->GetOutput()->GetCellData()->HasArray(name)) << name;
}

TEST(CanvasFilter, StrokesCloseWhereTheirEndsMeetOrWhereTheySayIt)
{
  // Longest side 800: a gap of 16 closes.
  const auto horseshoe = [](double gap)
  {
    std::vector<Vector2> points = straight({ 100, 100 }, { 300, 100 }, 10);
    points.emplace_back(300, 300);
    points.emplace_back(100, 100 + gap);
    return points;
  };
  std::vector<Vector2> exact = horseshoe(20.0);
  exact.emplace_back(100, 100);
  const auto drawing =
    toStrokes({ { horseshoe(15.9), desk },
                { horseshoe(16.1), desk },
                { exact, desk },
                { horseshoe(50.0), desk },
                { straight({ 5, 5 }, { 12, 5 }, 5), desk }, // a dot, near its start all along
                { horseshoe(15.9), desk },
                { horseshoe(50.0), desk } },
      { false, false, false, true });
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(drawing);
  filter->Update();
  EXPECT_EQ(closedOf(filter->GetOutput()), (std::vector<int>{ 1, 0, 1, 1, 0, 1, 0 }));
  EXPECT_EQ(pointsOfCell(filter->GetOutput(), 0).size(), 13u) << "the last sample stays";
  EXPECT_EQ(pointsOfCell(filter->GetOutput(), 2).size(), 13u) << "a place is not there twice";
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Closed", { -1, -1, -1, 0, 1, 0, 1 }));
  drawing->Modified();
  filter->Update();
  EXPECT_EQ(closedOf(filter->GetOutput()), (std::vector<int>{ 1, 0, 1, 1, 1, 0, 1 }));
}

TEST(CanvasFilter, ArraysGoAlongAndOfWhatIsNotReadNothingIsMadeAnew)
{
  const auto drawing = toStrokes(
    { { straight({ 0, 10 }, { 100, 10 }, 5), desk }, { straight({ 0, 50 }, { 90, 50 }, 3), desk } });
  drawing->GetPointData()->AddArray(arrayOf<vtkFloatArray>("Pressure", { .1, .2, .3, .4, .5, .6, .7, .8 }));
  drawing->GetPointData()->AddArray(arrayOf("Time", { 0, 1, 2, 3, 4, 0, 1, 2 }));
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", { 1, 0 }));
  drawing->GetCellData()->AddArray(arrayOf("SnapRadius", { 7.5, 3 }));
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(drawing);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  for (const char* name : { "Pressure", "Time" })
  {
    ASSERT_TRUE(output->GetPointData()->HasArray(name)) << name;
    for (vtkIdType i = 0; i < 8; ++i)
      EXPECT_EQ(output->GetPointData()->GetArray(name)->GetComponent(i, 0),
        drawing->GetPointData()->GetArray(name)->GetComponent(i, 0));
  }
  EXPECT_EQ(output->GetCellData()->GetArray("SnapRadius")->GetComponent(0, 0), 7.5);
  EXPECT_NEAR(output->GetPointData()->GetArray("ArcLength")->GetComponent(3, 0), 75.0, 1e-9);
  EXPECT_EQ(output->GetPointData()->GetArray("ArcLength")->GetComponent(5, 0), 0.0);
  vtkDataArray* const points = output->GetPoints()->GetData();
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 0, 1 }));
  drawing->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints()->GetData(), points);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Treatment")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(filter->GetProjectionCount(), 1);
}

TEST(CanvasFilter, RefusesWhereThereIsNoCanvas)
{
  const auto over = [](const View& view) {
    return toStrokes({ { straight({ 10, 10 }, { 90, 80 }, 9), view } });
  };
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(toStrokes({ { straight({ 0, 0 }, { 9, 9 }, 4), desk },
    { straight({ 0, 0 }, { 9, 9 }, 4), viewOver({ 1, 0 }, { 800, 600 }, 800, 600) } }));
  expectRefusal(filter, Failure::BadStroke, "strokes 0 and 1 carry different views");
  filter->SetInputData(over(perspectiveView({ 0, 0, 5 }, { 0, 1, 0 }, 30)));
  expectRefusal(filter, Failure::BadStroke, "perspective");
  filter->SetInputData(over(orthographicView({ 0, 0.5, 1 }, { 0, 1, 0 }, 100)));
  expectRefusal(filter, Failure::BadStroke, "does not face the plane");
  filter->SetInputData(over(orthographicView({ 0, 0, -1 }, { 0, 1, 0 }, 100)));
  expectRefusal(filter, Failure::BadStroke, "does not face the plane");
  filter->SetInputData(over(orthographicView({ 0, 0, 1 }, { 0.1, 1, 0 }, 100)));
  expectRefusal(filter, Failure::BadStroke, "is not upright");
  const auto bad = over(desk);
  bad->GetFieldData()->AddArray(arrayOf("Canvas", { 0, 0, 1 }));
  filter->SetInputData(bad);
  expectRefusal(filter, Failure::MissingArray, "no field array Canvas of four numbers");
  bad->GetFieldData()->AddArray(arrayOf("Canvas", { 0, 0, 1, 0 }));
  bad->Modified();
  expectRefusal(filter, Failure::BadStroke, "has no extent");
}

TEST(CanvasFilter, RefusesPicturesThatLieNowhere)
{
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(toStrokes({ { straight({ 0, 0 }, { 9, 9 }, 4), desk } }));
  vtkNew<vtkImageData> image;
  filter->SetPictureData(image);
  expectRefusal(filter, Failure::BadStroke, "the picture is empty");
  image->SetDimensions(4, 4, 2);
  expectRefusal(filter, Failure::BadStroke, "The picture has 2 slices");
  image->SetDimensions(4, 4, 1);
  image->SetSpacing(1, -1, 1);
  expectRefusal(filter, Failure::BadStroke, "spacing is not positive");
  image->SetSpacing(1, 1, 1);
  image->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  expectRefusal(filter, Failure::BadStroke, "direction matrix is not the identity");
}

TEST(CanvasFilter, RefusesBrokenStrokesAndCancels)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto good = straight({ 0, 0 }, { 90, 0 }, 9);
  vtkNew<vtkOversketchCanvas> filter;
  filter->SetInputData(toStrokes({ { good, desk }, { { { 5, 5 }, { nan, 6 } }, desk } }));
  expectRefusal(filter, Failure::BadStroke, "Stroke 1 cannot be used: sample 1 is not finite");
  filter->SetInputData(toPolyData(icosphere(1)));
  expectRefusal(filter, Failure::BadStroke, "polylines and no other cells");
  const auto unseen = toStrokes({ { good, desk } });
  unseen->GetCellData()->RemoveArray("ViewportSize");
  filter->SetInputData(unseen);
  expectRefusal(filter, Failure::MissingArray, "ViewportSize");
  // From the side the plane is a line.
  const auto image = picture(800, 600, 1, [](int, int, int) { return 0; });
  filter->SetPictureData(image);
  filter->SetInputData(
    toStrokes({ { good, desk }, { good, orthographicView({ 1, 0, 0 }, { 0, 1, 0 }, 100) } }));
  expectRefusal(
    filter, Failure::BadStroke, "Stroke 1 cannot be used: its view shows the plane z = 0 at none");
  filter->SetInputData(toStrokes({ { good, desk } }));
  expectCancel(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(CanvasFilter, TinyFarAndHugeCanvasesHoldTheSameDrawing)
{
  const auto drawing = [](const Vector2& corner, double scale)
  {
    const auto image = picture(200, 100, 1, [](int, int, int) { return 0; });
    image->SetSpacing(scale, scale, 1.0);
    image->SetOrigin(corner[0], corner[1], 0.0);
    vtkNew<vtkOversketchCanvas> canvas;
    canvas->SetInputData(toStrokes({ { ring({ 60, 50 }, 40, 50), viewOfPicture(image) } }));
    canvas->SetPictureData(image);
    vtkNew<vtkOversketchResample> resample;
    resample->SetInputConnection(canvas->GetOutputPort());
    resample->Update();
    EXPECT_EQ(resample->GetErrorCode(), 0u);
    std::vector<Vector2> places;
    for (const Vector3& p : pointsOfCell(resample->GetOutput(), 0))
      places.emplace_back((p.head<2>() - corner) / scale);
    return places;
  };
  const std::vector<Vector2> here = drawing({ 0, 0 }, 1.0);
  ASSERT_GT(here.size(), 250u);
  const struct
  {
    Vector2 corner;
    double scale, tolerance;
  } others[] = { { { 0, 0 }, 1e-6, 1e-9 }, { { 5e6, -5e6 }, 1.0, 1e-6 }, { { 3, 4 }, 1e9, 1e-6 } };
  for (const auto& other : others)
  {
    const std::vector<Vector2> there = drawing(other.corner, other.scale);
    ASSERT_EQ(there.size(), here.size()) << other.scale;
    for (std::size_t i = 0; i < here.size(); ++i)
      EXPECT_NEAR((there[i] - here[i]).norm(), 0.0, other.tolerance);
  }
}

TEST(ResampleFilter, SpacesSamplesOnceAndHandsDotsOn)
{
  const auto drawing = toStrokes({ { straight({ 0, 10 }, { 790, 10 }, 3), desk },
                                   { straight({ 0, 50 }, { 40, 50 }, 400), desk },
                                   { { { 7, 7 }, { 7, 7 } }, desk },
                                   { { { 9, 9 } }, desk },
                                   { { { 100, 100 }, { 101, 100 }, { 100.5, 100.5 } }, desk } },
    { false, false, false, false, true });
  drawing->GetPointData()->AddArray(
    [&]
    {
      auto time = arrayOf("Time", {});
      for (vtkIdType i = 0; i < drawing->GetNumberOfPoints(); ++i)
        time->InsertNextValue(drawing->GetPoint(i)[0]);
      return time;
    }());
  drawing->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 0, 0, 0, 0, 2 }));
  vtkNew<vtkOversketchCanvas> canvas;
  canvas->SetInputData(drawing);
  vtkNew<vtkOversketchResample> filter;
  filter->SetInputConnection(canvas->GetOutputPort());
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  vtkPolyData* output = filter->GetOutput();
  const double h = 4.0; // 0.005 of 800
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    const std::vector<Vector3> points = pointsOfCell(output, cell);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      EXPECT_LE((points[i] - points[i - 1]).norm(), h * (1 + 1e-9));
      EXPECT_GE((points[i] - points[i - 1]).norm(), 0.5 * h * (1 - 1e-9));
    }
  }
  EXPECT_EQ(pointsOfCell(output, 2).size(), 2u);
  EXPECT_EQ(pointsOfCell(output, 3).size(), 1u);
  EXPECT_EQ(pointsOfCell(output, 4).size(), 4u) << "too small a ring stays one";
  // What was put between has numbers between.
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    EXPECT_NEAR(output->GetPointData()->GetArray("Time")->GetComponent(i, 0), output->GetPoint(i)[0], 1e-9);
  EXPECT_EQ(output->GetCellData()->GetArray("Treatment")->GetComponent(4, 0), 2.0);
  vtkNew<vtkOversketchResample> again;
  again->SetInputConnection(filter->GetOutputPort());
  again->Update();
  expectSameCurves(again->GetOutput(), output);
  canvas->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetResamplingCount(), 1);
}

TEST(ResampleFilter, RefusesAndCancels)
{
  vtkNew<vtkOversketchResample> filter;
  const auto strokes = toStrokes({ { straight({ 0, 10 }, { 790, 10 }, 3), desk } });
  filter->SetInputData(strokes);
  expectRefusal(filter, Failure::MissingArray, "no field array Canvas");
  const auto far = vtkSmartPointer<vtkPolyData>::New();
  WriteCurves({ { { { 0, 0 }, { 1, 0 } }, false }, { { { 0, 0 }, { 1e9, 0 } }, false } },
    { Vector2::Zero(), Vector2::Ones() },
    far);
  filter->SetInputData(far);
  expectRefusal(filter, Failure::BadStroke, "Stroke 1 cannot be used: the spacing must be positive");
  WriteCurves({ { { { 0, 0 }, { 1, 0 } }, false } }, { Vector2::Zero(), Vector2::Ones() }, far);
  far->Modified();
  expectCancel(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 201);
}
