#include "Harness/data.h"
#include "Harness/polydata.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRemesh.h"

#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkOBJReader.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Inside = std::function<bool(const Vector3&)>;
using Map = std::function<Vector3(const Vector3&)>;

vtkSmartPointer<vtkDoubleArray> doubles(const char* name,
  const std::vector<double>& values,
  int components = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->InsertNextValue(values[i]);
  }
  return array;
}

// The mesh with its Region and a ShapeDiameter that limits nothing, unless told.
vtkSmartPointer<vtkPolyData> withRegion(const Mesh& mesh, const Inside& inside, double diameter = 1e9)
{
  auto input = toPolyData(mesh);
  vtkNew<vtkUnsignedCharArray> region;
  region->SetName("Region");
  for (const Vector3& p : mesh.points)
  {
    region->InsertNextValue(inside(p) ? 1 : 0);
  }
  input->GetPointData()->AddArray(region);
  input->GetPointData()->AddArray(
    doubles("ShapeDiameter", std::vector<double>(mesh.points.size(), diameter)));
  return input;
}

// Handles on the region's edges that cross the plane x = 0.013 at y > 0, with k = section / target.
vtkSmartPointer<vtkPolyData> handlesOn(vtkPolyData* input, double section, double target)
{
  const Mesh mesh = MeshOf(input);
  const Adjacency adjacency = buildAdjacency(mesh);
  auto handles = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("MeshVertices");
  vertices->SetNumberOfComponents(3);
  std::vector<double> weights, targets;
  vtkDataArray* region = input->GetPointData()->GetArray("Region");
  for (const MeshEdge& e : adjacency.edges)
  {
    const Vector3 &a = mesh.points[e.v0], &b = mesh.points[e.v1];
    if ((a[0] - 0.013) * (b[0] - 0.013) >= 0.0 || a[1] + b[1] < 0.0 || region->GetComponent(e.v0, 0) == 0.0 ||
        region->GetComponent(e.v1, 0) == 0.0)
    {
      continue;
    }
    const double alpha = (b[0] - 0.013) / (b[0] - a[0]);
    const Vector3 p = alpha * a + (1.0 - alpha) * b;
    const vtkIdType id = points->InsertNextPoint(p.data());
    verts->InsertNextCell(1, &id);
    for (const int v : { e.v0, e.v1, e.v0 })
    {
      vertices->InsertNextValue(v);
    }
    weights.insert(weights.end(), { alpha, 1.0 - alpha, 0.0 });
    targets.insert(targets.end(), { p[0], p[1] + 1.0, p[2] });
  }
  handles->SetPoints(points);
  handles->SetVerts(verts);
  handles->GetPointData()->AddArray(vertices);
  handles->GetPointData()->AddArray(doubles("MeshWeights", weights, 3));
  handles->GetPointData()->AddArray(doubles("Target", targets, 3));
  handles->GetFieldData()->AddArray(doubles("SectionLength", { section }));
  handles->GetFieldData()->AddArray(doubles("TargetLength", { target }));
  return handles;
}

struct Remeshed
{
  vtkNew<vtkOversketchRemesh> filter;
  Remeshed(vtkPolyData* input, int stage, vtkPolyData* handles = nullptr)
  {
    this->filter->SetInputData(input);
    this->filter->SetStage(stage);
    if (handles)
    {
      this->filter->SetHandlesData(handles);
    }
  }
  vtkSmartPointer<vtkPolyData> run()
  {
    this->filter->Update();
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->DeepCopy(this->filter->GetOutput());
    return result;
  }
};

std::vector<char> activeOf(vtkPolyData* data, const Mesh& mesh)
{
  std::vector<char> active;
  vtkDataArray* region = data->GetPointData()->GetArray("Region");
  for (const Triangle& t : mesh.triangles)
  {
    active.push_back(
      std::all_of(t.begin(), t.end(), [&](int v) { return region->GetComponent(v, 0) != 0.0; }));
  }
  return active;
}

double smallestAngle(const Mesh& mesh, const Triangle& t)
{
  double smallest = pi;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
    const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
    smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return smallest * 180.0 / pi;
}

