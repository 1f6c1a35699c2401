// 4-8 meshes and feature curves with known answers, for tests of features. Header-only.
#ifndef oversketch_testing_harness_feature_shapes_h
#define oversketch_testing_harness_feature_shapes_h

#include "Harness/forest_shapes.h"
#include "Stellar/refine.h"

namespace oversketch_test
{

// The unit square as n x n pairs; inner points are moved by up to `jitter` of a quad's side.
inline Forest squareForest(int n, double jitter = 0.0, unsigned seed = 1)
{
  Mesh mesh = quadPairs(n, n);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-jitter / n, jitter / n);
  for (Vector3& p : mesh.points)
  {
    const double dx = move(random), dy = move(random);
    p.x() += p.x() > 0.0 && p.x() < 1.0 ? dx : 0.0;
    p.y() += p.y() > 0.0 && p.y() < 1.0 ? dy : 0.0;
  }
  return forestOfPairs(mesh);
}

inline std::vector<Vector3> positionsOf(const Forest& forest)
{
  std::vector<Vector3> points;
  for (const Forest::Vertex& v : forest.vertices)
    points.push_back(v.position);
  return points;
}

inline void refineNear(Forest& forest, const FeatureCurves& curves, double radius, double edgeLength)
{
  RefineOptions options;
  options.radius = radius;
  options.targetEdgeLength = edgeLength;
  forest = refine(forest, curves, options, {}, Context());
}

// 60 lines across the square and 25 spirals in it, the same on every machine.
inline std::vector<FeatureCurve> planarCurves(bool spirals)
{
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<FeatureCurve> curves;
  for (int i = 0; i < (spirals ? 25 : 60); ++i)
  {
    std::vector<Vector3> points;
    if (spirals)
    {
      const Vector3 middle(0.4 + 0.2 * uniform(), 0.4 + 0.2 * uniform(), 0.0);
      const double start = 2.0 * pi * uniform(), turns = 2.0 + uniform();
      for (int k = 0; k <= 300; ++k)
      {
        const double t = k / 300.0, a = start + 2.0 * pi * turns * t, r = 0.02 + 0.33 * t;
        points.push_back(middle + Vector3(r * std::cos(a), r * std::sin(a), 0.0));
      }
    }
    else
    {
      points = { { 0.05 + 0.9 * uniform(), 0.05 + 0.9 * uniform(), 0.0 }, Vector3::Zero() };
      do
      {
        points[1] = { 0.05 + 0.9 * uniform(), 0.05 + 0.9 * uniform(), 0.0 };
      } while ((points[1] - points[0]).norm() < 0.4);
    }
    curves.push_back(featureCurve(points));
  }
  return curves;
}

// A curve that all edges follow is a chain of edges, from each vertex on it to the next.
inline int gapsOf(const Forest& forest)
{
  std::vector<std::pair<double, int>> along;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.vertices[v].curveId >= 0)
    {
      along.emplace_back(forest.vertices[v].curveParam, v);
    }
  }
  std::sort(along.begin(), along.end());
  int gaps = 0;
  for (std::size_t i = 1; i < along.size(); ++i)
  {
    gaps += forest.faceWithEdge(along[i - 1].second, along[i].second) < 0 ? 1 : 0;
  }
  return gaps;
}

} // namespace oversketch_test
#endif
