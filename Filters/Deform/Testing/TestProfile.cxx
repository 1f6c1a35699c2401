#include "EditTools.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchProfileDeform.h"
#include "vtkOversketchProfilePlanes.h"

#include "vtkOversketchFilterTools.h"

#include "vtkCutter.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPLYReader.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Eigen::Matrix4d fieldMatrix(vtkPolyData* data, const char* name)
{
  Eigen::Matrix4d m;
  for (int k = 0; k < 16; ++k)
  {
    m(k / 4, k % 4) = data->GetFieldData()->GetArray(name)->GetComponent(0, k);
  }
  return m;
}

// Planes, section and deformation of a region; the drawn profile is the old one, moved point by point.
struct Chain
{
  EditData data;
  vtkNew<vtkOversketchProfilePlanes> planes;
  vtkNew<vtkOversketchCrossSection> section;
  vtkNew<vtkOversketchProfileDeform> deform;

  explicit Chain(EditScene scene = sphereScene(20, 64, 0.3))
    : data(std::move(scene))
  {
    this->planes->SetInputData(this->data.mesh);
    this->planes->SetReferenceData(this->data.reference);
    this->section->SetInputData(this->data.mesh);
    this->section->SetBoundaryData(this->data.boundary);
    this->section->SetPlanesConnection(this->planes->GetOutputPort());
    this->deform->SetInputData(this->data.mesh);
    this->deform->SetReferenceData(this->data.reference);
    this->deform->SetProfileConnection(this->section->GetOutputPort());
  }
  // f: a displacement in the profile's plane by the share of its length.
  vtkSmartPointer<vtkPolyData> drawn(const std::function<Vector2(double)>& f)
  {
    this->section->Update();
    auto line = vtkSmartPointer<vtkPolyData>::New();
    line->DeepCopy(this->section->GetOutput());
    std::vector<double> source;
    for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
    {
      Vector3 p;
      line->GetPoint(i, p.data());
      source.push_back(line->GetPointData()->GetArray("CurveT")->GetComponent(i, 0));
      p.head<2>() += f(source.back());
      line->GetPoints()->SetPoint(i, p.data());
    }
    line->GetPointData()->AddArray(arrayOf("SourceT", source));
    return line;
  }
  std::vector<Vector3> run(const std::function<Vector2(double)>& f)
  {
    this->deform->SetDrawnData(this->drawn(f));
    this->deform->Update();
    return pointsOf(this->deform->GetOutput());
  }
  // How far a cross-section of the deformed mesh is from the profile that was drawn, at most [mean edges].
  double gap(const std::function<Vector2(double)>& f)
  {
    vtkNew<vtkOversketchCrossSection> again;
    again->SetInputConnection(this->deform->GetOutputPort());
    again->SetBoundaryData(this->data.boundary);
    again->SetPlanesConnection(this->planes->GetOutputPort());
    again->Update();
    const Eigen::Matrix4d back = fieldMatrix(this->section->GetOutput(), "ProfileMatrix").inverse();
    const std::vector<Vector3> line = pointsOf(this->drawn(f));
    const double edge = this->data.scene.meanEdge() * back.topLeftCorner<3, 1>().norm();
    double worst = 0.0;
    for (const Vector3& p : pointsOf(again->GetSectionOutput()))
    {
      const Vector2 flat = (back * p.homogeneous()).head<2>();
      double least = 1e9;
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        const Vector2 from = line[i - 1].head<2>(), step = line[i].head<2>() - from;
        const double share = std::clamp((flat - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (flat - from - share * step).norm());
      }
      worst = std::max(worst, least / edge);
    }
    return worst;
  }
};

Vector2 bump(double t)
{
  return { 0.0, 0.12 * std::sin(pi * t) };
}

double lengthOf(vtkPolyData* line)
{
  const std::vector<Vector3> points = pointsOf(line);
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

} // namespace