struct Quality
{
  int triangles = 0, borderEdges = 0, nonManifoldEdges = 0, folded = 0, euler = 0;
  double narrow = 0.0, smallest = 180.0, meanEdge = 0.0, borderLength = 0.0;
};

// Of the region's triangles: count, share with an angle under 30 degrees, smallest angle, mean edge; of the
// mesh: the rest.
Quality qualityOf(vtkPolyData* data)
{
  const Mesh mesh = MeshOf(data);
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<char> active = activeOf(data, mesh);
  Quality q;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (active[t])
    {
      const double angle = smallestAngle(mesh, mesh.triangles[t]);
      ++q.triangles;
      q.narrow += angle < 30.0 ? 1.0 : 0.0;
      q.smallest = std::min(q.smallest, angle);
    }
  }
  q.narrow /= std::max(1, q.triangles);
  int regionEdges = 0;
  for (std::size_t i = 0; i < adjacency.edges.size(); ++i)
  {
    const MeshEdge& e = adjacency.edges[i];
    const int* faces = adjacency.trianglesBegin(static_cast<int>(i));
    const double length = (mesh.points[e.v0] - mesh.points[e.v1]).norm();
    q.borderEdges += e.triangleCount == 1;
    q.borderLength += e.triangleCount == 1 ? length : 0.0;
    q.nonManifoldEdges += e.triangleCount > 2;
    q.folded += e.triangleCount == 2 &&
                facetNormal(mesh, faces[0]).dot(facetNormal(mesh, faces[1])) < std::cos(100.0 * pi / 180.0);
    if (std::any_of(faces, faces + e.triangleCount, [&](int t) { return active[t] != 0; }))
    {
      ++regionEdges;
      q.meanEdge += length;
    }
  }
  q.meanEdge /= std::max(1, regionEdges);
  q.euler = mesh.vertexCount() - static_cast<int>(adjacency.edges.size()) + mesh.triangleCount();
  return q;
}

void expectOutsideUntouched(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* region = input->GetPointData()->GetArray("Region");
  vtkIdType next = 0;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    if (region->GetComponent(i, 0) == 0.0)
    {
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(input->GetPoint(i)[k], output->GetPoint(next)[k]) << "point " << i;
      }
      ASSERT_EQ(output->GetPointData()->GetArray("Region")->GetComponent(next, 0), 0.0);
      ++next;
    }
  }
  for (; next < output->GetNumberOfPoints(); ++next)
  {
    ASSERT_EQ(output->GetPointData()->GetArray("Region")->GetComponent(next, 0), 1.0);
  }
}

vtkSmartPointer<vtkPolyData> mapped(vtkPolyData* input, const Map& map)
{
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->DeepCopy(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    output->GetPoints()->SetPoint(i, map(Vector3(input->GetPoint(i))).data());
  }
  return output;
}

std::string text(const char* format, double a, double b, double c, double d)
{
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, format, a, b, c, d);
  return buffer;
}

// Everything the filter gives, for comparison bit by bit.
std::vector<double> contentOf(vtkPolyData* data)
{
  std::vector<double> content;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    content.insert(content.end(), data->GetPoint(i), data->GetPoint(i) + 3);
  }
  for (const Triangle& t : MeshOf(data).triangles)
  {
    content.insert(content.end(), t.begin(), t.end());
  }
  for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      for (vtkIdType k = 0; k < array->GetNumberOfTuples() * array->GetNumberOfComponents(); ++k)
      {
        content.push_back(array->GetVariantValue(k).ToDouble());
      }
    }
  }
  return content;
}

const Inside upperHalf = [](const Vector3& p) { return p[2] > -0.05; };

} // namespace

