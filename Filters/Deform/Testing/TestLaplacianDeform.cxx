#include "Harness/promises.h"
#include "vtkOversketchLaplacianDeform.h"

#include "Mesh/context.h"
#include "Mesh/place.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

bool sameBits(const void* a, const void* b, std::size_t bytes)
{
  return std::memcmp(a, b, bytes) == 0;
}

// A sphere whose cap z > 0.2 is the region, with handles on edges of a meridian in the plane x = 0.
struct Scene
{
  Mesh mesh = icosphere(4);
  vtkSmartPointer<vtkPolyData> input;
  vtkNew<vtkPolyData> handles;
  vtkNew<vtkOversketchLaplacianDeform> filter;
  std::vector<Binding> bindings;

  explicit Scene(const std::function<Vector3(const Vector3&)>& move = [](const Vector3& q)
                 { return Vector3(q + Vector3(0, 0.3, 0.4)); })
  {
    const auto normals = vertexNormals(this->mesh);
    this->input = toPolyData(this->mesh, &normals);
    this->setRegion([](const Vector3& p) { return p[2] > 0.2; });
    const Adjacency adjacency = buildAdjacency(this->mesh);
    for (const MeshEdge& e : adjacency.edges)
    {
      const double a = this->mesh.points[e.v0][0], b = this->mesh.points[e.v1][0];
      if (this->mesh.points[e.v0][2] > 0.6 && a * b < 0.0)
      {
        this->bindings.push_back(Binding::edge(e.v0, e.v1, b / (b - a)));
      }
    }
    this->setHandles(move);
    this->filter->SetInputData(this->input);
    this->filter->SetHandlesData(this->handles);
  }

  void setRegion(const std::function<bool(const Vector3&)>& inside)
  {
    vtkNew<vtkUnsignedCharArray> region;
    region->SetName("Region");
    for (const Vector3& p : this->mesh.points)
    {
      region->InsertNextValue(inside(p));
    }
    this->input->GetPointData()->AddArray(region);
  }

  void setHandles(const std::function<Vector3(const Vector3&)>& move)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkIdTypeArray> vertices;
    vertices->SetName("MeshVertices");
    vertices->SetNumberOfComponents(3);
    vtkNew<vtkDoubleArray> weights, targets;
    weights->SetName("MeshWeights");
    targets->SetName("Target");
    weights->SetNumberOfComponents(3);
    targets->SetNumberOfComponents(3);
    for (const Binding& binding : this->bindings)
    {
      const Vector3 q = binding.of(this->mesh.points);
      points->InsertNextPoint(q.data());
      targets->InsertNextTuple(move(q).data());
      weights->InsertNextTuple(binding.weights.data());
      for (const int v : binding.vertices)
      {
        vertices->InsertNextValue(v);
      }
    }
    this->handles->SetPoints(points);
    this->handles->GetPointData()->AddArray(vertices);
    this->handles->GetPointData()->AddArray(weights);
    this->handles->GetPointData()->AddArray(targets);
  }

  std::vector<Vector3> run()
  {
    this->filter->Update();
    std::vector<Vector3> points(static_cast<std::size_t>(this->filter->GetOutput()->GetNumberOfPoints()));
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      this->filter->GetOutput()->GetPoint(static_cast<vtkIdType>(v), points[v].data());
    }
    return points;
  }
};

} // namespace

TEST(A10_1, DisplacementsStayInTheViewPlane)
{
  const Vector3 view = Vector3(0.3, -0.5, 0.7).normalized();
  Scene scene([&](const Vector3& q) { return Vector3(q + 0.4 * view.cross(Vector3(q[1], 1.0, q[0]))); });
  const auto points = scene.run();
  double worst = 0.0, most = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    worst = std::max(worst, std::abs((points[v] - scene.mesh.points[v]).dot(view)));
    most = std::max(most, (points[v] - scene.mesh.points[v]).norm());
  }
  EXPECT_GT(most, 0.3);
  EXPECT_LT(worst, 1e-9);
  fact("A10_1", "largest displacement along the view normal " + std::to_string(worst * 1e15) + "e-15");
}

