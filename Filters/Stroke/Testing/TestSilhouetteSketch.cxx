#include "SurfaceTools.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSilhouetteSketch.h"
#include "vtkOversketchVisibility.h"

#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Sketch = vtkOversketchSilhouetteSketch;

const View eyeAtThree = perspectiveView(Vector3(0, 0, 3), Vector3(0, 1, 0), 60.0);

vtkSmartPointer<vtkPolyData> exactSphere(int levels)
{
  const Mesh mesh = icosphere(levels);
  return toPolyData(mesh, &mesh.points);
}

vtkSmartPointer<vtkPolyData> silhouetteOf(vtkPolyData* mesh, vtkPolyData* stroke)
{
  vtkNew<vtkOversketchSilhouette> filter;
  filter->SetInputData(mesh);
  filter->SetStrokeData(stroke);
  filter->Update();
  return filter->GetOutput();
}

// The stroke along the sphere's great arc from one place of its silhouette to another, so many degrees apart
// as seen: `share` of the arc, or, where that is more than one, bulging so far out between its ends.
vtkSmartPointer<vtkPolyData> arcStroke(const View& view, double D, double degrees, double share, int count)
{
  const double radius = std::sqrt(1.0 - 1.0 / (D * D));
  const auto place = [&](double angle)
  { return Vector3(radius * std::cos(angle), radius * std::sin(angle), 1.0 / D); };
  const double a = 0.35, b = a + degrees * pi / 180.0;
  std::vector<Vector2> samples;
  for (int i = 0; i < count; ++i)
  {
    const double t = double(i) / (count - 1);
    const Vector3 p = ((1.0 - t) * place(a) + t * place(b)).normalized();
    const double out = share > 1.0 ? 1.0 + (share - 1.0) * std::sin(pi * t) : share;
    samples.emplace_back(view.toDisplay(out * p).head<2>());
  }
  return toStroke(samples, view);
}

std::string figureText(double x)
{
  std::ostringstream stream;
  stream << x;
  return stream.str();
}

std::vector<Vector3> pointsOf(vtkPolyData* polyData)
{
  std::vector<Vector3> points;
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
    points.emplace_back(polyData->GetPoint(i));
  return points;
}

// p0, pn and half the sum of their normals, on a sphere with exact normals.
struct Ends
{
  explicit Ends(const std::vector<Vector3>& curve)
    : begin(curve.front())
    , end(curve.back())
    , mean(0.5 * (begin.normalized() + end.normalized()))
  {
  }
  Vector3 begin, end, mean;
};

} // namespace

TEST(D4_1, SilhouetteAndPlaneOfASphere)
{
  const auto sphere = exactSphere(4);
  double off = 0.0, fromCentre = 0.0;
  for (const double D : { 1.5, 3.0, 10.0 })
  {
    const View view = perspectiveView(Vector3(0, 0, D), Vector3(0, 1, 0), 90.0 / D);
    const auto stroke = arcStroke(view, D, 60.0, 1.1, 40);
    const auto silhouette = silhouetteOf(sphere, stroke);
    ASSERT_GT(silhouette->GetNumberOfPoints(), 20);
    for (const Vector3& p : pointsOf(silhouette))
      off = std::max(off, std::abs(p[2] - 1.0 / D));
    vtkNew<Sketch> filter;
    filter->SetInputData(stroke);
    filter->SetMeshData(sphere);
    filter->SetSilhouetteData(silhouette);
    filter->SetMaximumStep(0.0);
    filter->Update();
    ASSERT_EQ(filter->GetErrorCode(), 0u);
    const std::vector<Vector3> sketch = pointsOf(filter->GetSketchOutput());
    const Vector3 normal = sketch.front().cross(sketch.back()).normalized();
    for (const Vector3& s : sketch)
      fromCentre = std::max(fromCentre, std::abs(s.dot(normal)));
  }
  EXPECT_LT(off, 1e-12);
  EXPECT_LT(fromCentre, 1e-12);
  // A plate that faces the camera has no silhouette, and is refused.
  const auto plate = toPolyData(
    gridSurface(4, 4, false, false, [](double u, double v) { return Vector3(2 * u - 1, 2 * v - 1, 0); }));
  const auto stroke = toStroke(straight({ 330, 270 }, { 470, 330 }, 30), eyeAtThree);
  EXPECT_EQ(silhouetteOf(plate, stroke)->GetNumberOfPoints(), 0);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(plate);
  filter->SetSilhouetteData(silhouetteOf(plate, stroke));
  expectRefusal(filter, Failure::BadStroke, "no silhouette");
  fact("D4_1",
    "eye at 1.5, 3, 10 R: samples off z = R*R/D by " + figureText(off) + ", plane off the centre by " +
      figureText(fromCentre) + "; a plate that faces the camera has none");
}