TEST(A11_1, MeanEdgeIsLKAfterStretchAndLAfterRestore)
{
  std::string figures;
  struct Case
  {
    Mesh mesh;
    Inside inside;
    double k;
  };
  const Case cases[] = { { icosphere(4), upperHalf, 0.5 },
    { icosphere(4), upperHalf, 0.3 },
    { torus(1.0, 0.4, 96, 38), upperHalf, 0.5 } };
  for (const Case& c : cases)
  {
    const auto input = withRegion(c.mesh, c.inside);
    const Quality before = qualityOf(input);
    Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handlesOn(input, c.k, 1.0));
    const auto dense = stretch.run();
    EXPECT_NEAR(stretch.filter->GetGuideLength(), before.meanEdge, 1e-12);
    const Quality afterStretch = qualityOf(dense);
    EXPECT_GT(dense->GetNumberOfPoints(), input->GetNumberOfPoints());
    const double a = afterStretch.meanEdge / (c.k * before.meanEdge);
    EXPECT_NEAR(a, 1.0, 0.2);
    Remeshed restore(dense, vtkOversketchRemesh::RESTORE);
    const Quality afterRestore = qualityOf(restore.run());
    EXPECT_EQ(restore.filter->GetGuideLength(), stretch.filter->GetGuideLength());
    const double b = afterRestore.meanEdge / before.meanEdge;
    EXPECT_NEAR(b, 1.0, 0.2);
    figures += text("k %.1f: mean edge %.3f L k, then %.3f L; ", c.k, a, b, 0);
  }
  fact("A11_1", figures);
}

TEST(A11_2, StretchedLimbKeepsItsTrianglesAndTheMeshItsTopology)
{
  struct Case
  {
    std::string name;
    vtkSmartPointer<vtkPolyData> input;
    Map map;
  };
  std::vector<Case> cases;
  const Map lengthen = [](const Vector3& p)
  {
    const double over = std::max(0.0, p[2] - 0.2);
    return Vector3(p[0], p[1] + 0.6 * over * over, p[2] + 3.0 * over * over);
  };
  cases.push_back(
    { "sphere", withRegion(icosphere(4), [](const Vector3& p) { return p[2] > 0.1; }), lengthen });
  cases.push_back({ "open tube",
    withRegion(cylinder(0.3, 2.0, 24, 40), [](const Vector3& p) { return p[2] > 0.1; }),
    lengthen });
  for (const char* name : { "spot_5k9", "armadillo_29k", "hand_closed" })
  {
    const std::string path = sharedData(std::string("meshes/") + name + ".obj");
    if (path.empty())
    {
      std::cout << name << " is absent: set OVERSKETCH_DATA\n";
      continue;
    }
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    reader->GetOutput()->GetPointData()->Initialize();
    const Mesh mesh = MeshOf(reader->GetOutput());
    // A ball round the highest point, the way up lengthened.
    const auto top = std::max_element(
      mesh.points.begin(), mesh.points.end(), [](const Vector3& a, const Vector3& b) { return a[1] < b[1]; });
    const Vector3 centre = *top;
    const double r = 0.25 * boundingDiagonal(mesh);
    cases.push_back({ name,
      withRegion(mesh, [=](const Vector3& p) { return (p - centre).norm() < r; }),
      [=](const Vector3& p)
      {
        const double s = std::max(0.0, 1.0 - (p - centre).norm() / (0.9 * r));
        return Vector3(p + Vector3(0, 2.0 * r * s * s, 0));
      } });
  }
  for (const Case& c : cases)
  {
    const Quality before = qualityOf(c.input);
    const Quality without = qualityOf(mapped(c.input, c.map));
    Remeshed stretch(c.input, vtkOversketchRemesh::STRETCH, handlesOn(c.input, 1.0, 2.5));
    const auto dense = stretch.run();
    const auto deformed = mapped(dense, c.map);
    Remeshed restore(deformed, vtkOversketchRemesh::RESTORE, stretch.filter->GetHandlesOutput());
    const auto result = restore.run();
    expectOutsideUntouched(c.input, dense);
    expectOutsideUntouched(deformed, result);
    const Quality after = qualityOf(result);
    EXPECT_LT(after.narrow, 0.5 * without.narrow) << c.name;
    EXPECT_GT(after.smallest, 4.0) << c.name;
    EXPECT_EQ(after.euler, before.euler) << c.name;
    EXPECT_EQ(after.nonManifoldEdges, 0) << c.name;
    EXPECT_LE(after.folded, std::max(before.folded, without.folded)) << c.name;
    // A border of the mesh is split at most.
    EXPECT_NEAR(after.borderLength, without.borderLength, 1e-9) << c.name;
    EXPECT_EQ(without.borderEdges == 0, after.borderEdges == 0) << c.name;
    fact("A11_2",
      c.name +
        text(": narrow triangles %.3f without, %.4f with both stages; smallest angle %.1f -> %.1f degrees",
          without.narrow,
          after.narrow,
          without.smallest,
          after.smallest));
  }
}

