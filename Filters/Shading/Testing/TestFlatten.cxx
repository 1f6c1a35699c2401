// Facts of editors.md, section 13, flatten and texture, by the filter; what every filter promises.
#include "ShadingScenes.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Flattened
{
  vtkNew<vtkOversketchFlatten> filter;

  explicit Flattened(vtkPolyData* mesh, vtkPolyData* reference)
  {
    this->filter->SetInputData(mesh);
    this->filter->SetReferenceData(reference);
  }
  explicit Flattened(const Scene& scene)
    : Flattened(meshOf(scene), toChain(scene.mesh, scene.reference))
  {
  }
};

double discArea(vtkPolyData* disc, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  disc->GetPolys()->GetCellAtId(cell, ids);
  double p[3][3];
  for (int k = 0; k < 3; ++k)
    disc->GetPoint(ids->GetId(k), p[k]);
  return 0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
}

// p95 over p5 of the disc's areas by the surface's.
double spread(const Scene& scene, vtkPolyData* disc)
{
  vtkDataArray* ids = disc->GetPointData()->GetArray("VertexId");
  std::vector<double> ratios;
  for (vtkIdType t = 0; t < disc->GetNumberOfCells(); ++t)
  {
    vtkNew<vtkIdList> corners;
    disc->GetPolys()->GetCellAtId(t, corners);
    Vector3 p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = scene.mesh.points[static_cast<std::size_t>(ids->GetComponent(corners->GetId(k), 0))];
    ratios.push_back(discArea(disc, t) / (0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm()));
    EXPECT_GT(ratios.back(), 0.0) << "triangle " << t << " is turned over";
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[ratios.size() * 95 / 100] / ratios[ratios.size() * 5 / 100];
}

// A grid of side x side quads in the plane, of which some are inside.
Scene gridScene(int side, const std::function<bool(int, int)>& inside, const std::vector<int>& reference)
{
  const Mesh mesh = gridSurface(
    side, side, false, false, [](double u, double v) { return Vector3(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0); });
  int t = 0;
  return sceneOf(
    mesh,
    [&](const Triangle&)
    {
      const int quad = t++ / 2;
      return inside(quad % side, quad / side);
    },
    reference);
}

// Quads 4 to 15 of 20, and a curve of three vertices.
Scene squareScene()
{
  return gridScene(20,
    [](int i, int j) { return i >= 4 && i < 16 && j >= 4 && j < 16; },
    { 10 * 21 + 9, 10 * 21 + 10, 10 * 21 + 11 });
}

} // namespace