TEST(A10_1, DoubledTargetsDoubleDisplacements)
{
  const Vector3 d(0.1, 0.2, 0.3);
  Scene scene([&](const Vector3& q) { return Vector3(q + d); });
  const auto once = scene.run();
  scene.setHandles([&](const Vector3& q) { return Vector3(q + 2.0 * d); });
  const auto twice = scene.run();
  double worst = 0.0;
  for (std::size_t v = 0; v < once.size(); ++v)
  {
    const Vector3& x = scene.mesh.points[v];
    worst = std::max(worst, ((twice[v] - x) - 2.0 * (once[v] - x)).norm());
  }
  EXPECT_LT(worst, 1e-12);
}

TEST(A10_1, ZeroTargetsReturnTheInputBitForBit)
{
  for (const bool adjust : { false, true })
  {
    Scene scene([](const Vector3& q) { return q; });
    scene.filter->SetAdjustNormals(adjust);
    EXPECT_EQ(scene.run(), scene.mesh.points);
    vtkDataArray* before = scene.input->GetPointData()->GetNormals();
    vtkDataArray* after = scene.filter->GetOutput()->GetPointData()->GetNormals();
    EXPECT_TRUE(sameBits(before->GetVoidPointer(0),
      after->GetVoidPointer(0),
      static_cast<std::size_t>(before->GetNumberOfValues()) * sizeof(double)));
  }
}

TEST(A10_1, VerticesOutsideTheRegionKeepTheirBits)
{
  for (const bool adjust : { false, true })
  {
    Scene scene;
    scene.filter->SetAdjustNormals(adjust);
    const auto points = scene.run();
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      if (scene.mesh.points[v][2] <= 0.2)
      {
        EXPECT_TRUE(sameBits(points[v].data(), scene.mesh.points[v].data(), sizeof(Vector3)));
      }
    }
  }
}

TEST(A10_2, AdjustedNormalsMoveVerticesAlongTheViewNormal)
{
  const Vector3 view(1, 0, 0);
  double worst[2] = { 0.0, 0.0 };
  for (const bool adjust : { false, true })
  {
    Scene scene;
    scene.filter->SetAdjustNormals(adjust);
    const auto points = scene.run();
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      worst[adjust] = std::max(worst[adjust], std::abs((points[v] - scene.mesh.points[v]).dot(view)));
    }
  }
  EXPECT_LT(worst[0], 1e-9);
  EXPECT_GT(worst[1], 0.01);
  fact("A10_2", "out of plane " + std::to_string(worst[1]) + " of the radius with AdjustNormals");
}

TEST(A10_2, ASimilarityOfAllConstraintsIsReproducedOnlyWithAdjustedNormals)
{
  // The whole sphere is the region: its only constraints are the handles, and all follow x -> 1.1 x + t.
  const auto move = [](const Vector3& q) { return Vector3(1.1 * q + Vector3(0.2, -0.1, 0.3)); };
  double worst[2] = { 0.0, 0.0 };
  for (const bool adjust : { false, true })
  {
    Scene scene(move);
    scene.setRegion([](const Vector3&) { return true; });
    // The ring that the region would end at, as constraints too.
    for (int v = 0; v < scene.mesh.vertexCount(); ++v)
    {
      if (std::abs(scene.mesh.points[v][2]) < 0.05)
      {
        scene.bindings.push_back(Binding::vertex(v));
      }
    }
    scene.setHandles(move);
    scene.filter->SetAdjustNormals(adjust);
    const auto points = scene.run();
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      worst[adjust] = std::max(worst[adjust], (points[v] - move(scene.mesh.points[v])).norm());
    }
  }
  EXPECT_LT(worst[1], 1e-8);
  EXPECT_GT(worst[0], 1e-2);
  fact("A10_2",
    "x -> 1.1 x + t reproduced to " + std::to_string(worst[1] * 1e12) + "e-12 on, " +
      std::to_string(worst[0]) + " off");
}

TEST(A10_3, HandlesComeWithinTwoPerCent)
{
  Scene scene;
  scene.run();
  EXPECT_EQ(scene.filter->GetActiveHandleCount(), static_cast<vtkIdType>(scene.bindings.size()));
  EXPECT_GT(scene.filter->GetMeanHandleResidual(), 0.0);
  EXPECT_LT(scene.filter->GetMeanHandleResidual(), 0.02 * 0.5);
  EXPECT_GE(scene.filter->GetMaximumHandleResidual(), scene.filter->GetMeanHandleResidual());
  fact("A10_3",
    "mean handle residual " + std::to_string(scene.filter->GetMeanHandleResidual() / 0.5 * 100) +
      " % of the displacement on a sphere");
}

