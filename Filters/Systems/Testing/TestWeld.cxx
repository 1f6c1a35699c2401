// The user's arrays, there and back through remeshings.
#include "Harness/polydata.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRemesh.h"
#include "vtkOversketchWeld.h"

#include "vtkIdTypeArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A sphere whose points are there twice along x = 0, once for each side, which point array Side tells apart
// (int); Place is the position, which any way through the surface must reproduce, Name a word per cell.
vtkSmartPointer<vtkPolyData> splitSphere()
{
  const Mesh sphere = icosphere(3);
  Mesh split;
  std::vector<int> sides;
  std::map<std::pair<int, int>, int> known;
  for (const Triangle& t : sphere.triangles)
  {
    const int side = (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]])[0] > 0.0;
    Triangle corners{};
    for (int k = 0; k < 3; ++k)
    {
      const auto [at, fresh] = known.emplace(std::pair(t[k], side), split.vertexCount());
      if (fresh)
      {
        split.points.push_back(sphere.points[t[k]]);
        sides.push_back(side);
      }
      corners[k] = at->second;
    }
    split.triangles.push_back(corners);
  }
  auto mesh = toPolyData(split, &split.points);
  vtkNew<vtkIntArray> side;
  side->SetName("Side");
  vtkNew<vtkDoubleArray> place;
  place->DeepCopy(mesh->GetPoints()->GetData());
  place->SetName("Place");
  vtkNew<vtkStringArray> name;
  name->SetName("Name");
  for (const int s : sides)
  {
    side->InsertNextValue(s);
  }
  for (int t = 0; t < split.triangleCount(); ++t)
  {
    name->InsertNextValue("cell " + std::to_string(t));
  }
  mesh->GetPointData()->AddArray(side);
  mesh->GetPointData()->AddArray(place);
  mesh->GetCellData()->AddArray(name);
  return mesh;
}

// Remeshed above z = -0.3.
vtkSmartPointer<vtkPolyData> remeshed(vtkPolyData* input, int stage)
{
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(input);
  vtkNew<vtkUnsignedCharArray> region;
  region->SetName("Region");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    region->InsertNextValue(mesh->GetPoint(i)[2] > -0.3);
  }
  mesh->GetPointData()->AddArray(region);
  vtkNew<vtkOversketchRemesh> filter;
  filter->LimitByDiameterOff();
  filter->SetStage(stage);
  filter->SetInputData(mesh);
  filter->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

} // namespace

TEST(Weld, SplitPointsAreOneVertexAndTheirSidesTwoCharts)
{
  const auto mesh = splitSphere();
  const Weld weld(mesh);
  EXPECT_EQ(weld.Welded()->GetNumberOfPoints(), 642);
  EXPECT_GT(mesh->GetNumberOfPoints(), 642);
  vtkDataArray* charts = weld.Welded()->GetCellData()->GetArray("Chart");
  ASSERT_NE(charts, nullptr);
  std::set<double> numbers;
  for (vtkIdType t = 0; t < charts->GetNumberOfTuples(); ++t)
  {
    numbers.insert(charts->GetComponent(t, 0));
  }
  EXPECT_EQ(numbers.size(), 2u);
  const auto whole = toPolyData(icosphere(3));
  const Weld nothing(whole);
  EXPECT_EQ(nothing.Welded()->GetPoints(), whole->GetPoints());
  EXPECT_EQ(nothing.Welded()->GetCellData()->GetArray("Chart"), nullptr);
}

TEST(Weld, ArraysComeBackThroughAnyNumberOfRemeshings)
{
  for (const bool split : { true, false })
  {
    const auto mesh = splitSphere();
    if (!split)
    {
      // The welded sphere itself, with its position as an attribute.
      const Weld weld(mesh);
      const Mesh sphere = MeshOf(weld.Welded());
      mesh->DeepCopy(toPolyData(sphere, &sphere.points));
      vtkNew<vtkDoubleArray> place;
      place->DeepCopy(mesh->GetPoints()->GetData());
      place->SetName("Place");
      mesh->GetPointData()->AddArray(place);
    }
    const Weld weld(mesh);
    std::vector<vtkSmartPointer<vtkPolyData>> kept;
    std::vector<vtkPolyData*> chain;
    for (int length = 1; length <= 3; ++length)
    {
      SCOPED_TRACE(length);
      kept.push_back(remeshed(kept.empty() ? weld.Welded() : kept.back().Get(),
        length == 1 ? vtkOversketchRemesh::Stretch : vtkOversketchRemesh::Restore));
      chain.push_back(kept.back());
      vtkNew<vtkPolyData> output;
      const std::vector<int> vertices = weld.Transfer(mesh, chain, output);
      ASSERT_EQ(static_cast<vtkIdType>(vertices.size()), output->GetNumberOfPoints());
      EXPECT_EQ(output->GetNumberOfPolys(), chain.back()->GetNumberOfPolys());
      vtkDataArray* place = output->GetPointData()->GetArray("Place");
      ASSERT_EQ(place->GetNumberOfTuples(), output->GetNumberOfPoints());
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const Vector3 p(output->GetPoint(i));
        EXPECT_LT((p - Vector3(place->GetTuple(i))).norm(), 1e-9);
        EXPECT_EQ(p, Vector3(chain.back()->GetPoint(vertices[i])));
        EXPECT_GT(p.normalized().dot(Vector3(output->GetPointData()->GetNormals()->GetTuple(i))), 0.99);
      }
      if (!split)
      {
        continue;
      }
      // No triangle takes from both sides; its cell is one that the user named.
      vtkDataArray* side = output->GetPointData()->GetArray("Side");
      auto* name = vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("Name"));
      ASSERT_EQ(name->GetNumberOfTuples(), output->GetNumberOfPolys());
      const Mesh result = MeshOf(output);
      for (int t = 0; t < result.triangleCount(); ++t)
      {
        const double first = side->GetComponent(result.triangles[t][0], 0);
        EXPECT_EQ(side->GetComponent(result.triangles[t][1], 0), first);
        EXPECT_EQ(side->GetComponent(result.triangles[t][2], 0), first);
        EXPECT_EQ(name->GetValue(t).find("cell "), 0u);
      }
    }
  }
}