TEST(B6_1, ByTheFilterTheModelKeepsWhatItHas)
{
  const Scene scene = capScene();
  const auto mesh = meshOf(scene);
  vtkNew<vtkDoubleArray> own;
  own->SetName("OwnTexture");
  own->SetNumberOfComponents(2);
  own->SetNumberOfTuples(mesh->GetNumberOfPoints());
  own->Fill(0.25);
  mesh->GetPointData()->SetTCoords(own);
  Flattened made(mesh, toChain(scene.mesh, scene.reference));
  made.filter->Update();
  ASSERT_EQ(made.filter->GetErrorCode(), 0u);

  vtkPolyData* output = made.filter->GetOutput();
  EXPECT_EQ(output->GetPointData()->GetTCoords(), own);
  EXPECT_EQ(output->GetPoints(), mesh->GetPoints());
  EXPECT_EQ(mesh->GetPointData()->GetArray("DiscCoords"), nullptr) << "the input is untouched";
  vtkPolyData* disc = made.filter->GetDiscOutput();
  EXPECT_EQ(disc->GetNumberOfCells(), std::count(scene.inside.begin(), scene.inside.end(), 1));
  for (vtkIdType t = 0; t < disc->GetNumberOfCells(); ++t)
    ASSERT_GT(discArea(disc, t), 0.0);
  const double* bounds = disc->GetBounds();
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(bounds[k], k % 2 == 0 ? -1.0 : 1.0, 1e-12);
  EXPECT_EQ(bounds[4], 0.0);
  EXPECT_EQ(bounds[5], 0.0);
  const std::vector<double> coordinates = pointValues(output, "DiscCoords");
  std::vector<char> known(scene.mesh.points.size(), 0);
  for (vtkIdType i = 0; i < disc->GetNumberOfPoints(); ++i)
  {
    const auto v = static_cast<std::size_t>(disc->GetPointData()->GetArray("VertexId")->GetComponent(i, 0));
    known[v] = 1;
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_EQ(coordinates[2 * v + k], 0.5 * (disc->GetPoint(i)[k] + 1.0));
      EXPECT_EQ(disc->GetPointData()->GetTCoords()->GetComponent(i, k), coordinates[2 * v + k]);
    }
  }
  for (std::size_t v = 0; v < known.size(); ++v)
    if (!known[v])
    {
      EXPECT_EQ(coordinates[2 * v], -1.0);
      EXPECT_NE(scene.labels[v], 2);
    }
  // The curve is where its vertices are.
  vtkPolyData* curve = made.filter->GetDiscCurveOutput();
  ASSERT_EQ(curve->GetNumberOfPoints(), static_cast<vtkIdType>(scene.reference.size()));
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
    EXPECT_EQ(0.5 * (curve->GetPoint(i)[0] + 1.0), coordinates[2 * scene.reference[i]]);
  EXPECT_TRUE(curve->GetPointData()->HasArray("CurveT"));

  Scene shifted = scene;
  for (Vector3& p : shifted.mesh.points)
    p += Vector3(5.0, 5.0, 5.0);
  Flattened again(shifted);
  again.filter->Update();
  const std::vector<double> other = pointValues(again.filter->GetOutput(), "DiscCoords");
  double worst = 0.0;
  for (std::size_t i = 0; i < other.size(); ++i)
    worst = std::max(worst, std::abs(other[i] - coordinates[i]));
  EXPECT_LT(worst, 1e-9);
  fact("B6_1",
    "by the filter: " + std::to_string(disc->GetNumberOfCells()) +
      " triangles of a sphere's cap, all of positive area; the model's own texture coordinates stay; shifted "
      "by 5: within " +
      std::to_string(worst * 1e12) + "e-12");
}

TEST(B6_6, ByTheFilterAndAsPublished)
{
  const Mesh drawnOut = limb(5, 6.0);
  const Scene scene = sceneOf(
    drawnOut,
    [](const Triangle&) { return true; },
    edgeWay(drawnOut, nearestVertex(drawnOut, { 0.0, 0.9, 2.6 }), nearestVertex(drawnOut, { 0, 0, 6 })));
  Flattened made(scene);
  made.filter->Update();
  const double balanced = spread(scene, made.filter->GetDiscOutput());
  made.filter->AsPublishedOn();
  made.filter->Update();
  const double plain = spread(scene, made.filter->GetDiscOutput());
  EXPECT_GT(plain, 30.0);
  EXPECT_LT(balanced, plain / 5.0);
  fact("B6_6",
    "by the filter: p95/p5 of a limb " + std::to_string(plain) + " as published, " +
      std::to_string(balanced) + " balanced");
}

TEST(FlattenFilter, AsPublishedARingThatTouchesItselfIsRefused)
{
  // A horseshoe whose ends are one quad apart: its ring closes the gap.
  const Scene narrow = gridScene(21,
    [](int i, int j)
    {
      const bool block = i >= 3 && i < 18 && j >= 3 && j < 18;
      const bool hollow = i >= 7 && i < 14 && j >= 7 && j < 14, gap = i == 10 && j >= 14;
      return block && !hollow && !gap;
    },
    { 5 * 22 + 9, 5 * 22 + 10, 5 * 22 + 11 });
  Flattened made(narrow);
  made.filter->Update();
  EXPECT_EQ(made.filter->GetErrorCode(), 0u);
  EXPECT_GT(spread(narrow, made.filter->GetDiscOutput()), 1.0);
  made.filter->AsPublishedOn();
  expectRefusal(made.filter, Failure::BadRegion, "has a hole or is in several pieces");
  // Where the ring does not touch itself it is flattened with the rest.
  Flattened square(squareScene());
  square.filter->Update();
  const vtkIdType inside = square.filter->GetDiscOutput()->GetNumberOfCells();
  EXPECT_EQ(inside, 2 * 12 * 12);
  square.filter->AsPublishedOn();
  square.filter->Update();
  EXPECT_EQ(square.filter->GetErrorCode(), 0u);
  EXPECT_EQ(square.filter->GetDiscOutput()->GetNumberOfCells(), 2 * 14 * 14 - 2)
    << "two corners' diagonals leave a triangle that touches nothing inside";
}

