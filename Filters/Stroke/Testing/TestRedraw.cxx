#include "Harness/drawings.h"
#include "Harness/promises.h"
#include "vtkOversketchCanvas.h"
#include "vtkOversketchRedraw.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View sheet = viewOver({ 0, 0 }, { 1000, 1000 }, 1000, 1000);
const View zoomed = viewOver({ 500, 400 }, { 250, 250 }, 1000, 1000);

std::vector<Vector2> arc(double from, double to, double radius, int count, const View& view)
{
  std::vector<Vector2> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = from + (to - from) * i / (count - 1);
    points.emplace_back(
      view.toDisplay(Vector3(500 + radius * std::cos(angle), 500 + radius * std::sin(angle), 0)).head<2>());
  }
  return points;
}

// A circle and a line, with numbers of their own.
vtkSmartPointer<vtkPolyData> circleAndLineOnSheet()
{
  auto strokes = toStrokes(
    { { ring({ 500, 500 }, 200, 300), sheet }, { straight({ 100, 900 }, { 800, 900 }, 70), sheet } },
    { true, false });
  auto pressure = arrayOf<vtkFloatArray>("Pressure", {});
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
    pressure->InsertNextValue(0.25f);
  strokes->GetPointData()->AddArray(pressure);
  strokes->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 1, 0 }));
  return strokes;
}

vtkSmartPointer<vtkPolyData> withPressure(const vtkSmartPointer<vtkPolyData>& strokes, float value)
{
  auto pressure = arrayOf<vtkFloatArray>("Pressure", {});
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
    pressure->InsertNextValue(value);
  strokes->GetPointData()->AddArray(pressure);
  return strokes;
}

struct Corrected
{
  vtkNew<vtkOversketchCanvas> canvas;
  vtkNew<vtkOversketchRedraw> redraw;

  Corrected()
  {
    this->canvas->SetInputData(circleAndLineOnSheet());
    this->redraw->SetInputConnection(this->canvas->GetOutputPort());
  }
};

} // namespace

TEST(RedrawFilter, AnArcIsReplacedFromAZoomedViewAndTheRestStays)
{
  Corrected chain;
  // 30 degrees round the circle's first sample, drawn 6 units outside in another view.
  chain.redraw->SetCorrectionsData(
    withPressure(toStrokes({ { arc(-pi / 12, pi / 12, 206, 40, zoomed), zoomed } }), 0.75f));
  chain.redraw->Update();
  ASSERT_EQ(chain.redraw->GetErrorCode(), 0u);
  vtkPolyData* output = chain.redraw->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 2);
  EXPECT_EQ(pointsOfCell(output, 1), pointsOfCell(chain.canvas->GetOutput(), 1));
  const std::vector<Vector3> before = pointsOfCell(chain.canvas->GetOutput(), 0);
  const std::vector<Vector3> after = pointsOfCell(output, 0);
  EXPECT_EQ(after.front(), after.back());
  vtkDataArray* pressure = output->GetPointData()->GetArray("Pressure");
  int drawn = 0, kept = 0;
  for (std::size_t i = 0; i + 1 < after.size(); ++i)
  {
    const double r = (after[i].head<2>() - Vector2(500, 500)).norm();
    const double value = pressure->GetComponent(static_cast<vtkIdType>(i), 0);
    EXPECT_GE(value, 0.25 - 1e-7);
    EXPECT_LE(value, 0.75 + 1e-7);
    drawn += std::abs(r - 206) < 1e-6 && std::abs(value - 0.75) < 1e-6;
    kept += std::find(before.begin(), before.end(), after[i]) != before.end() && value == 0.25;
  }
  EXPECT_EQ(drawn, 40);
  EXPECT_GT(kept, 200);
  EXPECT_EQ(output->GetCellData()->GetArray("Treatment")->GetComponent(0, 0), 1.0);
  double arcLength = 0.0;
  for (std::size_t i = 1; i + 1 < after.size(); ++i)
  {
    arcLength += (after[i] - after[i - 1]).norm();
    EXPECT_NEAR(output->GetPointData()->GetArray("ArcLength")->GetComponent(static_cast<vtkIdType>(i), 0),
      arcLength,
      1e-9 * arcLength);
  }
  // The same again is the same arrays.
  vtkDataArray* const points = output->GetPoints()->GetData();
  chain.redraw->Modified();
  chain.redraw->Update();
  EXPECT_EQ(chain.redraw->GetOutput()->GetPoints()->GetData(), points);
  EXPECT_EQ(chain.redraw->GetCorrectionCount(), 1);
}

