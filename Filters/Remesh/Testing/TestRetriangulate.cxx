// Facts of editors.md, section 13 (retriangulation), of the filter: edit after edit on one mesh.
#include "Harness/chains.h"
#include "Harness/enclosures.h"
#include "Harness/promises.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRetriangulate.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> withEditRegion(const Enclosure& scene)
{
  auto mesh = toPolyData(scene.mesh);
  vtkNew<vtkUnsignedCharArray> region;
  region->SetName("EditRegion");
  const double reach = distanceTo(scene.mesh, scene.boundary, Vector3::Zero());
  for (const Vector3& p : scene.mesh.points)
  {
    // Within a hexagon: by its six sides.
    double outermost = 0.0;
    for (int side = 0; side < 6; ++side)
    {
      const double angle = pi / 6.0 + side * pi / 3.0;
      outermost = std::max(outermost, p.dot(Vector3(std::cos(angle), std::sin(angle), 0)));
    }
    region->InsertNextValue(outermost < reach - 0.1 ? 2 : outermost < reach + 0.1 ? 1 : 0);
  }
  mesh->GetPointData()->AddArray(region);
  vtkNew<vtkDoubleArray> meanEdge;
  meanEdge->SetName("MeanEdge");
  meanEdge->InsertNextValue(1.0);
  mesh->GetFieldData()->AddArray(meanEdge);
  return mesh;
}

std::vector<char> labelsOf(vtkPolyData* mesh)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray("EditRegion");
  std::vector<char> labels;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    labels.push_back(static_cast<char>(array->GetComponent(v, 0)));
  }
  return labels;
}

// The mesh with its region lifted along z by a height at the reference curve.
vtkSmartPointer<vtkPolyData> lifted(vtkPolyData* mesh,
  vtkPolyData* reference,
  vtkPolyData* boundary,
  double height)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(mesh);
  const Enclosure scene{ MeshOf(mesh), chainOf(reference), chainOf(boundary) };
  const std::vector<double> shares = sharesOf(scene, labelsOf(mesh));
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    const double s = shares[v];
    if (s < 1.0)
    {
      const Vector3 p = scene.mesh.points[v] + Vector3(0, 0, height * (1.0 - 3.0 * s * s + 2.0 * s * s * s));
      moved->GetPoints()->SetPoint(v, p.data());
    }
  }
  return moved;
}

struct Redone
{
  vtkSmartPointer<vtkPolyData> rest, moved, reference, boundary;
  vtkNew<vtkOversketchRetriangulate> filter;

  Redone(const Enclosure& scene, double height)
    : rest(withEditRegion(scene))
    , reference(toChain(scene.mesh, scene.reference))
    , boundary(toChain(scene.mesh, scene.boundary))
  {
    this->moved = lifted(this->rest, this->reference, this->boundary, height);
    this->connect();
  }
  void connect()
  {
    this->filter->SetInputData(this->moved);
    this->filter->SetReferenceData(this->reference);
    this->filter->SetBoundaryData(this->boundary);
    this->filter->SetRestData(this->rest);
  }
  // The result is edited anew.
  void again(double height)
  {
    const auto copied = [](vtkPolyData* data)
    {
      auto copy = vtkSmartPointer<vtkPolyData>::New();
      copy->DeepCopy(data);
      return copy;
    };
    this->rest = copied(this->filter->GetOutput());
    this->reference = copied(this->filter->GetReferenceOutput());
    this->boundary = copied(this->filter->GetBoundaryOutput());
    this->moved = lifted(this->rest, this->reference, this->boundary, height);
    this->connect();
  }
};

// Points outside or on the boundary, in their order.
std::vector<Vector3> keptPoints(vtkPolyData* mesh)
{
  const std::vector<char> labels = labelsOf(mesh);
  std::vector<Vector3> kept;
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    if (labels[v] != 2)
    {
      kept.emplace_back(mesh->GetPoint(v));
    }
  }
  return kept;
}

bool ascends(vtkPolyData* curve)
{
  vtkDataArray* shares = curve->GetPointData()->GetArray("CurveT");
  bool rising = shares->GetComponent(0, 0) == 0.0;
  for (vtkIdType i = 1; i < shares->GetNumberOfTuples(); ++i)
  {
    rising = rising && shares->GetComponent(i, 0) > shares->GetComponent(i - 1, 0);
  }
  return rising && shares->GetComponent(shares->GetNumberOfTuples() - 1, 0) <= 1.0;
}

} // namespace

