// Facts of editors.md, section 13 (ROI): the unit sphere seen from +z, boundary z = 0.5, reference over the
// pole.
#include "Harness/chains.h"
#include "Harness/enclosures.h"
#include "Harness/promises.h"
#include "vtkOversketchEnclose.h"
#include "vtkOversketchFilterTools.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <functional>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Round
{
  vtkSmartPointer<vtkPolyData> mesh, reference, boundary;
  vtkNew<vtkOversketchEnclose> filter;

  explicit Round(const Enclosure& scene)
    : mesh(toPolyData(scene.mesh))
    , reference(toChain(scene.mesh, scene.reference))
    , boundary(toChain(scene.mesh, scene.boundary))
  {
    this->filter->SetInputData(this->mesh);
    this->filter->SetReferenceData(this->reference);
    this->filter->SetBoundaryData(this->boundary);
  }
  double label(vtkIdType v) const
  {
    return this->filter->GetOutput()->GetPointData()->GetArray("EditRegion")->GetComponent(v, 0);
  }
  double faceLabel(vtkIdType t) const
  {
    return this->filter->GetOutput()->GetCellData()->GetArray("EditRegion")->GetComponent(t, 0);
  }
};

bool above(const Mesh& mesh, const Triangle& t)
{
  return mesh.points[t[0]][2] > 0.499 && mesh.points[t[1]][2] > 0.499 && mesh.points[t[2]][2] > 0.499;
}

// A torus with a boundary round its tube, which parts nothing from anything.
Enclosure torusWithMeridian()
{
  Enclosure scene;
  const int around = 48, tube = 24;
  scene.mesh = torus(2.0, 0.6, around, tube);
  for (int v = 0; v <= tube; ++v)
  {
    scene.boundary.push_back((v % tube) * around);
  }
  scene.reference = { 10, 11, 12, 13, 14 };
  return scene;
}

// Between two rings of the sphere, cut open along a meridian.
Enclosure annulus()
{
  Enclosure scene = ringedSphere(24, 32);
  // The boundary goes round the ring at 60 degrees, over an edge to the next ring inwards, round that one and
  // back over the edge: the band between both is inside.
  const int inner = scene.boundary.front() - 32 * 4, outer = scene.boundary.front();
  std::vector<int> walk;
  for (int s = 0; s <= 32; ++s)
  {
    walk.push_back(outer + s % 32);
  }
  // Down the meridian s = 0 to the inner ring.
  for (int r = 1; r <= 4; ++r)
  {
    walk.push_back(outer - 32 * r);
  }
  for (int s = 31; s >= 0; --s)
  {
    walk.push_back(inner + s);
  }
  for (int r = 3; r >= 0; --r)
  {
    walk.push_back(outer - 32 * r);
  }
  scene.boundary = walk;
  scene.reference.clear();
  for (int s = 10; s < 14; ++s)
  {
    scene.reference.push_back(outer - 64 + s);
  }
  return scene;
}

} // namespace

TEST(B5_1, TheFarCapStaysOut)
{
  const Enclosure scene = ringedSphere(48, 64);
  Round round(scene);
  round.filter->Update();
  ASSERT_EQ(round.filter->GetErrorCode(), 0u);
  int inside = 0;
  for (int v = 0; v < scene.mesh.vertexCount(); ++v)
  {
    const double z = scene.mesh.points[v][2];
    if (z > 0.51)
    {
      EXPECT_EQ(round.label(v), 2.0) << v;
      ++inside;
    }
    if (z < 0.49)
    {
      EXPECT_NE(round.label(v), 2.0) << v;
    }
    if (z < 0.0)
    {
      EXPECT_EQ(round.label(v), 0.0) << v;
    }
  }
  fact("B5_1",
    std::to_string(inside) + " vertices over z = 0.51 are strictly inside, none under 0.49; all under 0 are "
                             "outside");
}

