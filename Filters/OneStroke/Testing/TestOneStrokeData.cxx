// The user's arrays through the one-stroke system.
#include "Harness/shipped.h"

#include "vtkOversketchOneStroke.h"

#include "vtkCleanPolyData.h"
#include "vtkFeatureEdges.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyDataNormals.h"

#include <gtest/gtest.h>

using namespace oversketch_test;

namespace
{

int openOrBadEdges(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  clean->SetTolerance(0.0);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(clean->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfCells());
}

// Every corner a point of its own, as readers of textured OBJ files make them. Texture coordinates are the
// position seen from the side, mirrored for triangles that face away, so there is a seam round the body;
// AlongZ is the position itself.
vtkSmartPointer<vtkPolyData> textured(vtkPolyData* mesh)
{
  Mesh split;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TCoords");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkIdTypeArray> id;
  id->SetName("CellNumber");
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    Vector3 p[3];
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids->GetId(k), p[k].data());
    }
    const double side = (p[1] - p[0]).cross(p[2] - p[0]).z() >= 0.0 ? 1.0 : -1.0;
    for (const Vector3& q : p)
    {
      split.points.push_back(q);
      texture->InsertNextTuple2(side * (10.0 + q.x()), q.y());
    }
    const int n = split.vertexCount();
    split.triangles.push_back({ n - 3, n - 2, n - 1 });
    id->InsertNextValue(cell);
  }
  auto result = toPolyData(split);
  result->GetPointData()->SetTCoords(texture);
  result->GetCellData()->AddArray(id);
  return result;
}

} // namespace

TEST(OneStrokeData, ATexturedMeshOfSplitCornersComesOutTexturedAndClosed)
{
  auto dog = shippedModel("dog");
  auto input = textured(dog);
  ASSERT_EQ(openOrBadEdges(dog), 0);
  for (const int remesh : { vtkOversketchOneStroke::RemeshOff, vtkOversketchOneStroke::RemeshOn })
  {
    vtkNew<vtkOversketchOneStroke> filter;
    filter->SetInputData(0, input);
    filter->SetStrokeData(shippedStroke("dog_longer_leg"));
    filter->SetRemesh(remesh);
    filter->Update();
    ASSERT_EQ(filter->GetErrorCode(), 0u);
    vtkPolyData* output = filter->GetOutput();
    EXPECT_EQ(openOrBadEdges(output), 0);
    vtkDataArray* texture = output->GetPointData()->GetTCoords();
    ASSERT_NE(texture, nullptr);
    ASSERT_EQ(texture->GetNumberOfTuples(), output->GetNumberOfPoints());
    // No triangle spans the seam: its corners lie on one side of the texture.
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
    {
      output->GetCellPoints(cell, ids);
      const double a = texture->GetComponent(ids->GetId(0), 0), b = texture->GetComponent(ids->GetId(1), 0),
                   c = texture->GetComponent(ids->GetId(2), 0);
      ASSERT_TRUE((a > 0) == (b > 0) && (a > 0) == (c > 0)) << cell << ": " << a << " " << b << " " << c;
    }
    // Where nothing moved, the texture still says where the point is.
    vtkIdType still = 0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double p[3];
      output->GetPoint(i, p);
      still += std::abs(std::abs(texture->GetComponent(i, 0)) - 10.0 - std::abs(p[0])) < 1e-4 ||
               std::abs(std::abs(texture->GetComponent(i, 0)) - (10.0 + p[0])) < 1e-4;
    }
    EXPECT_GT(still, output->GetNumberOfPoints() / 2);
    ASSERT_NE(output->GetCellData()->GetArray("CellNumber"), nullptr);
    EXPECT_EQ(output->GetCellData()->GetArray("CellNumber")->GetNumberOfTuples(), output->GetNumberOfPolys());
    EXPECT_EQ(output->GetCellData()->GetArray("Chart"), nullptr);
    EXPECT_EQ(output->GetCellData()->GetArray("SourceCell"), nullptr);
    EXPECT_EQ(output->GetPointData()->GetArray("Region"), nullptr);
  }
}