TEST(RedrawFilter, ExtensionsNewStrokesAndCorrectionsOfCorrections)
{
  Corrected chain;
  const auto corrections =
    withPressure(toStrokes({ { straight({ 790, 905 }, { 950, 905 }, 20), sheet }, // the line is made longer
                   { ring({ 500, 500 }, 80, 90), sheet },                  // a new closed one in the circle
                   { straight({ 940, 908 }, { 970, 700 }, 30), sheet } }), // the longer line, longer still
      1.0f);
  corrections->GetCellData()->AddArray(arrayOf<vtkIntArray>("Magnetic", { 0, 1, 0 }));
  chain.redraw->SetCorrectionsData(corrections);
  chain.redraw->Update();
  ASSERT_EQ(chain.redraw->GetErrorCode(), 0u);
  vtkPolyData* output = chain.redraw->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 3);
  const std::vector<Vector3> line = pointsOfCell(output, 1);
  EXPECT_EQ(line.front(), pointsOfCell(chain.canvas->GetOutput(), 1).front());
  EXPECT_NEAR((line.back() - Vector3(970, 700, 0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(pointsOfCell(output, 2).size(), 91u);
  vtkCellData* cells = output->GetCellData();
  const double expected[3][4] = { { 0, 1, 0, 1 }, { 1, 0, 0, 0 }, { 2, 1, 1, 0 } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    int column = 0;
    for (const char* name : { "StrokeId", "Closed", "Magnetic", "Treatment" })
      EXPECT_EQ(cells->GetArray(name)->GetComponent(i, 0), expected[i][column++]) << name << i;
  }
  // Without pressure on one side there is none.
  chain.redraw->SetCorrectionsData(toStrokes({ { straight({ 790, 905 }, { 950, 905 }, 20), sheet } }));
  chain.redraw->Update();
  EXPECT_FALSE(chain.redraw->GetOutput()->GetPointData()->HasArray("Pressure"));
}

TEST(RedrawFilter, WithoutCorrectionsTheCurvesGoThrough)
{
  Corrected chain;
  chain.redraw->Update();
  expectSameCurves(chain.redraw->GetOutput(), chain.canvas->GetOutput());
  vtkNew<vtkPolyData> none;
  chain.redraw->SetCorrectionsData(none);
  chain.redraw->Update();
  expectSameCurves(chain.redraw->GetOutput(), chain.canvas->GetOutput());
  EXPECT_EQ(chain.redraw->GetCorrectionCount(), 0);
}

TEST(RedrawFilter, RefusesAndCancels)
{
  Corrected chain;
  const auto redraw = chain.redraw.Get();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  redraw->SetCorrectionsData(
    toStrokes({ { straight({ 790, 905 }, { 950, 905 }, 20), sheet }, { { { 5, 5 }, { 5, 5 } }, sheet } }));
  expectRefusal(redraw, Failure::BadStroke, "Correction 1 cannot be used: a correction needs two distinct");
  redraw->SetCorrectionsData(toStrokes({ { { { 5, 5 }, { nan, 5 } }, sheet } }));
  expectRefusal(redraw, Failure::BadStroke, "sample 1 is not finite");
  redraw->SetCorrectionsData(
    toStrokes({ { straight({ 0, 0 }, { 9, 9 }, 4), orthographicView({ 1, 0, 0 }, { 0, 1, 0 }, 100) } }));
  expectRefusal(redraw, Failure::BadStroke, "Correction 0 cannot be used: its view shows the plane");
  const auto unseen = toStrokes({ { straight({ 0, 0 }, { 9, 9 }, 4), sheet } });
  unseen->GetCellData()->RemoveArray("ViewTransform");
  redraw->SetCorrectionsData(unseen);
  expectRefusal(redraw, Failure::MissingArray, "ViewTransform");
  redraw->SetCorrectionsData(toStrokes({ { straight({ 790, 905 }, { 950, 905 }, 20), sheet } }));
  expectCancel(redraw);
  redraw->Update();
  EXPECT_GT(redraw->GetOutput()->GetNumberOfPoints(), 300);
  redraw->SetInputData(circleAndLineOnSheet());
  expectRefusal(redraw, Failure::MissingArray, "no field array Canvas");
}
