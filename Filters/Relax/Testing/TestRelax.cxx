// The system as a filter: what it promises of bands, seams, bad hands, cancelling and what runs again. What
// goes and what stays is the kernel's test's.
#include "Harness/copies.h"
#include "Harness/promises.h"
#include "Harness/shapes.h"
#include "Harness/shipped.h"
#include "Harness/strokes.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRelax.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Mesh roughBall()
{
  Mesh mesh = icosphere(5);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  for (Vector3& p : mesh.points)
  {
    p *= 1.0 + noise(random);
  }
  return mesh;
}

// The ball from the front, its radius 200 px in a viewport of 800 x 600.
View front()
{
  return orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
}

struct Relax : testing::Test
{
  Relax()
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokesData(this->stroke);
    this->filter->SetRadius(0.2);
  }
  // The points that lie elsewhere, and the farthest of them from the stroke's plane.
  int moved() const
  {
    int count = 0;
    vtkPolyData* output = this->filter->GetOutput();
    for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
    {
      Vector3 before, after;
      this->mesh->GetPoint(i, before.data());
      output->GetPoint(i, after.data());
      if (before != after)
      {
        ++count;
        EXPECT_LT(std::abs(before[1]), 0.28) << "beyond the band";
        EXPECT_GT(before[2], -0.3) << "on the other side";
      }
    }
    return count;
  }

  vtkSmartPointer<vtkPolyData> mesh = toPolyData(roughBall());
  vtkSmartPointer<vtkPolyData> stroke = toStroke(straight({ 300, 300 }, { 500, 300 }, 30), front());
  vtkNew<vtkOversketchRelax> filter;
};

} // namespace

TEST_F(Relax, MovesWhatThePenPassesAndNothingElse)
{
  const auto kept = deepCopy(this->mesh);
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  const int moved = this->moved();
  EXPECT_GT(moved, 300);
  EXPECT_EQ(this->filter->GetFigure("moved"), moved);
  EXPECT_LT(this->filter->GetFigure("farthest"), 0.05);
  EXPECT_TRUE(identical(kept, this->mesh)) << "the input was touched";
  EXPECT_EQ(this->filter->GetOutput()->GetPolys()->GetMTime(), this->mesh->GetPolys()->GetMTime());
  vtkNew<vtkPolyData> hold, region;
  this->filter->GetHold(hold);
  this->filter->GetRegion(region);
  EXPECT_GT(hold->GetNumberOfPoints(), 20);
  EXPECT_GT(region->GetNumberOfPolys(), moved);
}

TEST_F(Relax, ThreadsChangeNothingAndWhatIsKnownIsKept)
{
  this->filter->Update();
  const auto first = deepCopy(this->filter->GetOutput());
  this->filter->Modified();
  this->filter->Update();
  EXPECT_EQ(this->filter->GetRelaxCount(), 1);
  this->filter->SetStrength(0.5);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetRelaxCount(), 2);
  auto* curves = vtkOversketchSurfaceStroke::SafeDownCast(this->filter->GetStep("Curves"));
  EXPECT_EQ(curves->GetProjectionCount(), 1);
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchRelax> other;
    other->SetInputData(0, deepCopy(this->mesh));
    other->SetStrokesData(this->stroke);
    other->SetRadius(0.2);
    other->Update();
    EXPECT_TRUE(identical(first, other->GetOutput())) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST_F(Relax, SeamsStayClosedAndArraysAreThere)
{
  // The ball again with each triangle's corners as points of their own, as a reader of cut textures has them.
  const Mesh ball = roughBall();
  Mesh split;
  for (const Triangle& t : ball.triangles)
  {
    const int first = split.vertexCount();
    for (const int v : t)
    {
      split.points.push_back(ball.points[v]);
    }
    split.triangles.push_back({ first, first + 1, first + 2 });
  }
  const auto cut = toPolyData(split);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Texture");
  coordinates->SetNumberOfComponents(2);
  for (int i = 0; i < split.vertexCount(); ++i)
  {
    coordinates->InsertNextTuple2(i % 3, i);
  }
  cut->GetPointData()->SetTCoords(coordinates);
  this->filter->Update();
  vtkNew<vtkOversketchRelax> other;
  other->SetInputData(0, cut);
  other->SetStrokesData(this->stroke);
  other->SetRadius(0.2);
  other->Update();
  EXPECT_EQ(other->GetOutput()->GetPointData()->GetTCoords(), coordinates.Get());
  int moved = 0;
  for (int t = 0; t < ball.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      Vector3 expected, found;
      this->filter->GetOutput()->GetPoint(ball.triangles[t][k], expected.data());
      other->GetOutput()->GetPoint(3 * t + k, found.data());
      EXPECT_LT((expected - found).norm(), 1e-9);
      moved += found != ball.points[ball.triangles[t][k]];
    }
  }
  EXPECT_GT(moved, 500);
}

