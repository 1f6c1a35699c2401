#include "SurfaceTools.h"
#include "vtkOversketchChaikin.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStrokeThinning.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const View front = perspectiveView(Vector3(0, 0, 4), Vector3(0, 1, 0), 40.0);
const View side = orthographicView(Vector3(1, 0, 0.2), Vector3(0, 1, 0), 200.0);

vtkSmartPointer<vtkPolyData> lineOver(const View& view)
{
  return toStroke(straight({ 330, 270 }, { 470, 330 }, 30), view);
}

void expectSameArray(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << a->GetName();
  EXPECT_EQ(std::memcmp(a->GetVoidPointer(0),
              b->GetVoidPointer(0),
              static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())),
    0)
    << a->GetName();
}

// What the curves' arrays promise: places, arc lengths, normals, ids.
void expectSound(vtkPolyData* curves, vtkPolyData* mesh)
{
  vtkPointData* data = curves->GetPointData();
  const auto whole = SharedMesh(mesh);
  vtkIdType corners[3];
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(static_cast<vtkIdType>(data->GetArray("MeshCell")->GetComponent(i, 0)), ids);
    Vector3 place = Vector3::Zero(), normal, weights;
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = static_cast<vtkIdType>(data->GetArray("MeshVertices")->GetComponent(i, k));
      ASSERT_EQ(corners[k], ids->GetId(k));
      const double weight = data->GetArray("MeshWeights")->GetComponent(i, k);
      EXPECT_GE(weight, 0.0);
      sum += weight;
      weights[k] = weight;
      place += weight * Vector3(mesh->GetPoint(corners[k]));
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_EQ(place, Vector3(curves->GetPoint(i)));
    data->GetNormals()->GetTuple(i, normal.data());
    EXPECT_NEAR(normal.norm(), 1.0, 1e-12);
    const std::vector<Vector3>& all = whole->Normals(); // by all faces, where the mesh brings none
    const Vector3 turned = weights[0] * all[static_cast<std::size_t>(corners[0])] +
                           weights[1] * all[static_cast<std::size_t>(corners[1])] +
                           weights[2] * all[static_cast<std::size_t>(corners[2])];
    EXPECT_EQ(normal, Vector3(turned.normalized())) << "to the bit";
  }
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    curves->GetLines()->GetCellAtId(cell, ids);
    EXPECT_EQ(curves->GetCellData()->GetArray("CurveId")->GetComponent(cell, 0), static_cast<double>(cell));
    double arc = 0.0;
    Vector3 before(curves->GetPoint(ids->GetId(0)));
    const bool closed = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds() - closed; ++k)
    {
      const Vector3 place(curves->GetPoint(ids->GetId(k)));
      arc += (place - before).norm();
      before = place;
      EXPECT_NEAR(data->GetArray("ArcLength")->GetComponent(ids->GetId(k), 0), arc, 1e-12 * (1.0 + arc));
    }
  }
}

} // namespace