TEST(LaplacianDeform, FactorsOnceForManyTargets)
{
  Scene scene;
  scene.run();
  auto* filter = scene.filter.Get();
  EXPECT_EQ(filter->GetFactorizationCount(), 1);
  EXPECT_EQ(filter->GetSolveCount(), 1);
  scene.setHandles([](const Vector3& q) { return Vector3(1.2 * q); });
  const auto moved = scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 1);
  EXPECT_EQ(filter->GetSolveCount(), 2);
  // The kept factor gives what a new filter computes, bit for bit.
  Scene fresh([](const Vector3& q) { return Vector3(1.2 * q); });
  EXPECT_EQ(fresh.run(), moved);

  // A changed colour runs nothing again and gives the same objects.
  vtkPoints* points = filter->GetOutput()->GetPoints();
  vtkDataArray* normals = filter->GetOutput()->GetPointData()->GetNormals();
  vtkNew<vtkFloatArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(scene.mesh.vertexCount());
  scene.input->GetPointData()->AddArray(colour);
  scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 1);
  EXPECT_EQ(filter->GetSolveCount(), 2);
  EXPECT_EQ(filter->GetOutput()->GetPoints(), points);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals(), normals);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Colour"), colour);

  // An equal region in a new array keeps the factor; another region, section or weight does not.
  scene.setRegion([](const Vector3& p) { return p[2] > 0.2; });
  scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 1);
  scene.setRegion([](const Vector3& p) { return p[2] > 0.1; });
  scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 2);
  EXPECT_EQ(filter->GetAnalysisCount(), 2);
  scene.bindings.pop_back();
  scene.setHandles([](const Vector3& q) { return Vector3(1.2 * q); });
  scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 3);
  filter->SetHandleWeight(5.0);
  const auto softer = scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 4);
  // Neither needs another order of elimination, and the kept one gives what a new filter computes.
  EXPECT_EQ(filter->GetAnalysisCount(), 2);
  fresh.setRegion([](const Vector3& p) { return p[2] > 0.1; });
  fresh.bindings.pop_back();
  fresh.setHandles([](const Vector3& q) { return Vector3(1.2 * q); });
  fresh.filter->SetHandleWeight(5.0);
  EXPECT_EQ(fresh.run(), softer);
  scene.input->GetPoints()->SetPoint(3, 0.0, 0.0, 1.5);
  scene.input->GetPoints()->Modified();
  scene.run();
  EXPECT_EQ(filter->GetFactorizationCount(), 5);
  EXPECT_EQ(filter->GetAnalysisCount(), 3);
}

TEST(LaplacianDeform, FiltersOfOneRegionShareItsAnalysis)
{
  Scene scene;
  scene.run();
  // Other handles on the same mesh and region, as a correction asks for them.
  vtkNew<vtkPolyData> others;
  const Scene other([](const Vector3& q) { return Vector3(q + Vector3(0.1, 0.2, 0.3)); });
  others->DeepCopy(other.handles);
  vtkNew<vtkOversketchLaplacianDeform> second;
  second->SetInputData(scene.input);
  second->SetHandlesData(others);
  second->SetHandleWeight(3.0);
  second->Update();
  EXPECT_EQ(second->GetAnalysisCount(), 0);
  EXPECT_EQ(second->GetFactorizationCount(), 1);
  // The same bits as alone.
  Scene alone([](const Vector3& q) { return Vector3(q + Vector3(0.1, 0.2, 0.3)); });
  alone.filter->SetHandleWeight(3.0);
  const auto expected = alone.run();
  EXPECT_EQ(alone.filter->GetAnalysisCount(), 1);
  for (vtkIdType v = 0; v < second->GetOutput()->GetNumberOfPoints(); ++v)
  {
    Vector3 p;
    second->GetOutput()->GetPoint(v, p.data());
    EXPECT_EQ(p, expected[static_cast<std::size_t>(v)]);
  }
}

