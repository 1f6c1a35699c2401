// Figures, arrays and what is kept; the laws are those of the kernel's test.
#include "Harness/promises.h"
#include "Harness/shapes.h"

#include "Print/print_check.h"
#include "vtkOversketchPrintCheck.h"

#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> slabData()
{
  return toPolyData(box(Vector3::Zero(), { 10.0, 10.0, 0.4 }));
}

vtkDoubleArray* wallsOf(vtkOversketchPrintCheck* filter)
{
  return vtkDoubleArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("Wall"));
}

vtkUnsignedCharArray* faultyOf(vtkOversketchPrintCheck* filter)
{
  return vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("Faulty"));
}

} // namespace

TEST(PrintCheckFilter, TellsFiguresAndAddsArrays)
{
  vtkNew<vtkOversketchPrintCheck> filter;
  filter->SetInputData(slabData());
  filter->Update();
  EXPECT_TRUE(filter->IsReady());
  EXPECT_NEAR(filter->GetLeastWall(), 0.4, 1e-12);
  EXPECT_EQ(filter->GetThinArea(), 0.0);
  ASSERT_TRUE(wallsOf(filter) && faultyOf(filter));
  EXPECT_NEAR(wallsOf(filter)->GetValue(0), 0.4, 1e-12);
  EXPECT_EQ(faultyOf(filter)->GetRange(0)[1], 0.0);
  EXPECT_EQ(filter->GetNumberOfBodies(), 1);
  EXPECT_NEAR(filter->GetBodyVolume(0), 40.0, 1e-9);
  EXPECT_EQ(filter->GetBodyVolume(1), 0.0);
  // What was found stands for another wall.
  const PrintCheck* found = &filter->Found();
  filter->SetWall(0.8);
  filter->Update();
  EXPECT_EQ(&filter->Found(), found);
  EXPECT_FALSE(filter->IsReady());
  EXPECT_NEAR(filter->GetThinArea(), 200.0, 1e-9);
}

TEST(PrintCheckFilter, NamesTheLargestHoleAndMarksItsFaces)
{
  Mesh mesh = box(Vector3::Zero(), Vector3::Constant(10.0));
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2); // at z = 0
  vtkNew<vtkOversketchPrintCheck> filter;
  filter->SetInputData(toPolyData(mesh));
  filter->Update();
  EXPECT_FALSE(filter->IsReady());
  EXPECT_EQ(filter->GetOpenEdges(), 4);
  EXPECT_EQ(filter->GetHoles(), 1);
  EXPECT_NEAR(filter->GetLargestHoleLength(), 40.0, 1e-9);
  double place[3];
  filter->GetLargestHole(place);
  EXPECT_LT((Vector3(place) - Vector3(5.0, 5.0, 0.0)).norm(), 1e-9);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    int low = 0;
    for (const int v : mesh.triangles[t])
    {
      low += mesh.points[v][2] == 0.0;
    }
    EXPECT_EQ(faultyOf(filter)->GetValue(t), low == 2 ? OpenFault : 0) << t;
  }
}

TEST(PrintCheckFilter, KeepsTheMeshAsItIs)
{
  const auto input = slabData();
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  numbers->SetNumberOfTuples(input->GetNumberOfPoints());
  numbers->Fill(7);
  input->GetPointData()->AddArray(numbers);
  vtkNew<vtkOversketchPrintCheck> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints(), input->GetPoints());
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Numbers"), numbers);
  EXPECT_EQ(input->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(PrintCheckFilter, IsTheSameOnOneThreadAndTwo)
{
  const auto input = toPolyData(joined(icosphere(3), icosphere(3), { 0.7, 0.1, 0.2 }));
  std::vector<double> walls[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkOversketchPrintCheck> filter;
    filter->SetInputData(input);
    filter->Update();
    EXPECT_GT(filter->GetCrossingPairs(), 100);
    walls[threads - 1].assign(wallsOf(filter)->Begin(), wallsOf(filter)->End());
  }
  vtkSMPTools::Initialize();
  EXPECT_EQ(walls[0], walls[1]);
}

TEST(PrintCheckFilter, RefusesWhatIsNoMeshAndStops)
{
  vtkNew<vtkOversketchPrintCheck> filter;
  filter->SetInputData(slabData());
  expectCancel(filter);
  filter->Update();
  EXPECT_TRUE(filter->IsReady());
  auto lines = slabData();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  lines->SetLines(line);
  filter->SetInputData(lines);
  expectRefusal(filter, Failure::BadMesh, "lines");
  EXPECT_FALSE(filter->IsReady()) << "of the mesh before";
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_FALSE(filter->IsReady());
  EXPECT_EQ(filter->GetLeastWall(), -1.0);
}