TEST(FlattenFilter, APatchGivesTheDiscOfItsMesh)
{
  const Scene scene = capScene(3);
  Flattened whole(scene);
  whole.filter->Update();
  // The patch by itself, with the ids of the mesh; the curve keeps naming those.
  Mesh alone;
  std::vector<int> number(scene.mesh.points.size(), -1);
  Scene part;
  const auto patch = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("VertexId");
  for (int v = 0; v < scene.mesh.vertexCount(); ++v)
    if (scene.labels[v] > 0)
    {
      number[v] = alone.vertexCount();
      alone.points.push_back(scene.mesh.points[v]);
      part.labels.push_back(scene.labels[v]);
      ids->InsertNextValue(v);
    }
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t)
  {
    const Triangle& c = scene.mesh.triangles[t];
    if (number[c[0]] >= 0 && number[c[1]] >= 0 && number[c[2]] >= 0)
    {
      alone.triangles.push_back({ number[c[0]], number[c[1]], number[c[2]] });
      part.inside.push_back(scene.inside[t]);
    }
  }
  part.mesh = alone;
  const auto mesh = meshOf(part);
  mesh->GetPointData()->AddArray(ids);
  Flattened made(mesh, toChain(scene.mesh, scene.reference));
  made.filter->Update();
  ASSERT_EQ(made.filter->GetErrorCode(), 0u);
  EXPECT_TRUE(sameBits(made.filter->GetDiscOutput()->GetPoints()->GetData(),
    whole.filter->GetDiscOutput()->GetPoints()->GetData()));
  EXPECT_TRUE(sameBits(made.filter->GetDiscCurveOutput()->GetPoints()->GetData(),
    whole.filter->GetDiscCurveOutput()->GetPoints()->GetData()));
  EXPECT_EQ(number[static_cast<std::size_t>(
              whole.filter->GetDiscOutput()->GetPointData()->GetArray("VertexId")->GetComponent(7, 0))],
    made.filter->GetDiscOutput()->GetPointData()->GetArray("VertexId")->GetComponent(7, 0));
  // A vertex that the patch lacks.
  const auto outside = static_cast<int>(std::find(number.begin(), number.end(), -1) - number.begin());
  made.filter->SetReferenceData(toChain(scene.mesh, { scene.reference[0], outside }));
  expectRefusal(made.filter, Failure::BadStroke, "Point 1 of the reference curve is no vertex of the mesh");
}

TEST(FlattenFilter, PointLabelsAloneLeaveOutWhatHasAllCornersOnTheBoundary)
{
  const Scene scene = squareScene();
  Flattened made(meshOf(scene, false), toChain(scene.mesh, scene.reference));
  made.filter->Update();
  ASSERT_EQ(made.filter->GetErrorCode(), 0u);
  EXPECT_EQ(made.filter->GetDiscOutput()->GetNumberOfCells(), 2 * 12 * 12 - 2) << "two corners of the square";
}

