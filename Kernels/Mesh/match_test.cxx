#include "Harness/shapes.h"
#include "Mesh/match.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A vertex moved, triangles gone, one split, a vertex cut in two; numbered backwards.
Mesh withChanges(const Mesh& mesh)
{
  Mesh changed = mesh;
  changed.points[700] *= 1.01;
  changed.triangles.erase(changed.triangles.begin() + 4000, changed.triangles.begin() + 4003);
  const Triangle split = changed.triangles[300];
  const int middle = changed.vertexCount();
  changed.points.emplace_back((mesh.points[split[0]] + mesh.points[split[1]] + mesh.points[split[2]]) / 3.0);
  changed.triangles[300][0] = middle;
  changed.triangles.push_back({ split[0], middle, split[2] });
  changed.triangles.push_back({ split[0], split[1], middle });
  const int twin = changed.vertexCount();
  changed.points.push_back(changed.points[changed.triangles[1000][1]]);
  changed.triangles[1000][1] = twin;
  const int last = changed.vertexCount() - 1;
  std::reverse(changed.points.begin(), changed.points.end());
  for (Triangle& t : changed.triangles)
  {
    t = { last - t[0], last - t[1], last - t[2] };
  }
  return changed;
}

} // namespace

TEST(Match, NormalsAfterAChangeAreThoseComputedAnew)
{
  const Mesh before = icosphere(4), now = withChanges(before);
  for (const auto& [from, to] : { std::pair(before, now), std::pair(now, before), std::pair(now, now) })
  {
    std::vector<Vector3> normals;
    ASSERT_TRUE(normalsAfter(from, vertexNormals(from), to, trianglesAround(to), normals));
    EXPECT_EQ(normals, vertexNormals(to));
  }
  std::vector<Vector3> normals;
  const Mesh other = torus(1.0, 0.4, 60, 30);
  EXPECT_FALSE(normalsAfter(before, vertexNormals(before), other, trianglesAround(other), normals));
}

TEST(Match, EachTriangleIsOneOfTheOthersOrNew)
{
  const Mesh before = icosphere(4), now = withChanges(before);
  std::vector<int> numbers, others;
  ASSERT_TRUE(matchTriangles(before, now, numbers, others));
  std::vector<int> told = others;
  for (int i = 0; i < before.triangleCount(); ++i)
  {
    for (int k = 0; numbers[i] >= 0 && k < 3; ++k)
    {
      EXPECT_EQ(now.points[now.triangles[numbers[i]][k]], before.points[before.triangles[i][k]]);
    }
    if (numbers[i] >= 0)
    {
      told.push_back(numbers[i]);
    }
  }
  std::sort(told.begin(), told.end());
  for (int i = 0; i < now.triangleCount(); ++i)
  {
    ASSERT_EQ(told[i], i);
  }
  EXPECT_EQ(told.size(), now.triangles.size());
  EXPECT_LE(others.size(), 20u);
}