TEST(B5_2, ThePatchIsTheFacesInsideAndOneRing)
{
  const Enclosure scene = ringedSphere(48, 64);
  Round round(scene);
  round.filter->Update();
  ASSERT_EQ(round.filter->GetErrorCode(), 0u);
  // Faces inside by where they lie; of the ring, those that share a vertex.
  std::vector<char> touched(scene.mesh.points.size(), 0);
  for (const Triangle& t : scene.mesh.triangles)
  {
    for (int k = 0; above(scene.mesh, t) && k < 3; ++k)
    {
      touched[t[k]] = 1;
    }
  }
  std::vector<int> expected;
  for (int t = 0; t < scene.mesh.triangleCount(); ++t)
  {
    const Triangle& c = scene.mesh.triangles[t];
    const bool ring = touched[c[0]] || touched[c[1]] || touched[c[2]];
    EXPECT_EQ(round.faceLabel(t), above(scene.mesh, c) ? 2.0 : ring ? 1.0 : 0.0) << t;
    if (ring)
    {
      expected.push_back(t);
    }
  }
  const Mesh patch = MeshOf(round.filter->GetPatchOutput());
  vtkDataArray* ids = round.filter->GetPatchOutput()->GetPointData()->GetArray("VertexId");
  ASSERT_EQ(patch.triangles.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(ids->GetComponent(patch.triangles[i][k], 0), scene.mesh.triangles[expected[i]][k]);
    }
  }
  for (int v = 0; v < patch.vertexCount(); ++v)
  {
    const vtkIdType id = static_cast<vtkIdType>(ids->GetComponent(v, 0));
    EXPECT_EQ(patch.points[v], scene.mesh.points[id]);
    EXPECT_EQ(round.filter->GetPatchOutput()->GetPointData()->GetArray("EditRegion")->GetComponent(v, 0),
      round.label(id));
  }
  EXPECT_EQ(eulerNumber(patch.triangles), 1);
  // Boundary and ring are not strictly inside.
  for (const int v : scene.boundary)
  {
    EXPECT_EQ(round.label(v), 1.0);
  }
  fact("B5_2",
    std::to_string(expected.size()) +
      " faces: those inside and every one that shares a vertex, V - E + F = " +
      std::to_string(eulerNumber(patch.triangles)));
}

TEST(B5_3, WhatIsNoDiscIsRefused)
{
  Round handle(torusWithMeridian());
  const auto content = toPolyData(torusWithMeridian().mesh);
  expectRefusal(handle.filter, Failure::BadRegion, "100 % of the surface");
  EXPECT_EQ(MeshOf(handle.mesh).points, MeshOf(content).points);
  EXPECT_FALSE(handle.mesh->GetPointData()->HasArray("EditRegion"));
  EXPECT_EQ(handle.filter->GetPatchOutput()->GetNumberOfPoints(), 0);

  Round band(annulus());
  expectRefusal(band.filter, Failure::BadRegion, "has a hole");

  // Two meridians: half of the torus, a tube.
  Enclosure tube = torusWithMeridian();
  std::vector<int> walk = tube.boundary;
  for (int u = 1; u <= 24; ++u)
  {
    walk.push_back(u); // along v = 0 to the other meridian
  }
  for (int v = 1; v <= 24; ++v)
  {
    walk.push_back((v % 24) * 48 + 24);
  }
  for (int u = 23; u >= 0; --u)
  {
    walk.push_back(u);
  }
  tube.boundary = walk;
  tube.reference = { 48 * 4 + 5, 48 * 4 + 6, 48 * 4 + 7 };
  // Cut open along v = 0, but the faces on either side share its vertices.
  Round pipe(tube);
  expectRefusal(pipe.filter, Failure::BadRegion, "has a hole");

  Enclosure across = ringedSphere(48, 64);
  across.reference.push_back(across.reference.back() + 64 * 4);
  Round crossing(across);
  expectRefusal(crossing.filter, Failure::BadRegion, "not all inside the boundary");
  fact("B5_3",
    "round a torus's handle, an annulus, a tube and a reference that leaves: each refused by name, the mesh "
    "as it was");
}

