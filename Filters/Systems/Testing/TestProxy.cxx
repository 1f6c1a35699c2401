// A proxy of a mesh, and the mesh moved as it was.
#include "Harness/data.h"
#include "Harness/edges.h"
#include "Harness/polydata.h"
#include "Harness/promises.h"
#include "vtkOversketchDetailTransfer.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchProxy.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPLYReader.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr int target = 6000;

// Each triangle with points of its own, as some files have them; array Number tells the points apart.
vtkSmartPointer<vtkPolyData> looseSphere()
{
  const Mesh sphere = icosphere(6);
  Mesh loose;
  for (const Triangle& t : sphere.triangles)
  {
    const int first = loose.vertexCount();
    for (const int v : t)
    {
      loose.points.push_back(sphere.points[v]);
    }
    loose.triangles.push_back({ first, first + 1, first + 2 });
  }
  auto mesh = toPolyData(loose, &loose.points);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  number->SetNumberOfTuples(loose.vertexCount());
  std::iota(number->GetPointer(0), number->GetPointer(0) + loose.vertexCount(), 0);
  mesh->GetPointData()->AddArray(number);
  return mesh;
}

vtkSmartPointer<vtkPolyData> proxyOf(vtkPolyData* mesh)
{
  vtkNew<vtkOversketchProxy> filter;
  filter->SetTargetTriangles(target);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

// By a quarter turn about z, and along it.
Vector3 turned(const Vector3& p)
{
  return { -p[1], p[0], p[2] + 2.0 };
}

} // namespace

TEST(Proxy, ItsPointsAreTheMeshsOwnWithTheirArrays)
{
  const auto mesh = looseSphere();
  const auto proxy = proxyOf(mesh);
  EXPECT_NEAR(static_cast<double>(proxy->GetNumberOfPolys()), target, 0.3 * target);
  EXPECT_EQ(eulerNumber(MeshOf(proxy).triangles), 2);
  EXPECT_EQ(proxy->GetPointData()->GetNormals(), nullptr); // of welded points
  vtkDataArray* origin = proxy->GetPointData()->GetArray("Origin");
  vtkDataArray* number = proxy->GetPointData()->GetArray("Number");
  ASSERT_TRUE(origin && number);
  for (vtkIdType i = 0; i < proxy->GetNumberOfPoints(); ++i)
  {
    Vector3 place, was, from;
    proxy->GetPoint(i, place.data());
    origin->GetTuple(i, was.data());
    mesh->GetPoint(static_cast<vtkIdType>(number->GetComponent(i, 0)), from.data());
    EXPECT_EQ(place, was);
    EXPECT_EQ(place, from);
  }
}

TEST(Proxy, TheBunnyKeepsItsKind)
{
  const std::string path = sharedData("meshes/bunny_30k.ply");
  if (path.empty())
  {
    GTEST_SKIP() << "meshes/bunny_30k.ply is not there";
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const Mesh bunny = MeshOf(reader->GetOutput()), proxy = MeshOf(proxyOf(reader->GetOutput()));
  EXPECT_EQ(eulerNumber(proxy.triangles), eulerNumber(bunny.triangles));
  const Adjacency around = buildAdjacency(proxy);
  for (const MeshEdge& edge : around.edges)
  {
    EXPECT_EQ(edge.triangleCount, 2);
  }
}

TEST(Proxy, ASmallMeshIsPassed)
{
  const auto mesh = toPolyData(icosphere(3));
  const auto proxy = proxyOf(mesh);
  EXPECT_EQ(proxy->GetPolys(), mesh->GetPolys());
  EXPECT_EQ(MeshOf(proxy).points, MeshOf(mesh).points);
  EXPECT_TRUE(proxy->GetPointData()->HasArray("Origin"));
}

TEST(Proxy, EndsWhenCancelledAndRefusesWhatHasNoArea)
{
  vtkNew<vtkOversketchProxy> filter;
  filter->SetTargetTriangles(target);
  filter->SetInputData(looseSphere());
  expectCancel(filter);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), 0);
  Mesh flat = icosphere(6);
  std::fill(flat.points.begin(), flat.points.end(), Vector3::Zero());
  filter->SetInputData(toPolyData(flat));
  expectRefusal(filter, Failure::BadMesh, "No triangle of the mesh has an area");
}

TEST(DetailTransferFilter, MovesTheMeshAsItsProxyWas)
{
  const auto mesh = looseSphere();
  const auto proxy = proxyOf(mesh);
  vtkNew<vtkOversketchDetailTransfer> filter;
  filter->SetInputData(0, mesh);
  filter->SetInputData(1, proxy);
  filter->Update();
  EXPECT_EQ(MeshOf(filter->GetOutput()).points, MeshOf(mesh).points);
  for (vtkIdType i = 0; i < proxy->GetNumberOfPoints(); ++i)
  {
    const double* p = proxy->GetPoint(i);
    proxy->GetPoints()->SetPoint(i, turned({ p[0], p[1], p[2] }).data());
  }
  proxy->GetPoints()->Modified();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPolys(), mesh->GetPolys());
  EXPECT_EQ(output->GetPointData()->GetArray("Number"), mesh->GetPointData()->GetArray("Number"));
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector3 before, after, normal;
    mesh->GetPoint(i, before.data());
    output->GetPoint(i, after.data());
    normals->GetTuple(i, normal.data());
    EXPECT_LT((after - turned(before)).norm(), 1e-6);
    EXPECT_LT((normal - (after - Vector3(0, 0, 2))).norm(), 0.01);
  }
}

TEST(DetailTransferFilter, SaysWhatTheProxyLacks)
{
  const auto mesh = toPolyData(icosphere(3));
  vtkNew<vtkOversketchDetailTransfer> filter;
  filter->SetInputData(0, mesh);
  filter->SetInputData(1, mesh);
  expectRefusal(filter, Failure::MissingArray, "Origin");
}

TEST(DetailTransfer, MaskedPointsKeepTheirBits)
{
  const auto mesh = looseSphere();
  const auto proxy = proxyOf(mesh);
  vtkNew<vtkDoubleArray> mask;
  mask->SetName("Mask");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(mesh->GetPoint(i)[0] > 0.0 ? 1.0 : 0.0);
  }
  mesh->GetPointData()->AddArray(mask);
  for (vtkIdType i = 0; i < proxy->GetNumberOfPoints(); ++i)
  {
    proxy->GetPoints()->SetPoint(i, turned(Vector3(proxy->GetPoint(i))).data());
  }
  proxy->GetPoints()->Modified();
  vtkNew<vtkOversketchDetailTransfer> filter;
  filter->SetInputData(0, mesh);
  filter->SetInputData(1, proxy);
  filter->Update();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const bool stays = Vector3(filter->GetOutput()->GetPoint(i)) == Vector3(mesh->GetPoint(i));
    EXPECT_EQ(stays, mask->GetValue(i) == 1.0) << i;
  }
}