TEST(Remesh, TheSectionKeepsItsPlaceWhenProtected)
{
  const auto input = withRegion(icosphere(3), upperHalf);
  const auto handles = handlesOn(input, 1.0, 3.0);
  ASSERT_GT(handles->GetNumberOfPoints(), 5);
  for (const bool protect : { true, false })
  {
    Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handles);
    stretch.filter->SetProtectSection(protect);
    const auto output = stretch.run();
    vtkPolyData* bound = stretch.filter->GetHandlesOutput();
    ASSERT_EQ(bound->GetNumberOfPoints(), handles->GetNumberOfPoints());
    double drift = 0.0;
    vtkDataArray* vertices = bound->GetPointData()->GetArray("MeshVertices");
    vtkDataArray* weights = bound->GetPointData()->GetArray("MeshWeights");
    for (vtkIdType i = 0; i < bound->GetNumberOfPoints(); ++i)
    {
      Vector3 p = Vector3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        p += weights->GetComponent(i, k) *
             Vector3(output->GetPoint(static_cast<vtkIdType>(vertices->GetComponent(i, k))));
      }
      EXPECT_LT((p - Vector3(bound->GetPoint(i))).norm(), 1e-12);
      drift = std::max(drift, (p - Vector3(handles->GetPoint(i))).norm());
    }
    EXPECT_EQ(bound->GetPointData()->GetArray("Target"), handles->GetPointData()->GetArray("Target"));
    std::cout << "drift " << drift << " with protection " << protect << "\n";
    EXPECT_LT(drift, protect ? 1e-12 : 0.1 * stretch.filter->GetGuideLength());
  }
}

TEST(Remesh, EveryCornerKnowsWhereItCameFromAndChartsKeepTheirSeams)
{
  Mesh mesh = torus(1.0, 0.4, 48, 24);
  const auto input = withRegion(mesh, [](const Vector3& p) { return p[0] > -0.3; });
  vtkNew<vtkIntArray> chart;
  chart->SetName("Chart");
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 m = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
    chart->InsertNextValue((m[1] > 0.0 ? 1 : 0) + (m[2] > 0.0 ? 2 : 0));
  }
  input->GetCellData()->AddArray(chart);
  const auto seams = [](vtkPolyData* data)
  {
    const Mesh m = MeshOf(data);
    const Adjacency adjacency = buildAdjacency(m);
    vtkDataArray* c = data->GetCellData()->GetArray("Chart");
    double length = 0.0;
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
    {
      const int* t = adjacency.trianglesBegin(static_cast<int>(e));
      if (c->GetComponent(t[0], 0) != c->GetComponent(t[1], 0))
      {
        length += (m.points[adjacency.edges[e].v0] - m.points[adjacency.edges[e].v1]).norm();
      }
    }
    return length;
  };
  for (const double k : { 0.4, 1.0 })
  {
    Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handlesOn(input, k, 1.0));
    const auto output = stretch.run();
    const Mesh result = MeshOf(output);
    vtkDataArray* cell = output->GetCellData()->GetArray("SourceCell");
    vtkDataArray* weight = output->GetCellData()->GetArray("SourceWeights");
    vtkDataArray* ownChart = output->GetCellData()->GetArray("Chart");
    EXPECT_NEAR(seams(output), seams(input), 1e-9);
    int identical = 0;
    for (int t = 0; t < result.triangleCount(); ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const int from = static_cast<int>(cell->GetComponent(t, c));
        ASSERT_EQ(chart->GetValue(from), ownChart->GetComponent(t, 0)) << "triangle " << t;
        Vector3 p = Vector3::Zero();
        for (int i = 0; i < 3; ++i)
        {
          p += weight->GetComponent(t, 3 * c + i) * mesh.points[mesh.triangles[from][i]];
        }
        ASSERT_LT((p - result.points[result.triangles[t][c]]).norm(), 1e-13) << "triangle " << t;
        identical += weight->GetComponent(t, 4 * c) == 1.0 && from == cell->GetComponent(t, 0);
      }
    }
    EXPECT_GT(identical, 0);
  }
}

