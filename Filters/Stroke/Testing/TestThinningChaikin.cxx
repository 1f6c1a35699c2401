#include "SurfaceTools.h"
#include "vtkOversketchChaikin.h"
#include "vtkOversketchStrokeThinning.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View lens = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 100.0);
const View otherLens = perspectiveView(Vector3(1, 2, 3), Vector3(0, 1, 0), 50.0);

std::vector<Vector2> ringOf(int count, double radius)
{
  std::vector<Vector2> ring;
  ring.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    ring.emplace_back(
      400 + radius * std::cos(2 * pi * i / count), 300 + radius * std::sin(2 * pi * i / count));
  return ring;
}

template <typename Filter>
void refusesBadStrokes()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    vtkSmartPointer<vtkPolyData> stroke;
    const char* words;
  } cases[] = { { toStroke({ { 5, 5 } }, lens), "Stroke 0 cannot be used: it has 1 sample;" },
    { toStrokes({ { straight({ 0, 0 }, { 90, 0 }, 9), lens }, { { { 5, 5 }, { 6, nan } }, lens } }),
      "Stroke 1 cannot be used: sample 1 is not finite" },
    { toPolyData(icosphere(1)), "polylines and no other cells" } };
  for (const auto& each : cases)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(each.stroke);
    expectRefusal(filter, Failure::BadStroke, each.words);
  }
  const auto dangling = toStroke({ { 0, 0 }, { 5, 5 }, { 9, 9 } }, lens);
  const vtkIdType ids[3] = { 0, 99, 2 };
  dangling->GetLines()->ReplaceCellAtId(0, 3, ids);
  vtkNew<Filter> filter;
  filter->SetInputData(dangling);
  expectRefusal(filter, Failure::BadStroke, "does not exist");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  filter->SetInputData(toStroke(straight({ 0, 0 }, { 90, 0 }, 50), lens));
  expectCancel(filter);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 1);
}

} // namespace

TEST(StrokeThinning, ArraysGoWithTheirSamplesAndViewsArePassed)
{
  const auto strokes = toStrokes(
    { { straight({ 0, 10 }, { 100, 10 }, 101), lens }, { ringOf(200, 50), otherLens } }, { false, true });
  vtkNew<vtkFloatArray> pressure;
  pressure->SetName("Pressure");
  for (int i = 0; i < 301; ++i)
    pressure->InsertNextValue(0.001f * static_cast<float>(i));
  strokes->GetPointData()->AddArray(pressure);
  vtkNew<vtkOversketchStrokeThinning> filter;
  filter->SetInputData(strokes);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 2);
  const std::vector<Vector3> first = pointsOfCell(output, 0), second = pointsOfCell(output, 1);
  ASSERT_EQ(first.size(), 26u); // 0, 4, ... 100
  for (int i = 0; i < 26; ++i)
  {
    EXPECT_EQ(first[i], Vector3(4 * i, 10, 0));
    EXPECT_EQ(output->GetPointData()->GetArray("Pressure")->GetComponent(i, 0), pressure->GetValue(4 * i));
  }
  EXPECT_EQ(second.front(), second.back()) << "a ring stays one";
  for (std::size_t i = 1; i + 1 < second.size(); ++i)
    EXPECT_GE((second[i] - second[i - 1]).norm(), 4.0);
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    EXPECT_EQ(output->GetCellData()->GetArray(name), strokes->GetCellData()->GetArray(name)) << name;
  // Again nothing changes.
  vtkNew<vtkOversketchStrokeThinning> again;
  again->SetInputData(output);
  again->Update();
  EXPECT_EQ(again->GetOutput()->GetNumberOfPoints(), output->GetNumberOfPoints());
  filter->SetSpacing(0.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 301);
}

TEST(StrokeThinning, RefusesAndCancels)
{
  refusesBadStrokes<vtkOversketchStrokeThinning>();
}

TEST(Chaikin, RefusesAndCancels)
{
  refusesBadStrokes<vtkOversketchChaikin>();
}

TEST(Chaikin, SmoothsPlacesAndArraysAlike)
{
  const auto stroke = toStroke({ { 100, 100 }, { 200, 100 }, { 200, 200 }, { 300, 260 } }, lens);
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (vtkIdType i = 0; i < 4; ++i)
    x->InsertNextValue(stroke->GetPoint(i)[0]);
  stroke->GetPointData()->AddArray(x);
  vtkNew<vtkOversketchChaikin> filter;
  filter->SetInputData(stroke);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 10); // 4, 6, 10
  EXPECT_EQ(Vector3(output->GetPoint(0)), Vector3(100, 100, 0));
  EXPECT_EQ(Vector3(output->GetPoint(9)), Vector3(300, 260, 0));
  for (vtkIdType i = 0; i < 10; ++i)
    EXPECT_EQ(output->GetPointData()->GetArray("X")->GetComponent(i, 0), output->GetPoint(i)[0]);
  EXPECT_NE(output->GetCellData()->GetArray("ViewTransform"), nullptr);
  filter->SetIterations(0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 4);
  filter->SetIterations(1);
  filter->Update();
  EXPECT_EQ(Vector3(filter->GetOutput()->GetPoint(1)), Vector3(175, 100, 0));
}

TEST(Chaikin, EndsThatMeetMakeARing)
{
  std::vector<Vector2> nearly = ringOf(60, 50);
  nearly.push_back(nearly.front() + Vector2(2, 1));
  std::vector<Vector2> exactly = ringOf(60, 50);
  exactly.push_back(exactly.front());
  for (const auto& samples : { nearly, exactly })
  {
    vtkNew<vtkOversketchChaikin> filter;
    filter->SetInputData(toStroke(samples, lens));
    filter->Update();
    const std::vector<Vector3> ring = pointsOfCell(filter->GetOutput(), 0);
    EXPECT_EQ(ring.front(), ring.back());
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(ring.size()) - 1);
    EXPECT_EQ(ring.size(), 4u * (samples == exactly ? 60u : 61u) + 1u);
    for (std::size_t i = 1; i < ring.size(); ++i)
      EXPECT_GT((ring[i] - ring[i - 1]).norm(), 0.0) << "no corner where it began";
  }
  // A hook is none.
  vtkNew<vtkOversketchChaikin> hook;
  hook->SetIterations(1);
  hook->SetInputData(toStroke({ { 0, 0 }, { 4, 0 }, { 4, 4 } }, lens));
  hook->Update();
  EXPECT_EQ(pointsOfCell(hook->GetOutput(), 0),
    (std::vector<Vector3>{ { 0, 0, 0 }, { 3, 0, 0 }, { 4, 1, 0 }, { 4, 4, 0 } }));
  // Nor is what stands still.
  vtkNew<vtkOversketchChaikin> dot;
  dot->SetInputData(toStroke({ { 7, 7 }, { 7, 7 }, { 7, 7 } }, lens));
  dot->Update();
  EXPECT_EQ(dot->GetErrorCode(), 0u);
}

TEST(Chaikin, AHundredThousandSamples)
{
  vtkNew<vtkOversketchStrokeThinning> thin;
  thin->SetInputData(toStroke(ringOf(100000, 250), lens));
  vtkNew<vtkOversketchChaikin> smooth;
  smooth->SetInputConnection(thin->GetOutputPort());
  smooth->Update();
  EXPECT_LT(thin->GetOutput()->GetNumberOfPoints(), 400);
  EXPECT_GT(smooth->GetOutput()->GetNumberOfPoints(), 1000);
}
