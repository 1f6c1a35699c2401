#include "vtkOversketchNurbsFit.h"

#include "Harness/promises.h"
#include "Harness/strokes.h"
#include "Stroke/nurbs.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View eye = perspectiveView(Vector3(0, 0, 5), Vector3(0, 1, 0), 30.0);

// A plate in z = 0, and before its left half another one in z = 1.
vtkSmartPointer<vtkPolyData> twoPlates()
{
  Mesh mesh;
  const std::pair<double, double> rightAndHeight[] = { { 1.0, 0.0 }, { 0.0, 1.0 } };
  for (const auto& [right, height] : rightAndHeight)
  {
    const int first = mesh.vertexCount();
    for (const Vector2& corner : { Vector2(-1, -1), Vector2(right, -1), Vector2(right, 1), Vector2(-1, 1) })
    {
      mesh.points.emplace_back(corner[0], corner[1], height);
    }
    mesh.triangles.push_back({ first, first + 1, first + 2 });
    mesh.triangles.push_back({ first, first + 2, first + 3 });
  }
  return toPolyData(mesh);
}

// From left to right, with a corner where the near plate ends, which is seen at x = 400.
std::vector<Vector2> wave(double from, double to)
{
  std::vector<Vector2> samples;
  for (double x = from; x <= to; x += 12.0)
  {
    samples.emplace_back(x, 300.0 + 60.0 * std::abs(std::sin(0.03 * (x - 394.0))));
  }
  return samples;
}

vtkSmartPointer<vtkPolyData> fitted(vtkPolyData* strokes, vtkPolyData* mesh, int space, bool through = false)
{
  vtkNew<vtkOversketchNurbsFit> fit;
  fit->SetInputData(strokes);
  fit->SetMeshData(mesh);
  fit->SetFitSpace(space);
  fit->SetInterpolate(through);
  fit->Update();
  return fit->GetOutput();
}

std::vector<Vector3> controlsIn(vtkPolyData* curve)
{
  vtkDataArray* array = curve->GetFieldData()->GetArray("NurbsPoints");
  std::vector<Vector3> controls;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    controls.emplace_back(array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
  }
  return controls;
}