TEST(B8_1, PlanesStandOnTheCurve)
{
  Chain chain(sphereScene(20, 64));
  vtkOversketchProfilePlanes* filter = chain.planes;
  for (const int frame : { vtkOversketchProfilePlanes::Surface, vtkOversketchProfilePlanes::Fitted })
  {
    filter->SetFrame(frame);
    for (const double t : { 0.0, 0.25, 0.5, 1.0 })
    {
      filter->SetT(t);
      filter->Update();
      vtkPolyData* planes = filter->GetOutput();
      ASSERT_EQ(planes->GetNumberOfPolys(), 3);
      Vector3 normals[3];
      for (vtkIdType k = 0; k < 3; ++k)
      {
        planes->GetCellData()->GetNormals()->GetTuple(k, normals[k].data());
        EXPECT_EQ(planes->GetCellData()->GetArray("Plane")->GetComponent(k, 0), static_cast<double>(k));
      }
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_LT(std::abs(normals[k].dot(normals[(k + 1) % 3])), 1e-12);
      }
      // On the curve, at that share of its 90 degrees; and large enough to cut all points.
      const Eigen::Matrix4d axes = fieldMatrix(planes, "Frame");
      const double angle = (t - 0.5) * pi / 2.0;
      EXPECT_LT((axes.topRightCorner<3, 1>() - Vector3(std::sin(angle), 0, std::cos(angle))).norm(), 1e-3);
      const Vector3 tangent(std::cos(angle), 0, -std::sin(angle));
      EXPECT_GT(normals[2].dot(tangent), std::cos(4.0 * pi / 180.0));
      if (frame == vtkOversketchProfilePlanes::Fitted)
      {
        EXPECT_LT((normals[0] - Vector3::UnitY()).norm(), 1e-9);
      }
      else
      {
        EXPECT_GT(normals[0].dot(axes.topRightCorner<3, 1>()), std::cos(3.0 * pi / 180.0));
      }
      double bounds[6];
      planes->GetBounds(bounds);
      EXPECT_LT(bounds[0], -1.0);
      EXPECT_GT(bounds[5], 1.0);
    }
  }
  fact("B8_1", "planes at 0, 0.25, 0.5 and 1 of an arc stand on it, mutually perpendicular to 1e-12");
}

TEST(B8_2, TheProfileIsFlatAndLeadsBack)
{
  Chain chain(sphereScene(30, 96, 0.3));
  chain.section->Update();
  vtkPolyData *profile = chain.section->GetOutput(), *section = chain.section->GetSectionOutput();
  ASSERT_EQ(profile->GetNumberOfLines(), 1);
  const double length = lengthOf(section);
  EXPECT_GT(length, 0.99 * 2.0 * pi / 3.0);
  EXPECT_LE(length, 2.0 * pi / 3.0);
  const Eigen::Matrix4d toWorld = fieldMatrix(profile, "ProfileMatrix");
  double off = 0.0;
  for (const Vector3& p : pointsOf(profile))
  {
    EXPECT_EQ(p[2], 0.0);
    const Vector3 there = (toWorld * p.homogeneous()).head<3>();
    off = std::max(off, std::abs(there.norm() - 1.0));
    EXPECT_LT(std::abs(there[0]), 1e-3); // the plane x = 0, as far as uneven normals have it
  }
  EXPECT_LT(off, 0.1 * chain.data.scene.meanEdge());
  for (vtkPolyData* line : { profile, section })
  {
    vtkDataArray* beside = line->GetPointData()->GetArray("SideDistance");
    EXPECT_NEAR(beside->GetComponent(0, 0), -1.0, 1e-12);
    EXPECT_NEAR(beside->GetComponent(line->GetNumberOfPoints() - 1, 0), 1.0, 1e-12);
  }
  // To the right of a view, whichever that is.
  chain.section->SetRight(0.0, 1.0, 0.0);
  chain.section->Update();
  const Vector3 right = pointsOf(chain.section->GetSectionOutput()).back();
  chain.section->SetRight(0.0, -1.0, 0.0);
  chain.section->Update();
  EXPECT_LT((pointsOf(chain.section->GetSectionOutput()).front() - right).norm(), 1e-12);
  EXPECT_EQ(chain.section->GetSectionCount(), 3);
  fact("B8_2",
    "as a filter: " + std::to_string(length) + " long, the spline within " + std::to_string(off) +
      " of the sphere");
}