TEST(LaplacianDeform, DraggingIsWhatAnUpdateWithMovedTargetsGives)
{
  for (const bool adjust : { false, true })
  {
    Scene scene;
    scene.filter->SetAdjustNormals(adjust);
    const Ear ear(scene.filter);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    EXPECT_FALSE(scene.filter->Drag(Vector3(1, 0, 0).data(), points));
    const auto before = scene.run();
    EXPECT_FALSE(scene.filter->Drag(Vector3(1, 0, 0).data(), points));
    EXPECT_FALSE(scene.filter->Drag(Vector3(1, 0, 0).data(), nullptr));
    EXPECT_EQ(ear.errors.size(), 3u);
    points->DeepCopy(scene.filter->GetOutput()->GetPoints());
    for (const Vector3& d : { Vector3(0.1, -0.2, 0.05), Vector3(-0.3, 0.0, 0.2) })
    {
      ASSERT_TRUE(scene.filter->Drag(d.data(), points));
      Scene moved([&](const Vector3& q) { return Vector3(q + Vector3(0, 0.3, 0.4) + d); });
      moved.filter->SetAdjustNormals(adjust);
      const auto expected = moved.run();
      double worst = 0.0;
      for (std::size_t v = 0; v < expected.size(); ++v)
      {
        Vector3 place;
        points->GetPoint(static_cast<vtkIdType>(v), place.data());
        worst = std::max(worst, (place - expected[v]).norm());
      }
      EXPECT_LT(worst, 1e-9);
    }
    // One solve served all places; the output stands, bit for bit.
    EXPECT_EQ(scene.filter->GetSolveCount(), 2);
    EXPECT_EQ(scene.filter->GetFactorizationCount(), 1);
    EXPECT_EQ(scene.run(), before);
  }
}

TEST(LaplacianDeform, AReleasedFactorLeavesTheDragAndReleasedWorkIsMadeAnew)
{
  const Vector3 by(0.1, -0.2, 0.05);
  Scene scene, kept;
  const auto before = scene.run();
  EXPECT_EQ(kept.run(), before);
  const auto dragged = [&by](Scene& of)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->DeepCopy(of.filter->GetOutput()->GetPoints());
    EXPECT_TRUE(of.filter->Drag(by.data(), points));
    std::vector<Vector3> places(static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (std::size_t v = 0; v < places.size(); ++v)
    {
      points->GetPoint(static_cast<vtkIdType>(v), places[v].data());
    }
    return places;
  };
  const auto places = dragged(kept);
  EXPECT_NE(places, before);

  // Neither the drag nor a run with nothing new needs the factor.
  auto* filter = scene.filter.Get();
  filter->ReleaseFactor();
  EXPECT_EQ(dragged(scene), places);
  filter->Modified();
  EXPECT_EQ(scene.run(), before);
  EXPECT_EQ(dragged(scene), places);
  EXPECT_EQ(filter->GetFactorizationCount(), 1);
  // Other targets do, and get the same one.
  const auto further = [](const Vector3& q) { return Vector3(1.2 * q); };
  scene.setHandles(further);
  kept.setHandles(further);
  EXPECT_EQ(scene.run(), kept.run());
  EXPECT_EQ(filter->GetFactorizationCount(), 2);
  EXPECT_EQ(kept.filter->GetFactorizationCount(), 1);
  EXPECT_EQ(dragged(scene), dragged(kept));

  filter->ReleaseWork();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPoints> points;
  points->DeepCopy(kept.filter->GetOutput()->GetPoints());
  {
    const Ear ear(scene.filter);
    EXPECT_FALSE(filter->Drag(by.data(), points));
    EXPECT_EQ(ear.errors.size(), 1u);
  }
  EXPECT_EQ(scene.run(), kept.run());
  EXPECT_EQ(dragged(scene), dragged(kept));
}

TEST(LaplacianDeform, KeepsTheKindOfPointsAndRecomputesNormals)
{
  Scene scene;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(scene.input->GetPoints());
  scene.input->SetPoints(points);
  scene.filter->Update();
  vtkPolyData* output = scene.filter->GetOutput();
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_NE(output->GetPoints(), points);
  Mesh after = scene.mesh;
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    output->GetPoint(v, after.points[v].data());
  }
  const auto expected = vertexNormals(after);
  double changed = 0.0;
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    Vector3 n, old;
    output->GetPointData()->GetNormals()->GetTuple(v, n.data());
    scene.input->GetPointData()->GetNormals()->GetTuple(v, old.data());
    EXPECT_LT((n - expected[v]).norm(), 1e-5);
    changed = std::max(changed, (n - old).norm());
  }
  EXPECT_GT(changed, 0.1);
}