TEST(D4_2, ARolledCameraSeesTheSameAndEndsStay)
{
  const auto sphere = exactSphere(4);
  double apart = 0.0, atEnds = 0.0;
  std::vector<Vector3> expected;
  for (const double roll : { 0.0, 0.7, 2.0 })
  {
    const View view = perspectiveView(Vector3(0, 0, 3), Vector3(std::sin(roll), std::cos(roll), 0), 60.0);
    const auto stroke = arcStroke(view, 3.0, 60.0, 1.15, 60);
    const auto silhouette = silhouetteOf(sphere, stroke);
    const std::vector<Vector3> samples = pointsOf(silhouette);
    if (expected.empty())
      expected = samples;
    ASSERT_EQ(samples.size(), expected.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      apart = std::max(apart, (samples[i] - expected[i]).norm());
    for (const int projection : { Sketch::Ray, Sketch::Line, Sketch::Path })
    {
      vtkNew<Sketch> filter;
      filter->SetInputData(stroke);
      filter->SetMeshData(sphere);
      filter->SetSilhouetteData(silhouette);
      filter->SetProjection(projection);
      filter->Update();
      ASSERT_EQ(filter->GetErrorCode(), 0u);
      vtkPolyData* curve = filter->GetOutput();
      vtkPolyData* sketch = filter->GetSketchOutput();
      ASSERT_EQ(curve->GetNumberOfPoints(), sketch->GetNumberOfPoints());
      EXPECT_EQ(curve->GetNumberOfPoints(), 60);
      EXPECT_EQ(curve->GetLines(), sketch->GetLines());
      EXPECT_EQ(curve->GetCellData()->GetArray("CurveId"), sketch->GetCellData()->GetArray("CurveId"));
      for (const vtkIdType end : { vtkIdType(0), vtkIdType(59) })
        atEnds = std::max(atEnds, (Vector3(curve->GetPoint(end)) - Vector3(sketch->GetPoint(end))).norm());
    }
  }
  EXPECT_LT(apart, 1e-12);
  EXPECT_EQ(atEnds, 0.0);
  fact("D4_2",
    "rolled by 40 and 115 degrees: samples move by " + figureText(apart) +
      "; 60 points of curve and sketch each, their ends " + figureText(atEnds) + " apart");
}

TEST(D4_3, ASketchInsideTheSphereStaysOnTheNearSide)
{
  const auto sphere = exactSphere(4);
  const auto stroke = arcStroke(eyeAtThree, 3.0, 60.0, 0.9, 40);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(sphere);
  filter->SetSilhouetteData(silhouetteOf(sphere, stroke));
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  const std::vector<Vector3> curve = pointsOf(filter->GetOutput());
  const Ends ends(curve);
  double least = 1.0, step = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
  {
    least = std::min(least, curve[k].dot(ends.mean));
    step = k > 0 ? std::max(step, (curve[k] - curve[k - 1]).norm()) : step;
  }
  EXPECT_GT(least, 0.5);
  EXPECT_LT(step, 0.1);
  filter->SetProjectionToRay();
  filter->Update();
  int behind = 0;
  for (const Vector3& p : pointsOf(filter->GetOutput()))
    behind += p.dot(ends.mean) < 0.0;
  EXPECT_GT(behind, 10);
  fact("D4_3",
    "0.9 of an arc of 60 degrees: every p . n at least " + figureText(least) + ", steps at most " +
      figureText(step) + "; as published " + std::to_string(behind) + " of 40 on the far side");
}

TEST(SilhouetteSketch, PathFollowsTheSilhouetteBetweenTheEnds)
{
  const auto sphere = exactSphere(5);
  const auto stroke = arcStroke(eyeAtThree, 3.0, 80.0, 1.3, 50);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(sphere);
  filter->SetSilhouetteData(silhouetteOf(sphere, stroke));
  filter->SetProjectionToPath();
  filter->Update();
  const std::vector<Vector3> curve = pointsOf(filter->GetOutput());
  ASSERT_EQ(curve.size(), 50u);
  double length = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
  {
    EXPECT_NEAR(curve[k][2], 1.0 / 3.0, 1e-9); // the short way round, on the silhouette
    length += k > 0 ? (curve[k] - curve[k - 1]).norm() : 0.0;
  }
  const double angle =
    std::acos(curve.front().head<2>().normalized().dot(curve.back().head<2>().normalized()));
  EXPECT_NEAR(length, angle * curve.front().head<2>().norm(), 0.01);
}

TEST(SilhouetteSketch, VisibleCurvesArePreferredAndAnEndBesideTheModelFindsTheOutline)
{
  // A small sphere behind a large one, its silhouette nearer to the stroke's first end in the picture.
  const View view = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 200.0);
  const auto mesh = toPolyData(joined(icosphere(4), icosphere(3, 0.4), { 0.5, 0, -3 }));
  const auto beside = [&](double gap)
  {
    std::vector<Vector2> samples;
    for (int i = 0; i < 40; ++i)
    {
      const double angle = -0.5 + i / 39.0;
      samples.emplace_back(400 + (200 + gap) * std::cos(angle), 300 + (200 + gap) * std::sin(angle));
    }
    return toStroke(samples, view);
  };
  const auto stroke = beside(15.0);
  vtkNew<vtkOversketchVisibility> visible;
  visible->SetInputData(silhouetteOf(mesh, stroke));
  visible->SetMeshData(mesh);
  visible->SetStrokeData(stroke);
  visible->Update();
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(mesh);
  filter->SetSilhouetteData(visible->GetOutput());
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  for (const Vector3& p : pointsOf(filter->GetOutput()))
    EXPECT_GT(p[2], -1.5);
  // If nothing is visible, what is hidden serves.
  vtkNew<vtkPolyData> hidden;
  hidden->DeepCopy(visible->GetOutput());
  hidden->GetCellData()->GetArray("Visible")->Fill(0.0);
  filter->SetSilhouetteData(hidden);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  filter->SetSilhouetteData(visible->GetOutput());
  filter->SetInputData(beside(30.0));
  expectRefusal(filter, Failure::BadStroke, "The stroke begins 30 px beside the silhouette");
}