TEST_F(Relax, MaskedPointsStayToTheBitAndHalfMaskedGoByHalfTheStrength)
{
  this->filter->Update();
  const auto free = deepCopy(this->filter->GetOutput());
  vtkNew<vtkFloatArray> mask;
  mask->SetName("Mask");
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(this->mesh->GetPoint(i)[0] > 0.0 ? 1.0f : 0.0f);
  }
  this->mesh->GetPointData()->AddArray(mask);
  this->filter->Modified();
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  int moved = 0, alike = 0;
  for (vtkIdType i = 0; i < this->mesh->GetNumberOfPoints(); ++i)
  {
    Vector3 before, after, unmasked;
    this->mesh->GetPoint(i, before.data());
    this->filter->GetOutput()->GetPoint(i, after.data());
    free->GetPoint(i, unmasked.data());
    if (mask->GetValue(i) == 1.0f)
    {
      EXPECT_EQ(before, after) << i;
    }
    else
    {
      moved += before != after;
      alike += before != unmasked && (after - unmasked).norm() < 0.02;
    }
  }
  EXPECT_GT(moved, 150);
  EXPECT_GT(alike, 100) << "away from the mask the band does as before";
  EXPECT_EQ(this->filter->GetOutput()->GetPointData()->GetArray("Mask"), mask.Get());

  mask->Fill(0.5);
  mask->Modified();
  this->filter->Modified();
  this->filter->Update();
  const auto half = deepCopy(this->filter->GetOutput());
  this->mesh->GetPointData()->RemoveArray("Mask");
  this->filter->SetStrength(0.5);
  this->filter->Update();
  half->GetPointData()->RemoveArray("Mask");
  EXPECT_TRUE(identical(half, this->filter->GetOutput()));
  this->mesh->GetPointData()->AddArray(mask);
  mask->Fill(1.0);
  mask->Modified();
  this->filter->Modified();
  expectRefusal(this->filter, Failure::BadStroke, "beside the mask");
}

TEST_F(Relax, NormalsTurnWithTheSurface)
{
  Mesh rough = roughBall();
  const std::vector<Vector3> normals = vertexNormals(rough);
  vtkNew<vtkDoubleArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  for (const Vector3& n : normals)
  {
    array->InsertNextTuple(n.data());
  }
  this->mesh->GetPointData()->SetNormals(array);
  this->filter->Update();
  vtkPolyData* output = this->filter->GetOutput();
  double before = 0.0, after = 0.0;
  int count = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Vector3 p, n;
    output->GetPoint(i, p.data());
    output->GetPointData()->GetNormals()->GetTuple(i, n.data());
    if (p != rough.points[i])
    {
      ++count;
      before += std::acos(std::min(1.0, normals[i].dot(p.normalized())));
      after += std::acos(std::min(1.0, n.dot(p.normalized())));
    }
    else if (std::abs(p[1]) > 0.4) // beside the band triangles turn, too
    {
      EXPECT_EQ(n, normals[i]);
    }
  }
  EXPECT_LT(after / count, 0.3 * before / count);
}