TEST(SurfaceStroke, ManyStrokesManyViewsAndTheirArrays)
{
  const auto mesh = toPolyData(icosphere(4));
  std::vector<Vector2> ring;
  ring.reserve(50);
  for (int i = 0; i < 50; ++i)
    ring.emplace_back(400 + 60 * std::cos(2 * pi * i / 50), 300 + 60 * std::sin(2 * pi * i / 50));
  const auto strokes =
    toStrokes({ { straight({ 330, 270 }, { 470, 330 }, 30), front }, { ring, side } }, { false, true });
  vtkNew<vtkFloatArray> pressure;
  pressure->SetName("Pressure");
  for (vtkIdType i = 0; i < strokes->GetNumberOfPoints(); ++i)
    pressure->InsertNextValue(i < 30 ? static_cast<float>(i) : 0.5f);
  strokes->GetPointData()->AddArray(pressure);
  vtkNew<vtkDoubleArray> radius, colour;
  radius->SetName("Radius");
  radius->InsertNextValue(0.1);
  radius->InsertNextValue(0.2);
  colour->SetName("Colour");
  colour->InsertNextValue(7);
  colour->InsertNextValue(8);
  strokes->GetCellData()->AddArray(radius);
  strokes->GetCellData()->AddArray(colour);
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetInputData(strokes);
  filter->SetMeshData(mesh);
  filter->Update();
  vtkPolyData* curves = filter->GetOutput();
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  EXPECT_EQ(curves->GetPoints()->GetDataType(), VTK_DOUBLE);
  expectSound(curves, mesh);
  const std::vector<Vector3> first = pointsOfCell(curves, 0), second = pointsOfCell(curves, 1);
  EXPECT_EQ(second.front(), second.back());
  for (const Vector3& p : first)
    EXPECT_GT(p[2], 0.9); // before the first eye
  for (const Vector3& p : second)
    EXPECT_GT(p[0], 0.85); // before the second
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    // The stroke's own place in the picture tells the pressure: 0 to 29 along it.
    const double x = front.toDisplay(first[i])[0];
    EXPECT_NEAR(curves->GetPointData()->GetArray("Pressure")->GetComponent(static_cast<vtkIdType>(i), 0),
      29.0 * (x - 330.0) / 140.0,
      1e-4);
  }
  EXPECT_EQ(curves->GetPointData()->GetArray("Pressure")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(curves->GetCellData()->GetArray("Radius")->GetComponent(1, 0), 0.2);
  EXPECT_EQ(curves->GetCellData()->GetArray("StrokeId")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(curves->GetCellData()->GetArray("Colour"), nullptr);
  EXPECT_EQ(curves->GetCellData()->GetArray("Height"), nullptr);
  EXPECT_EQ(curves->GetCellData()->GetArray("ViewTransform")->GetNumberOfTuples(), 2);
  EXPECT_EQ(curves->GetPointData()->GetNumberOfArrays(), 7);
}

TEST(SurfaceStroke, KeepsItsSceneAndWhatItMade)
{
  const auto mesh = toPolyData(icosphere(4));
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetInputData(lineOver(front));
  filter->SetMeshData(mesh);
  filter->Update();
  const vtkSmartPointer<vtkPoints> points = filter->GetOutput()->GetPoints();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetProjectionCount(), 1) << "the same question";
  EXPECT_EQ(filter->GetOutput()->GetPoints(), points.Get());
  // Another mesh object with the same points and polygons, and a colour that changed.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(mesh);
  vtkNew<vtkDoubleArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(mesh->GetNumberOfPoints());
  colour->Fill(1.0);
  copy->GetPointData()->AddArray(colour);
  filter->SetMeshData(copy);
  filter->Update();
  EXPECT_EQ(filter->GetProjectionCount(), 1);
  // A second stroke, and another tolerance: the scene stands.
  filter->SetInputData(lineOver(side));
  filter->Update();
  filter->SetTolerance(0.0);
  filter->Update();
  EXPECT_EQ(filter->GetProjectionCount(), 3);
  EXPECT_EQ(filter->GetSceneCount(), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 30) << "as published";
  // Normals alone do not change it, points do.
  filter->SetMeshData(toPolyData(icosphere(3)));
  filter->Update();
  EXPECT_EQ(filter->GetSceneCount(), 2);
  // Cold, the same bits.
  vtkNew<vtkOversketchSurfaceStroke> cold;
  cold->SetTolerance(0.0);
  cold->SetInputData(lineOver(side));
  cold->SetMeshData(toPolyData(icosphere(3)));
  cold->Update();
  expectSameArray(cold->GetOutput()->GetPoints()->GetData(), filter->GetOutput()->GetPoints()->GetData());
  vtkNew<vtkDoubleArray> normals;
  normals->DeepCopy(filter->GetOutput()->GetPointData()->GetNormals());
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("Tolerance: 0"), std::string::npos);
  EXPECT_NE(text.str().find("SceneCount: 2"), std::string::npos);
}

TEST(SurfaceStroke, ThreadsDoNotMatter)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 90, 45));
  std::vector<Vector2> scribble;
  scribble.reserve(300);
  for (int i = 0; i < 300; ++i)
    scribble.emplace_back(400 + 150 * std::sin(0.37 * i), 300 + 150 * std::cos(0.23 * i));
  vtkSmartPointer<vtkPolyData> results[2];
  for (int threads = 1; threads <= 2; ++threads)
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchSurfaceStroke> filter;
    filter->SetInputData(toStroke(scribble, front));
    filter->SetMeshData(mesh);
    filter->Update();
    results[threads - 1] = filter->GetOutput();
  }
  vtkSMPTools::Initialize();
  EXPECT_GT(results[0]->GetNumberOfLines(), 3);
  for (const char* name : { "ArcLength", "MeshCell", "MeshVertices", "MeshWeights", "Normals" })
    expectSameArray(results[0]->GetPointData()->GetArray(name), results[1]->GetPointData()->GetArray(name));
  expectSameArray(results[0]->GetPoints()->GetData(), results[1]->GetPoints()->GetData());
}