TEST(B8_3, ADrawnProfileIsMatched)
{
  Chain chain(sphereScene(40, 128, 0.3));
  const std::vector<Vector3> points = chain.run(bump);
  EXPECT_EQ(chain.deform->GetFoldedEdges(), 0);
  const double worst = chain.gap(bump);
  EXPECT_LT(worst, 0.1);
  int moved = 0;
  const EditScene& s = chain.data.scene;
  for (int v = 0; v < s.mesh.vertexCount(); ++v)
  {
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): its bits are meant
    EXPECT_TRUE(s.region[v] == 2 || std::memcmp(points[v].data(), s.mesh.points[v].data(), 24) == 0);
    moved += points[v] != s.mesh.points[v] ? 1 : 0;
  }
  EXPECT_EQ(chain.deform->GetMovedPoints(), moved);
  EXPECT_GT(moved, 3000);
  fact("B8_3",
    "as filters: the recut section within " + std::to_string(worst) + " mean edges of the drawn profile");
}

// VTK cuts the whole mesh; what it finds between the section's ends is the section.
TEST(B8_2, AsVtkCutterCutsIt)
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(OVERSKETCH_DATA_FOLDER "/Models/dog.ply");
  reader->Update();
  double off = 0.0, longer = 0.0;
  int sections = 0;
  for (const EditScene& scene : { sphereScene(30, 96, 0.3),
         pathScene(MeshOf(reader->GetOutput()), { -0.4, 1.1, 0.0 }, { 0.3, 1.1, 0.0 }, 0.28) })
  {
    Chain chain(scene);
    for (const double t : { 0.3, 0.5, 0.61 })
    {
      chain.planes->SetT(t);
      chain.section->Update();
      Vector3 normal;
      chain.planes->GetOutput()->GetCellData()->GetNormals()->GetTuple(2, normal.data());
      const Vector3 origin = fieldMatrix(chain.planes->GetOutput(), "Frame").topRightCorner<3, 1>();
      vtkNew<vtkPlane> plane;
      plane->SetNormal(normal.data());
      plane->SetOrigin(origin.data());
      vtkNew<vtkCutter> cutter;
      cutter->SetCutFunction(plane);
      cutter->SetInputData(chain.data.mesh);
      cutter->Update();
      const std::vector<Vector3> mine = pointsOf(chain.section->GetSectionOutput());
      const auto distance = [](const Vector3& p, const Vector3& a, const Vector3& b)
      {
        const Vector3 step = b - a;
        const double square = step.squaredNorm();
        const double share = square > 0.0 ? std::clamp((p - a).dot(step) / square, 0.0, 1.0) : 0.0;
        return (p - a - share * step).norm();
      };
      const auto toMine = [&](const Vector3& p)
      {
        double least = HUGE_VAL;
        for (std::size_t i = 1; i < mine.size(); ++i)
        {
          least = std::min(least, distance(p, mine[i - 1], mine[i]));
        }
        return least;
      };
      vtkPolyData* cut = cutter->GetOutput();
      std::vector<double> least(mine.size(), HUGE_VAL);
      double length = 0.0;
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = 0; cell < cut->GetNumberOfLines(); ++cell)
      {
        cut->GetLines()->GetCellAtId(cell, ids);
        const Vector3 a(cut->GetPoint(ids->GetId(0))), b(cut->GetPoint(ids->GetId(1)));
        for (std::size_t i = 0; i < mine.size(); ++i)
        {
          least[i] = std::min(least[i], distance(mine[i], a, b));
        }
        length += toMine(0.5 * (a + b)) < 1e-9 ? (b - a).norm() : 0.0;
      }
      off = std::max(off, *std::max_element(least.begin(), least.end()));
      longer = std::max(longer, std::abs(length / lengthOf(chain.section->GetSectionOutput()) - 1.0));
      ++sections;
    }
  }
  EXPECT_LT(off, 1e-9);
  EXPECT_LT(longer, 1e-9);
  fact("B8_2",
    std::to_string(sections) + " sections lie within " + std::to_string(1e12 * off) +
      "e-12 of vtkCutter's and are as long within " + std::to_string(1e12 * longer) + "e-12");
}

