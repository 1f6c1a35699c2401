#include "Harness/promises.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchViewStroke.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> polyline(const std::vector<Vector3>& places)
{
  auto line = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(places.size()));
  for (const Vector3& p : places)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  line->SetPoints(points);
  line->SetLines(lines);
  return line;
}

// A camera that looks askew.
vtkSmartPointer<vtkCamera> askew(bool parallel)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(3, -2, 5);
  camera->SetFocalPoint(0.5, 1, -1);
  camera->SetViewUp(0.2, 1, 0.1);
  camera->SetViewAngle(41);
  camera->SetParallelScale(2.5);
  camera->SetParallelProjection(parallel);
  return camera;
}

void take(vtkOversketchViewStroke* filter, vtkCamera* camera)
{
  filter->SetCameraPosition(camera->GetPosition());
  filter->SetCameraFocalPoint(camera->GetFocalPoint());
  filter->SetCameraViewUp(camera->GetViewUp());
  filter->SetCameraViewAngle(camera->GetViewAngle());
  filter->SetCameraParallelScale(camera->GetParallelScale());
  filter->SetCameraParallelProjection(camera->GetParallelProjection());
}

const std::vector<Vector3> places = { { 0, 0, 0 }, { 0.3, 0.2, -0.5 }, { 1, 0.5, 0.25 }, { -0.5, 1.5, 1 } };

} // namespace

TEST(ViewStroke, SeesWhatTheCameraSees)
{
  for (const bool parallel : { false, true })
  {
    const auto camera = askew(parallel);
    vtkNew<vtkOversketchViewStroke> filter;
    take(filter, camera);
    filter->SetViewSize(640, 480);
    filter->SetInputData(polyline(places));
    filter->Update();
    vtkPolyData* stroke = filter->GetOutput();
    const View view = ViewOf(stroke);
    EXPECT_EQ(view.width(), 640);
    EXPECT_EQ(view.height(), 480);
    EXPECT_EQ(view.perspective(), !parallel);
    vtkMatrix4x4* world = camera->GetViewTransformMatrix();
    vtkMatrix4x4* clip = camera->GetProjectionTransformMatrix(640.0 / 480.0, -1, 1);
    for (int r = 0; r < 4; ++r)
    {
      for (int c = 0; c < 4; ++c)
      {
        EXPECT_NEAR(view.viewTransform()(r, c), world->GetElement(r, c), 1e-12) << r << c;
        if (r != 2) // depth means nothing
        {
          EXPECT_NEAR(view.projectionTransform()(r, c), clip->GetElement(r, c), 1e-12) << r << c;
        }
      }
    }
    const std::vector<Vector2> samples = StrokeOf(stroke);
    ASSERT_EQ(samples.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      double p[4] = { places[i][0], places[i][1], places[i][2], 1.0 };
      world->MultiplyPoint(p, p);
      clip->MultiplyPoint(p, p);
      EXPECT_NEAR(samples[i][0], (p[0] / p[3] + 1) * 320, 1e-4); // the input's points are floats
      EXPECT_NEAR(samples[i][1], (p[1] / p[3] + 1) * 240, 1e-4);
    }
  }
}

TEST(ViewStroke, TheFocalPointIsTheMiddleOfTheView)
{
  vtkNew<vtkOversketchViewStroke> filter;
  filter->SetInputData(polyline({ { 0, 0, 0 }, { 0, std::tan(pi / 12), 0 } }));
  filter->Update();
  const std::vector<Vector2> samples = StrokeOf(filter->GetOutput());
  EXPECT_NEAR((samples[0] - Vector2(400, 300)).norm(), 0, 1e-9);
  EXPECT_NEAR((samples[1] - Vector2(400, 600)).norm(), 0, 1e-4) << "half of 30 degrees above is the top edge";
}

TEST(ViewStroke, RefusesWhatNoViewShows)
{
  vtkNew<vtkOversketchViewStroke> filter;
  filter->SetInputData(polyline({ { 0, 0, 0 }, { 0, 0, 2 } }));
  expectRefusal(filter, Failure::BadStroke, "Point 1 of the polyline");
  filter->SetInputData(polyline({ { 0, std::numeric_limits<double>::quiet_NaN(), 0 }, { 0, 0, 0 } }));
  expectRefusal(filter, Failure::BadStroke, "Point 0 of the polyline");
  filter->SetInputData(toPolyData(icosphere(1)));
  expectRefusal(filter, Failure::BadStroke, "0 polylines and 80 other cells");
  filter->SetInputData(polyline(places));
  filter->SetCameraViewUp(0, 0, 1);
  expectRefusal(filter, Failure::BadStroke, "The camera sees nothing");
  filter->SetCameraViewUp(0, 1, 0);
  filter->SetCameraPosition(0, 0, 0);
  expectRefusal(filter, Failure::BadStroke, "The camera sees nothing");
  filter->SetCameraPosition(0, 0, 5);
  filter->SetViewSize(0, 600);
  expectRefusal(filter, Failure::BadStroke, "ViewportSize");
}

TEST(ViewStroke, SeveralPolylinesAreStrokesOfTheirOwn)
{
  const std::vector<Vector3> second = { { -0.2, 0.1, 0 }, { 0.4, -0.3, 0.2 } };
  vtkNew<vtkPolyData> both; // the second's points before the first's, which share one
  vtkNew<vtkPoints> points;
  for (const Vector3& p : second)
  {
    points->InsertNextPoint(p.data());
  }
  for (const Vector3& p : places)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 2, 3, 4, 5 });
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 5, 1 });
  both->SetPoints(points);
  both->SetLines(lines);
  vtkNew<vtkOversketchViewStroke> filter;
  take(filter, askew(false));
  filter->SetViewSize(640, 480);
  filter->SetInputData(both);
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  vtkNew<vtkPolyData> together;
  together->DeepCopy(filter->GetOutput());
  ASSERT_EQ(together->GetNumberOfLines(), 3);
  EXPECT_EQ(together->GetNumberOfCells(), 3);
  const std::vector<std::vector<Vector3>> each = { places, second, { places.back(), second.back() } };
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < 3; ++line)
  {
    SCOPED_TRACE(line);
    filter->SetInputData(polyline(each[static_cast<std::size_t>(line)]));
    filter->Update();
    vtkPolyData* alone = filter->GetOutput();
    together->GetLines()->GetCellAtId(line, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), alone->GetNumberOfPoints());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      Vector3 p, q;
      together->GetPoint(ids->GetId(i), p.data());
      alone->GetPoint(i, q.data());
      EXPECT_EQ(p, q) << i;
    }
    for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    {
      vtkDataArray* ours = together->GetCellData()->GetArray(name);
      vtkDataArray* theirs = alone->GetCellData()->GetArray(name);
      ASSERT_TRUE(ours && theirs) << name;
      ASSERT_EQ(ours->GetNumberOfTuples(), 3) << name;
      for (int c = 0; c < theirs->GetNumberOfComponents(); ++c)
      {
        EXPECT_EQ(ours->GetComponent(line, c), theirs->GetComponent(0, c)) << name;
      }
    }
  }
}

TEST(ViewStroke, NothingInNothingOutSilently)
{
  vtkNew<vtkOversketchViewStroke> filter;
  filter->SetInputData(vtkNew<vtkPolyData>());
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