TEST(Remesh, AFinAndABorderStay)
{
  // A wavy sheet with a fin standing on one of its inner edges.
  Mesh mesh = gridSurface(20,
    20,
    false,
    false,
    [](double u, double v) { return Vector3(u - 0.52, v + 0.1, 0.05 * std::sin(6.0 * u)); });
  const int a = 10 * 21 + 10, b = a + 1;
  mesh.points.push_back(0.5 * (mesh.points[a] + mesh.points[b]) + Vector3(0, 0, 0.1));
  mesh.triangles.push_back({ a, b, mesh.vertexCount() - 1 });
  const auto input = withRegion(mesh, [](const Vector3&) { return true; });
  const Quality before = qualityOf(input);
  for (const double k : { 1.0, 0.5 })
  {
    Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handlesOn(input, k, 1.0));
    const Quality after = qualityOf(stretch.run());
    EXPECT_EQ(after.nonManifoldEdges, 1);
    EXPECT_NEAR(after.borderLength, before.borderLength, 1e-12);
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_EQ(after.folded, 0);
  }
}

TEST(Remesh, AThinSheetDoesNotExplodeAndALimitIsFollowed)
{
  const Mesh mesh = icosphere(4);
  const double edge = qualityOf(withRegion(mesh, upperHalf)).meanEdge;
  for (const double diameter : { 1e-9, 0.0, -1.0, 1.6 * edge, 1e9 })
  {
    const auto input = withRegion(mesh, upperHalf, diameter);
    const int before = qualityOf(input).triangles;
    const Quality after = qualityOf(Remeshed(input, vtkOversketchRemesh::RESTORE).run());
    EXPECT_LT(after.triangles, 5 * before) << diameter;
    if (diameter == 1.6 * edge)
    {
      EXPECT_NEAR(after.meanEdge, 0.8 * edge, 0.12 * edge);
    }
    if (diameter <= 0.0 || diameter > 1.0)
    {
      EXPECT_NEAR(after.meanEdge, edge, 0.05 * edge);
    }
  }
}

TEST(Remesh, DataAreCarriedOver)
{
  const Mesh mesh = icosphere(3);
  std::vector<Vector3> normals = mesh.points;
  const auto input = withRegion(mesh, upperHalf);
  input->GetPointData()->SetNormals(toPolyData(mesh, &normals)->GetPointData()->GetNormals());
  std::vector<double> linear;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cells");
  for (const Vector3& p : mesh.points)
  {
    linear.push_back(1.0 + p[0] - 2.0 * p[1]);
    ids->InsertNextValue(ids->GetNumberOfTuples());
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    cells->InsertNextValue(t);
  }
  input->GetPointData()->SetScalars(doubles("Linear", linear));
  input->GetPointData()->SetGlobalIds(ids);
  input->GetCellData()->AddArray(cells);
  input->GetFieldData()->AddArray(doubles("Note", { 7.0 }));
  const auto content = contentOf(input);
  Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handlesOn(input, 0.4, 1.0));
  const auto output = stretch.run();
  EXPECT_EQ(contentOf(input), content);
  ASSERT_NE(output->GetPointData()->GetScalars(), nullptr);
  ASSERT_NE(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(output->GetPointData()->GetGlobalIds(), nullptr);
  EXPECT_EQ(output->GetFieldData()->GetArray("Note")->GetComponent(0, 0), 7.0);
  EXPECT_EQ(
    output->GetFieldData()->GetArray("GuideLength")->GetComponent(0, 0), stretch.filter->GetGuideLength());
  EXPECT_EQ(input->GetFieldData()->GetArray("GuideLength"), nullptr);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 p(output->GetPoint(i)), n(output->GetPointData()->GetNormals()->GetTuple(i));
    EXPECT_NEAR(output->GetPointData()->GetScalars()->GetComponent(i, 0), 1.0 + p[0] - 2.0 * p[1], 1e-12);
    EXPECT_NEAR(n.norm(), 1.0, 1e-12);
    EXPECT_GT(n.dot(p.normalized()), 0.999);
  }
  // The cell data come from the triangle under the middle: its own middle is within a triangle's size.
  for (vtkIdType t = 0; t < output->GetNumberOfCells(); ++t)
  {
    const int from = static_cast<int>(output->GetCellData()->GetArray("Cells")->GetComponent(t, 0));
    const Triangle& s = mesh.triangles[from];
    vtkIdType count = 0;
    const vtkIdType* c = nullptr;
    output->GetPolys()->GetCellAtId(t, count, c);
    const Vector3 middle =
      (Vector3(output->GetPoint(c[0])) + Vector3(output->GetPoint(c[1])) + Vector3(output->GetPoint(c[2]))) /
      3.0;
    const Vector3 sourceMiddle = (mesh.points[s[0]] + mesh.points[s[1]] + mesh.points[s[2]]) / 3.0;
    EXPECT_LT((middle - sourceMiddle).norm(), (mesh.points[s[0]] - mesh.points[s[1]]).norm());
  }
}

