#include "Harness/promises.h"
#include "vtkOversketchSilhouette.h"

#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector3 y(0, 1, 0), z(0, 0, 1);

vtkSmartPointer<vtkPolyData> strokeOf(const View& view)
{
  return toStroke({ { 10, 10 }, { 20, 30 } }, view);
}

// The filter's output for a mesh, with the given normals where they are given.
vtkSmartPointer<vtkPolyData> silhouette(const Mesh& mesh,
  const View& view,
  const std::vector<Vector3>* normals = nullptr)
{
  vtkNew<vtkOversketchSilhouette> filter;
  filter->SetInputData(toPolyData(mesh, normals));
  filter->SetStrokeData(strokeOf(view));
  filter->Update();
  vtkSmartPointer<vtkPolyData> output = filter->GetOutput();
  return output;
}

std::vector<Vector3> directions(const Mesh& mesh)
{
  std::vector<Vector3> normals = mesh.points;
  for (Vector3& n : normals)
  {
    n.normalize();
  }
  return normals;
}

Vector3 point(vtkPolyData* curves, vtkIdType i)
{
  Vector3 p;
  curves->GetPoint(i, p.data());
  return p;
}

bool closed(vtkPolyData* curves, vtkIdType cell)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  curves->GetLines()->GetCellAtId(cell, size, ids);
  return size > 3 && ids[0] == ids[size - 1];
}

double longestEdge(const Mesh& mesh)
{
  double longest = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    longest = std::max(longest, (mesh.points[t[0]] - mesh.points[t[1]]).norm());
    longest = std::max(longest, (mesh.points[t[1]] - mesh.points[t[2]]).norm());
    longest = std::max(longest, (mesh.points[t[2]] - mesh.points[t[0]]).norm());
  }
  return longest;
}

} // namespace

TEST(A1_1, SphereInAnOrthographicView)
{
  const double R = 2.5;
  const Mesh mesh = icosphere(3, R);
  const auto normals = directions(mesh);
  const View view = orthographicView(Vector3(0.3, -0.4, 0.8), y, 80.0);
  const auto curves = silhouette(mesh, view, &normals);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_TRUE(closed(curves, 0));
  const double shortest = R * std::cos(std::asin(longestEdge(mesh) / (2.0 * R)));
  double worst = 0.0, low = R, high = 0.0;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = point(curves, i);
    const double height = p.dot(view.normal());
    worst = std::max(worst, std::abs(height));
    const double radius = (p - height * view.normal()).norm();
    low = std::min(low, radius);
    high = std::max(high, radius);
    EXPECT_NEAR(curves->GetPointData()->GetArray("NormalDotView")->GetComponent(i, 0), 0.0, 1e-12);
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_GE(low, shortest);
  EXPECT_LE(high, R * (1.0 + 1e-15));
  fact("A1_1",
    "sphere R 2.5: one closed curve, out of plane " + std::to_string(worst * 1e12) + "e-12, radii " +
      std::to_string(low) + " to " + std::to_string(high) + " in [" + std::to_string(shortest) + ", 2.5]");
}

TEST(A1_2, SphereInAPerspectiveView)
{
  const double R = 2.0, D = 6.0;
  const Vector3 towards = Vector3(0.3, -0.4, 0.8).normalized();
  const Mesh mesh = icosphere(4, R);
  const auto normals = directions(mesh);
  const View view = perspectiveView(D * towards, y, 45.0);
  const auto curves = silhouette(mesh, view, &normals);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_TRUE(closed(curves, 0));
  double worst = 0.0, high = 0.0;
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = point(curves, i);
    const double height = p.dot(towards);
    worst = std::max(worst, std::abs(height - R * R / D));
    high = std::max(high, (p - height * towards).norm());
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_NEAR(high / R, 0.9428, 1e-3);
  EXPECT_LE(high, R * std::sqrt(1.0 - R * R / (D * D)) + 1e-12);
  fact("A1_2",
    "D = 3R: plane at R*R/D to " + std::to_string(worst * 1e12) + "e-12, largest radius " +
      std::to_string(high / R) + " R (limit 0.9428)");
}

TEST(A1_3, OctahedronAlongAVertexAxis)
{
  const Mesh mesh{
    { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } }
  };
  const auto normals = directions(mesh);
  const auto curves = silhouette(mesh, orthographicView(z, y, 100.0), &normals);
  ASSERT_EQ(curves->GetNumberOfLines(), 1);
  EXPECT_TRUE(closed(curves, 0));
  ASSERT_EQ(curves->GetNumberOfPoints(), 4);
  std::vector<int> vertices;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    double weights[3], ids[3];
    curves->GetPointData()->GetArray("MeshWeights")->GetTuple(i, weights);
    curves->GetPointData()->GetArray("MeshVertices")->GetTuple(i, ids);
    EXPECT_EQ(weights[0], 1.0);
    EXPECT_EQ(ids[0], ids[1]);
    EXPECT_EQ(ids[0], ids[2]);
    vertices.push_back(static_cast<int>(ids[0]));
  }
  std::sort(vertices.begin(), vertices.end());
  EXPECT_EQ(vertices, (std::vector<int>{ 0, 1, 2, 3 }));
  fact("A1_3", "octahedron: 4 vertex points, 0 edge points, 1 closed curve");
}