TEST_F(Relax, ABadHandIsToldWhatIsWrong)
{
  const auto draw = [this](const std::vector<Vector2>& samples)
  { this->filter->SetStrokesData(toStroke(samples, front())); };
  draw(straight({ 20, 20 }, { 80, 20 }, 10));
  expectRefusal(this->filter, Failure::BadStroke, "draw it over the model");
  draw({ { 400, 300 } });
  expectRefusal(this->filter, Failure::BadStroke, "Stroke 0");
  vtkNew<vtkPolyData> none;
  this->filter->SetStrokesData(none);
  expectRefusal(this->filter, Failure::BadStroke, "no stroke");
  draw(straight({ 300, 303.7 }, { 500, 302.9 }, 30)); // through no point
  this->filter->SetRadius(1e-4);
  expectRefusal(this->filter, Failure::BadStroke, "No point of the mesh");
  this->filter->SetRadius(0.0);
  expectRefusal(this->filter, Failure::BadStroke, "Radius");
  this->filter->SetRadius(std::nan(""));
  expectRefusal(this->filter, Failure::BadStroke, "Radius");
  this->filter->SetRadius(0.2);
  // Partly in the void, backwards, to and fro: what lies on the model counts.
  const auto works = [&](const std::vector<Vector2>& samples)
  {
    draw(samples);
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    EXPECT_GT(this->moved(), 100);
  };
  works(straight({ 500, 300 }, { 790, 300 }, 30));
  works(straight({ 500, 300 }, { 300, 300 }, 30));
  std::vector<Vector2> scribble;
  for (int i = 0; i < 200; ++i)
  {
    scribble.emplace_back(400.0 + 60.0 * std::sin(0.5 * i), 300.0 + 3.0 * std::sin(0.7 * i));
  }
  works(scribble);
}

TEST_F(Relax, CancelLeavesNothing)
{
  expectCancel(this->filter, 0.6);
  this->filter->Update();
  EXPECT_GT(this->moved(), 300);
}

TEST_F(Relax, PreviewShowsWhereTheLineLies)
{
  vtkNew<vtkPolyData> hold;
  EXPECT_FALSE(this->filter->Preview(this->mesh, toStroke({ { 400, 300 } }, front()), hold));
  ASSERT_TRUE(this->filter->Preview(this->mesh, this->stroke, hold));
  EXPECT_GT(hold->GetNumberOfPoints(), 20);
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
  this->filter->Update();
  auto* curves = vtkOversketchSurfaceStroke::SafeDownCast(this->filter->GetStep("Curves"));
  EXPECT_EQ(curves->GetSceneCount(), 1);
}

TEST_F(Relax, NothingInGivesNothingOut)
{
  vtkNew<vtkPolyData> none;
  this->filter->SetInputData(0, none);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Wide bands over thin ears, legs that nearly touch, and paws.
TEST(RelaxedDog, NothingTurnsOverUnderAWideBand)
{
  Mesh before = MeshOf(shippedModel("dog"));
  const Vector3 middle = boxRound(before.points).center();
  for (Vector3& p : before.points)
  {
    p -= middle;
  }
  const double size = boundingDiagonal(before);
  const auto dog = toPolyData(before);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> off(-1.0, 1.0);
  int drawn = 0;
  for (int i = 0; i < 30; ++i)
  {
    const Vector3 from = Vector3(off(random), 0.4 * off(random), off(random)).normalized();
    const View view = orthographicView(from, { 0, 1, 0 }, 600.0 / size);
    const Vector2 a(400.0 + 150.0 * off(random), 300.0 + 120.0 * off(random)),
      b(400.0 + 150.0 * off(random), 300.0 + 120.0 * off(random));
    vtkNew<vtkOversketchRelax> filter;
    filter->SetInputData(0, dog);
    filter->SetStrokesData(toStroke(straight(a, b, 40), view));
    const double radius = (i % 2 == 0 ? 0.03 : 0.08) * size;
    filter->SetRadius(radius);
    Ear ear(filter);
    filter->Update();
    if (filter->GetErrorCode() != 0) // drawn beside the dog
    {
      ASSERT_NE(ear.errors[0].find("draw it over the model"), std::string::npos) << ear.errors[0];
      continue;
    }
    ++drawn;
    const Mesh after = MeshOf(filter->GetOutput());
    int turned = 0;
    for (int t = 0; t < before.triangleCount(); ++t)
    {
      turned += facetNormal(before, t).dot(facetNormal(after, t)) < 0.0;
    }
    EXPECT_LE(turned, 2) << "stroke " << i; // a crease's own may
    EXPECT_LT(filter->GetFigure("farthest"), radius) << "stroke " << i;
  }
  EXPECT_GT(drawn, 15);
}
