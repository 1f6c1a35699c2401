#include "EditTools.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchMatrixDeform.h"

#include "Matrix/logarithm.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A region, operations, and what they make of it.
struct Deformed
{
  EditData data;
  vtkNew<vtkOversketchHandles> handles;
  vtkNew<vtkOversketchMatrixDeform> deform;

  explicit Deformed(const char* operations, EditScene scene = sphereScene(20, 64))
    : data(std::move(scene))
  {
    this->handles->SetInputData(this->data.mesh);
    this->handles->SetReferenceData(this->data.reference);
    this->handles->SetOperations(operations);
    this->deform->SetInputData(this->data.mesh);
    this->deform->SetHandlesConnection(this->handles->GetOutputPort());
  }
  std::vector<Vector3> run()
  {
    this->deform->Update();
    return pointsOf(this->deform->GetOutput());
  }
};

// Handles as points: places and matrices, in their own axes or the world's.
vtkSmartPointer<vtkPolyData> toHandles(const std::vector<double>& places,
  const std::vector<Matrix4>& matrices)
{
  auto handles = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> array;
  array->SetName("Matrix");
  array->SetNumberOfComponents(16);
  for (const Matrix4& matrix : matrices)
  {
    points->InsertNextPoint(0, 0, 0);
    array->InsertNextTuple(Matrix4(matrix.transpose()).data());
  }
  handles->SetPoints(points);
  handles->GetPointData()->AddArray(arrayOf("CurveT", places));
  handles->GetPointData()->AddArray(array);
  return handles;
}

Matrix4 matrixOfTuple(vtkPolyData* handles, const char* name, vtkIdType i)
{
  Matrix4 m;
  for (int k = 0; k < 16; ++k)
  {
    m(k / 4, k % 4) = handles->GetPointData()->GetArray(name)->GetComponent(i, k);
  }
  return m;
}

} // namespace