TEST(Remesh, SameBitsForAnyNumberOfThreadsColdOrKept)
{
  const auto input = withRegion(icosphere(4), upperHalf, 0.1);
  const auto handles = handlesOn(input, 0.5, 1.0);
  std::vector<std::vector<double>> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&] { results.push_back(contentOf(Remeshed(input, vtkOversketchRemesh::STRETCH, handles).run())); });
  }
  EXPECT_EQ(results[0], results[1]);

  Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handles);
  EXPECT_EQ(contentOf(stretch.run()), results[0]);
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 1);
  vtkPoints* points = stretch.filter->GetOutput()->GetPoints();
  vtkDataArray* region = stretch.filter->GetOutput()->GetPointData()->GetArray("Region");
  // A new colour, a moved target: found again. Another length: remeshed.
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(input);
  coloured->GetPointData()->AddArray(doubles("Colour", std::vector<double>(input->GetNumberOfPoints(), 0.5)));
  stretch.filter->SetInputData(coloured);
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(handles);
  moved->GetPointData()->GetArray("Target")->FillComponent(1, 9.0);
  stretch.filter->SetHandlesData(moved);
  stretch.filter->Update();
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 1);
  EXPECT_EQ(stretch.filter->GetOutput()->GetPoints(), points);
  EXPECT_EQ(stretch.filter->GetOutput()->GetPointData()->GetArray("Region"), region);
  ASSERT_NE(stretch.filter->GetOutput()->GetPointData()->GetArray("Colour"), nullptr);
  EXPECT_EQ(stretch.filter->GetHandlesOutput()->GetPointData()->GetArray("Target")->GetComponent(0, 1), 9.0);
  moved->GetFieldData()->GetArray("TargetLength")->FillComponent(0, 1.5);
  moved->Modified();
  stretch.filter->Update();
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 2);
}