TEST(SilhouetteSketch, APenBesideALimbTakesTheLimbNotWhatIsBehind)
{
  // A small sphere before a large one; the stroke begins and ends 3 px outside the small one's outline.
  const View view = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 200.0);
  const auto mesh = toPolyData(joined(icosphere(4), icosphere(4, 0.4), { 0.1, 0, 3 }));
  std::vector<Vector2> samples;
  for (int i = 0; i < 40; ++i)
  {
    const double angle = 1.0 + i / 39.0;
    const double radius = 83 + 25 * std::sin(pi * i / 39.0);
    samples.emplace_back(420 + radius * std::cos(angle), 300 + radius * std::sin(angle));
  }
  const auto stroke = toStroke(samples, view);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(mesh);
  filter->SetSilhouetteData(silhouetteOf(mesh, stroke));
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  for (const Vector3& p : pointsOf(filter->GetOutput()))
    EXPECT_GT(p[2], 2.5);
  // As published it is the far sphere's silhouette that is nearest to the surface under the pen.
  filter->SetProjectionToRay();
  filter->Update();
  EXPECT_LT(filter->GetOutput()->GetPoint(0)[2], 1.0);
}

TEST(SilhouetteSketch, ASketchOverEmptySpaceIsRefused)
{
  // From one of two spheres to the other.
  const View view = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 120.0);
  const auto mesh = toPolyData(joined(icosphere(4), icosphere(4), { 3, 0, 0 }));
  const auto stroke = toStroke(
    straight(view.toDisplay({ 0, 0.98, 0 }).head<2>(), view.toDisplay({ 3, 0.98, 0 }).head<2>(), 80), view);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(mesh);
  filter->SetSilhouetteData(silhouetteOf(mesh, stroke));
  expectRefusal(filter, Failure::BadStroke, "longer than 0.1");
  filter->SetProjectionToPath();
  expectRefusal(filter, Failure::BadStroke, "No one silhouette curve joins");
  filter->SetProjectionToLine();
  filter->SetMaximumStep(0.0);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u) << "asked for";
}