TEST(A1_4, TorusHasTwoClosedCurves)
{
  const Mesh mesh = torus(1.0, 0.4, 96, 48);
  for (const double degrees : { 5.0, 30.0, 58.0, 75.0, 88.0 })
  {
    const double a = degrees * pi / 180.0;
    const auto curves = silhouette(mesh, orthographicView(Vector3(std::sin(a), 0, std::cos(a)), y, 100.0));
    ASSERT_EQ(curves->GetNumberOfLines(), 2) << degrees;
    EXPECT_TRUE(closed(curves, 0) && closed(curves, 1)) << degrees;
  }
  const auto curves = silhouette(torus(1.0, 0.4, 256, 256), perspectiveView(Vector3(0, 0, 4), y, 45.0));
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  double radii[2], heights[2];
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    curves->GetLines()->GetCellAtId(cell, size, ids);
    radii[cell] = heights[cell] = 0.0;
    for (vtkIdType k = 1; k < size; ++k)
    {
      const Vector3 p = point(curves, ids[k]);
      radii[cell] += p.head<2>().norm() / static_cast<double>(size - 1);
      heights[cell] += p[2] / static_cast<double>(size - 1);
    }
  }
  const int outer = radii[0] > radii[1] ? 0 : 1;
  EXPECT_NEAR(radii[outer], 1.3768, 5e-4);
  EXPECT_NEAR(heights[outer], 0.1342, 5e-4);
  EXPECT_NEAR(radii[1 - outer], 0.6044, 5e-4);
  EXPECT_NEAR(heights[1 - outer], -0.0589, 5e-4);
  fact("A1_4",
    "two closed curves at 5..88 degrees; eye at 4: radii " + std::to_string(radii[outer]) + " and " +
      std::to_string(radii[1 - outer]) + " (1.3768, 0.6044), heights " + std::to_string(heights[outer]) +
      " and " + std::to_string(heights[1 - outer]) + " (0.1342, -0.0589)");
}

TEST(A1_5, OpenCylinderFromTheSide)
{
  const Mesh mesh = cylinder(0.7, 3.0, 31, 9);
  const View view = orthographicView(Vector3(1, 0.17, 0), z, 80.0);
  const auto curves = silhouette(mesh, view);
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  double worst = 0.0;
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    EXPECT_FALSE(closed(curves, cell));
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    curves->GetLines()->GetCellAtId(cell, size, ids);
    const Vector3 a = point(curves, ids[0]), b = point(curves, ids[size - 1]);
    EXPECT_NEAR(std::abs(b[2] - a[2]), 3.0, 1e-12); // from border to border
    for (vtkIdType k = 0; k < size; ++k)
    {
      const Vector3 p = point(curves, ids[k]);
      // The surface is a prism: a silhouette point is off the line by less than its flat sides are off the
      // circle.
      const double off = (p - a).cross((b - a).normalized()).norm();
      worst = std::max(worst, off);
      EXPECT_NEAR(p.head<2>().dot(view.normal().head<2>()), 0.0, 0.01);
    }
  }
  EXPECT_LT(worst, 0.7 * (1.0 - std::cos(pi / 31)));
  fact(
    "A1_5", "two open curves from border to border, off a straight line by at most " + std::to_string(worst));
}

TEST(Silhouette, RefusesWhatItCannotRead)
{
  const Mesh mesh = icosphere(1);
  const View view = orthographicView(z, y, 100.0);
  const auto expect = [](vtkPolyData* input, vtkPolyData* stroke, Failure failure, const std::string& word)
  {
    vtkNew<vtkOversketchSilhouette> filter;
    filter->SetInputData(input);
    filter->SetStrokeData(stroke);
    expectRefusal(filter, failure, word);
  };
  const auto stroke = strokeOf(view);
  auto bad = toPolyData(mesh);
  bad->GetPoints()->SetPoint(7, 0.0, std::nan(""), 0.0);
  expect(bad, stroke, Failure::BadMesh, "Point 7");
  bad = toPolyData(mesh);
  bad->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  expect(bad, stroke, Failure::BadMesh, "Cell 80");
  const auto good = toPolyData(mesh);
  auto viewless = strokeOf(view);
  viewless->GetCellData()->RemoveArray("ProjectionTransform");
  expect(good, viewless, Failure::MissingArray, "ProjectionTransform");
  auto twoViews = strokeOf(view);
  twoViews->GetLines()->InsertNextCell({ 0, 1 });
  for (int i = 0; i < twoViews->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = twoViews->GetCellData()->GetArray(i);
    array->InsertNextTuple(array->GetTuple(0));
    array->SetComponent(1, 0, array->GetComponent(0, 0) + 1.0);
  }
  expect(good, twoViews, Failure::BadStroke, "different views");
}

TEST(Silhouette, AnEmptyMeshGivesAnEmptyOutputSilently)
{
  vtkNew<vtkOversketchSilhouette> filter;
  Ear ear(filter);
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->SetStrokeData(strokeOf(orthographicView(z, y, 100.0)));
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Silhouette, ANewStrokeOfTheSameViewChangesNothingAndTheInputStands)
{
  const Mesh mesh = icosphere(3);
  const auto input = toPolyData(mesh);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(input);
  const View view = orthographicView(Vector3(0.3, 0.2, 1), y, 100.0);
  vtkNew<vtkOversketchSilhouette> filter;
  filter->SetInputData(input);
  filter->SetStrokeData(strokeOf(view));
  filter->Update();
  vtkNew<vtkPolyData> first;
  first->DeepCopy(filter->GetOutput());
  filter->SetStrokeData(toStroke({ { 1, 2 }, { 3, 4 }, { 5, 9 } }, view));
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), first->GetNumberOfPoints());
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(point(first, i), point(filter->GetOutput(), i));
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(point(before, i), point(input, i));
  }
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), 0);
}