TEST(Remesh, RefusesWhatItCannotRead)
{
  struct Case
  {
    std::string word;
    Failure failure;
    std::function<void(vtkPolyData*, vtkPolyData*)> spoil;
  };
  const std::vector<Case> cases = {
    { "Region",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPointData()->RemoveArray("Region"); } },
    { "ShapeDiameter",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPointData()->RemoveArray("ShapeDiameter"); } },
    { "Region",
      Failure::MissingArray,
      [](vtkPolyData* m, vtkPolyData*)
      {
        m->GetPointData()->AddArray(
          doubles("Region", std::vector<double>(3 * m->GetNumberOfPoints(), 1.0), 3));
      } },
    { "Point 3",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*) { m->GetPoints()->SetPoint(3, NAN, 0, 0); } },
    { "Cell",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*) {
        m->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
      } },
    { "lines",
      Failure::BadMesh,
      [](vtkPolyData* m, vtkPolyData*)
      {
        vtkNew<vtkCellArray> lines;
        lines->InsertNextCell({ 0, 1 });
        m->SetLines(lines);
      } },
    { "MeshVertices",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h) { h->GetPointData()->RemoveArray("MeshVertices"); } },
    { "Handle 2",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetPointData()->GetArray("MeshVertices")->SetComponent(2, 0, 1e6); } },
    { "handle 1",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetPointData()->GetArray("MeshWeights")->SetComponent(1, 0, NAN); } },
    { "SectionLength",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h) { h->GetFieldData()->RemoveArray("SectionLength"); } },
    { "TargetLength",
      Failure::MissingArray,
      [](vtkPolyData*, vtkPolyData* h)
      { h->GetFieldData()->GetArray("TargetLength")->FillComponent(0, 0.0); } },
  };
  for (const Case& c : cases)
  {
    const auto input = withRegion(icosphere(2), upperHalf);
    const auto handles = handlesOn(input, 1.0, 2.0);
    Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handles);
    Ear ear(stretch.filter);
    const auto good = contentOf(stretch.run());
    vtkNew<vtkPolyData> badInput, badHandles;
    badInput->DeepCopy(input);
    badHandles->DeepCopy(handles);
    c.spoil(badInput, badHandles);
    stretch.filter->SetInputData(badInput);
    stretch.filter->SetHandlesData(badHandles);
    stretch.filter->Update();
    ASSERT_EQ(ear.errors.size(), 1u) << c.word;
    EXPECT_NE(ear.errors[0].find(c.word), std::string::npos) << ear.errors[0];
    EXPECT_EQ(
      stretch.filter->GetErrorCode(), vtkErrorCode::UserError + static_cast<unsigned long>(c.failure));
    EXPECT_EQ(stretch.filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(stretch.filter->GetHandlesOutput()->GetNumberOfPoints(), 0);
    stretch.filter->SetInputData(input);
    stretch.filter->SetHandlesData(handles);
    EXPECT_EQ(contentOf(stretch.run()), good);
  }
}

TEST(Remesh, NothingToDoIsNoError)
{
  vtkNew<vtkPolyData> empty;
  Remeshed none(empty, vtkOversketchRemesh::STRETCH);
  Ear ear(none.filter);
  EXPECT_EQ(none.run()->GetNumberOfPoints(), 0);
  const auto outside = withRegion(icosphere(2), [](const Vector3&) { return false; });
  Remeshed same(outside, vtkOversketchRemesh::RESTORE);
  const auto output = same.run();
  expectOutsideUntouched(outside, output);
  EXPECT_EQ(output->GetNumberOfPoints(), outside->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfCells(), outside->GetNumberOfCells());
  EXPECT_TRUE(ear.errors.empty());
}

TEST(Remesh, ACancelledRunIsSilentAndARetryComplete)
{
  const auto input = withRegion(icosphere(4), upperHalf);
  const auto whole =
    contentOf(Remeshed(input, vtkOversketchRemesh::STRETCH, handlesOn(input, 0.5, 1.0)).run());
  Remeshed stretch(input, vtkOversketchRemesh::STRETCH, handlesOn(input, 0.5, 1.0));
  Ear ear(stretch.filter);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(filter);
      if (algorithm->GetProgress() > 0.4)
      {
        algorithm->AbortExecuteOn();
      }
    });
  const unsigned long tag = stretch.filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(stretch.run()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(
    stretch.filter->GetErrorCode(), vtkErrorCode::UserError + static_cast<unsigned long>(Failure::Cancelled));
  EXPECT_EQ(stretch.filter->GetRemeshCount(), 0);
  stretch.filter->RemoveObserver(tag);
  stretch.filter->AbortExecuteOff();
  stretch.filter->Modified();
  EXPECT_EQ(contentOf(stretch.run()), whole);
}

TEST(Remesh, PrintsEveryParameter)
{
  vtkNew<vtkOversketchRemesh> filter;
  std::ostringstream os;
  filter->Print(os);
  for (const char* name :
    { "Stage: ", "Iterations: 5", "LimitByDiameter: On", "ProtectSection: On", "MinimumFactor: 0.2" })
  {
    EXPECT_NE(os.str().find(name), std::string::npos) << name;
  }
}
