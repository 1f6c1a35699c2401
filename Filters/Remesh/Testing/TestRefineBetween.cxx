#include "CurveChain.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMeanEdge.h"
#include "vtkOversketchRefineBetween.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View eye = perspectiveView(Vector3(0, 0, 5), Vector3(0, 1, 0), 30.0);

// A coarse sphere with arrays, a line and a ring on it.
struct Coarse
{
  vtkSmartPointer<vtkPolyData> mesh;
  std::unique_ptr<CurveChain> line, ring;
  vtkNew<vtkOversketchMeanEdge> mean;
  vtkNew<vtkOversketchRefineBetween> refine;

  explicit Coarse(int levels = 2)
    : mesh(toPolyData(icosphere(levels)))
  {
    vtkNew<vtkDoubleArray> height;
    height->SetName("Height");
    vtkNew<vtkIntArray> label;
    label->SetName("Label");
    for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
    {
      height->InsertNextValue(3.0 * this->mesh->GetPoint(i)[0] + 1.0);
      label->InsertNextValue(this->mesh->GetPoint(i)[0] > 0.0 ? 7 : 3);
    }
    vtkNew<vtkIdTypeArray> cells;
    cells->SetName("Cell");
    for (vtkIdType i = 0; i < this->mesh->GetNumberOfPolys(); ++i)
    {
      cells->InsertNextValue(i);
    }
    this->mesh->GetPointData()->AddArray(height);
    this->mesh->GetPointData()->AddArray(label);
    this->mesh->GetCellData()->AddArray(cells);
    std::vector<Vector2> straight;
    for (int i = 0; i <= 20; ++i)
    {
      straight.emplace_back(370.0 + 3.0 * i, 300.0);
    }
    this->line = std::make_unique<CurveChain>(this->mesh, toStroke(straight, eye));
    this->ring = std::make_unique<CurveChain>(
      this->mesh, toStrokes({ { circleOf({ 400, 300 }, 60.0, 90), eye } }, { true }));
    this->mean->SetInputData(this->mesh);
    this->refine->SetInputConnection(0, this->mean->GetOutputPort());
    this->refine->SetReferenceConnection(this->line->Project->GetOutputPort());
    this->refine->SetBoundaryConnection(this->ring->Project->GetOutputPort());
  }
};

} // namespace

TEST(RefineBetweenFilter, NewPointsLieOnOldTrianglesWithWhatTheyHold)
{
  Coarse c;
  c.refine->Update();
  vtkPolyData* made = c.refine->GetOutput();
  ASSERT_EQ(c.refine->GetErrorCode(), 0u);
  ASSERT_GT(made->GetNumberOfPolys(), c.mesh->GetNumberOfPolys() + 100);
  vtkDataArray* height = made->GetPointData()->GetArray("Height");
  vtkDataArray* lengths = made->GetPointData()->GetArray("EdgeLength");
  ASSERT_TRUE(lengths);
  const double mean = made->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
  double shortest = mean;
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(height->GetComponent(i, 0), 3.0 * made->GetPoint(i)[0] + 1.0, 1e-12);
    const double label = made->GetPointData()->GetArray("Label")->GetComponent(i, 0);
    EXPECT_TRUE(label == 3.0 || label == 7.0);
    EXPECT_GT(lengths->GetComponent(i, 0), 0.0);
    EXPECT_LE(lengths->GetComponent(i, 0), mean);
    shortest = std::min(shortest, lengths->GetComponent(i, 0));
  }
  for (vtkIdType i = 0; i < c.mesh->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vector3(made->GetPoint(i)), Vector3(c.mesh->GetPoint(i)));
  }
  // 3/4 of the half width, 30 to 60 px, over six.
  EXPECT_LT(shortest, 0.25 * mean);
  // Of each triangle the one that was there.
  vtkDataArray* cells = made->GetCellData()->GetArray("Cell");
  vtkNew<vtkIdList> ids, old;
  for (vtkIdType t = 0; t < made->GetNumberOfPolys(); ++t)
  {
    made->GetPolys()->GetCellAtId(t, ids);
    c.mesh->GetPolys()->GetCellAtId(static_cast<vtkIdType>(cells->GetComponent(t, 0)), old);
    const auto corner = [](vtkPolyData* mesh, vtkIdList* of, int k)
    { return Vector3(mesh->GetPoint(of->GetId(k))); };
    const Vector3 a = corner(c.mesh, old, 0), b = corner(c.mesh, old, 1), d = corner(c.mesh, old, 2);
    const Vector3 normal = (b - a).cross(d - a).normalized();
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_LT(std::abs((corner(made, ids, k) - a).dot(normal)), 1e-6);
    }
  }
}

TEST(RefineBetweenFilter, WhatIsFineEnoughIsPassedAndSoIsAllWithoutBothCurves)
{
  Coarse fine(6);
  fine.refine->SetEdges(4.0);
  fine.refine->Update();
  EXPECT_EQ(fine.refine->GetOutput()->GetPoints(), fine.mesh->GetPoints());
  EXPECT_EQ(fine.refine->GetOutput()->GetPolys(), fine.mesh->GetPolys());
  Coarse c;
  c.refine->SetEdges(0.0);
  c.refine->Update();
  EXPECT_EQ(c.refine->GetOutput()->GetPoints(), c.mesh->GetPoints());
  c.refine->SetEdges(7.0);
  c.refine->SetBoundaryConnection(nullptr);
  c.refine->Update();
  EXPECT_EQ(c.refine->GetOutput()->GetPoints(), c.mesh->GetPoints());
}

TEST(RefineBetweenFilter, IsTheSameForAnyNumberOfThreadsAndKeepsItsPromises)
{
  const auto made = []
  {
    Coarse c;
    c.refine->Update();
    const auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(c.refine->GetOutput());
    return copy;
  };
  vtkSMPTools::Initialize(1);
  const auto one = made();
  vtkSMPTools::Initialize(2);
  const auto two = made();
  ASSERT_EQ(one->GetNumberOfPoints(), two->GetNumberOfPoints());
  EXPECT_EQ(std::memcmp(one->GetPoints()->GetVoidPointer(0),
              two->GetPoints()->GetVoidPointer(0),
              24 * static_cast<std::size_t>(one->GetNumberOfPoints())),
    0);
  Coarse c;
  c.line->Project->Update();
  expectCancel(c.refine);
  c.refine->Update();
  EXPECT_GT(c.refine->GetOutput()->GetNumberOfPoints(), c.mesh->GetNumberOfPoints());
  c.refine->SetInputConnection(0, nullptr);
  c.refine->SetInputData(0, c.mesh);
  expectRefusal(c.refine, Failure::MissingArray, "MeanEdge");
  vtkNew<vtkPolyData> loose;
  loose->DeepCopy(c.ring->Project->GetOutput());
  loose->GetPointData()->RemoveArray("MeshCell");
  c.refine->SetInputConnection(0, c.mean->GetOutputPort());
  c.refine->SetBoundaryData(loose);
  expectRefusal(c.refine, Failure::MissingArray, "MeshCell");
  loose->DeepCopy(c.ring->Project->GetOutput());
  loose->GetPointData()->GetArray("MeshCell")->SetComponent(0, 0, 1e6);
  loose->Modified();
  expectRefusal(c.refine, Failure::BadStroke, "leaves the mesh");
}