TEST(B10_5, OnAMeshAHandleMovesWhatIsBetweenItsNeighbours)
{
  Deformed scene("pin 0.25; move 0.5 n 1; pin 0.75");
  const std::vector<Vector3> points = scene.run();
  const EditScene& s = scene.data.scene;
  // The middle handle is at the pole: its outward is z.
  const Vector3 up = matrixOfTuple(scene.handles->GetOutput(), "Matrix", 1).topRightCorner<3, 1>();
  EXPECT_LT((up - Vector3::UnitZ()).norm(), 0.01);
  double worst = 0.0;
  int beyond = 0;
  for (int v = 0; v < s.mesh.vertexCount(); ++v)
  {
    const double t = s.parameter[v];
    const double share = s.region[v] != 2 ? 0.0 : std::max(0.0, 1.0 - std::abs(t - 0.5) / 0.25);
    worst = std::max(worst, (points[v] - s.mesh.points[v] - s.weight[v] * share * up).norm());
    if (share == 0.0)
    {
      EXPECT_EQ(points[v], s.mesh.points[v]);
      ++beyond;
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(beyond, 1000);
  EXPECT_LT((points[0] - s.mesh.points[0] - up).norm(), 1e-12); // w = 1 at the place itself

  Deformed open("move 0.5 n 1; pin 0.75");
  const std::vector<Vector3> whole = open.run();
  for (int v = 0; v < s.mesh.vertexCount(); ++v)
  {
    if (s.region[v] == 2 && s.parameter[v] < 0.5)
    {
      EXPECT_LT((whole[v] - s.mesh.points[v] - s.weight[v] * up).norm(), 1e-9);
    }
  }
  fact("B10_5", "on a sphere's region within " + std::to_string(worst * 1e15) + "e-15 of it");
}

TEST(B10_4, WhatHasNoLogarithmLeavesTheMesh)
{
  Deformed scene("");
  Matrix4 mirror = Matrix4::Identity(), half = Matrix4::Identity(), flat = Matrix4::Identity();
  mirror(0, 0) = -1.0;
  half(0, 0) = half(1, 1) = -1.0;
  flat(2, 2) = 0.0;
  const Matrix4 nothing = Matrix4::Identity();
  const std::vector<std::pair<Matrix4, std::string>> refused{
    { mirror, "a reflection or turns by 180 degrees" },
    { half, "a reflection or turns by 180 degrees" },
    { flat, "is singular" },
    { Matrix4::Zero(), "last row is not 0 0 0 1" },
    { Matrix4::Constant(std::nan("")), "is not finite" },
  };
  for (const auto& [matrix, words] : refused)
  {
    scene.deform->SetHandlesData(toHandles({ 0.2, 0.6 }, { nothing, matrix }));
    const bool read =
      words.find("last row") != std::string::npos || words.find("finite") != std::string::npos;
    expectRefusal(scene.deform, read ? Failure::BadStroke : Failure::SolveFailed, words);
    Ear ear(scene.deform);
    scene.deform->Modified();
    scene.deform->Update();
    ASSERT_EQ(ear.errors.size(), 1u);
    EXPECT_NE(ear.errors[0].find("andle 1"), std::string::npos) << ear.errors[0];
  }
  // The input is as it was, and can be deformed.
  EXPECT_EQ(pointsOf(scene.data.mesh), scene.data.scene.mesh.points);
  scene.deform->SetHandlesConnection(scene.handles->GetOutputPort());
  EXPECT_EQ(scene.run(), scene.data.scene.mesh.points);
}

TEST(MatrixDeform, NothingDoneIsNothingMoved)
{
  for (const char* operations :
    { "", "pin 0.1; pin 0.9", "move 0.5 n 0; rotate 0.2 t 0; scale 0.7 w 1", "move 0.5 w 0; move 0.5 w 0" })
  {
    Deformed scene(operations);
    scene.run();
    EXPECT_TRUE(sameBits(scene.deform->GetOutput(), scene.data.mesh)) << operations;
    EXPECT_EQ(scene.deform->GetMovedPoints(), 0);
  }
  // Black all over.
  Deformed black("rotate 0.5 n 90");
  black.data.mesh->GetPointData()->GetArray("EditWeight")->Fill(0.0);
  black.run();
  EXPECT_TRUE(sameBits(black.deform->GetOutput(), black.data.mesh));
}

TEST(MatrixDeform, OnlyWhatHasWeightMovesAndNormalsTurnWithIt)
{
  Deformed scene("rotate 0.5 t 60; scale 0.5 n 1.4", sphereScene(20, 64, 0.3));
  const std::vector<Vector3> points = scene.run();
  const EditScene& s = scene.data.scene;
  Mesh after = s.mesh;
  after.points = points;
  const std::vector<Vector3> normals = vertexNormals(after);
  int moved = 0;
  for (int v = 0; v < s.mesh.vertexCount(); ++v)
  {
    const bool may = s.region[v] == 2 && s.weight[v] > 0.0;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): its bits are meant
    EXPECT_TRUE(may || std::memcmp(points[v].data(), s.mesh.points[v].data(), 24) == 0) << v;
    moved += points[v] != s.mesh.points[v] ? 1 : 0;
    Vector3 normal;
    scene.deform->GetOutput()->GetPointData()->GetNormals()->GetTuple(v, normal.data());
    EXPECT_LT((normal - normals[v]).norm(), 1e-14) << v;
  }
  EXPECT_GT(moved, 800);
  EXPECT_EQ(scene.deform->GetMovedPoints(), moved);
  int folds = 0;
  const Adjacency links = buildAdjacency(s.mesh);
  for (const MeshEdge& e : links.edges)
  {
    const int a = links.edgeTriangles[e.firstTriangle], b = links.edgeTriangles[e.firstTriangle + 1];
    folds += facetNormal(after, a).dot(facetNormal(after, b)) < -0.5 &&
                 facetNormal(s.mesh, a).dot(facetNormal(s.mesh, b)) >= -0.5
               ? 1
               : 0;
  }
  EXPECT_EQ(scene.deform->GetFoldedEdges(), folds);
  EXPECT_LE(folds, 5);
  for (int t = 0; t < s.mesh.triangleCount(); ++t)
  {
    Vector3 normal;
    scene.deform->GetOutput()->GetCellData()->GetNormals()->GetTuple(t, normal.data());
    EXPECT_LT((normal - facetNormal(after, t)).norm(), 1e-14) << t;
  }
  // A turn about the normal sweeps a long curve over the boundary.
  Deformed swept("rotate 0.5 n 120");
  swept.run();
  EXPECT_GT(swept.deform->GetFoldedEdges(), 10);
}

TEST(MatrixDeform, HandlesAtOnePlaceActAtOnce)
{
  Deformed both("rotate 0.5 w 40; move 0.5 n 0.2; rotate 0.5 t 30");
  Deformed other("rotate 0.5 t 30; rotate 0.5 w 40; move 0.5 n 0.2");
  const std::vector<Vector3> points = both.run(), swapped = other.run();
  both.handles->Update();
  Matrix4 sum = Matrix4::Zero();
  for (vtkIdType i = 0; i < 3; ++i)
  {
    sum += logarithm(matrixOfTuple(both.handles->GetOutput(), "Matrix", i));
  }
  const Matrix4 at = exponential(sum);
  const Vector3 pole = both.data.scene.mesh.points[0];
  EXPECT_LT((points[0] - (at * pole.homogeneous()).head<3>()).norm(), 1e-12);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    EXPECT_LT((points[v] - swapped[v]).norm(), 1e-12);
  }
  // In any order along the curve.
  Deformed sorted("pin 0.2; move 0.4 n 0.1; move 0.8 n 0.3"),
    mixed("move 0.8 n 0.3; pin 0.2; move 0.4 n 0.1");
  EXPECT_EQ(sorted.run(), mixed.run());
}

