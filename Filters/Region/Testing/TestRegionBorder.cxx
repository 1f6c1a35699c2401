#include "Harness/promises.h"
#include "Region/border.h"
#include "vtkOversketchRegionBorder.h"

#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch_test;

namespace
{

struct Count
{
  int inside = 0, outside = 0;
};

Count neighboursOf(const Adjacency& adjacency, const std::vector<char>& region, int v)
{
  Count count;
  for (const int n : adjacency.vertexVertices[v])
  {
    ++(region[n] ? count.inside : count.outside);
  }
  return count;
}

// Convex (not exempted) and concave vertices of the region.
int unsmooth(const Adjacency& adjacency, const std::vector<char>& region, const std::vector<char>& isSeed)
{
  int left = 0;
  for (int v = 0; v < int(region.size()); ++v)
  {
    const Count count = neighboursOf(adjacency, region, v);
    const bool convex = count.inside <= 2 && count.outside > 0 && !adjacency.borderVertex[v] && !isSeed[v];
    left += region[v] && (convex || count.outside == 1);
  }
  return left;
}

std::vector<char> randomRegion(const Adjacency& adjacency, int vertices, unsigned seed)
{
  // A few discs of rings and some salt: ragged borders.
  std::mt19937 generator(seed);
  std::vector<char> region(vertices, 0);
  for (int disc = 0; disc < 3; ++disc)
  {
    std::vector<int> front{ int(generator() % unsigned(vertices)) };
    region[front[0]] = 1;
    for (int ring = 0; ring < 6; ++ring)
    {
      std::vector<int> next;
      for (int v : front)
      {
        for (const int n : adjacency.vertexVertices[v])
        {
          if (!region[n] && generator() % 3 > 0)
          {
            region[n] = 1;
            next.push_back(n);
          }
        }
      }
      front = next;
    }
  }
  return region;
}

Mesh openGrid(int n)
{
  return gridSurface(n, n, false, false, [](double u, double v) { return Vector3(u, v, 0); });
}

vtkSmartPointer<vtkPolyData> withRegion(const Mesh& mesh,
  const std::vector<char>& region,
  const std::vector<char>& seeds)
{
  auto polyData = toPolyData(mesh);
  for (const auto& [name, values] : { std::pair("Region", &region), std::pair("RegionSeed", &seeds) })
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(name);
    for (char v : *values)
    {
      array->InsertNextValue(static_cast<unsigned char>(v));
    }
    polyData->GetPointData()->AddArray(array);
  }
  return polyData;
}

std::vector<char> regionOf(vtkPolyData* polyData)
{
  std::vector<char> region;
  vtkDataArray* array = polyData->GetPointData()->GetArray("Region");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    region.push_back(char(array->GetComponent(i, 0)));
  }
  return region;
}

} // namespace

TEST(A9_1, NothingIsLeftToSmoothAndASecondPassChangesNothing)
{
  int changed = 0, regions = 0;
  for (const Mesh& mesh : { icosphere(4), torus(1.0, 0.4, 60, 30) })
  {
    const Adjacency adjacency = oversketch::buildAdjacency(mesh);
    for (unsigned seed = 0; seed < 120; ++seed)
    {
      const std::vector<char> region = randomRegion(adjacency, mesh.vertexCount(), seed);
      std::vector<char> seeds(region.size(), 0);
      if (seed % 2)
      {
        seeds[std::find(region.begin(), region.end(), 1) - region.begin()] = 1;
      }
      const std::vector<char> smooth = oversketch::smoothBorder(adjacency, seeds, region, 0);
      EXPECT_EQ(unsmooth(adjacency, smooth, seeds), 0) << seed;
      EXPECT_EQ(oversketch::smoothBorder(adjacency, seeds, smooth, 0), smooth) << seed;
      changed += smooth != region;
      ++regions;
    }
  }
  EXPECT_EQ(changed, regions);
  fact("A9_1",
    std::to_string(regions) + " random regions on closed meshes: none with a convex or concave vertex left, "
                              "none changed by a second pass");
}