TEST(SilhouetteSketch, RefusesABadHandByName)
{
  const auto sphere = exactSphere(3);
  const auto good = arcStroke(eyeAtThree, 3.0, 60.0, 1.1, 40);
  const auto silhouette = silhouetteOf(sphere, good);
  vtkNew<Sketch> filter;
  filter->SetMeshData(sphere);
  filter->SetSilhouetteData(silhouette);
  const auto refused = [&](vtkPolyData* stroke, const char* words)
  {
    filter->SetInputData(stroke);
    expectRefusal(filter, Failure::BadStroke, words);
    EXPECT_EQ(filter->GetSketchOutput()->GetNumberOfPoints(), 0);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused(toStroke({ { 400, 300 } }, eyeAtThree), "1 sample");
  refused(toStroke({ { 400, 300 }, { nan, 300 } }, eyeAtThree), "sample 1 is not finite");
  refused(toStroke(straight({ 5, 5 }, { 60, 5 }, 20), eyeAtThree), "px beside the silhouette");
  refused(toStrokes({ { straight({ 380, 300 }, { 420, 300 }, 9), eyeAtThree },
            { straight({ 380, 300 }, { 420, 300 }, 9), eyeAtThree } }),
    "holds 2 polylines");
  // There and back: one place of the silhouette for both ends.
  const Vector2 rim = eyeAtThree.toDisplay({ std::sqrt(8.0) / 3.0, 0, 1.0 / 3.0 }).head<2>();
  refused(toStroke({ rim, rim + Vector2(60, 0), rim }, eyeAtThree), "span no plane");
  refused(toStroke(std::vector<Vector2>(9, rim), eyeAtThree), "span no plane");
  // Opposite places: their normals cancel, as at both sides of a limb.
  const View parallel = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  const auto opposite = toStroke({ { 200, 300 }, { 400, 120 }, { 600, 300 } }, parallel);
  filter->SetSilhouetteData(silhouetteOf(sphere, opposite));
  refused(opposite, "round the end of a limb");
  // Beside each other, on what a limb stands on.
  refused(toStroke({ { 386, 499.5 }, { 400, 690 }, { 414, 499.5 } }, parallel), "a limb rather than a bump");
  filter->SetInputData(good);
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(silhouette);
  bare->GetPointData()->SetNormals(nullptr);
  bare->GetPointData()->RemoveArray("Normals");
  filter->SetSilhouetteData(bare);
  expectRefusal(filter, Failure::MissingArray, "The silhouette has no array Normals");
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(silhouette);
  broken->GetPoints()->SetPoint(0, nan, 0, 0);
  filter->SetSilhouetteData(broken);
  expectRefusal(
    filter, Failure::BadMesh, "of the silhouette names a point that does not exist, or is not finite");
  filter->SetSilhouetteData(sphere);
  expectRefusal(filter, Failure::BadMesh, "not polylines");
  filter->SetSilhouetteData(silhouette);
  filter->SetMaximumStep(nan);
  expectRefusal(filter, Failure::BadStroke, "MaximumStep is not finite");
  vtkNew<vtkPolyData> empty;
  filter->SetMeshData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SilhouetteSketch, KeepsCancelsAndPrints)
{
  const auto sphere = exactSphere(4);
  const auto stroke = arcStroke(eyeAtThree, 3.0, 60.0, 1.1, 40);
  vtkNew<Sketch> filter;
  filter->SetInputData(stroke);
  filter->SetMeshData(sphere);
  filter->SetSilhouetteData(silhouetteOf(sphere, stroke));
  expectCancel(filter);
  expectCancel(filter, 0.7);
  filter->Update();
  const vtkSmartPointer<vtkPoints> points = filter->GetOutput()->GetPoints();
  const vtkSmartPointer<vtkPoints> sketch = filter->GetSketchOutput()->GetPoints();
  const vtkIdType runs = filter->GetProjectionCount();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetProjectionCount(), runs);
  EXPECT_EQ(filter->GetOutput()->GetPoints(), points.Get());
  EXPECT_EQ(filter->GetSketchOutput()->GetPoints(), sketch.Get());
  const vtkIdType scenes = filter->GetSceneCount();
  filter->SetInputData(arcStroke(eyeAtThree, 3.0, 60.0, 1.2, 40));
  filter->Update();
  EXPECT_EQ(filter->GetProjectionCount(), runs + 1);
  EXPECT_EQ(filter->GetSceneCount(), scenes);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("Projection: 1"), std::string::npos);
}