TEST(B11_1, TenEditsLeaveASoundMesh)
{
  for (const int rule : { vtkOversketchRetriangulate::Edit, vtkOversketchRetriangulate::Curvature })
  {
    const Enclosure scene = sheet(12);
    Redone redone(scene, 4.0);
    redone.filter->SetRule(rule);
    const std::vector<Vector3> kept = keptPoints(redone.rest);
    const int euler = eulerNumber(scene.mesh.triangles);
    vtkIdType operations = 0, most = 0;
    for (int edit = 0; edit < 10; ++edit)
    {
      SCOPED_TRACE("rule " + std::to_string(rule) + ", edit " + std::to_string(edit));
      redone.filter->Update();
      ASSERT_EQ(redone.filter->GetErrorCode(), 0u);
      vtkPolyData* output = redone.filter->GetOutput();
      const Mesh mesh = MeshOf(output);
      operations += redone.filter->GetOperationCount();
      most = std::max<vtkIdType>(most, mesh.triangleCount());
      EXPECT_EQ(output->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0), 1.0);
      EXPECT_TRUE(isManifold(mesh));
      EXPECT_EQ(eulerNumber(mesh.triangles), euler);
      int turned = 0;
      for (int t = 0; t < mesh.triangleCount(); ++t)
      {
        turned += facetNormal(mesh, t)[2] > 0.0 ? 0 : 1; // the edits lift a sheet straight up
      }
      EXPECT_EQ(turned, 0);
      EXPECT_EQ(keptPoints(output), kept);
      for (vtkPolyData* curve : { redone.filter->GetReferenceOutput(), redone.filter->GetBoundaryOutput() })
      {
        const std::vector<int> chain = chainOf(curve);
        EXPECT_TRUE(isChainOfEdges(mesh, chain));
        EXPECT_TRUE(ascends(curve));
        for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
        {
          EXPECT_EQ(Vector3(curve->GetPoint(i)), mesh.points[chain[i]]);
        }
      }
      EXPECT_EQ(chainOf(redone.filter->GetBoundaryOutput()).front(),
        chainOf(redone.filter->GetBoundaryOutput()).back());
      redone.again(edit % 2 == 0 ? -3.0 : 4.0);
    }
    EXPECT_GT(operations, 100);
    fact("B11_1",
      std::string(rule == vtkOversketchRetriangulate::Edit ? "ten edits" : "ten by curvature") + ": " +
        std::to_string(operations) + " operations, at most " + std::to_string(most) +
        " faces; MeanEdge, Euler number, points outside to the bit, curves of edges");
  }
}

TEST(B11_3, WithoutAMotionTheInputComesOut)
{
  Redone still(sheet(10), 0.0);
  still.filter->Update();
  ASSERT_EQ(still.filter->GetErrorCode(), 0u);
  EXPECT_EQ(still.filter->GetOperationCount(), 0);
  EXPECT_EQ(MeshOf(still.filter->GetOutput()).points, MeshOf(still.moved).points);
  EXPECT_EQ(MeshOf(still.filter->GetOutput()).triangles, MeshOf(still.moved).triangles);
  EXPECT_EQ(still.filter->GetOutput()->GetPoints(), still.moved->GetPoints());
  EXPECT_EQ(chainOf(still.filter->GetReferenceOutput()), chainOf(still.reference));
  fact("B11_3", "the filter without a motion hands its input on");
}

TEST(Retriangulate, ArraysAreInterpolated)
{
  Redone redone(sheet(12), 10.0);
  vtkNew<vtkDoubleArray> linear, normals;
  linear->SetName("Linear");
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> ids, cells;
  ids->SetName("Ids");
  cells->SetName("Cells");
  vtkNew<vtkFloatArray> texture;
  texture->SetName("Texture");
  texture->SetNumberOfComponents(2);
  for (vtkIdType v = 0; v < redone.moved->GetNumberOfPoints(); ++v)
  {
    const Vector3 p(redone.moved->GetPoint(v));
    linear->InsertNextValue(1.0 + p[0] - 2.0 * p[1]);
    normals->InsertNextTuple3(0.6, 0.0, 0.8);
    ids->InsertNextValue(static_cast<int>(v));
    texture->InsertNextTuple2(p[0], p[1]);
  }
  for (vtkIdType t = 0; t < redone.moved->GetNumberOfCells(); ++t)
  {
    cells->InsertNextValue(static_cast<int>(t));
  }
  vtkPointData* data = redone.moved->GetPointData();
  data->AddArray(linear);
  data->SetNormals(normals);
  data->SetTCoords(texture);
  data->SetGlobalIds(ids);
  redone.moved->GetCellData()->AddArray(cells);
  const Mesh before = MeshOf(redone.moved), rest = MeshOf(redone.rest);
  redone.filter->Update();
  ASSERT_EQ(redone.filter->GetErrorCode(), 0u);
  vtkPolyData* output = redone.filter->GetOutput();
  const Mesh after = MeshOf(output);
  EXPECT_GT(after.triangleCount(), before.triangleCount() + 100);
  EXPECT_EQ(output->GetPointData()->GetGlobalIds(), nullptr);
  ASSERT_NE(output->GetPointData()->GetNormals(), nullptr);
  ASSERT_NE(output->GetPointData()->GetTCoords(), nullptr);
  for (vtkIdType v = 0; v < output->GetNumberOfPoints(); ++v)
  {
    // The sheet is lifted straight up.
    const Vector3 p(output->GetPoint(v));
    EXPECT_NEAR(
      output->GetPointData()->GetArray("Linear")->GetComponent(v, 0), 1.0 + p[0] - 2.0 * p[1], 1e-9);
    EXPECT_NEAR(output->GetPointData()->GetTCoords()->GetComponent(v, 0), p[0], 1e-5);
    EXPECT_NEAR(Vector3(output->GetPointData()->GetNormals()->GetTuple(v)).norm(), 1.0, 1e-12);
    const double label = output->GetPointData()->GetArray("EditRegion")->GetComponent(v, 0);
    EXPECT_TRUE(label == 0.0 || label == 1.0 || label == 2.0);
  }
  for (int t = 0; t < after.triangleCount(); ++t)
  {
    const Triangle &c = after.triangles[t], &s = rest.triangles[static_cast<int>(
                                              output->GetCellData()->GetArray("Cells")->GetComponent(t, 0))];
    const Vector3 middle = (after.points[c[0]] + after.points[c[1]] + after.points[c[2]]) / 3.0;
    // Over the triangle, whose corners are 0.58 from its middle.
    const Vector3 source = (rest.points[s[0]] + rest.points[s[1]] + rest.points[s[2]]) / 3.0;
    EXPECT_LT((middle - source).head<2>().norm(), 0.58);
  }
}