TEST(SurfaceStroke, RefusesABadHandByName)
{
  const auto mesh = toPolyData(icosphere(3));
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetMeshData(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](vtkPolyData* strokes, const char* words, Failure failure = Failure::BadStroke)
  {
    filter->SetInputData(strokes);
    expectRefusal(filter, failure, words);
  };
  const std::vector<Vector2> good = straight({ 330, 270 }, { 470, 330 }, 30);
  refused(toStrokes({ { good, front }, { straight({ 10, 10 }, { 90, 20 }, 20), front } }),
    "Stroke 1 cannot be used: no two samples in succession lie on the mesh");
  refused(toStroke({ { 400, 300 } }, front), "Stroke 0 cannot be used: it has 1 sample;");
  refused(toStroke({ { 400, 300 }, { 400, 300 } }, front), "no two samples");
  refused(toStroke({ { 400, 300 }, { 410, nan }, { 420, 300 } }, front), "sample 1 is not finite");
  // 100,000 samples that leap over the picture.
  std::vector<Vector2> leaps;
  leaps.reserve(100000);
  for (int i = 0; i < 100000; ++i)
    leaps.emplace_back(400 + 300 * std::sin(1.9 * i), 300 + 200 * std::cos(2.3 * i));
  refused(toStroke(leaps, front), "at most 100000 px are taken");
  const auto blind = lineOver(front);
  blind->GetCellData()->RemoveArray("ViewTransform");
  refused(blind, "Stroke 0 cannot be used: The stroke has no array ViewTransform", Failure::MissingArray);
  const auto flat = lineOver(front);
  flat->GetCellData()->GetArray("ViewTransform")->Fill(0.0);
  refused(flat, "singular");
  const auto broken = lineOver(front);
  broken->GetCellData()->GetArray("ViewTransform")->SetComponent(0, 3, nan);
  refused(broken, "not finite");
  refused(toPolyData(icosphere(1)), "polylines and no other cells");
  filter->SetTolerance(nan);
  refused(lineOver(front), "Tolerance is not finite");
  filter->SetTolerance(-1.0);
  const auto quads = toPolyData(icosphere(1));
  const vtkIdType four[4] = { 0, 1, 2, 3 };
  quads->GetPolys()->InsertNextCell(4, four);
  filter->SetMeshData(quads);
  refused(lineOver(front), "is not a triangle", Failure::BadMesh);
  filter->SetMeshData(toPolyData({ { { 0, 0, 0 }, { 1, 0, 0 } }, {} }));
  refused(lineOver(front), "no two samples");
  vtkNew<vtkPolyData> empty;
  filter->SetMeshData(empty);
  Ear ear(filter);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  filter->SetMeshData(mesh);
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SurfaceStroke, CancelsInEitherHalfAndRunsAgain)
{
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetInputData(lineOver(front));
  filter->SetMeshData(toPolyData(icosphere(5)));
  expectCancel(filter);
  expectCancel(filter, 0.55);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 10);
}

TEST(SurfaceStroke, AHundredThousandSamplesOfARestlessHand)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < 100000; ++i)
  {
    const double t = 1e-5 * i;
    samples.emplace_back(
      250 + 300 * t + 0.3 * std::sin(7.0 * i), 300 + 80 * std::sin(9 * t) + 0.3 * std::sin(11.0 * i));
  }
  const auto mesh = toPolyData(icosphere(5));
  vtkNew<vtkOversketchSurfaceStroke> raw;
  raw->SetInputData(toStroke(samples, front));
  raw->SetMeshData(mesh);
  raw->Update();
  EXPECT_EQ(raw->GetErrorCode(), 0u);
  EXPECT_GE(raw->GetOutput()->GetNumberOfPoints(), 100000);
  vtkNew<vtkOversketchStrokeThinning> thin;
  thin->SetInputData(toStroke(samples, front));
  vtkNew<vtkOversketchChaikin> smooth;
  smooth->SetInputConnection(thin->GetOutputPort());
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetInputConnection(smooth->GetOutputPort());
  filter->SetMeshData(mesh);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 1);
  EXPECT_LT(filter->GetOutput()->GetNumberOfPoints(), 1000);
}