TEST(MatrixDeform, IsKeptAndFollowsWhatItReads)
{
  Deformed scene("move 0.5 n 0.2");
  scene.run();
  EXPECT_EQ(scene.deform->GetDeformCount(), 1);
  scene.deform->Modified();
  scene.run();
  EXPECT_EQ(scene.deform->GetDeformCount(), 1);
  scene.handles->SetOperations("move 0.5 n 0.3");
  const std::vector<Vector3> further = scene.run();
  EXPECT_EQ(scene.deform->GetDeformCount(), 2);
  EXPECT_NEAR(further[0][2], 1.3, 1e-3);
  scene.data.mesh->GetPointData()->GetArray("EditWeight")->SetComponent(0, 0, 0.5);
  scene.data.mesh->GetPointData()->GetArray("EditWeight")->Modified();
  scene.data.mesh->Modified();
  EXPECT_NEAR(scene.run()[0][2], 1.15, 1e-3);
  expectSameOnTwoThreads(
    []
    {
      Deformed made("rotate 0.3 w 70; scale 0.6 t 0.5; move 0.9 n 0.2");
      return vtkSmartPointer<vtkPolyDataAlgorithm>(made.deform.Get());
    });
  scene.handles->SetOperations("rotate 0.5 n 20");
  scene.handles->Update();
  expectCancel(scene.deform);
  EXPECT_GT(scene.run().size(), 0u);
}

TEST(MatrixDeform, FloatsStayFloats)
{
  Deformed scene("move 0.5 n 0.2");
  vtkNew<vtkPolyData> floats;
  floats->ShallowCopy(scene.data.mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(scene.data.mesh->GetPoints());
  floats->SetPoints(points);
  scene.handles->SetInputData(floats);
  scene.deform->SetInputData(floats);
  scene.run();
  EXPECT_EQ(scene.deform->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_NEAR(pointsOf(scene.deform->GetOutput())[0][2], 1.2, 1e-3);
}

TEST(MatrixDeform, BadInputIsRefused)
{
  Deformed scene("move 0.5 n 0.2");
  const EditData& data = scene.data;
  const int v = data.insideVertex();
  const double nan = std::nan("");
  for (const char* name : { "EditRegion", "EditWeight", "CurveParameter" })
  {
    scene.deform->SetInputData(data.without(name));
    expectRefusal(scene.deform, Failure::MissingArray, name);
  }
  for (const char* name : { "EditWeight", "CurveParameter" })
  {
    for (const double value : { nan, -1.0, 2.0, std::numeric_limits<double>::infinity() })
    {
      scene.deform->SetInputData(data.with(name, v, value));
      expectRefusal(scene.deform, Failure::BadRegion, std::string(name) + " of point " + std::to_string(v));
    }
  }
  // What is outside is not read.
  const int outside = data.scene.mesh.vertexCount() - 1;
  scene.deform->SetInputData(data.with("CurveParameter", outside, nan));
  EXPECT_NEAR(scene.run()[0][2], 1.2, 1e-3);
  auto empty = data.with("EditRegion", v, 0.0);
  empty->GetPointData()->GetArray("EditRegion")->Fill(1.0);
  scene.deform->SetInputData(empty);
  expectRefusal(scene.deform, Failure::BadRegion, "No vertex lies strictly inside");

  scene.deform->SetInputData(data.mesh);
  for (const double place : { -1.0, 2.0, nan })
  {
    scene.deform->SetHandlesData(toHandles({ 0.1, place }, { Matrix4::Identity(), Matrix4::Identity() }));
    expectRefusal(scene.deform, Failure::BadStroke, "Handle 1 has a CurveT of");
  }
  auto bare = toHandles({ 0.1 }, { Matrix4::Identity() });
  bare->GetPointData()->RemoveArray("Matrix");
  scene.deform->SetHandlesData(bare);
  expectRefusal(scene.deform, Failure::MissingArray, "Matrix: make handles with vtkOversketchHandles");
  Matrix4 huge = Matrix4::Identity();
  huge(0, 3) = 1e200;
  scene.deform->SetHandlesData(toHandles({ 0.1 }, { huge }));
  expectRefusal(scene.deform, Failure::SolveFailed, "too large");
  vtkNew<vtkPolyData> nothing;
  scene.deform->SetInputData(nothing);
  scene.deform->Update();
  EXPECT_EQ(scene.deform->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.deform->GetErrorCode(), 0u);
}

TEST(Handles, AreAtTheirPlacesInTheirAxes)
{
  Deformed scene("move 0.5 n 0.1; rotate 0.7 t 30; scale 0.3 w 1.5; pin 0.2");
  Matrix4 lift = Matrix4::Identity();
  lift(2, 3) = 0.5; // outward, in the handle's own axes
  scene.handles->SetHandlesData(toHandles({ 0.9, 0.5 }, { lift, lift }));
  scene.handles->Update();
  vtkPolyData* handles = scene.handles->GetOutput();
  ASSERT_EQ(handles->GetNumberOfPoints(), 6);
  ASSERT_EQ(handles->GetNumberOfVerts(), 6);
  const std::vector<double> places{ 0.5, 0.7, 0.3, 0.2, 0.9, 0.5 };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(handles->GetPointData()->GetArray("CurveT")->GetComponent(i, 0), places[i]);
    const Matrix4 frame = matrixOfTuple(handles, "Frame", i);
    const Eigen::Matrix3d axes = frame.topLeftCorner<3, 3>();
    EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-12);
    Vector3 place;
    handles->GetPoint(i, place.data());
    EXPECT_EQ(Vector3(frame.topRightCorner<3, 1>()), place);
    EXPECT_NEAR(place.norm(), 1.0, 0.01); // on the sphere
    if (i > 3)
    {
      const Matrix4 matrix = matrixOfTuple(handles, "Matrix", i);
      EXPECT_LT((matrix.topRightCorner<3, 1>() - 0.5 * axes.col(2)).norm(), 1e-12);
      EXPECT_GT(axes.col(2).dot(place), 0.99);
    }
  }
  EXPECT_EQ(matrixOfTuple(handles, "Matrix", 3), Matrix4::Identity());
  const Matrix4 first = matrixOfTuple(handles, "Matrix", 0);
  EXPECT_LT((first.topRightCorner<3, 1>() - Vector3(0, 0, 0.1)).norm(), 1e-3);
  vtkDataArray* kept = handles->GetPointData()->GetArray("Matrix");
  scene.handles->Modified();
  scene.handles->Update();
  EXPECT_EQ(scene.handles->GetOutput()->GetPointData()->GetArray("Matrix"), kept);
}

