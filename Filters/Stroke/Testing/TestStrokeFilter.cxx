#include "Harness/promises.h"
#include "vtkOversketchStrokeFilter.h"

#include "Mesh/context.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View view = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 100.0);

vtkSmartPointer<vtkPolyData> line(double length)
{
  return toStroke({ { 100, 100 }, { 100 + length / 2, 100 }, { 100 + length, 100 } }, view);
}

void refuses(vtkPolyData* stroke, const char* words)
{
  vtkNew<vtkOversketchStrokeFilter> filter;
  filter->SetInputData(stroke);
  expectRefusal(filter, Failure::BadStroke, words);
}

} // namespace

TEST(StrokeFilter, SamplesUniformlyAndInterpolatesPressureAndTime)
{
  // 0 to 100 px in steps that grow; pressure and time linear in arc length.
  std::vector<Vector2> samples;
  vtkNew<vtkFloatArray> pressure;
  pressure->SetName("Pressure");
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (int i = 0; i <= 20; ++i)
  {
    const double x = 0.25 * i * i;
    samples.emplace_back(50 + 0.6 * x, 70 + 0.8 * x);
    pressure->InsertNextValue(static_cast<float>(x / 100.0));
    time->InsertNextValue(0.01 * x);
  }
  const auto stroke = toStroke(samples, view);
  stroke->GetPointData()->AddArray(pressure);
  stroke->GetPointData()->AddArray(time);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(stroke);
  vtkNew<vtkOversketchStrokeFilter> filter;
  filter->SetInputData(stroke);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 51); // 100 px at 2 px
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  for (int i = 0; i < 51; ++i)
  {
    Vector3 p;
    output->GetPoint(i, p.data());
    EXPECT_NEAR((p - Vector3(50 + 1.2 * i, 70 + 1.6 * i, 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(output->GetPointData()->GetArray("Pressure")->GetComponent(i, 0), 0.02 * i, 1e-6);
    EXPECT_NEAR(output->GetPointData()->GetArray("Time")->GetComponent(i, 0), 0.02 * i, 1e-12);
  }
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    EXPECT_EQ(output->GetCellData()->GetArray(name), stroke->GetCellData()->GetArray(name)) << name;
  // The input is as it was.
  ASSERT_EQ(stroke->GetNumberOfPoints(), 21);
  for (vtkIdType i = 0; i < 21; ++i)
    EXPECT_EQ(Vector3(stroke->GetPoint(i)), Vector3(before->GetPoint(i)));
  // Cleaning what is clean changes nothing.
  vtkNew<vtkOversketchStrokeFilter> again;
  again->SetInputData(output);
  again->Update();
  ASSERT_EQ(again->GetOutput()->GetNumberOfPoints(), 51);
  for (vtkIdType i = 0; i < 51; ++i)
    EXPECT_NEAR((Vector3(again->GetOutput()->GetPoint(i)) - Vector3(output->GetPoint(i))).norm(), 0.0, 1e-9);
}

TEST(StrokeFilter, TakesManyStrokesEachWithItsOwnView)
{
  const auto strokes = line(60);
  vtkPoints* points = strokes->GetPoints();
  const vtkIdType ids[2] = { points->InsertNextPoint(0, 0, 5), points->InsertNextPoint(0, 40, 5) };
  strokes->GetLines()->InsertNextCell(2, ids);
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    vtkDataArray* array = strokes->GetCellData()->GetArray(name);
    array->InsertNextTuple(0, array);
    array->SetComponent(1, 0, 7.0);
  }
  vtkNew<vtkOversketchStrokeFilter> filter;
  filter->SetInputData(strokes);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfLines(), 2);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 31 + 21);
  EXPECT_EQ(Vector3(filter->GetOutput()->GetPoint(51)), Vector3(0, 40, 0));
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("ViewportSize")->GetComponent(1, 0), 7.0);
}

TEST(StrokeFilter, RefusesWhatIsNoStroke)
{
  refuses(line(9), "Stroke 0 cannot be used: it is 9 px long");
  refuses(toStroke({ { 5, 5 } }, view), "1 sample");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses(toStroke({ { 5, 5 }, { 50, nan }, { 90, 9 } }, view), "sample 1 is not finite");
  std::vector<Vector2> circle;
  circle.reserve(100);
  for (int i = 0; i < 100; ++i)
    circle.emplace_back(300 + 50 * std::cos(0.0625 * i), 300 + 50 * std::sin(0.0625 * i));
  refuses(toStroke(circle, view), "closed");
  const auto points = line(60);
  points->SetLines(nullptr);
  refuses(points, "polylines");
  const auto mixed = line(60);
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ 0 });
  mixed->SetVerts(vertex);
  refuses(mixed, "no other cells");
  const auto dangling = line(60);
  const vtkIdType ids[3] = { 0, 99, 2 };
  dangling->GetLines()->ReplaceCellAtId(0, 3, ids);
  refuses(dangling, "sample 1");
}

TEST(StrokeFilter, AnEmptyPolyDataIsNoError)
{
  vtkNew<vtkOversketchStrokeFilter> filter;
  Ear ear(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(StrokeFilter, NothingStaleAfterAnErrorAndParametersCount)
{
  vtkNew<vtkOversketchStrokeFilter> filter;
  Ear ear(filter);
  filter->SetInputData(line(60));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 31);
  filter->SetInputData(line(4));
  filter->Update();
  EXPECT_EQ(ear.errors.size(), 1u);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetMinimumLength(3.0);
  filter->SetMinimumSpacing(0.5);
  filter->SetSpacing(0.5);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 9);
}
