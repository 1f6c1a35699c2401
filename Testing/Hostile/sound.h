// What must hold of a mesh whatever was drawn on it: finite, of the topology that it had, and where it is a
// 4-8 mesh, one whose arrays can be read. Header-only.
#ifndef oversketch_testing_hostile_sound_h
#define oversketch_testing_hostile_sound_h

#include "Harness/promises.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStellarBase.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace oversketch_test
{

struct Topology
{
  long euler = 0;
  int borders = 0; // loops

  bool operator==(const Topology& other) const
  {
    return this->euler == other.euler && this->borders == other.borders;
  }
};

// Of an oriented manifold, points that repeat a place taken for one.
inline Topology topologyOf(vtkPolyData* polyData)
{
  const Mesh mesh = MeshOf(polyData);
  const auto before = [&mesh](int a, int b)
  {
    const Vector3 &p = mesh.points[a], &q = mesh.points[b];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::vector<int> order(mesh.points.size()), number(mesh.points.size(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), before);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    number[order[i]] = number[order[i - 1]] + (before(order[i - 1], order[i]) ? 1 : 0);
  }
  std::vector<int> used;
  std::vector<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      used.push_back(number[t[k]]);
      edges.emplace_back(number[t[k]], number[t[(k + 1) % 3]]);
    }
  }
  const auto onlyOnce = [](auto& values)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  };
  onlyOnce(used);
  onlyOnce(edges);
  Topology topology;
  std::map<int, int> following;
  long count = 0;
  for (const auto& [a, b] : edges)
  {
    const bool twice = std::binary_search(edges.begin(), edges.end(), std::make_pair(b, a));
    count += !twice || a < b;
    if (!twice)
    {
      following[a] = b;
    }
  }
  topology.euler = static_cast<long>(used.size()) - count + static_cast<long>(mesh.triangles.size());
  while (!following.empty())
  {
    ++topology.borders;
    for (auto at = following.begin(); at != following.end();)
    {
      const int next = at->second;
      following.erase(at);
      at = following.find(next);
    }
  }
  return topology;
}

// A mesh with the arrays of a 4-8 mesh goes through the step that would make it one.
inline void expectForest(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(mesh);
  vtkNew<vtkOversketchStellarBase> base;
  Ear ear(base);
  base->SetInputData(copy);
  base->Update();
  EXPECT_EQ(base->GetErrorCode(), 0u);
  EXPECT_TRUE(ear.errors.empty() && ear.warnings.empty());
  EXPECT_EQ(base->GetBaseCount(), 0); // nothing was made anew
}

// What was made of a base: no fewer triangles, all finite, its topology. `forest` is the output before points
// were split along seams.
inline void expectSound48(vtkPolyData* base, vtkPolyData* forest, vtkPolyData* output)
{
  ASSERT_GE(output->GetNumberOfPolys(), base->GetNumberOfPolys());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(Vector3(output->GetPoint(i)).allFinite());
  }
  EXPECT_TRUE(topologyOf(output) == topologyOf(base));
  expectForest(forest);
}

} // namespace oversketch_test
#endif