TEST(Handles, ErrorsNameOperationAndRemedy)
{
  Deformed scene("");
  const std::vector<std::pair<const char*, const char*>> refused{
    { "move 0.5 n 0.1; scale 0.3 w 0",
      "Operation 2, \"scale 0.3 w 0\": A handle cannot be scaled by 0; give" },
    { "scale 0.3 w -1", "give a factor above 0" },
    { "rotate 0.3 w 180", "give less than 180 degrees either way" },
    { "pin -1", "its place is not on the curve" },
    { "pin 2", "its place is not on the curve" },
    { "move 0.5 n nan", "its amount is \"nan\"" },
    { "lift 0.5 n 1", "write \"move T AXIS LENGTH\"" },
  };
  for (const auto& [operations, words] : refused)
  {
    scene.handles->SetOperations(operations);
    expectRefusal(scene.handles, Failure::BadStroke, words);
  }
  scene.handles->SetOperations(nullptr);
  scene.handles->Update();
  EXPECT_EQ(scene.handles->GetErrorCode(), 0u);
  EXPECT_EQ(scene.handles->GetOutput()->GetNumberOfPoints(), 0);
  scene.handles->SetHandlesData(toHandles({ 0.1, -0.5 }, { Matrix4::Identity(), Matrix4::Identity() }));
  expectRefusal(scene.handles, Failure::BadStroke, "Handle 1 has a CurveT of -0.5");
  vtkNew<vtkPolyData> none;
  scene.handles->SetHandlesData(none);
  scene.handles->SetReferenceData(none);
  expectRefusal(scene.handles, Failure::BadStroke, "must be polylines and no other cells");
  auto wrong = toChain(scene.data.scene.mesh, { 0, 1, 2 });
  wrong->GetPointData()->GetArray("VertexId")->SetComponent(1, 0, 1e9);
  scene.handles->SetReferenceData(wrong);
  expectRefusal(scene.handles, Failure::BadStroke, "Point 1 of the reference curve is no vertex of the mesh");
  wrong->GetPointData()->RemoveArray("VertexId");
  expectRefusal(scene.handles, Failure::MissingArray, "VertexId");
  scene.handles->SetReferenceData(toChain(scene.data.scene.mesh, { 5, 5 }));
  expectRefusal(scene.handles, Failure::BadStroke, "fewer than two distinct points");
  scene.handles->SetInputData(none);
  scene.handles->Update();
  EXPECT_EQ(scene.handles->GetErrorCode(), 0u);
}
