// A deformation of one side, done on the other side too.
#include "Harness/promises.h"
#include "vtkOversketchMirror.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A sphere symmetric about x = 0, and the same with a bump drawn out round a place on one side.
struct MirrorScene
{
  Mesh mesh = icosphere(3);
  std::vector<Vector3> normals = vertexNormals(mesh);
  vtkSmartPointer<vtkPolyData> before, after;
  vtkNew<vtkOversketchMirror> filter;

  explicit MirrorScene(const Vector3& centre = Vector3(0.6, 0.8, 0.0), double offset = 0.0)
  {
    for (Vector3& p : this->mesh.points)
    {
      p[0] += offset;
    }
    this->before = toPolyData(this->mesh, &this->normals);
    Mesh moved = this->mesh;
    std::vector<Vector3> turned = this->normals;
    for (std::size_t i = 0; i < moved.points.size(); ++i)
    {
      const Vector3 round = this->mesh.points[i] - Vector3(offset, 0.0, 0.0);
      const double near = std::max(0.0, 1.0 - (round - centre).norm() / 0.5);
      if (near > 0.0)
      {
        moved.points[i] += near * Vector3(0.2, 0.3, 0.1);
        turned[i] = (turned[i] + near * Vector3(0.0, 0.5, 0.2)).normalized();
      }
    }
    this->after = toPolyData(moved, &turned);
    this->filter->SetOffset(offset);
    this->filter->SetInputData(0, this->before);
    this->filter->SetInputData(1, this->after);
  }

  static Vector3 at(vtkPolyData* mesh, vtkIdType i)
  {
    Vector3 p;
    mesh->GetPoint(i, p.data());
    return p;
  }
  bool moved(vtkIdType i) const { return at(this->before, i) != at(this->after, i); }
  vtkIdType partner(vtkIdType i, double offset) const
  {
    Vector3 place = at(this->before, i);
    place[0] = 2.0 * offset - place[0];
    const vtkIdType found = this->before->FindPoint(place.data());
    EXPECT_LT((at(this->before, found) - place).norm(), 1e-12);
    return found;
  }
};

} // namespace

TEST(Mirror, MaskedPointsDoNotFollow)
{
  MirrorScene s;
  vtkNew<vtkFloatArray> mask;
  mask->SetName("Mask");
  for (const Vector3& p : s.mesh.points)
  {
    mask->InsertNextValue(p[0] < 0.0 && p[2] > 0.0 ? 1.0f : 0.0f);
  }
  s.before->GetPointData()->AddArray(mask);
  s.filter->Update();
  int follow = 0, stay = 0;
  for (vtkIdType i = 0; i < s.before->GetNumberOfPoints(); ++i)
  {
    if (s.mesh.points[i][0] < -1e-9 && s.moved(s.partner(i, 0.0)))
    {
      const bool stays = MirrorScene::at(s.filter->GetOutput(), i) == MirrorScene::at(s.before, i);
      EXPECT_EQ(stays, mask->GetValue(i) == 1.0f) << i;
      (stays ? stay : follow) += 1;
    }
  }
  EXPECT_GT(stay, 10);
  EXPECT_GT(follow, 10);
}

TEST(Mirror, TheOtherSideFollowsExactly)
{
  MirrorScene s;
  s.filter->Update();
  vtkPolyData* output = s.filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), s.before->GetNumberOfPoints());
  int followed = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 old = MirrorScene::at(s.before, i);
    if (std::abs(old[0]) < 1e-9)
    {
      EXPECT_EQ(MirrorScene::at(output, i)[0], old[0]) << "points in the plane stay in it";
      continue;
    }
    if (old[0] > 0.0)
    {
      EXPECT_EQ(MirrorScene::at(output, i), MirrorScene::at(s.after, i))
        << "the side that leads is as it was deformed";
      continue;
    }
    const vtkIdType leader = s.partner(i, 0.0);
    if (!s.moved(leader))
    {
      EXPECT_EQ(MirrorScene::at(output, i), old);
      continue;
    }
    ++followed;
    Vector3 expected = MirrorScene::at(s.after, leader);
    expected[0] = -expected[0];
    EXPECT_EQ(MirrorScene::at(output, i), expected);
    Vector3 normal, leaders;
    output->GetPointData()->GetNormals()->GetTuple(i, normal.data());
    s.after->GetPointData()->GetNormals()->GetTuple(leader, leaders.data());
    leaders[0] = -leaders[0];
    EXPECT_EQ(normal, leaders);
  }
  EXPECT_GT(followed, 20);
}

TEST(Mirror, WhatTheOtherSideDidIsTakenBack)
{
  MirrorScene s(Vector3(-0.6, 0.8, 0.0)); // deformed below, led from above, where nothing moved
  s.filter->Update();
  for (vtkIdType i = 0; i < s.before->GetNumberOfPoints(); ++i)
  {
    if (std::abs(MirrorScene::at(s.before, i)[0]) > 1e-9)
    {
      EXPECT_EQ(MirrorScene::at(s.filter->GetOutput(), i), MirrorScene::at(s.before, i));
    }
  }
  s.filter->SetSideToBelow();
  s.filter->Update();
  vtkIdType moved = 0;
  for (vtkIdType i = 0; i < s.before->GetNumberOfPoints(); ++i)
  {
    moved += MirrorScene::at(s.filter->GetOutput(), i) != MirrorScene::at(s.before, i) &&
             MirrorScene::at(s.before, i)[0] > 0.0;
  }
  EXPECT_GT(moved, 20);
}

TEST(Mirror, APlaneAwayFromTheOrigin)
{
  MirrorScene s(Vector3(0.6, 0.8, 0.0), 3.0);
  s.filter->Update();
  int followed = 0;
  for (vtkIdType i = 0; i < s.before->GetNumberOfPoints(); ++i)
  {
    if (MirrorScene::at(s.before, i)[0] < 3.0 - 1e-9 && s.moved(s.partner(i, 3.0)))
    {
      Vector3 expected = MirrorScene::at(s.after, s.partner(i, 3.0));
      expected[0] = 6.0 - expected[0];
      EXPECT_EQ(MirrorScene::at(s.filter->GetOutput(), i), expected);
      ++followed;
    }
  }
  EXPECT_GT(followed, 20);
}

TEST(Mirror, InputsStayAndBadOnesAreRefused)
{
  MirrorScene s;
  vtkNew<vtkPolyData> kept;
  kept->DeepCopy(s.after);
  s.filter->Update();
  for (vtkIdType i = 0; i < kept->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(MirrorScene::at(kept, i), MirrorScene::at(s.after, i));
  }
  // One point off its mirrored place.
  MirrorScene crooked;
  for (vtkIdType i = 0; i < crooked.before->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = MirrorScene::at(crooked.before, i);
    if (p[0] > 1e-3 && crooked.moved(i))
    {
      const vtkIdType partner = crooked.partner(i, 0.0);
      crooked.before->GetPoints()->SetPoint(partner, 0.9 * -p[0], p[1], p[2]);
      crooked.before->Modified();
      expectRefusal(crooked.filter, Failure::BadMesh, "Point " + std::to_string(i) + " moved");
      break;
    }
  }
  MirrorScene other;
  other.filter->SetInputData(1, toPolyData(icosphere(2)));
  expectRefusal(other.filter, Failure::BadMesh, "deform without remeshing");
  vtkNew<vtkOversketchMirror> empty;
  vtkNew<vtkPolyData> none;
  empty->SetInputData(0, none);
  empty->SetInputData(1, none);
  Ear ear(empty);
  empty->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(empty->GetOutput()->GetNumberOfPoints(), 0);
}