// From the places of a curve to another one.
double farthest(vtkPolyData* curve, vtkPolyData* other)
{
  double worst = 0.0;
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    double nearest = 1e9;
    for (vtkIdType k = 0; k + 1 < other->GetNumberOfPoints(); ++k)
    {
      const Vector3 from(other->GetPoint(k)), way = Vector3(other->GetPoint(k + 1)) - from;
      const Vector3 there = Vector3(curve->GetPoint(i)) - from;
      const double t = std::clamp(there.dot(way) / way.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (there - t * way).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

} // namespace

TEST(B2_7, ASplineInSpaceLeapsThroughTheAir)
{
  const auto mesh = twoPlates();
  const auto strokes = toStrokes({ { wave(250, 560), eye } });
  const auto inPicture = fitted(strokes, mesh, vtkOversketchNurbsFit::Picture);
  const auto inSpace = fitted(strokes, mesh, vtkOversketchNurbsFit::World);
  EXPECT_EQ(inPicture->GetFieldData()->GetArray("NurbsPoints")->GetNumberOfComponents(), 2);
  const std::vector<Vector3> controls = controlsIn(inSpace);
  int near = 0;
  for (const Vector3& control : controls)
  {
    EXPECT_LT(std::min(std::abs(control[2]), std::abs(control[2] - 1.0)), 1e-6) << "on neither plate";
    near += control[2] > 0.5;
  }
  EXPECT_GT(near, 5);
  EXPECT_LT(near, static_cast<int>(controls.size()) - 5);
  // Places are where the spline in space is seen; of it some lie on no plate.
  const Nurbs spline(static_cast<int>(controls.size()));
  vtkDataArray* parameters = inSpace->GetPointData()->GetArray("CurveT");
  double off = 0.0, air = 0.0, gap = 0.0;
  for (vtkIdType i = 0; i < inSpace->GetNumberOfPoints(); ++i)
  {
    const Vector3 place = spline.at(parameters->GetComponent(i, 0)).of(controls);
    const Vector2 seen(inSpace->GetPoint(i)[0], inSpace->GetPoint(i)[1]);
    off = std::max(off, (eye.toDisplay(place).head<2>() - seen).norm());
    air = std::max(air, std::min(std::abs(place[2]), std::abs(place[2] - 1.0)));
    gap =
      i > 0 ? std::max(gap, (Vector3(inSpace->GetPoint(i)) - Vector3(inSpace->GetPoint(i - 1))).norm()) : gap;
  }
  EXPECT_LT(off, 1e-9);
  EXPECT_LT(gap, 0.55);
  EXPECT_GT(air, 0.4);
  const double apart = farthest(inSpace, inPicture);
  EXPECT_GT(apart, 0.01);
  // What is seen without perspective is the same curve, to how finely it is sampled.
  const View parallel = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 200.0);
  const auto flat = toStrokes({ { wave(250, 560), parallel } });
  const auto flatPicture = fitted(flat, mesh, vtkOversketchNurbsFit::Picture);
  const auto flatSpace = fitted(flat, mesh, vtkOversketchNurbsFit::World);
  ASSERT_EQ(flatSpace->GetNumberOfPoints(), flatPicture->GetNumberOfPoints());
  for (vtkIdType i = 0; i < flatSpace->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT((Vector3(flatSpace->GetPoint(i)) - Vector3(flatPicture->GetPoint(i))).norm(), 1e-5);
  }
  std::ostringstream text;
  text << "two plates 1 apart: a spline in space is up to " << air << " off both, and seen up to " << apart
       << " px beside the one in the picture; without perspective it is the same one";
  fact("B2_7", text.str());
}

TEST(NurbsFit, InSpaceThroughSamplesAndBesideTheMesh)
{
  const auto mesh = twoPlates();
  const auto strokes = toStrokes({ { wave(250, 560), eye } });
  const auto through = fitted(strokes, mesh, vtkOversketchNurbsFit::World, true);
  for (const Vector2& sample : wave(250, 560))
  {
    double nearest = 1e9;
    for (vtkIdType i = 0; i < through->GetNumberOfPoints(); ++i)
    {
      nearest =
        std::min(nearest, (Vector2(through->GetPoint(i)[0], through->GetPoint(i)[1]) - sample).norm());
    }
    EXPECT_LT(nearest, 0.51);
  }
  // What lies beside the plates is as far away as the last sample that does not.
  const auto over = fitted(toStrokes({ { wave(440, 780), eye } }), mesh, vtkOversketchNurbsFit::World);
  const std::vector<Vector3> controls = controlsIn(over);
  EXPECT_GT(controls.back()[0], 1.1);
  EXPECT_NEAR(controls.back()[2], 0.0, 1e-6);
  // A mesh that is not looked at changes nothing.
  vtkNew<vtkPolyData> none;
  const auto with = fitted(strokes, mesh, vtkOversketchNurbsFit::Picture);
  const auto without = fitted(strokes, none, vtkOversketchNurbsFit::Picture);
  ASSERT_EQ(with->GetNumberOfPoints(), without->GetNumberOfPoints());
  for (vtkIdType i = 0; i < with->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vector3(with->GetPoint(i)), Vector3(without->GetPoint(i)));
  }
}

TEST(NurbsFit, InSpaceRefusals)
{
  const auto mesh = twoPlates();
  const auto strokes = toStrokes({ { wave(250, 560), eye } });
  vtkNew<vtkOversketchNurbsFit> fit;
  fit->SetFitSpaceToWorld();
  fit->SetInputData(strokes);
  expectRefusal(fit, Failure::BadMesh, "no mesh");
  fit->SetMeshData(mesh);
  fit->SetInputData(toStrokes({ { straight({ 5, 5 }, { 90, 8 }, 12), eye } }));
  expectRefusal(fit, Failure::BadStroke, "nothing of it lies on the mesh");
  vtkNew<vtkPolyData> blind;
  blind->ShallowCopy(strokes);
  blind->GetCellData()->Initialize();
  fit->SetInputData(blind);
  expectRefusal(fit, Failure::MissingArray, "ViewTransform");
  fit->SetInputData(strokes);
  fit->Update();
  EXPECT_GT(fit->GetOutput()->GetNumberOfPoints(), 0);
}