TEST(Enclose, KeepsArraysAndAnswersAgain)
{
  const Enclosure scene = ringedSphere(24, 32);
  Round round(scene);
  round.mesh->GetPointData()->AddArray(toPolyData(scene.mesh)->GetPoints()->GetData());
  round.mesh->GetPointData()->GetArray(0)->SetName("Before");
  round.filter->Update();
  vtkPolyData* patch = round.filter->GetPatchOutput();
  vtkDataArray* ids = patch->GetPointData()->GetArray("VertexId");
  for (vtkIdType v = 0; v < patch->GetNumberOfPoints(); ++v)
  {
    const vtkIdType id = static_cast<vtkIdType>(ids->GetComponent(v, 0));
    EXPECT_EQ(Vector3(patch->GetPointData()->GetArray("Before")->GetTuple(v)), scene.mesh.points[id]);
  }
  vtkDataArray* labels = round.filter->GetOutput()->GetPointData()->GetArray("EditRegion");
  vtkPoints* points = patch->GetPoints();
  round.filter->Modified();
  round.filter->Update();
  EXPECT_EQ(round.filter->GetOutput()->GetPointData()->GetArray("EditRegion"), labels);
  EXPECT_EQ(round.filter->GetPatchOutput()->GetPoints(), points);
  EXPECT_EQ(round.filter->GetGrowthCount(), 1);
  // A new colour grows nothing, but is on the patch.
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(round.mesh);
  vtkNew<vtkDoubleArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(scene.mesh.vertexCount());
  colour->Fill(0.5);
  coloured->GetPointData()->AddArray(colour);
  round.filter->SetInputData(coloured);
  round.filter->Update();
  EXPECT_EQ(round.filter->GetGrowthCount(), 1);
  EXPECT_TRUE(round.filter->GetPatchOutput()->GetPointData()->HasArray("Colour"));
  // A smaller boundary grows again.
  const vtkIdType before = round.filter->GetPatchOutput()->GetNumberOfPoints();
  Enclosure smaller = scene;
  for (int& v : smaller.boundary)
  {
    v -= 32;
  }
  round.filter->SetBoundaryData(toChain(smaller.mesh, smaller.boundary));
  round.filter->Update();
  EXPECT_EQ(round.filter->GetGrowthCount(), 2);
  EXPECT_EQ(round.filter->GetPatchOutput()->GetNumberOfPoints(), before - 32);
}

TEST(Enclose, SameForAnyNumberOfThreads)
{
  std::vector<std::vector<double>> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        Round round(ringedSphere(48, 64));
        round.filter->Update();
        std::vector<double>& labels = results.emplace_back();
        for (vtkIdType v = 0; v < round.mesh->GetNumberOfPoints(); ++v)
        {
          labels.push_back(round.label(v));
        }
      });
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(Enclose, RefusesAndCancels)
{
  const Enclosure scene = ringedSphere(24, 32);
  const struct
  {
    const char* words;
    Failure failure;
    std::function<void(Round&)> spoil;
  } cases[] = {
    { "VertexId",
      Failure::MissingArray,
      [](Round& r) { r.reference->GetPointData()->RemoveArray("VertexId"); } },
    { "Point 2 of the boundary curve is no vertex",
      Failure::BadStroke,
      [](Round& r) { r.boundary->GetPointData()->GetArray("VertexId")->SetComponent(2, 0, 1e7); } },
    { "Point 0 of the reference curve is no vertex",
      Failure::BadStroke,
      [](Round& r) { r.reference->GetPointData()->GetArray("VertexId")->SetComponent(0, 0, -1.0); } },
    { "must be polylines and no other cells",
      Failure::BadStroke,
      [](Round& r) { r.reference->SetLines(vtkNew<vtkCellArray>()); } },
    { "There are 2 polylines",
      Failure::BadStroke,
      [](Round& r) {
        r.boundary->GetLines()->InsertNextCell({ 0, 1 });
      } },
    { "not closed",
      Failure::BadStroke,
      [](Round& r)
      {
        vtkNew<vtkCellArray> lines;
        lines->InsertNextCell({ 0, 1, 2, 3, 4 });
        r.boundary->SetLines(lines);
      } },
    { "Point 3", Failure::BadMesh, [](Round& r) { r.mesh->GetPoints()->SetPoint(3, std::nan(""), 0, 0); } },
  };
  for (const auto& each : cases)
  {
    Round round(scene);
    each.spoil(round);
    expectRefusal(round.filter, each.failure, each.words);
  }
  Round round(scene);
  expectCancel(round.filter);
  round.filter->Update();
  EXPECT_GT(round.filter->GetPatchOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> empty;
  round.filter->SetInputData(empty);
  Ear ear(round.filter);
  round.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(round.filter->GetOutput()->GetNumberOfPoints(), 0);
}
