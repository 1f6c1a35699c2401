// What must hold of a mesh whatever was drawn on it: finite, of the topology that it had, and where it is a
// 4-8 mesh, one whose arrays can be read. Header-only.
#ifndef oversketch_test_sound_h
#define oversketch_test_sound_h

#include "Harness/promises.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStellarBase.h"

#include <map>
#include <set>
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
  std::map<std::vector<double>, int> places;
  std::vector<int> number;
  for (const Vector3& p : mesh.points)
  {
    const std::vector<double> place{ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 };
    number.push_back(places.emplace(place, static_cast<int>(places.size())).first->second);
  }
  std::set<int> used;
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      used.insert(number[t[k]]);
      edges.emplace(number[t[k]], number[t[(k + 1) % 3]]);
    }
  }
  Topology topology;
  std::map<int, int> following;
  long count = 0;
  for (const auto& [a, b] : edges)
  {
    const bool twice = edges.count({ b, a }) > 0;
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