TEST(FlattenFilter, OnlyTheRegionFlattensAnew)
{
  Scene scene = squareScene();
  const auto mesh = meshOf(scene);
  Flattened made(mesh, toChain(scene.mesh, scene.reference));
  made.filter->Update();
  const vtkSmartPointer<vtkDataArray> first =
    made.filter->GetOutput()->GetPointData()->GetArray("DiscCoords");
  scene.reference.push_back(scene.reference.back() + 1);
  made.filter->SetReferenceData(toChain(scene.mesh, scene.reference));
  made.filter->Update();
  EXPECT_EQ(made.filter->GetDiscCurveOutput()->GetNumberOfPoints(), 4);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(other);
  made.filter->Update();
  EXPECT_TRUE(made.filter->GetOutput()->GetPointData()->HasArray("Other"));
  EXPECT_EQ(made.filter->GetOutput()->GetPointData()->GetArray("DiscCoords"), first.Get());
  EXPECT_EQ(made.filter->GetFlattenCount(), 1);
  mesh->GetPointData()->GetArray("EditRegion")->Modified();
  made.filter->Update();
  EXPECT_EQ(made.filter->GetFlattenCount(), 2);
  EXPECT_TRUE(sameBits(first, made.filter->GetOutput()->GetPointData()->GetArray("DiscCoords")));
}

TEST(FlattenFilter, OneAndTwoThreadsGiveTheSameBits)
{
  const Scene scene = capScene();
  Flattened one(scene), two(scene);
  vtkSMPTools::Initialize(1);
  one.filter->Update();
  vtkSMPTools::Initialize(2);
  two.filter->Update();
  vtkSMPTools::Initialize();
  EXPECT_TRUE(sameBits(one.filter->GetOutput()->GetPointData()->GetArray("DiscCoords"),
    two.filter->GetOutput()->GetPointData()->GetArray("DiscCoords")));
}

TEST(FlattenFilter, RefusesRegionsThatAreNoDisc)
{
  const std::vector<int> reference{ 10 * 21 + 9, 10 * 21 + 10, 10 * 21 + 11 };
  const auto block = [](int i, int j, int low, int high)
  { return i >= low && i < high && j >= low && j < high; };
  const struct
  {
    Scene scene;
    const char* words;
  } cases[] = {
    { gridScene(
        20, [&](int i, int j) { return block(i, j, 4, 16) && !(i == 6 && j == 6); }, reference),
      "has a hole or is in several pieces" },
    { gridScene(
        20, [&](int i, int j) { return block(i, j, 4, 16) || block(i, j, 17, 19); }, reference),
      "has a hole or is in several pieces" },
    { gridScene(
        20, [&](int i, int j) { return block(i, j, 4, 13) || block(i, j, 13, 18); }, reference),
      "is pinched at a vertex" },
    { gridScene(
        20, [&](int i, int j) { return i == 10 && j == 10; }, reference),
      "No vertex lies strictly inside the boundary" },
    { gridScene(
        20, [&](int, int) { return false; }, reference),
      "No vertex lies strictly inside" },
    { sceneOf(icosphere(2), [](const Triangle&) { return true; }, { 0, 1 }),
      "is closed: it has no boundary" },
  };
  for (const auto& each : cases)
  {
    Flattened made(each.scene);
    expectRefusal(made.filter, Failure::BadRegion, each.words);
  }
  int face = 0;
  Flattened one(sceneOf(squareScene().mesh, [&](const Triangle&) { return face++ == 200; }, { 100, 101 }));
  expectRefusal(one.filter, Failure::BadRegion, "No vertex lies strictly inside");
  // A torus with a triangle left out has one border, and a handle.
  int t = 0;
  const Mesh ring = torus(2.0, 0.7, 24, 12);
  Flattened handle(sceneOf(ring, [&](const Triangle&) { return t++ > 0; }, { 100, 101 }));
  expectRefusal(handle.filter, Failure::BadRegion, "has a handle");
}

