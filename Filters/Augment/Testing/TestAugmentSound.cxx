// What strokes make of meshes that are hard for them, and what is said of it.
#include "AugmentTools.h"

#include "Intersection/crossing_faces.h"
#include "vtkOversketchRemesh.h"

#include "vtkIntArray.h"
#include "vtkQuadricDecimation.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> decimated(const std::string& name, double triangles = 1600.0)
{
  const auto model = shippedModel(name);
  vtkNew<vtkQuadricDecimation> filter;
  filter->SetInputData(model);
  filter->SetTargetReduction(1.0 - triangles / static_cast<double>(model->GetNumberOfPolys()));
  filter->Update();
  return filter->GetOutput();
}

double highestOf(vtkPolyData* mesh)
{
  vtkDataArray* moves = mesh->GetPointData()->GetArray("Displacement");
  double most = 0.0;
  for (vtkIdType i = 0; i < moves->GetNumberOfTuples(); ++i)
  {
    most = std::max(most, Vector3(moves->GetTuple3(i)).norm());
  }
  return most;
}

std::size_t cutting(vtkPolyData* polyData)
{
  Mesh mesh;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    mesh.points.push_back(pointOf(polyData, i));
  }
  for (vtkIdType f = 0; f < polyData->GetNumberOfPolys(); ++f)
  {
    polyData->GetPolys()->GetCellAtId(f, ids);
    mesh.triangles.push_back(
      { int(ids->GetId(0)), int(ids->GetId(1)), int(ids->GetId(2)) }); // as the kernel numbers them
  }
  return crossingFaces(mesh, {}).size();
}

// A round bar along y, of radius 0.2 and length 2.
vtkSmartPointer<vtkPolyData> bar()
{
  Mesh mesh = icosphere(5, 0.2);
  for (Vector3& p : mesh.points)
  {
    p[1] = p[1] * 5.0;
  }
  return toPolyData(mesh);
}

std::vector<Vector2> straightLine(const Vector2& a, const Vector2& b, int count = 30)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= count; ++i)
  {
    samples.emplace_back(a + (b - a) * (i / double(count)));
  }
  return samples;
}

// Which pixels the mesh covers along a row: the leftmost and the rightmost.
std::pair<double, double> extentAt(vtkPolyData* mesh, const View& view, double row, double within = 4.0)
{
  std::pair<double, double> extent{ HUGE_VAL, -HUGE_VAL };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3 d = view.toDisplay(pointOf(mesh, i));
    if (std::abs(d[1] - row) < within)
    {
      extent.first = std::min(extent.first, d[0]);
      extent.second = std::max(extent.second, d[0]);
    }
  }
  return extent;
}

} // namespace

// Lines over decimated models: without even triangles first, 6 to 31 places where they cross edges stay
// unsnapped in each, and a crest has 0.75 of its height.
TEST(AugmentSound, LinesOverLongThinTriangles)
{
  struct Case
  {
    const char* model;
    double rise, length;
  };
  for (const Case& one : { Case{ "dog", 30, 120 },
         Case{ "dog", 30, 200 },
         Case{ "hand", -60, 120 },
         Case{ "hand", -60, 200 },
         Case{ "person", 60, 200 } })
  {
    SCOPED_TRACE(one.model + std::to_string(one.rise) + " " + std::to_string(one.length));
    System s(decimated(one.model), { vein(one.length, one.rise) });
    ASSERT_EQ(cutting(s.mesh), 0u);
    Ear ear(s.filter);
    vtkPolyData* output = s.run();
    EXPECT_GT(s.filter->GetInnerOutput("Even")->GetNumberOfPolys(), 0);
    EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0);
    EXPECT_EQ(s.filter->GetFigure("met.self_intersecting_faces"), 0.0);
    EXPECT_LE(s.filter->GetFigure("met.residual"), 1.0 + 0.01 * s.filter->GetFigure("met.crossings"));
    EXPECT_GT(s.filter->GetFigure("met.crest_minimum"), 0.95);
    EXPECT_TRUE(ear.warnings.empty()) << ear.warnings.front();
    EXPECT_EQ(cutting(output), 0u);
    // Another height finds the even mesh again.
    auto* even = vtkOversketchRemesh::SafeDownCast(s.filter->GetStep("Even"));
    EXPECT_EQ(even->GetRemeshCount(), 1);
    const auto first = deepCopy(output);
    s.filter->SetHeight(1e-3);
    s.run();
    s.filter->SetHeight(0.0);
    expectSame(first, s.run());
    EXPECT_EQ(even->GetRemeshCount(), 1);
  }
}

TEST(AugmentSound, EvenTrianglesStayAsTheyAre)
{
  for (const char* name : { "bear", "dog", "hand" })
  {
    System s(shippedModel(name));
    s.run();
    EXPECT_EQ(s.filter->GetInnerOutput("Even")->GetNumberOfPolys(), 0) << name;
  }
}