TEST(A9_2, AHoleFillsASpikeGoesAndTheWholeOpenGridTerminates)
{
  const Mesh mesh = openGrid(20);
  const Adjacency adjacency = oversketch::buildAdjacency(mesh);
  const auto id = [](int i, int j) { return j * 21 + i; };
  std::vector<char> block(mesh.points.size(), 0);
  for (int j = 6; j <= 14; ++j)
  {
    for (int i = 6; i <= 14; ++i)
    {
      block[id(i, j)] = 1;
    }
  }
  const std::vector<char> seeds(mesh.points.size(), 0);
  const std::vector<char> smooth = oversketch::smoothBorder(adjacency, seeds, block, 2);
  std::vector<char> holed = block;
  holed[id(10, 10)] = 0;
  EXPECT_EQ(oversketch::smoothBorder(adjacency, seeds, holed, 2), smooth);
  EXPECT_TRUE(smooth[id(10, 10)]);
  std::vector<char> spiked = smooth;
  spiked[id(15, 10)] = spiked[id(16, 10)] = spiked[id(17, 10)] = 1;
  const std::vector<char> blunted = oversketch::smoothBorder(adjacency, seeds, spiked, 3);
  EXPECT_FALSE(blunted[id(16, 10)]);
  EXPECT_FALSE(blunted[id(17, 10)]);

  // Two corners of an open grid have two neighbours, both selected: convex and hard to please.
  const std::vector<char> whole(mesh.points.size(), 1);
  EXPECT_EQ(oversketch::smoothBorder(adjacency, seeds, whole, 0), whole);
  std::vector<char> cornerless = whole;
  cornerless[id(20, 0)] = cornerless[id(0, 20)] = 0;
  EXPECT_EQ(oversketch::smoothBorder(adjacency, seeds, cornerless, 0), whole);
  fact("A9_2", "hole filled, spike of 2 vertices gone, whole 21 x 21 grid unchanged");
}

TEST(RegionBorder, ConfinementStopsTheRunAwayAlongALattice)
{
  // A block on a wrapped lattice: corners let the concave rule run along rows.
  const Mesh mesh = torus(1.0, 0.4, 90, 60);
  const Adjacency adjacency = oversketch::buildAdjacency(mesh);
  const std::vector<char> seeds(mesh.points.size(), 0);
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const std::vector<char> region = randomRegion(adjacency, mesh.vertexCount(), seed);
    const std::vector<char> confined = oversketch::smoothBorder(adjacency, seeds, region, 2);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (confined[v] && !region[v])
      {
        // Within one ring of a vertex that has a selected neighbour.
        bool near = neighboursOf(adjacency, region, v).inside > 0;
        for (const int n : adjacency.vertexVertices[v])
        {
          near = near || neighboursOf(adjacency, region, n).inside > 0;
        }
        EXPECT_TRUE(near);
      }
    }
  }
}

TEST(RegionBorder, SeedsStayAndPiecesWithoutOneGo)
{
  const Mesh mesh = icosphere(3);
  const Adjacency adjacency = oversketch::buildAdjacency(mesh);
  std::vector<char> region(mesh.points.size(), 0), seeds(mesh.points.size(), 0);
  region[5] = seeds[5] = 1; // alone, so convex
  int far = 0;              // the vertex opposite
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    far = mesh.points[v].dot(mesh.points[5]) < mesh.points[far].dot(mesh.points[5]) ? v : far;
  }
  region[far] = 1;
  for (const int n : adjacency.vertexVertices[far])
  {
    region[n] = 1;
  }
  const std::vector<char> smooth = oversketch::smoothBorder(adjacency, seeds, region, 2);
  EXPECT_TRUE(smooth[5]);
  EXPECT_EQ(std::count(smooth.begin(), smooth.end(), 1), 1);
}

TEST(RegionBorder, FilterSmoothsCachesAndRefuses)
{
  const Mesh mesh = icosphere(4);
  const Adjacency adjacency = oversketch::buildAdjacency(mesh);
  const std::vector<char> region = randomRegion(adjacency, mesh.vertexCount(), 1);
  const std::vector<char> seeds(region.size(), 0);
  const auto input = withRegion(mesh, region, seeds);
  vtkNew<vtkOversketchRegionBorder> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(regionOf(filter->GetOutput()), oversketch::smoothBorder(adjacency, seeds, region, 2));
  EXPECT_EQ(regionOf(input), region);
  vtkDataArray* first = filter->GetOutput()->GetPointData()->GetArray("Region");
  input->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetSmoothingCount(), 1);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Region"), first);
  filter->ConfineOff();
  filter->Update();
  EXPECT_EQ(filter->GetSmoothingCount(), 2);
  EXPECT_EQ(regionOf(filter->GetOutput()), oversketch::smoothBorder(adjacency, seeds, region, 0));

  const auto refuses = [&](vtkPolyData* bad, Failure failure, const char* words)
  {
    filter->SetInputData(bad);
    expectRefusal(filter, failure, words);
  };
  refuses(toPolyData(mesh), Failure::MissingArray, "Region");
  const auto seedless = withRegion(mesh, region, seeds);
  seedless->GetPointData()->RemoveArray("RegionSeed");
  refuses(seedless, Failure::MissingArray, "RegionSeed");
  refuses(withRegion(mesh, std::vector<char>(region.size(), 1), seeds), Failure::BadRegion, "whole model");
  refuses(withRegion(mesh, std::vector<char>(region.size(), 0), seeds), Failure::BadRegion, "empty");
  Ear ear(filter);
  filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  filter->SetInputData(input);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(regionOf(filter->GetOutput()).size(), region.size());
}