TEST(SurfaceStroke, FarAwayAndTinyModelsGiveTheCurvesOfHome)
{
  const Mesh home = torus(1.0, 0.4, 60, 30);
  vtkNew<vtkOversketchSurfaceStroke> filter;
  filter->SetInputData(toStroke(straight({ 250, 220 }, { 560, 330 }, 60), front));
  filter->SetMeshData(toPolyData(home));
  filter->Update();
  const auto here = vtkSmartPointer<vtkPolyData>::New();
  here->DeepCopy(filter->GetOutput());
  ASSERT_GT(here->GetNumberOfPoints(), 30);
  const struct
  {
    double scale;
    Vector3 shift;
    double tolerance;
  } places[] = {
    { 1e-7, Vector3::Zero(), 1e-9 }, { 1e9, Vector3::Zero(), 1e-9 }, { 1.0, Vector3(5e6, -3e6, 1e6), 1e-6 }
  };
  for (const auto& place : places)
  {
    Mesh away = home;
    for (Vector3& p : away.points)
      p = place.scale * p + place.shift;
    Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
    back.topLeftCorner<3, 3>() /= place.scale;
    back.topRightCorner<3, 1>() = -place.shift / place.scale;
    const View view(front.viewTransform() * back, front.projectionTransform(), front.width(), front.height());
    filter->SetInputData(toStroke(straight({ 250, 220 }, { 560, 330 }, 60), view));
    filter->SetMeshData(toPolyData(away));
    filter->Update();
    vtkPolyData* there = filter->GetOutput();
    ASSERT_EQ(there->GetNumberOfLines(), here->GetNumberOfLines()) << place.scale;
    ASSERT_NEAR(
      static_cast<double>(there->GetNumberOfPoints()), static_cast<double>(here->GetNumberOfPoints()), 2);
    for (vtkIdType cell = 0; cell < here->GetNumberOfLines(); ++cell)
    {
      const Vector3 a = pointsOfCell(here, cell).front(), b = pointsOfCell(there, cell).front();
      EXPECT_NEAR(((b - place.shift) / place.scale - a).norm(), 0.0, place.tolerance);
    }
  }
}

TEST(D3_4, NoSegmentLeapsOnRealModels)
{
  double worst = 0.0, published = 0.0;
  int models = 0, cut = 0;
  for (const char* name : { "bunny_5k.obj",
         "armadillo_29k.obj",
         "spot_5k9.obj",
         "scorpion.ply",
         "man.ply",
         "spring_long.ply",
         "mountain_sheet.ply",
         "hand_closed.obj" })
  {
    const auto model = sharedModel(name);
    if (!model)
      continue;
    ++models;
    const double r = 0.03 * model->GetLength();
    for (const bool perspective : { false, true })
    {
      const View view = viewOfModel(model, perspective);
      std::vector<Vector2> sine;
      sine.reserve(160);
      for (int i = 0; i < 160; ++i)
        sine.emplace_back(80 + 4 * i, 300 + 180 * std::sin(0.09 * i));
      vtkNew<vtkOversketchSurfaceStroke> filter;
      filter->SetInputData(toStrokes({ { sine, view }, { straight({ 60, 240 }, { 740, 350 }, 170), view } }));
      filter->SetMeshData(model);
      filter->Update();
      ASSERT_EQ(filter->GetErrorCode(), 0u) << name;
      expectSound(filter->GetOutput(), model);
      worst = std::max(worst, longestSegment(filter->GetOutput()) / r);
      cut += static_cast<int>(filter->GetOutput()->GetNumberOfLines()) - 2;
      filter->SetTolerance(0.0);
      filter->Update();
      published = std::max(published, longestSegment(filter->GetOutput()) / r);
    }
  }
  if (models == 0)
    GTEST_SKIP() << "the shared models are absent";
  EXPECT_LE(worst, 0.5 + 1e-9);
  EXPECT_GT(published, 1.0);
  fact("D3_4",
    std::to_string(models) + " models, two views, two strokes: cut " + std::to_string(cut) +
      " times, longest segment " + std::to_string(worst) + " r; as published " + std::to_string(published) +
      " r");
}
