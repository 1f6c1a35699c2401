#include "match_chain.h"

#include "vtkOversketchCorrection.h"

#include "vtkUnsignedCharArray.h"

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A sphere of 200 px with handles on its own outline from 20 to 160 degrees, and a deformed copy whose
// vertices near the outline about 90 degrees stand out by 8 px.
struct Bulged
{
  explicit Bulged(bool perspective = false)
    : view(perspective ? perspectiveView(Vector3(0, 0, 4), up, 30.0) : orthographicView(front, up, 200.0))
    , mesh(sphere(5))
    , radius(perspective ? 1.0 / std::sqrt(1.0 - 1.0 / 16.0) : 1.0) // of the outline, on the plane z = 0
    , chain(mesh, toStroke(arc(this->view, this->radius, 20.0, 160.0), this->view))
  {
    deformed->DeepCopy(mesh);
    vtkNew<vtkUnsignedCharArray> region;
    region->SetName("Region");
    const double px = this->view.toDisplay(Vector3(0, 1, 0))[1] - this->view.toDisplay(Vector3::Zero())[1];
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      Vector3 p = pointOf(mesh, i);
      const double angle = angleOf(p);
      const bool near = angle > 60.0 && angle < 120.0 && std::hypot(p[0], p[1]) > 0.9;
      region->InsertNextValue(near);
      if (near)
      {
        p *= 1.0 + 8.0 / px * std::cos((angle - 90.0) * 3.0 * pi / 180.0);
        deformed->GetPoints()->SetPoint(i, p.data());
      }
    }
    deformed->GetPointData()->AddArray(region);
    filter->SetInputConnection(0, chain.targets->GetOutputPort());
    filter->SetInputData(1, chain.stroke);
    filter->SetInputData(2, deformed);
    filter->SetInputData(3, mesh);
  }
  View view;
  vtkSmartPointer<vtkPolyData> mesh;
  double radius;
  Chain chain;
  vtkNew<vtkPolyData> deformed;
  vtkNew<vtkOversketchCorrection> filter;
};

} // namespace

TEST(Correction, AnOutlineOnTheStrokeIsLeftAlone)
{
  Bulged b;
  b.deformed->GetPoints()->DeepCopy(b.mesh->GetPoints());
  b.deformed->Modified();
  b.filter->Update();
  vtkPolyData* handles = b.chain.targets->GetOutput();
  EXPECT_EQ(b.filter->GetOutput()->GetNumberOfPoints(), handles->GetNumberOfPoints());
  EXPECT_EQ(
    b.filter->GetOutput()->GetPointData()->GetArray("Target"), handles->GetPointData()->GetArray("Target"));
}

TEST(Correction, WhatStandsOutIsPulledToTheStroke)
{
  for (const bool perspective : { false, true })
  {
    Bulged b(perspective);
    b.filter->Update();
    vtkPolyData* handles = b.chain.targets->GetOutput();
    vtkPolyData* more = b.filter->GetOutput();
    const vtkIdType old = handles->GetNumberOfPoints();
    ASSERT_GT(more->GetNumberOfPoints(), old + 5);
    ASSERT_EQ(more->GetNumberOfVerts(), more->GetNumberOfPoints());
    const Vector2 centre = b.view.toDisplay(Vector3::Zero()).head<2>();
    const double rim = (arc(b.view, b.radius, 0.0, 1.0)[0] - centre).norm();
    double worst = 0.0;
    for (vtkIdType i = 0; i < more->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(more->GetPointData()->GetArray("HandleId")->GetComponent(i, 0), static_cast<double>(i));
      if (i < old)
      {
        EXPECT_EQ(tuple(more, "Target", i), tuple(handles, "Target", i));
        EXPECT_EQ(pointOf(more, i), pointOf(handles, i));
        continue;
      }
      const auto vertex = static_cast<vtkIdType>(tuple(more, "MeshVertices", i)[0]);
      EXPECT_EQ(tuple(more, "MeshWeights", i), Vector3(1, 0, 0));
      EXPECT_EQ(b.deformed->GetPointData()->GetArray("Region")->GetComponent(vertex, 0), 1.0);
      EXPECT_EQ(pointOf(more, i), pointOf(b.mesh, vertex));
      const Vector3 from = b.view.toDisplay(pointOf(b.deformed, vertex));
      const Vector3 to = b.view.toDisplay(tuple(more, "Target", i));
      EXPECT_NEAR(from[2], to[2], 1e-9); // at its own depth
      EXPECT_LT((to - from).norm(), 10.0);
      // What lay on the outline within 1 px now lies on the stroke as nearly.
      worst = std::max(worst, std::abs((to.head<2>() - centre).norm() - rim));
      const double relative = more->GetPointData()->GetArray("RelativePosition")->GetComponent(i, 0);
      EXPECT_GE(relative, 0.2);
      EXPECT_LE(relative, 0.8);
    }
    EXPECT_LT(worst, 1.1);
    EXPECT_EQ(field(more, "SectionLength"), field(handles, "SectionLength"));
  }
}

TEST(Correction, OnlyTheRegionAndOnlyWithinReach)
{
  Bulged b;
  b.filter->SetReach(2.0); // less than the bulge of 8 px, save at its foot
  b.filter->Update();
  const vtkIdType few = b.filter->GetOutput()->GetNumberOfPoints();
  b.filter->SetReach(12.0);
  b.filter->Update();
  EXPECT_LT(few, b.filter->GetOutput()->GetNumberOfPoints());
  b.deformed->GetPointData()->GetArray("Region")->FillComponent(0, 0.0);
  b.deformed->Modified();
  b.filter->Update();
  EXPECT_EQ(b.filter->GetOutput()->GetNumberOfPoints(), b.chain.targets->GetOutput()->GetNumberOfPoints());
}

TEST(Correction, RefusesWithOneMessage)
{
  {
    Bulged b;
    b.deformed->GetPointData()->RemoveArray("Region");
    expectRefusal(b.filter, Failure::MissingArray, "Region");
  }
  {
    Bulged b;
    b.filter->SetInputData(3, sphere(3));
    expectRefusal(b.filter, Failure::BadMesh, "differ in their number of points");
  }
  {
    Bulged b;
    vtkNew<vtkPolyData> blind;
    blind->DeepCopy(b.chain.stroke);
    blind->GetCellData()->RemoveArray("ViewTransform");
    b.filter->SetInputData(1, blind);
    expectRefusal(b.filter, Failure::MissingArray, "ViewTransform");
  }
  {
    Bulged b;
    vtkNew<vtkPolyData> handles;
    handles->DeepCopy(b.chain.targets->GetOutput());
    handles->GetPointData()->RemoveArray("Target");
    b.filter->SetInputData(0, handles);
    expectRefusal(b.filter, Failure::MissingArray, "Target");
  }
  {
    Bulged b;
    vtkNew<vtkPolyData> nothing;
    b.filter->SetInputData(2, nothing);
    Ear ear(b.filter);
    b.filter->Update();
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(b.filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}