TEST(B8_3, OnAModelToo)
{
  // Along the dog's back; the curve and the boundary are chains of edges as they come.
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(OVERSKETCH_DATA_FOLDER "/Models/dog.ply");
  reader->Update();
  Chain chain(pathScene(MeshOf(reader->GetOutput()), { -0.4, 1.1, 0.0 }, { 0.3, 1.1, 0.0 }, 0.28));
  double worst = 0.0;
  for (const double aside : { 0.0, 0.6 })
  {
    const auto raised = [aside](double t)
    {
      const double l = 2.0 * t - 1.0, height = 0.2 * (1.0 - l * l) * (1.0 - l * l);
      return Vector2(aside * height, height);
    };
    chain.run(raised);
    EXPECT_LE(chain.deform->GetFoldedEdges(), 5);
    worst = std::max(worst, chain.gap(raised));
  }
  EXPECT_LT(worst, 0.25);
  fact("B8_3", "on a dog's back within " + std::to_string(worst));
}

TEST(ProfileDeform, TheSameProfileMovesNothing)
{
  Chain chain;
  chain.run([](double) { return Vector2(0.0, 0.0); });
  EXPECT_TRUE(sameBits(chain.deform->GetOutput(), chain.data.mesh));
  EXPECT_EQ(chain.deform->GetMovedPoints(), 0);
  // Black all over.
  chain.data.mesh->GetPointData()->GetArray("EditWeight")->Fill(0.0);
  chain.deform->UseTextureOn();
  chain.run(bump);
  EXPECT_TRUE(sameBits(chain.deform->GetOutput(), chain.data.mesh));
  chain.deform->UseTextureOff();
  chain.run(bump);
  EXPECT_GT(chain.deform->GetMovedPoints(), 0);
}

TEST(ProfileDeform, HandlesAndTheTextureLimitIt)
{
  Chain chain;
  const EditScene& s = chain.data.scene;
  const std::vector<Vector3> whole = chain.run(bump);
  chain.deform->UseTextureOn();
  const std::vector<Vector3> grey = chain.run(bump);
  chain.deform->UseTextureOff();
  vtkNew<vtkOversketchHandles> handles;
  handles->SetInputData(chain.data.mesh);
  handles->SetReferenceData(chain.data.reference);
  handles->SetOperations("pin 0.25; pin 0.75");
  chain.deform->SetHandlesConnection(handles->GetOutputPort());
  const std::vector<Vector3> limited = chain.run(bump);
  for (int v = 0; v < s.mesh.vertexCount(); ++v)
  {
    const Vector3& p = s.mesh.points[v];
    EXPECT_LT((grey[v] - p - s.weight[v] * (whole[v] - p)).norm(), 1e-12);
    const double share = s.region[v] == 2 ? std::max(0.0, 1.0 - std::abs(s.parameter[v] - 0.5) / 0.25) : 0.0;
    EXPECT_LT((limited[v] - p - share * (whole[v] - p)).norm(), 1e-12);
    EXPECT_TRUE(share > 0.0 || limited[v] == p);
  }
}