TEST(LaplacianDeform, OneAndTwoThreadsAgreeBitForBit)
{
  for (const bool adjust : { false, true })
  {
    std::vector<std::vector<Vector3>> results;
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      Scene scene;
      scene.filter->SetAdjustNormals(adjust);
      results.push_back(scene.run());
    }
    vtkSMPTools::Initialize(0);
    EXPECT_EQ(results[0], results[1]);
  }
}

TEST(LaplacianDeform, InputsStayUntouched)
{
  Scene scene;
  vtkNew<vtkPolyData> mesh, handles;
  mesh->DeepCopy(scene.input);
  handles->DeepCopy(scene.handles);
  scene.run();
  const auto same = [](vtkDataArray* a, vtkDataArray* b)
  {
    return a->GetNumberOfValues() == b->GetNumberOfValues() &&
           sameBits(a->GetVoidPointer(0),
             b->GetVoidPointer(0),
             static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize()));
  };
  EXPECT_TRUE(same(mesh->GetPoints()->GetData(), scene.input->GetPoints()->GetData()));
  EXPECT_TRUE(same(mesh->GetPointData()->GetNormals(), scene.input->GetPointData()->GetNormals()));
  EXPECT_TRUE(same(handles->GetPoints()->GetData(), scene.handles->GetPoints()->GetData()));
}

TEST(LaplacianDeform, AnEmptyMeshGivesAnEmptyOutput)
{
  Scene scene;
  Ear ear(scene.filter);
  vtkNew<vtkPolyData> empty;
  scene.filter->SetInputData(empty);
  scene.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(scene.filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LaplacianDeform, RefusesBadInputWithOneMessageAndRecovers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case
  {
    const char* text;
    Failure failure;
    std::function<void(Scene&)> spoil;
  };
  const std::vector<Case> cases = {
    { "Region", Failure::MissingArray, [](Scene& s) { s.input->GetPointData()->RemoveArray("Region"); } },
    { "inside its border",
      Failure::BadRegion,
      [](Scene& s) { s.setRegion([](const Vector3&) { return false; }); } },
    { "No handle",
      Failure::BadRegion,
      [](Scene& s) { s.setRegion([](const Vector3& p) { return p[2] < -0.2; }); } },
    { "no handle", Failure::BadRegion, [](Scene& s) { s.handles->Initialize(); } },
    { "MeshVertices",
      Failure::MissingArray,
      [](Scene& s) { s.handles->GetPointData()->RemoveArray("MeshVertices"); } },
    { "Target", Failure::MissingArray, [](Scene& s) { s.handles->GetPointData()->RemoveArray("Target"); } },
    { "Target",
      Failure::MissingArray,
      [](Scene& s) { s.handles->GetPointData()->GetArray("Target")->SetNumberOfComponents(1); } },
    { "Handle 2",
      Failure::BadMesh,
      [&](Scene& s) { s.handles->GetPointData()->GetArray("Target")->SetComponent(2, 1, nan); } },
    { "Point 1",
      Failure::BadMesh,
      [](Scene& s) { s.handles->GetPointData()->GetArray("MeshVertices")->SetComponent(1, 0, 1e9); } },
    { "Point 0",
      Failure::BadMesh,
      [](Scene& s) { s.handles->GetPointData()->GetArray("MeshWeights")->SetComponent(0, 0, 7.0); } },
    { "Point 5", Failure::BadMesh, [&](Scene& s) { s.input->GetPoints()->SetPoint(5, nan, 0.0, 0.0); } },
    { "not a triangle",
      Failure::BadMesh,
      [](Scene& s)
      {
        const vtkIdType quad[4] = { 0, 1, 2, 3 };
        s.input->GetPolys()->InsertNextCell(4, quad);
      } },
  };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.text);
    Scene scene;
    scene.run();
    c.spoil(scene);
    scene.input->GetPoints()->Modified();
    scene.input->Modified();
    scene.handles->Modified();
    expectRefusal(scene.filter, c.failure, c.text);
    Scene good;
    scene.filter->SetInputData(good.input);
    scene.filter->SetHandlesData(good.handles);
    EXPECT_EQ(scene.run(), good.run());
  }
}

TEST(LaplacianDeform, ACancelledRunIsSilentAndARetryComplete)
{
  Scene scene, other;
  expectCancel(scene.filter);
  EXPECT_EQ(scene.run(), other.run());
}