// Points without a triangle, before, between and after the others, keep place and attributes; with a double
// of one of them the mesh is welded.
TEST(OneStrokeData, LoosePointsSurviveTheRemesher)
{
  const auto dog = shippedModel("dog");
  const std::vector<Vector3> loose{ { 1.5, 0, 0 }, { -1.5, 0, 0.5 }, { 0, 1.5, 0 } };
  for (const bool doubled : { false, true })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> mark;
    mark->SetName("Mark");
    const auto add = [&](const double* p, double value)
    {
      points->InsertNextPoint(p);
      mark->InsertNextValue(value);
    };
    add(loose[0].data(), 1.0);
    const vtkIdType half = dog->GetNumberOfPoints() / 2;
    for (vtkIdType i = 0; i < dog->GetNumberOfPoints(); ++i)
    {
      if (i == half)
      {
        add(loose[1].data(), 2.0);
      }
      add(dog->GetPoint(i), 0.0);
    }
    add(loose[2].data(), 3.0);
    if (doubled)
    {
      add(loose[0].data(), 1.0);
    }
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < dog->GetNumberOfPolys(); ++cell)
    {
      dog->GetCellPoints(cell, ids);
      for (int k = 0; k < 3; ++k)
      {
        ids->SetId(k, ids->GetId(k) + (ids->GetId(k) < half ? 1 : 2));
      }
      polys->InsertNextCell(ids);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(polys);
    mesh->GetPointData()->AddArray(mark);
    vtkNew<vtkOversketchOneStroke> filter;
    filter->SetInputData(0, mesh);
    filter->SetStrokeData(shippedStroke("dog_longer_leg"));
    filter->SetRemeshToOn();
    filter->Update();
    ASSERT_EQ(filter->GetErrorCode(), 0u);
    vtkPolyData* output = filter->GetOutput();
    EXPECT_NE(output->GetNumberOfPolys(), dog->GetNumberOfPolys());
    vtkDataArray* marks = output->GetPointData()->GetArray("Mark");
    ASSERT_NE(marks, nullptr);
    std::vector<double> seen;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double value = marks->GetComponent(i, 0);
      if (value != 0.0)
      {
        seen.push_back(value);
        EXPECT_LT((Vector3(output->GetPoint(i)) - loose.at(std::size_t(value) - 1)).norm(), 1e-6);
      }
    }
    EXPECT_EQ(seen, (std::vector<double>{ 1.0, 2.0, 3.0 })) << (doubled ? "welded" : "as it came");
  }
}

// A linear field of the position before: after remeshing it is interpolated, so it stays within its range
// and, at points that did not move, exact.
TEST(OneStrokeData, PointArraysAreInterpolatedWhereTheRemesherMadePoints)
{
  auto mesh = shippedModel("dog");
  vtkNew<vtkDoubleArray> field;
  field->SetName("Height");
  double low = 1e300, high = -1e300;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    field->InsertNextValue(p[1]);
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  mesh->GetPointData()->AddArray(field);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  vtkNew<vtkOversketchOneStroke> filter;
  filter->SetInputConnection(0, normals->GetOutputPort());
  filter->SetStrokeData(shippedStroke("dog_longer_leg"));
  filter->SetRemeshToOn();
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_TRUE(filter->GetRemeshed());
  EXPECT_NE(output->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  vtkDataArray* height = output->GetPointData()->GetArray("Height");
  ASSERT_NE(height, nullptr);
  ASSERT_EQ(height->GetNumberOfTuples(), output->GetNumberOfPoints());
  vtkIdType exact = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    EXPECT_GE(height->GetComponent(i, 0), low - 1e-9);
    EXPECT_LE(height->GetComponent(i, 0), high + 1e-9);
    exact += height->GetComponent(i, 0) == p[1];
  }
  EXPECT_GT(exact, mesh->GetNumberOfPoints() / 2);
  vtkDataArray* n = output->GetPointData()->GetNormals();
  ASSERT_NE(n, nullptr);
  for (vtkIdType i = 0; i < n->GetNumberOfTuples(); ++i)
  {
    Vector3 v;
    n->GetTuple(i, v.data());
    ASSERT_NEAR(v.norm(), 1.0, 1e-5);
  }
}