TEST(ProfileDeform, IsKeptAndTheSameOnTwoThreads)
{
  Chain chain;
  chain.run(bump);
  chain.deform->Modified();
  chain.deform->Update();
  EXPECT_EQ(chain.deform->GetDeformCount(), 1);
  chain.planes->SetT(0.4); // another plane, and the old drawing: another question
  chain.deform->Update();
  EXPECT_EQ(chain.deform->GetDeformCount(), 2);
  expectSameOnTwoThreads(
    []
    {
      Chain made;
      made.deform->SetDrawnData(
        made.drawn([](double t) { return Vector2(std::sin(pi * t) * Vector2(0.05, 0.2)); }));
      return vtkSmartPointer<vtkPolyDataAlgorithm>(made.deform.Get());
    });
  chain.deform->SetDrawnData(chain.drawn([](double) { return Vector2(0.0, 0.1); }));
  expectCancel(chain.deform);
  chain.deform->Update();
  EXPECT_GT(chain.deform->GetMovedPoints(), 0);
}

TEST(ProfileDeform, BadProfilesAreRefused)
{
  Chain chain;
  const double nan = std::nan("");
  const auto good = chain.drawn(bump);
  const auto with = [&](const char* array, vtkIdType i, double value)
  {
    auto changed = vtkSmartPointer<vtkPolyData>::New();
    changed->DeepCopy(good);
    if (array)
    {
      changed->GetPointData()->GetArray(array)->SetComponent(i, 0, value);
    }
    else
    {
      changed->GetPoints()->SetPoint(i, value, 0.0, 0.0);
    }
    return changed;
  };
  chain.deform->SetDrawnData(with(nullptr, 3, nan));
  expectRefusal(chain.deform, Failure::BadStroke, "Point 3 of the new profile is not finite");
  chain.deform->SetDrawnData(with("SourceT", 3, nan));
  expectRefusal(chain.deform, Failure::BadStroke, "Point 3 of the new profile comes from a place outside");
  chain.deform->SetDrawnData(with("SourceT", 5, 0.0));
  expectRefusal(chain.deform, Failure::BadStroke, "Point 5 of the new profile comes from a place before");
  auto bare = with(nullptr, 0, 0.0);
  bare->GetPointData()->RemoveArray("SourceT");
  chain.deform->SetDrawnData(bare);
  expectRefusal(
    chain.deform, Failure::MissingArray, "SourceT: draw the profile anew with vtkOversketchResketch");
  vtkNew<vtkPolyData> nothing;
  chain.deform->SetDrawnData(nothing);
  expectRefusal(chain.deform, Failure::BadStroke, "The new profile input holds 0 polylines");
  // One that turns back in its plane is drawn all the same.
  chain.run([](double t) { return Vector2(0.3 * std::sin(2.0 * pi * t), 0.2 * std::sin(pi * t)); });
  EXPECT_EQ(chain.deform->GetErrorCode(), 0u);
  EXPECT_GT(chain.deform->GetMovedPoints(), 0);

  chain.deform->SetDrawnData(good);
  auto old = vtkSmartPointer<vtkPolyData>::New();
  old->DeepCopy(chain.section->GetOutput());
  chain.deform->SetProfileData(old);
  old->GetFieldData()->GetArray("ProfileMatrix")->SetComponent(0, 5, nan);
  expectRefusal(chain.deform, Failure::BadStroke, "has no field array ProfileMatrix of 16 finite numbers");
  old->GetFieldData()->GetArray("ProfileMatrix")->Fill(0.0);
  old->GetFieldData()->GetArray("ProfileMatrix")->Modified();
  expectRefusal(chain.deform, Failure::BadStroke, "its ProfileMatrix is singular");
  old->GetFieldData()->RemoveArray("ProfileMatrix");
  expectRefusal(chain.deform, Failure::MissingArray, "ProfileMatrix");
  chain.deform->SetProfileData(nothing); // none was found
  chain.deform->Update();
  EXPECT_TRUE(sameBits(chain.deform->GetOutput(), chain.data.mesh));

  chain.deform->SetProfileConnection(chain.section->GetOutputPort());
  const int v = chain.data.insideVertex();
  for (const char* name : { "CurveDistance", "CurveParameter", "CurveSide" })
  {
    chain.deform->SetInputData(chain.data.without(name));
    expectRefusal(chain.deform, Failure::MissingArray, name);
    for (const double value : { nan, 2.0, -2.0 })
    {
      chain.deform->SetInputData(chain.data.with(name, v, value));
      expectRefusal(chain.deform, Failure::BadRegion, std::string(name) + " of point " + std::to_string(v));
    }
  }
  chain.deform->SetInputData(nothing);
  chain.deform->Update();
  EXPECT_EQ(chain.deform->GetErrorCode(), 0u);
}