TEST(FlattenFilter, RefusesAndCancels)
{
  const Scene scene = squareScene();
  const auto refused = [&](vtkPolyData* mesh, vtkPolyData* reference, Failure failure, const char* words)
  {
    Flattened made(mesh, reference);
    expectRefusal(made.filter, failure, words);
  };
  const auto curve = toChain(scene.mesh, scene.reference);
  const auto mesh = meshOf(scene);
  for (const int wrong : { -1, 21 * 21, 1 << 30 })
    refused(mesh,
      toChain(scene.mesh, { scene.reference[0], wrong }),
      Failure::BadStroke,
      "is no vertex of the mesh");
  refused(
    mesh, toChain(scene.mesh, { scene.reference[0], 0 }), Failure::BadStroke, "lies outside the boundary");
  refused(mesh, areasOnDisc({ { { 0, 0 }, { 1, 1 } } }), Failure::MissingArray, "no array VertexId");
  refused(mesh,
    areasOnDisc({ { { 0, 0 } }, { { 1, 1 } } }),
    Failure::BadStroke,
    "There are 2 polylines where the reference curve is one");
  refused(mesh, toPolyData(scene.mesh), Failure::BadStroke, "must be polylines and no other cells");
  vtkNew<vtkPolyData> nothing;
  refused(mesh, nothing, Failure::BadStroke, "must be polylines and no other cells");
  refused(toPolyData(scene.mesh), curve, Failure::MissingArray, "no array EditRegion");
  Scene wrong = scene;
  wrong.labels[7] = 3;
  refused(meshOf(wrong), curve, Failure::BadRegion, "EditRegion of vertex 7 is not 0");
  wrong = scene;
  wrong.mesh.points[210][1] = std::nan("");
  refused(meshOf(wrong), curve, Failure::BadMesh, "Point 210 of the mesh is not finite");
  wrong = scene;
  for (Vector3& p : wrong.mesh.points)
    p = Vector3::Zero();
  refused(meshOf(wrong), curve, Failure::BadRegion, "has no area");
  const auto nan = toChain(scene.mesh, scene.reference);
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("VertexId");
  ids->InsertNextValue(std::nan(""));
  ids->InsertNextValue(0.5);
  ids->InsertNextValue(1.0);
  nan->GetPointData()->AddArray(ids);
  refused(mesh, nan, Failure::BadStroke, "Point 0 of the reference curve is no vertex of the mesh");
  ids->SetValue(0, 0.0);
  refused(mesh, nan, Failure::BadStroke, "Point 1 of the reference curve is no vertex of the mesh");
  const auto quads = meshOf(scene);
  vtkNew<vtkCellArray> polys;
  const vtkIdType corners[4] = { 0, 1, 22, 21 };
  polys->InsertNextCell(4, corners);
  quads->SetPolys(polys);
  refused(quads, curve, Failure::BadMesh, "is not a triangle");
  const auto cells = meshOf(scene);
  vtkNew<vtkUnsignedCharArray> few;
  few->SetName("EditRegion");
  few->InsertNextValue(2);
  cells->GetCellData()->AddArray(few);
  refused(cells, curve, Failure::MissingArray, "Array EditRegion of the mesh's cells has 1 tuples");

  Flattened made(scene);
  expectCancel(made.filter, 0.2);
  made.filter->Update();
  EXPECT_GT(made.filter->GetDiscOutput()->GetNumberOfPoints(), 0);
  made.filter->SetInputData(nothing);
  Ear ear(made.filter);
  made.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(made.filter->GetDiscOutput()->GetNumberOfPoints(), 0);
}

TEST(FlattenFilter, ARegionOfOneVertexAndTinyOrHugeOnesAreDiscs)
{
  // What is round a vertex, at 1e-7 and 5e6.
  for (const double scale : { 1.0, 1e-7, 5e6 })
  {
    Scene scene = gridScene(
      20, [](int i, int j) { return i >= 9 && i < 11 && j >= 9 && j < 11; }, { 10 * 21 + 10, 10 * 21 + 10 });
    for (Vector3& p : scene.mesh.points)
      p *= scale;
    Flattened made(scene);
    made.filter->Update();
    EXPECT_EQ(made.filter->GetErrorCode(), 0u);
    EXPECT_EQ(made.filter->GetDiscOutput()->GetNumberOfCells(), 8);
  }
}