// A blade pushed through a bar: as published it goes through the other side, and that is said with figures.
TEST(AugmentSound, WhatGoesThroughItselfIsSaid)
{
  System s(bar(), { straightLine({ 390, 300 }, { 410, 300 }, 8) });
  s.filter->SetRadius(0.1);
  s.filter->SetHeight(-0.6);
  s.filter->AsPublishedOn();
  Ear ear(s.filter);
  s.run();
  const auto cuts = static_cast<int>(s.filter->GetFigure("met.self_intersecting_faces"));
  EXPECT_GT(cuts, 10);
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(
    ear.warnings[0].find(std::to_string(cuts) + " triangles newly pass through others"), std::string::npos)
    << ear.warnings[0];
}

// The same stops before the other side, which stays where it is, and says so.
TEST(AugmentSound, AGrooveStopsBeforeTheOtherSide)
{
  System s(bar(), { straightLine({ 390, 300 }, { 410, 300 }, 8) });
  s.filter->SetRadius(0.1);
  s.filter->SetHeight(-0.6);
  Ear ear(s.filter);
  vtkPolyData* output = s.run();
  EXPECT_EQ(s.filter->GetFigure("met.self_intersecting_faces"), 0.0);
  EXPECT_EQ(cutting(output), 0u);
  EXPECT_NEAR(highestOf(output), 0.4 * 0.4, 0.01);
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(ear.warnings[0].find("stops before the other side, at 27 % of it"), std::string::npos)
    << ear.warnings[0];
  // One that fits is as deep as asked.
  s.filter->SetHeight(-0.05);
  EXPECT_NEAR(highestOf(s.run()), 0.05, 1e-9);
  EXPECT_EQ(ear.warnings.size(), 1u);
}

// Lines side by side, nearer than two radii.
TEST(AugmentSound, ParallelLinesAreTheSameAtOnceAndOneByOne)
{
  std::vector<std::vector<Vector2>> drawn;
  for (const double rise : { -30.0, -15.0, 0.0, 15.0, 30.0 })
  {
    drawn.push_back(straightLine({ 350, 300 + rise }, { 450, 300 + rise }));
  }
  System s(shippedModel("bear"), drawn);
  const auto atOnce = deepCopy(s.run());
  EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0);
  s.filter->OneByOneOn();
  expectSame(atOnce, s.run());
  // One that crosses them is raised on what they have made.
  drawn.push_back(straightLine({ 400, 250 }, { 400, 350 }));
  System crossed(shippedModel("bear"), drawn);
  const auto together = deepCopy(crossed.run());
  crossed.filter->OneByOneOn();
  EXPECT_FALSE(identical(together, crossed.run()));
}

// Lines over others, which stand on what those have made: all rise as the mesh before them looks, and none
// leans over on another one's flank.
TEST(AugmentSound, HatchingOneByOneCrossesItselfNowhere)
{
  std::vector<std::vector<Vector2>> drawn;
  for (const double by : { -24.0, -12.0, 0.0, 12.0, 24.0 })
  {
    drawn.push_back(straightLine({ 350, 300 + by }, { 450, 300 + by }));
  }
  for (const double by : { -24.0, -12.0, 0.0, 12.0, 24.0 })
  {
    drawn.push_back(straightLine({ 400 + by, 250 }, { 400 + by, 350 }));
  }
  System s(shippedModel("bear"), drawn);
  s.filter->OneByOneOn();
  Ear ear(s.filter);
  s.run();
  EXPECT_EQ(s.filter->GetFigure("met.self_intersecting_faces"), 0.0);
  EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0);
  EXPECT_TRUE(ear.warnings.empty()) << ear.warnings[0];
}

// What is snapped to a feature's foot lies at its radius but for rounding, which decides nothing.
TEST(AugmentSound, FarFromTheOriginTheSameTrianglesAreMade)
{
  const Vector3 offset(5e5, 4.6e6, 120.0);
  const auto collar = [](const Vector3& by)
  {
    const auto mesh = deepCopy(shippedModel("dog")), strokes = deepCopy(shippedStroke("dog_collar"));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(Vector3(pointOf(mesh, i) + by).data());
    }
    mesh->SetPoints(points);
    vtkDataArray* views = strokes->GetCellData()->GetArray("ViewTransform");
    for (vtkIdType i = 0; i < views->GetNumberOfTuples(); ++i)
    {
      Eigen::Matrix<double, 4, 4, Eigen::RowMajor> eye, back = Eigen::Matrix4d::Identity();
      views->GetTuple(i, eye.data());
      back.topRightCorner<3, 1>() = -by;
      eye = eye * back;
      views->SetTuple(i, eye.data());
    }
    vtkNew<vtkOversketchAugment> filter;
    filter->SetInputData(0, mesh);
    filter->SetStrokesData(strokes);
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    return deepCopy(filter->GetOutput());
  };
  const auto here = collar(Vector3::Zero()), far = collar(offset);
  ASSERT_EQ(here->GetNumberOfPoints(), far->GetNumberOfPoints());
  ASSERT_EQ(here->GetNumberOfPolys(), far->GetNumberOfPolys());
  double most = 0.0;
  for (vtkIdType i = 0; i < here->GetNumberOfPoints(); ++i)
  {
    most = std::max(most, (pointOf(far, i) - offset - pointOf(here, i)).norm());
  }
  EXPECT_LT(most, 1e-9 * offset.norm());
}