TEST(CrossSection, WhatHasNoneIsSaid)
{
  Chain chain;
  // A boundary elsewhere: no profile, and a warning.
  const Triangle& last = chain.data.scene.mesh.triangles.back();
  chain.section->SetBoundaryData(toChain(chain.data.scene.mesh, closed({ last[0], last[1], last[2] })));
  chain.planes->SetT(0.3);
  {
    Ear ear(chain.section);
    chain.section->Update();
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(ear.warnings[0].find("back without meeting the boundary curve"), std::string::npos);
    EXPECT_EQ(chain.section->GetErrorCode(), 0u);
    EXPECT_EQ(chain.section->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(chain.section->GetSectionOutput()->GetNumberOfPoints(), 0);
  }
  chain.section->SetEndsToOutermost();
  {
    Ear ear(chain.section);
    chain.section->Update();
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(ear.warnings[0].find("fewer than twice"), std::string::npos);
  }
  chain.section->SetEndsToNearest();
  std::vector<int> torn = chain.data.scene.boundary;
  std::swap(torn[4], torn[20]);
  chain.section->SetBoundaryData(toChain(chain.data.scene.mesh, closed(torn)));
  expectRefusal(chain.section, Failure::BadStroke, "are not joined by an edge of the mesh");
  EXPECT_EQ(chain.section->GetSectionOutput()->GetNumberOfPoints(), 0);
  chain.section->SetBoundaryData(chain.data.boundary);
  chain.section->SetRight(std::nan(""), 0.0, 0.0);
  expectRefusal(chain.section, Failure::BadStroke, "Right is not a finite number");
  chain.section->SetRight(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> nothing;
  chain.section->SetPlanesData(nothing);
  expectRefusal(chain.section, Failure::MissingArray, "Frame");
  chain.section->SetPlanesConnection(chain.planes->GetOutputPort());
  for (const char* name : { "CurveDistance", "CurveSide" })
  {
    chain.section->SetInputData(chain.data.without(name));
    expectRefusal(chain.section, Failure::MissingArray, name);
  }
  chain.section->SetInputData(chain.data.mesh);
  chain.planes->SetT(std::nan(""));
  expectRefusal(chain.planes, Failure::BadStroke, "T is not a finite number");
  chain.planes->SetT(7.0);
  EXPECT_EQ(chain.planes->GetT(), 1.0);
  chain.section->Update();
  EXPECT_GT(chain.section->GetOutput()->GetNumberOfPoints(), 10);
  // As published: between the outermost meetings, through the mesh's middle.
  chain.planes->SetT(0.5);
  chain.section->SetEndsToOutermost();
  chain.section->SetWalkToCentre();
  chain.section->Update();
  EXPECT_EQ(chain.section->GetErrorCode(), 0u);
  EXPECT_GT(lengthOf(chain.section->GetSectionOutput()), 0.98 * 2.0 * pi / 3.0);
  chain.section->SetInputData(nothing);
  chain.section->Update();
  EXPECT_EQ(chain.section->GetErrorCode(), 0u);
}
