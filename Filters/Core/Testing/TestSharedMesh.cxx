#include "Harness/polydata.h"
#include "vtkOversketchSharedMesh.h"

#include "Mesh/context.h"

#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <thread>

using namespace oversketch;
using namespace oversketch_test;

TEST(SharedMesh, IsFoundAgainByAShallowCopyAndForgottenWithItsLastHolder)
{
  const auto sphere = toPolyData(icosphere(2));
  auto first = SharedMesh(sphere);
  EXPECT_EQ(first->Surface().vertexCount(), 162);
  EXPECT_EQ(first->Neighbours().edges.size(), 480u);
  EXPECT_EQ(first->Normals().size(), 162u);
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(sphere);
  EXPECT_EQ(SharedMesh(copy), first);
  const std::weak_ptr<const MeshData> watch = first;
  first.reset();
  EXPECT_TRUE(watch.expired());
}

TEST(SharedMesh, SeesMovedPointsNewNormalsAndForeignCells)
{
  const Mesh mesh = icosphere(1);
  const auto sphere = toPolyData(mesh);
  const auto first = SharedMesh(sphere);
  sphere->GetPoints()->SetPoint(0, 9.0, 9.0, 9.0);
  sphere->GetPoints()->Modified();
  const auto second = SharedMesh(sphere);
  EXPECT_NE(first, second);
  EXPECT_EQ(second->Surface().points[0], Vector3(9, 9, 9));
  EXPECT_NE(first->Surface().points[0], second->Surface().points[0]);
  std::vector<Vector3> normals(mesh.points.size(), Vector3(0, 0, 2));
  sphere->GetPointData()->SetNormals(toPolyData(mesh, &normals)->GetPointData()->GetNormals());
  EXPECT_EQ(SharedMesh(sphere)->Normals()[3], Vector3(0, 0, 1));
  const auto mixed = toPolyData(mesh);
  const auto kept = SharedMesh(mixed);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  mixed->SetLines(line);
  EXPECT_THROW(SharedMesh(mixed), Error);
}

TEST(SharedMesh, ManyThreadsGetOneResult)
{
  const auto sphere = toPolyData(icosphere(4));
  const auto held = SharedMesh(sphere);
  std::vector<std::shared_ptr<const MeshData>> found(8);
  std::vector<std::thread> threads;
  threads.reserve(found.size());
  for (auto& slot : found)
  {
    threads.emplace_back([&slot, &sphere] { slot = SharedMesh(sphere); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& slot : found)
  {
    EXPECT_EQ(slot, held);
  }
}