// Round the end of the bar, from one side to the other.
TEST(AugmentSound, AnOutlineRoundALimbsEndIsRefused)
{
  System s(bar());
  s.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
  for (const double longer : { 40.0, -40.0 })
  {
    std::vector<Vector2> arc;
    for (int i = 0; i <= 40; ++i)
    {
      const double a = pi * i / 40.0;
      arc.emplace_back(400.0 + 40.0 * std::cos(a), 430.0 + (120.0 + longer) * std::sin(a));
    }
    s.filter->SetStrokesData(strokesOf({ arc }, s.view));
    Ear ear(s.filter);
    s.filter->Update();
    ASSERT_EQ(ear.errors.size(), 1u);
    EXPECT_NE(ear.errors[0].find("pull the limb itself by one-stroke"), std::string::npos) << ear.errors[0];
  }
}

// The right side of the bar, pressed in.
TEST(AugmentSound, ADentIsMadeAsItIsDrawn)
{
  System s(bar());
  s.filter->SetSketchMode(vtkOversketchAugment::Silhouette);
  const double right = extentAt(s.mesh, s.view, 300.0).second, deep = 15.0;
  std::vector<Vector2> stroke;
  for (int i = 0; i <= 30; ++i)
  {
    const double y = 270.0 + 2.0 * i;
    stroke.emplace_back(
      extentAt(s.mesh, s.view, y).second - deep * std::pow(std::sin(pi * i / 30.0), 2.0), y);
  }
  s.filter->SetStrokesData(strokesOf({ stroke }, s.view));
  vtkPolyData* output = s.run();
  EXPECT_EQ(s.filter->GetFigure("met.flipped_faces"), 0);
  EXPECT_EQ(cutting(output), 0u);
  EXPECT_NEAR(extentAt(output, s.view, 300.0, 2.0).second, right - deep, 3.0);
  EXPECT_NEAR(extentAt(output, s.view, 300.0).first, extentAt(s.mesh, s.view, 300.0).first, 2.0);
}

// A colour of bytes that is linear in space stays so within what bytes can say; labels are those of a corner.
TEST(AugmentSound, ColoursAreMixedAndLabelsAreNot)
{
  const auto mesh = bar();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> measure, label;
  measure->SetName("Heat");
  label->SetName("RegionId");
  const auto valueAt = [](const Vector3& p) { return 100.0 + 80.0 * p[1] + 40.0 * p[0]; };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double value = valueAt(pointOf(mesh, i));
    const double rounded = std::round(value);
    colours->InsertNextTuple3(rounded, 255.0 - rounded, 7.0);
    measure->InsertNextValue(static_cast<int>(std::lround(1000.0 * value)));
    label->InsertNextValue(pointOf(mesh, i)[1] > 0.0 ? 1000 : 5);
  }
  mesh->GetPointData()->SetScalars(colours);
  mesh->GetPointData()->AddArray(measure);
  mesh->GetPointData()->AddArray(label);
  System s(mesh);
  s.filter->SetHeight(1e-4);
  vtkPolyData* output = s.run();
  const vtkIdType before = mesh->GetNumberOfPoints(), count = output->GetNumberOfPoints();
  ASSERT_GT(count, before + 100);
  vtkDataArray* rgb = output->GetPointData()->GetArray("RGB");
  ASSERT_TRUE(rgb);
  EXPECT_EQ(rgb->GetDataType(), VTK_UNSIGNED_CHAR);
  double off = 0.0, offMeasure = 0.0;
  for (vtkIdType i = before; i < count; ++i)
  {
    const double value = valueAt(pointOf(output, i));
    off = std::max({ off,
      std::abs(rgb->GetComponent(i, 0) - value),
      std::abs(rgb->GetComponent(i, 1) - (255.0 - value)),
      std::abs(rgb->GetComponent(i, 2) - 7.0) });
    offMeasure = std::max(
      offMeasure, std::abs(output->GetPointData()->GetArray("Heat")->GetComponent(i, 0) - 1000.0 * value));
    const double id = output->GetPointData()->GetArray("RegionId")->GetComponent(i, 0);
    EXPECT_TRUE(id == 5.0 || id == 1000.0) << id;
  }
  EXPECT_LT(off, 1.02); // half a unit of the input, and half of what comes out
  EXPECT_LT(offMeasure, 40.0);
}