TEST(Retriangulate, FilterSameForAnyNumberOfThreadsAndKept)
{
  std::vector<Mesh> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        Redone redone(sheet(12), 8.0);
        redone.filter->Update();
        results.push_back(MeshOf(redone.filter->GetOutput()));
      });
  }
  EXPECT_EQ(results[0].points, results[1].points);
  EXPECT_EQ(results[0].triangles, results[1].triangles);
  Redone redone(sheet(12), 8.0);
  redone.filter->Update();
  vtkPoints* points = redone.filter->GetOutput()->GetPoints();
  redone.filter->Modified();
  redone.filter->Update();
  EXPECT_EQ(redone.filter->GetOutput()->GetPoints(), points);
  EXPECT_EQ(redone.filter->GetRetriangulationCount(), 1);
  redone.filter->SetRuleToCurvature();
  redone.filter->Update();
  EXPECT_EQ(redone.filter->GetRetriangulationCount(), 2);
}

TEST(Retriangulate, FilterRefusesAndCancels)
{
  const struct
  {
    const char* words;
    Failure failure;
    std::function<void(Redone&)> spoil;
  } cases[] = {
    { "EditRegion",
      Failure::MissingArray,
      [](Redone& r) { r.moved->GetPointData()->RemoveArray("EditRegion"); } },
    { "EditRegion of vertex 7",
      Failure::BadRegion,
      [](Redone& r) { r.moved->GetPointData()->GetArray("EditRegion")->SetComponent(7, 0, 5.0); } },
    { "MeanEdge",
      Failure::MissingArray,
      [](Redone& r) { r.moved->GetFieldData()->RemoveArray("MeanEdge"); } },
    { "VertexId",
      Failure::MissingArray,
      [](Redone& r) { r.boundary->GetPointData()->RemoveArray("VertexId"); } },
    { "Point 1 of the reference curve",
      Failure::BadStroke,
      [](Redone& r) { r.reference->GetPointData()->GetArray("VertexId")->SetComponent(1, 0, 1e7); } },
    { "Rule Edit needs the mesh before",
      Failure::BadMesh,
      [](Redone& r) { r.filter->SetRestData(nullptr); } },
    { "other triangles",
      Failure::BadMesh,
      [](Redone& r) { r.filter->SetRestData(toPolyData(icosphere(1))); } },
    { "Point 3", Failure::BadMesh, [](Redone& r) { r.moved->GetPoints()->SetPoint(3, NAN, 0, 0); } },
  };
  for (const auto& each : cases)
  {
    Redone redone(sheet(8), 4.0);
    each.spoil(redone);
    expectRefusal(redone.filter, each.failure, each.words);
  }
  Redone redone(sheet(8), 4.0);
  expectCancel(redone.filter, 0.2);
  redone.filter->Update();
  EXPECT_GT(redone.filter->GetOutput()->GetNumberOfPoints(), 0);
  redone.filter->SetRuleToCurvature();
  redone.filter->SetRestData(nullptr);
  redone.filter->Update();
  EXPECT_EQ(redone.filter->GetErrorCode(), 0u);
  vtkNew<vtkPolyData> empty;
  redone.filter->SetInputData(empty);
  Ear ear(redone.filter);
  redone.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(redone.filter->GetOutput()->GetNumberOfPoints(), 0);
}
